"""The examples of `docs/robots.md` work."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from crs_cc.cli.main import main

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "robots.md"
PROGRAM = """#include <unistd.h>
#include "Nclient.h"
int main(void) { connect_robot(1); vm(50, 50, 0); for (;;) { gs(); usleep(100000); } }
"""


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(), re.DOTALL)


def test_the_examples_on_the_page_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    definition, world = blocks("xml")
    Path("cart.xml").write_text(definition)
    assert len(definition.strip().splitlines()) <= 12
    Path("world.xml").write_text(world)
    Path("program.c").write_text(PROGRAM)
    assert main(["check", "cart.xml", "world.xml"]) == 0
    assert main(["run", "program.c", "world.xml", "--max-time", "3"]) == 0
    assert main(["run", "program.c", "--robot", "cart.xml", "--max-time", "1"]) == 0
    (example,) = blocks("python")
    names: dict[str, object] = {}
    exec(example, names)


def test_the_picture_exists():
    for name in re.findall(r"!\[[^]]*\]\(([^)]*)\)", PAGE.read_text()):
        assert (PAGE.parent / name).is_file()
