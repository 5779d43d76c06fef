"""Files that programs write are saved below the folder that the user names, and nowhere else."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.cli.save_files import save_files

COPY = r"""
#include <stdio.h>
int main(void)
{
    FILE *from = fopen("map", "r"), *to = fopen("/logs/../logs/copy.txt", "w");
    int c;
    if (from == NULL || to == NULL)
        return 9;
    while ((c = getc(from)) != EOF)
        putc(c, to);
    return 0;
}
"""
PAIR = """<world version="1"><area length="9m" width="9m"/>
<robot id="left" x="1m" y="2m"/><robot id="right" x="7m" y="2m"/></world>"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("copy.c").write_text(COPY)
    Path("map.txt").write_text("a map\n")
    return tmp_path


def test_a_named_file_is_readable_and_a_written_one_is_saved(
    capfd: pytest.CaptureFixture[str],
) -> None:
    arguments = ["run", "copy.c", "--file", "map=map.txt", "--files", "new/out"]
    assert main(arguments) == 0
    assert Path("new/out/logs/copy.txt").read_text() == "a map\n"
    assert [path.name for path in Path("new/out").rglob("*")] == ["logs", "copy.txt"]
    assert main(arguments) == 0  # over those of the run before
    assert capfd.readouterr().err == ""


def test_several_robots_have_separate_folders() -> None:
    Path("pair.xml").write_text(PAIR)
    assert main(["run", "copy.c", "pair.xml", "--file", "map=map.txt", "--files", "out"]) == 0
    assert Path("out/left/logs/copy.txt").read_text() == "a map\n"
    assert Path("out/right/logs/copy.txt").read_text() == "a map\n"


def test_without_a_folder_discarded_files_are_warned_about(
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert main(["run", "copy.c", "--file", "map=map.txt"]) == 0
    assert "'robot0' wrote logs/copy.txt, which is not saved" in capfd.readouterr().err
    assert main(["run", "copy.c", "--file", "map=map.txt", "--quiet"]) == 0
    assert capfd.readouterr().err == ""
    assert sorted(path.name for path in Path().iterdir()) == ["copy.c", "map.txt"]


def test_no_other_file_can_be_read() -> None:
    assert main(["run", "copy.c", "--files", "out"]) == 9


def test_files_written_before_a_failure_are_saved() -> None:
    Path("fails.c").write_text(
        "#include <stdio.h>\n#include <stdlib.h>\nint main(void) {\n"
        'FILE *f = fopen("log", "w"); fputs("last words", f); fflush(f); abort(); }\n'
    )
    assert main(["run", "fails.c", "--files", "out"]) == 123
    assert Path("out/log").read_text() == "last words"


def test_an_existing_file_that_was_not_named_is_reported(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "copy.c"]) == 9
    assert "looked for" not in capfd.readouterr().err
    Path("map").write_text("a map\n")
    assert main(["run", "copy.c"]) == 9
    err = capfd.readouterr().err
    assert "'robot0' looked for map, which programs cannot read" in err
    assert "--file map" in err


@pytest.mark.parametrize(
    "names", [["map=copy.c", "./map=map.txt"], ["map/a=copy.c", "map=map.txt"], ["dev/null=copy.c"]]
)
def test_invalid_file_names_are_rejected(
    names: list[str], capfd: pytest.CaptureFixture[str]
) -> None:
    options = [each for name in names for each in ("--file", name)]
    assert main(["run", "copy.c", *options]) == 2
    assert f"--file '{names[-1]}'" in capfd.readouterr().err


@pytest.mark.parametrize(
    "arguments", [["--file", "none"], ["--file", "."], ["--files", "copy.c/x"]]
)
def test_invalid_files_are_reported_before_the_run(
    arguments: list[str], capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", "copy.c", *arguments]) == 2
    assert arguments[1] in capfd.readouterr().err


@pytest.mark.parametrize("name", [b"link", b"inner/file", b"pipe"])
def test_links_and_devices_are_not_followed(name: bytes, folder: Path) -> None:
    import os

    out, outside = folder / "out", folder / "outside"
    out.mkdir()
    outside.mkdir()
    (out / "link").symlink_to(outside / "file")
    (out / "inner").symlink_to(outside)
    os.mkfifo(out / "pipe")
    (failed,) = save_files(out, {name: b"content"})
    assert failed.location.file == str(out / name.decode())
    assert list(outside.iterdir()) == []


LOGS = r"""
#include <stdio.h>
int main(void)
{
    const char *names[] = {"first", "taken", "last"};
    for (int i = 0; i < 3; i++)
        fputs("kept", fopen(names[i], "w"));
    return 7;
}
"""


def test_a_file_that_cannot_be_saved_does_not_lose_the_next(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("logs.c").write_text(LOGS)
    Path("out/taken").mkdir(parents=True)
    assert main(["run", "logs.c", "--files", "out", "--plot", "path.svg"]) == 1
    assert Path("out/first").read_text() == Path("out/last").read_text() == "kept"
    assert Path("path.svg").exists()
    assert capfd.readouterr().err == "out/taken: error: cannot be written: Is a directory\n"


def test_a_folder_that_cannot_be_created_does_not_lose_other_robots_files(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("logs.c").write_text(LOGS)
    Path("pair.xml").write_text(PAIR)
    Path("out").mkdir()
    Path("out/left").write_text("not a folder")
    assert main(["run", "logs.c", "pair.xml", "--files", "out"]) == 1
    assert Path("out/right/last").read_text() == "kept"
    assert capfd.readouterr().err == "out/left: error: cannot be written: File exists\n"


def test_files_that_cannot_be_saved_after_debugging_are_reported(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("logs.c").write_text(LOGS)
    Path("out/taken").mkdir(parents=True)
    Path("commands").write_text("run\n")
    arguments = ["debug", "--batch", "-x", "commands", "logs.c", "--files", "out"]
    assert main(arguments) == 1
    assert Path("out/last").read_text() == "kept"
    assert "out/taken: error: cannot be written: Is a directory\n" in capfd.readouterr().err
