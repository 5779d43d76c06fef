"""300 broken worlds: each gives one error with its line, and never a traceback."""

from __future__ import annotations

import random
import re
import shutil
from pathlib import Path

import pytest
from lxml import etree

from crs_cc.cli.main import main
from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import load_world
from tests.sim.broken_worlds import BREAKAGES, hostile_files

WORLDS = Path(__file__).parents[2] / "worlds"
GOOD = sorted(WORLDS.glob("*.xml"))
COUNT = 300
MESSAGE = re.compile(r"(?P<file>[^:\n]+)(:\d+(:\d+)?)?: error: (?P<text>.{8,})")
MAX_COUNT = 101
MAX_TEXT = 600


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("broken") / "worlds"
    shutil.copytree(WORLDS, folder)
    hostile_files(folder)
    return folder


def broken(seed: int) -> tuple[str, bytes]:
    """Return the name of a breakage, and the content of the file."""
    dice = random.Random(seed)
    root = etree.parse(dice.choice(GOOD)).getroot()
    breakage = BREAKAGES[seed % len(BREAKAGES)]
    return breakage.__name__, breakage(dice, root)


@pytest.mark.parametrize("part", range(10))
def test_every_broken_world_is_reported_clearly(folder: Path, part: int) -> None:
    path = folder / "broken.xml"
    for seed in range(part, COUNT, 10):
        name, text = broken(seed)
        path.write_bytes(text)
        try:
            load_world(path)
        except WorldError as wrong:
            error = wrong
        else:
            pytest.fail(f"{name}, seed {seed}: taken as it is")
        assert 1 <= len(error.diagnostics) <= MAX_COUNT, (name, seed)
        places = set()
        for message in error.diagnostics:
            first = message.render().splitlines()[0]
            match = MESSAGE.fullmatch(first)
            assert match, (name, seed, first)
            assert len(first) < MAX_TEXT, (name, seed, first)
            places.add(match["file"])
        assert any(place.startswith(str(folder)) for place in places), (name, seed, places)


@pytest.mark.parametrize("seed", range(0, COUNT, 23))
def test_command_reports_error_and_exits_with_122(
    folder: Path, seed: int, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    name, text = broken(seed)
    Path("broken.xml").write_bytes(text)
    Path("go.c").write_text("int main(void) { return 0; }\n")
    for command in (["check", "broken.xml"], ["run", "go.c", "broken.xml"]):
        assert main(command) == 122, name
        shown = capfd.readouterr()
        assert MESSAGE.match(shown.err.splitlines()[0]), shown.err
        assert "Traceback" not in shown.err + shown.out
        assert "internal error" not in shown.err


def test_intact_worlds_are_accepted(folder: Path) -> None:
    for path in GOOD:
        (folder / "broken.xml").write_bytes(path.read_bytes())
        load_world(folder / "broken.xml")
