"""The tutorial shows what really happens: its commands run, and its mistake is there.

The page is made again with what comes out of its commands; `pytest --update-goldens` writes it.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
from collections import deque
from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from tests import commands

DOCS = Path(__file__).parents[2] / "docs"
PAGE = DOCS / "tutorial-debugging.md"
_BLOCK = re.compile(r"(?<=^```)(console|diff)\n(.*?)(?=^```$)", re.DOTALL | re.MULTILINE)
_TYPED = ("$ ", "(crs) ", ">")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the tutorial's files, to work in."""
    return Path(shutil.copytree(DOCS / "tutorial", tmp_path / "tutorial"))


def crs(line: str, folder: Path, script: str = "") -> str:
    """Return what a command shows, in a terminal of 80 columns."""
    words = shlex.split(line)[1:]
    if words[0] == "debug":
        (folder / "script.dbg").write_text(script)
        words[1:1] = ["--batch", "-x", "script.dbg"]
    done = subprocess.run(
        commands.crs(*words),
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(DOCS.parent), "COLUMNS": "80"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout
    return done.stdout


def mend(folder: Path, change: str) -> None:
    """Exchange the lines of a diff in the only program that has them."""
    removed, added = (
        "\n".join(line[1:] for line in change.splitlines() if line[0] == sign) for sign in "-+"
    )
    (program,) = (each for each in folder.rglob("*.c") if removed in each.read_text())
    source = program.read_text()
    assert source.count(removed) == 1
    program.write_text(source.replace(removed, added))


class Reader:
    """Somebody who does what the page says, in its order."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._shown: deque[str] = deque()

    def read(self, page: str) -> str:
        """Return the page with what is shown to him."""
        typed = [
            line
            for kind, text in _BLOCK.findall(page)
            for line in ([text] if kind == "diff" else text.splitlines())
            if kind == "diff" or line.startswith(_TYPED)
        ]
        self._left = deque(typed)
        return _BLOCK.sub(lambda block: f"{block[1]}\n{self._block(*block.groups())}", page)

    def _block(self, kind: str, text: str) -> str:
        if kind == "diff":
            assert self._left.popleft() == text
            mend(self._folder, text)
            return text
        lines = [each for each in text.splitlines() if each.startswith(_TYPED)]
        return "".join(self._do(each) for each in lines)

    def _do(self, line: str) -> str:
        assert self._left.popleft() == line
        if line.startswith("$ "):
            assert not self._shown
            shown = crs(line[2:], self._folder, self._script())
            self._shown.extend(re.split(r"^(?=\(crs\) )", shown, flags=re.MULTILINE))
            return f"{line}\n{self._shown.popleft()}"
        if line.startswith(">"):
            return ""  # comes with the command that asks for it
        shown = self._shown.popleft()
        assert shown.startswith(f"{line}\n")
        return shown

    def _script(self) -> str:
        """Return the debugger's commands that come now."""
        commands = []
        for line in self._left:
            if not line.startswith(_TYPED[1:]):
                break
            commands.append(line.removeprefix("(crs) ").removeprefix(">"))
        return "\n".join(commands)


def test_the_tutorial_shows_what_its_commands_do(
    folder: Path, check_golden: Callable[[Path, bytes], None]
) -> None:
    check_golden(PAGE, Reader(folder).read(PAGE.read_text()).encode())


def collisions(capfd: pytest.CaptureFixture[str], *arguments: str) -> list[int]:
    """Return how often each robot collides in a run of the tutorial."""
    main(["run", "--json", "-q", *arguments])
    return [int(each["collisions"]) for each in json.loads(capfd.readouterr().out)["robots"]]


def test_the_program_collides_as_in_the_picture_until_it_is_mended(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(folder)
    assert collisions(capfd, "aisle.c", "aisle.xml", "--plot", "aisle.svg") == [1]
    assert Path("aisle.svg").read_text() == (DOCS / "images" / "aisle.svg").read_text()
    change = next(text for kind, text in _BLOCK.findall(PAGE.read_text()) if kind == "diff")
    mend(folder, change)
    assert collisions(capfd, "aisle.c", "aisle.xml") == [0]


def test_the_convoy_crashes_by_a_lost_message_until_it_is_mended(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(folder)
    assert collisions(capfd, "convoy/convoy.xml") == [1, 1]
    _, change = (text for kind, text in _BLOCK.findall(PAGE.read_text()) if kind == "diff")
    mend(folder, change)
    assert collisions(capfd, "convoy/convoy.xml") == [0, 0]
