"""The command line: help, usage errors, unreadable files, exit statuses."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from crs_cc import __version__
from crs_cc.cli import check
from crs_cc.cli.main import COMMANDS, main
from crs_cc.core.errors import InternalError
from crs_cc.core.source import Location
from tests.commands import crs


def run_crs(*arguments: str, **options: object) -> subprocess.CompletedProcess[str]:
    """Run crs in a process of its own."""
    return subprocess.run(crs(*arguments), capture_output=True, text=True, check=False, **options)  # type: ignore[call-overload]


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["-V"]) == main(["--version"]) == 0
    assert capsys.readouterr().out == f"crs {__version__}\n" * 2


@pytest.mark.parametrize("command", [[], *([name] for name in COMMANDS)])
def test_help_of_every_command_has_examples(
    command: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*command, "--help"]) == main([*command, "-h"]) == 0
    text = capsys.readouterr().out
    assert "Examples:\n    crs " in text


def test_help_imports_nothing_heavy() -> None:
    code = (
        "import sys\nfrom crs_cc.cli.main import main\nmain(['--help'])\n"
        "heavy = {'numpy', 'wasmtime', 'pymunk', 'lxml', 'pycparser', 'rich'} & set(sys.modules)\n"
        "sys.exit(f'imported {heavy}' if heavy else 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["rum"], "No such command 'rum'"),
        (["run"], "Missing argument"),
        (["run", "a.c", "--max-time", "soon"], "'soon' is not a valid float"),
        (["run", "a.c", "--max-time", "0"], "0.0 is not in the range"),
        (["run", "a.c", "--max-time", "nan"], "nan is not a valid time"),
        (["run", "a.c", "--seed", "-1"], "-1 is not in the range"),
        (["run", "a.c", "--trace", "all"], "'all' is not one of 'requests', 'messages'"),
        (["run", "a.c", "a.xml", "b.xml"], "more than one world file: a.xml b.xml"),
        (["run", "a.c", "b.c", "./a.c"], "a.c is given twice"),
        (["run", "a.c", "--plot", "nowhere/a.svg"], "cannot write 'nowhere/a.svg': no such folder"),
        (["compile", "--emit", "exe", "a.c"], "'exe' is not one of"),
    ],
)
def test_an_invalid_command_line_exits_with_2(
    arguments: list[str],
    message: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 2
    shown = capsys.readouterr()
    assert message in shown.err
    assert shown.out == ""


@pytest.mark.parametrize("command", ["run", "check", "compile"])
def test_a_missing_file_is_reported_with_a_suggestion(
    command: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("wander.c").touch()
    assert main([command, "wnader.c", *["-q"][: command == "check"]]) == 121
    shown = capsys.readouterr().err
    assert shown == "wnader.c: error: no such file\n    hint: did you mean 'wander.c'?\n"


@pytest.mark.parametrize(
    ("forgotten", "status", "message"),
    [
        (["fast", "3"], 121, "fast: error: no such file\n    hint: arguments of the program"),
        (["3"], 121, "3: error: no such file\n    hint: arguments of the program follow --"),
        (["--sped", "3"], 2, "Options of the program itself follow"),
        (["-v"], 2, "No such option '-v'. Options of the program itself follow --."),
    ],
)
def test_program_arguments_without_dashes_get_a_hint(
    forgotten: list[str],
    status: int,
    message: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    program = tmp_path / "wander.c"
    program.write_text("int main(void) { return 0; }\n")
    assert main(["run", str(program), *forgotten]) == status
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(("name", "status"), [("folder.c", 121), ("folder.xml", 122)])
def test_a_folder_is_not_a_file(
    name: str, status: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / name).mkdir()
    assert main(["check", "-q", str(tmp_path / name)]) == status
    assert capsys.readouterr().err == f"{tmp_path / name}: error: is a directory, not a file\n"


def test_an_unreadable_file_is_reported(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    # not by its mode: root, who may run the tests, can read everything
    monkeypatch.setattr("os.access", lambda _path, _mode: False)
    monkeypatch.chdir(tmp_path)
    Path("secret.c").touch()
    assert main(["check", "-q", "secret.c"]) == 121
    assert capsys.readouterr().err == "secret.c: error: cannot be read: permission denied\n"


def test_an_invalid_file_name_is_rejected(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "-q", "x" * 10_000 + ".c"]) == 121
    assert "cannot be read: File name too long" in capsys.readouterr().err


def test_the_first_file_with_errors_determines_the_status(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["check", "no.xml", "no.c"]) == 122
    assert main(["check", "no.c", "no.xml"]) == 121
    assert "2 files checked: 2 errors, 0 warnings" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (KeyError("slot"), "crs: internal error: KeyError: 'slot'"),
        (RecursionError("too deep"), "crs: internal error: RecursionError: too deep"),
        (InternalError.at(Location("a.c", 3), "malformed IR"), "a.c:3: error: malformed IR"),
    ],
)
def test_internal_errors_ask_for_a_report_and_show_no_traceback(
    error: Exception,
    message: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def fail(*_arguments: object) -> None:
        raise error

    monkeypatch.setattr(check, "check_readable", fail)
    monkeypatch.delenv("CRS_DEBUG", raising=False)
    assert main(["check", "a.c"]) == 70
    shown = capsys.readouterr().err
    assert shown.startswith(message)
    assert "Please report it" in shown
    assert "Traceback" not in shown
    monkeypatch.setenv("CRS_DEBUG", "1")
    assert main(["check", "a.c"]) == 70
    assert "Traceback" in capsys.readouterr().err


def test_ctrl_c_while_compiling_exits_with_130(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(check, "check_readable", fail)
    assert main(["check", "a.c"]) == 130
    assert capsys.readouterr().err == "\ncrs: interrupted\n"


def test_a_lack_of_address_space_is_reported(tmp_path: Path) -> None:
    (tmp_path / "hello.c").write_text("int main(void) { return 0; }\n")
    limit = 3 * 2**30

    def limited() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    done = run_crs("run", str(tmp_path / "hello.c"), preexec_fn=limited)
    assert done.returncode == 1
    assert "error: cannot allocate memory for 1 program" in done.stderr


def run_without_reader(*arguments: str, stderr: bool = False, **options: Any) -> tuple[int, str]:
    """Return exit status and stderr of a crs whose output is not read."""
    reader, writer = os.pipe()
    os.close(reader)
    errors = writer if stderr else subprocess.PIPE
    done = subprocess.run(
        crs(*arguments),
        stdin=subprocess.DEVNULL, stdout=writer, stderr=errors, check=False, **options,
    )  # fmt: skip
    os.close(writer)
    return done.returncode, (done.stderr or b"").decode()


@pytest.mark.parametrize(
    "arguments",
    [
        ["--help"],
        ["--version"],
        ["run", "hello.c"],
        ["run", "hello.c", "--json"],
        ["check", "hello.c", "--json"],
        ["compile", "--emit", "ir", "hello.c"],
        ["debug", "--repl", "hello.c"],
        ["debug", "--batch", "hello.c", "-x", "commands"],
    ],
    ids=" ".join,
)
def test_a_broken_pipe_exits_with_141_without_a_traceback(
    arguments: list[str], tmp_path: Path
) -> None:
    hello = '#include <stdio.h>\nint main(void) { puts("hello"); return 0; }\n'
    (tmp_path / "hello.c").write_text(hello)
    (tmp_path / "commands").write_text("run\n")
    status, errors = run_without_reader(*arguments, cwd=tmp_path)
    assert status == 141
    assert errors == ("hello\n" if "--json" in arguments and "run" in arguments else "")


@pytest.mark.parametrize(
    "arguments",
    [["--help"], ["--bogus"], ["check", "no.c"], ["run", "silent.c", "--summary"]],
    ids=" ".join,
)
def test_a_broken_pipe_for_both_streams_exits_with_141(
    arguments: list[str], tmp_path: Path
) -> None:
    (tmp_path / "silent.c").write_text("int main(void) { return 0; }\n")
    assert run_without_reader(*arguments, stderr=True, cwd=tmp_path) == (141, "")
