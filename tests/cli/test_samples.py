"""`crs samples` and `crs docs`: what comes with crs, listed, copied and shown."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.cli.sample_files import all_samples
from crs_cc.core.shared_files import shared_folder

ROOT = Path(__file__).parents[2]
CHECKED = [
    *(each for each in all_samples() if each.path.suffix in {".c", ".xml"}),
    *(each for each in all_samples() if each.path.is_dir() and any(each.path.glob("*.xml"))),
]


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_the_list_has_a_line_on_each_sample_and_world(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["samples"]) == 0
    lines = capsys.readouterr().out.splitlines()
    rows = dict(line.split(None, 1) for line in lines if line.startswith("  "))
    assert rows["wander.c"].startswith("Let a Scout wander through a room")
    assert rows["room.xml"].startswith("A room with furniture")
    assert {path.name for path in (ROOT / "worlds").glob("*.xml")} <= rows.keys()
    assert {path.name for path in (ROOT / "samples" / "scout_c").glob("*.c")} <= rows.keys()
    assert "results" not in rows, "of experiments: no sample"
    assert all(len(line) <= 100 for line in lines)


def test_copied_worlds_bring_the_files_that_they_name(capsys: pytest.CaptureFixture[str]) -> None:
    """Pictures, robot definitions and programs: every world can be read where it was copied to."""
    names = [each.name for each in CHECKED if each.path.suffix != ".c"]
    assert main(["samples", "copy", *names, "."]) == 0
    for each in CHECKED:
        if each.path.suffix == ".xml":
            assert main(["check", each.name]) == 0, capsys.readouterr().err
    for path in Path().glob("*/*.xml"):
        if "<robot " in path.read_text() and path.parent.name != "lib":
            assert 'program="' not in path.read_text() or list(path.parent.glob("*.c"))


@pytest.mark.parametrize("name", ["wander.c", "wander", "scout_c/wander.c", "mission.txt"])
def test_a_sample_is_named_with_or_without_its_folder_and_ending(name: str) -> None:
    assert main(["samples", "copy", name, "."]) == 0
    (copied,) = Path().iterdir()
    assert copied.read_bytes() == (ROOT / "samples" / "scout_c" / copied.name).read_bytes()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["wandr.c", "."], "unknown sample 'wandr.c': did you mean 'wander.c'?"),
        (["zzzz", "."], "unknown sample 'zzzz': 'crs samples' lists them."),
        (["../../setup.py", "."], "unknown sample '../../setup.py'"),
        (["platoon", "."], "choose 'scout_c/platoon.c' or 'worlds/platoon.xml'."),
        (["wander.c", "room.xml"], "'room.xml' is not a folder: name the folder to copy to last"),
        (["wander.c"], "'wander.c' is not a folder"),
        (["mine.c", "wander.c", "."], "unknown sample 'mine.c'"),
    ],
)
def test_a_failed_copy_is_one_error_and_copies_nothing(
    arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["samples", "copy", *arguments]) == 2
    assert message in capsys.readouterr().err
    assert not list(Path().iterdir())


def test_copying_overwrites_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    Path("wander.c").write_text("mine")
    assert main(["samples", "copy", "square.c", "wander.c", "."]) == 2
    assert "'wander.c' already exists." in capsys.readouterr().err
    assert Path("wander.c").read_text() == "mine"
    assert not Path("square.c").exists()


def test_pages_are_listed_and_shown(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["docs"]) == 0
    listed = {line.split()[0] for line in capsys.readouterr().out.splitlines()}
    assert {"sensors", "language", "tutorial-debugging"} <= listed
    for name in ("sensors", "sensors.md"):
        assert main(["docs", name]) == 0
        shown = capsys.readouterr().out
        assert "This page lists the sensors of a robot" in shown
        assert "\x1b" not in shown
        assert "](" not in shown
        assert "<!--" not in shown


def test_an_unknown_page_is_an_error_with_a_suggestion(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["docs", "sensor"]) == 2
    assert "unknown page 'sensor': did you mean 'sensors'?" in capsys.readouterr().err


def test_an_incomplete_installation_is_reported() -> None:
    from crs_cc.core.errors import InternalError

    with pytest.raises(InternalError, match="was not installed"):
        shared_folder("nothing")


def test_a_missing_file_that_is_a_sample_is_found(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "wander.c"]) == 121
    assert "hint: there is a sample of that name: crs samples copy wander.c ." in (
        capsys.readouterr().err
    )
