"""What README and ARCHITECTURE show works and what they name exists.

Commands and programs run, files, tests and make targets exist, exit statuses are those of the code.
"""

from __future__ import annotations

import ast
import io
import re
import shlex
import shutil
from pathlib import Path

import click
import pytest

from crs_cc.cli import exit_status
from crs_cc.cli.main import main
from crs_cc.core import errors

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text()
ARCHITECTURE = (ROOT / "ARCHITECTURE.md").read_text()


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)


def commands() -> list[str]:
    lines = "".join(blocks("sh")).splitlines()
    return [line for line in lines if line.startswith("crs ")]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest) -> Path:
    """A folder with the samples, the worlds and the README's own programs, to work in."""
    for name in ("samples", "worlds"):
        shutil.copytree(ROOT / name, tmp_path / name)
    for name, program in zip(("approach.c", "cool.c"), blocks("c"), strict=True):
        (tmp_path / name).write_text(program)
    monkeypatch.chdir(tmp_path)
    copying = next(each for each in commands() if each.startswith("crs samples copy"))
    if "command" not in request.fixturenames or request.getfixturevalue("command") != copying:
        assert main(shlex.split(copying)[1:]) == 0
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO()))  # nobody types
    return tmp_path


@pytest.mark.parametrize("command", commands())
def test_every_command_of_the_readme_runs(
    command: str, folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(shlex.split(command, comments=True)[1:]) == 0, capfd.readouterr().err
    shown = capfd.readouterr()
    assert shown.out + shown.err
    assert ": error: " not in shown.err


def test_the_readmes_own_program_does_what_its_text_says(
    folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    command = next(command for command in commands() if "approach.c" in command)
    main(shlex.split(command)[1:])
    inches = re.match(r"(\d+) inches ahead of the wall at x = ", capfd.readouterr().out)
    assert inches
    assert 5 < int(inches[1]) <= 20
    assert (folder / "approach.svg").read_text().startswith("<?xml")


def test_the_readmes_lines_of_python_run(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exec("".join(blocks("python")), {})
    assert re.match(r"\[\d+\.\d+ \d+\.\d+ \d+\.\d+\]\n", capsys.readouterr().out)


def exit_statuses() -> set[int]:
    """Return every exit status of our own."""
    classes = [each for each in vars(errors).values() if isinstance(each, type)]
    named = [value for name, value in vars(exit_status).items() if name.isupper()]
    blamed = [each.exit_status for each in classes if issubclass(each, errors.CrsError)]
    return {click.UsageError.exit_code, *named, *blamed}


def test_readme_and_help_list_every_exit_status(capsys: pytest.CaptureFixture[str]) -> None:
    rows = re.findall(r"^\| ([\d, ]+) \|", README, re.MULTILINE)
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
