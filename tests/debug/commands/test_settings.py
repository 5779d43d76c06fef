"""Settings and commands are kept for the next session at a terminal, and for nobody else."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.commands.user_session import UserSession
from tests.debug.debuggers import debugger_of

SOURCE = "int row[300];\nint main(void)\n{\n    int n = 1;\n    return row[n];\n}\n"


@pytest.fixture
def config(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the user's files."""
    for name in ("CONFIG", "STATE"):
        monkeypatch.setenv(f"XDG_{name}_HOME", str(tmp_path / "home"))
    return tmp_path / "home" / "crs_cc"


@pytest.fixture
def shell(config: Path) -> Shell:
    made = Shell(debugger_of(SOURCE))
    made.debugger.start()
    return made


def answers(shell: Shell, *commands: str) -> list[str]:
    """Return the lines that commands answer with."""
    return [line.text for each in commands for line in shell.execute(each)]


def test_settings_change_what_commands_show(shell: Shell) -> None:
    assert len(answers(shell, "list 1,")) == 6
    assert len(answers(shell, "set listsize 2", "list 1,")) == 2
    assert answers(shell, "show listsize") == [
        "listsize = 2: Number of source lines that list shows."
    ]
    assert len(answers(shell, "show")) > 3
    answers(shell, "set var row[9] = 1", "set print elements 9")
    assert answers(shell, "print row") == ["$1 = {0, 0, 0, 0, 0, 0, 0, 0, 0, ...}"]
    assert answers(shell, "set var row[1] = 5", "print row[1]") == ["$2 = 5"]  # still an assignment


@pytest.mark.parametrize(
    ("command", "message"),
    [
        ("set listsize 0", "invalid value '0' of 'listsize' (expected 1 to 10,000)"),
        ("set listsize", "invalid value '' of 'listsize' (expected 1 to 10,000)"),
        ("set history save maybe", "invalid value 'maybe' of 'history save' (expected on or off)"),
        ("show lists", "listsize = 10: Number of source lines that list shows."),
        ("show nothing", "unknown setting 'nothing'"),
    ],
)
def test_invalid_settings_are_refused(shell: Shell, command: str, message: str) -> None:
    assert answers(shell, command)[0].startswith(message)


def test_with_changes_a_setting_for_one_command_and_keeps_nothing(
    shell: Shell, config: Path
) -> None:
    UserSession(shell.context).keep_settings()
    answers(shell, "set var row[0] = 1", "set var row[1] = 2", "set var row[9] = 3")
    assert len(answers(shell, "with listsize 2 -- list 1,")) == 2
    assert answers(shell, "with print elements 2 -- print row") == ["$1 = {1, 2, ...}"]
    assert answers(shell, "print -elements 3 -- row") == ["$2 = {1, 2, 0, ...}"]
    assert answers(shell, "with listsize 2 -- nonsense")[0].startswith("Undefined command")
    assert answers(shell, "show listsize") == [
        "listsize = 10: Number of source lines that list shows."
    ]
    assert "print elements = 200" in answers(shell, "show print elements")[0]
    assert not config.exists()


def test_only_a_session_at_a_terminal_keeps_settings(shell: Shell, config: Path) -> None:
    answers(shell, "set listsize 3")  # a script
    assert not config.exists()
    first = UserSession(shell.context)
    assert list(first.load_settings()) == []
    first.keep_settings()
    answers(shell, "set print elements 50", "set history save off")
    kept = config / "debugger.conf"
    assert kept.read_text() == "print elements 50\nhistory save off\n"

    kept.write_text("print elements 70\nnonsense 1\nlistsize many\n")
    later = Shell(shell.debugger)
    assert later.context.settings["print elements"] == 200
    assert list(UserSession(later.context).load_settings()) == [
        f"{kept}:2: unknown setting 'nonsense 1'",
        f"{kept}:3: invalid value 'many' of 'listsize' (expected 1 to 10,000)",
    ]
    assert later.context.settings["print elements"] == 70
    assert later.debugger.view.full_style.most_elements == 70


def test_commands_are_kept_up_to_the_size_of_the_history(shell: Shell, config: Path) -> None:
    answers(shell, "set history size 3")
    UserSession(shell.context).keep_commands(["one", "two"])
    session = UserSession(shell.context)
    assert session.commands == ["one", "two"]
    session.keep_commands(["three", "four"])
    assert (config / "debugger_history").read_text() == "two\nthree\nfour\n"
    answers(shell, "set history save off")
    session.keep_commands(["five"])
    assert UserSession(shell.context).commands == ["two", "three", "four"]


def test_files_that_cannot_be_used_are_no_error(shell: Shell, config: Path) -> None:
    config.parent.write_text("not a folder")
    session = UserSession(shell.context)
    assert session.commands == []
    assert list(session.load_settings()) == []
    session.keep_settings()
    assert answers(shell, "set listsize 3") == []
    session.keep_commands(["one"])
