"""What README, ARCHITECTURE and the first pages show works and what they name exists.

Commands and programs run, files, tests and make targets exist, exit statuses are those of the code.
"""

from __future__ import annotations

import ast
import io
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from crs_cc.cli import exit_status
from crs_cc.cli.main import main
from crs_cc.core import errors
from crs_cc.core.errors import ProgramError

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text()
ARCHITECTURE = (ROOT / "ARCHITECTURE.md").read_text()


PAGES = {
    path.stem: path
    for path in (
        ROOT / "README.md",
        ROOT / "docs" / "first-steps.md",
        ROOT / "docs" / "command-line.md",
        ROOT / "docs" / "robot-api.md",
    )
}
"""The pages whose commands a reader types, from the first to the last, in an empty folder."""

_STEP = re.compile(r"`(\w+\.(?:c|xml))`[^`]*\n```(?:c|xml)\n(.*?)```|```sh\n(.*?)```", re.DOTALL)
"""A file to be saved, with its name in the sentence before, or commands."""


def steps(page: Path) -> Iterator[tuple[str, str]]:
    """Yield what the reader of a page does: a file's name and content, or a command and ''."""
    for name, content, commands in _STEP.findall(page.read_text("utf-8")):
        if name:
            yield name, content
        yield from ((line, "") for line in commands.splitlines() if line.startswith("crs "))


def run(command: str, capfd: pytest.CaptureFixture[str]) -> str:
    """Return what a command of crs prints."""
    status = main(shlex.split(command, comments=True)[1:])
    shown = capfd.readouterr()
    assert status == 0, f"{command}: {shown.err}"
    assert ": error: " not in shown.err
    return shown.out + shown.err


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to work in, without typed input."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO()))
    return tmp_path


@pytest.mark.parametrize("page", PAGES.values(), ids=PAGES)
def test_every_command_of_a_page_runs_in_an_empty_folder(
    page: Path, folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    for step, content in steps(page):
        if content:
            (folder / step).write_text(content)
        else:
            run(step, capfd)
            for written in re.findall(r"--(?:plot|html|csv|record) (\S+)", step):
                assert Path(written).exists(), step


def test_first_steps_show_what_the_programs_print(
    folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    page = PAGES["first-steps"]
    for name, content in steps(page):
        if content:
            (folder / name).write_text(content)
    run("crs samples copy room.xml .", capfd)
    shown = run("crs run approach.c room.xml", capfd)
    inches = re.match(r"(\d+) inches from the wall, at x = ", shown)
    assert inches
    assert 5 < int(inches[1]) <= 20
    assert f"```\n{shown.splitlines()[0]}\n```" in page.read_text("utf-8")
    assert main(["run", "nearest.c", "room.xml"]) == ProgramError.exit_status
    report = capfd.readouterr().err
    assert report[report.index("nearest.c") :] in page.read_text("utf-8")


def test_the_readmes_lines_of_python_run(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    run("crs samples copy wander.c room.xml .", capfd)
    exec("".join(re.findall(r"```python\n(.*?)```", README, re.DOTALL)), {})
    assert re.match(r"\[\d+\.\d+ \d+\.\d+ \d+\.\d+\]\n", capfd.readouterr().out)


def exit_statuses() -> set[int]:
    """Return every exit status of our own."""
    classes = [each for each in vars(errors).values() if isinstance(each, type)]
    named = [value for name, value in vars(exit_status).items() if name.isupper()]
    blamed = [each.exit_status for each in classes if issubclass(each, errors.CrsError)]
    return {click.UsageError.exit_code, *named, *blamed}


def test_page_and_help_list_every_exit_status(capsys: pytest.CaptureFixture[str]) -> None:
    page = PAGES["command-line"].read_text("utf-8")
    rows = re.findall(r"^\| ([\d, ]+) \|", page, re.MULTILINE)
    assert {int(number) for row in rows for number in row.split(",")} == exit_statuses()
    main(["--help"])
    shown = re.findall(r"^ +(\d+(?: \d+)*)  ", capsys.readouterr().out, re.MULTILINE)
    assert {int(number) for row in shown for number in row.split()} == exit_statuses()


def test_every_file_that_the_texts_name_exists() -> None:
    links = re.findall(r"\]\(([^)#]+)\)", README + ARCHITECTURE)
    paths = re.findall(r"`((?:[\w.]+/)+[\w.]*)`", README)
    assert links
    for name in [*links, *paths]:
        if not name.startswith((".venv", "http")):
            assert (ROOT / name).exists(), name


def test_every_make_target_that_the_texts_name_exists() -> None:
    makefile = (ROOT / "Makefile").read_text()
    texts = README + (ROOT / "CONTRIBUTING.md").read_text()
    targets = re.findall(r"^ *make (\w+)", texts, re.MULTILINE)
    assert {"demo", "test", "check", "bench"} <= set(targets)
    for target in targets:
        assert re.search(rf"^{target}:", makefile, re.MULTILINE)


def test_every_test_that_the_architecture_names_exists() -> None:
    named = re.findall(r"`(tests/[\w/]+\.py)(?:::(\w+))?`", ARCHITECTURE)
    assert len(named) >= 8
    for file, test in named:
        tree = ast.parse((ROOT / file).read_text())
        names = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        assert not test or test in names, f"{file}::{test}"
