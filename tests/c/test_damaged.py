"""Programs with something missing or out of place compile or are refused; nothing else happens."""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from crs_cc.errors import CompileError
from crs_cc.frontend.options import Options
from crs_cc.frontend.unit import compile_file
from crs_cc.ir.verify import verify
from crs_cc.session.library import HEADERS
from crs_cc.source import Diagnostics
from tests.c.execution import cases, name

TOKEN = re.compile(r"[A-Za-z_]\w*|\d[\w.]*|\"(?:\\.|[^\"\n])*\"|[^\s\w]|\n")
DAMAGES = 6
"""Damaged versions of each program."""


def damaged(text: str, chance: random.Random) -> str:
    """Gives a program with one to three tokens deleted, doubled, swapped or replaced."""
    places = [match.span() for match in TOKEN.finditer(text)]
    for _ in range(chance.randint(1, 3)):
        (first, last), (other, end) = chance.choice(places), chance.choice(places)
        inserted = chance.choice(["", text[other:end], text[first:last] * 2, " ( ", " { ", " 0 "])
        text = text[:first] + inserted + text[last:]
    return text


def compile_or_refuse(source: Path) -> None:
    diagnostics = Diagnostics()
    try:
        verify(compile_file(source, Options(system_paths=(HEADERS,)), diagnostics))
    except CompileError:
        assert all(message.location.line for message in diagnostics.errors)


@pytest.mark.slow
@pytest.mark.parametrize("path", cases("valid"), ids=name)
def test_a_damaged_program_is_compiled_or_refused(path: Path, tmp_path: Path) -> None:
    chance = random.Random(name(path))
    text = path.read_text(encoding="latin-1")
    for _ in range(DAMAGES):
        source = tmp_path / path.name
        source.write_text(damaged(text, chance), encoding="latin-1")
        compile_or_refuse(source)
