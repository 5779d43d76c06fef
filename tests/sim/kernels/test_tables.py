"""What kernels and Python agree on is the same in both."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from crs_cc.sim.kernels import calm, tables

FOLDER = Path(tables.__file__).parent


def enumerated(file: str, first: str) -> dict[str, int]:
    """Return the numbers of the enumeration in a C file that begins with a name."""
    text = (FOLDER / file).read_text()
    names = text[text.index(f"enum {{ {first}") :].split("}")[0].split("{")[1].split(",")
    begin = int(number[1]) if (number := re.search(r"= (\d+)", names[0])) else 0
    return {each.split("=")[0].strip(): begin + place for place, each in enumerate(names)}


@pytest.mark.parametrize(
    ("file", "first", "module"),
    [
        ("main.c", "SETUP", tables),
        ("kernels.h", "ADVANCED", tables),
        ("calm.h", "RUN", calm),
    ],
)
def test_enumerations_have_the_same_numbers(file: str, first: str, module: object) -> None:
    numbers = enumerated(file, first)
    assert {name: getattr(module, name) for name in numbers} == numbers
