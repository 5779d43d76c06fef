"""`show` shows printed values ten at a time, and convenience variables."""

from __future__ import annotations

import pytest

from crs_cc import __version__
from crs_cc.debug.commands.shell import Shell
from tests.debug.commands.test_settings import answers
from tests.debug.debuggers import debugger_of


@pytest.fixture
def shell() -> Shell:
    made = Shell(debugger_of("int main(void)\n{\n    return 0;\n}\n"))
    made.debugger.start()
    return made


def numbers(shell: Shell, command: str) -> list[int]:
    """Return the numbers of the values that a command shows."""
    return [int(each[1:].split()[0]) for each in answers(shell, command)]


def test_printed_values_are_shown_ten_at_a_time(shell: Shell) -> None:
    assert answers(shell, "show values") == ["No values have been printed."]
    answers(shell, *(f"print {each * each}" for each in range(1, 31)))
    assert answers(shell, "show values")[-1] == "$30 = 900"
    assert numbers(shell, "show values") == list(range(21, 31))
    assert numbers(shell, "show values 12") == list(range(7, 17))
    assert numbers(shell, "show values +") == list(range(17, 27))
    assert numbers(shell, "show values +") == list(range(27, 31))
    assert numbers(shell, "show values +") == []
    assert numbers(shell, "show values 2") == list(range(1, 11))


def test_convenience_variables_are_shown_without_printed_values(shell: Shell) -> None:
    assert answers(shell, "show convenience") == ["No convenience variables have values."]
    assert answers(shell, "print 5", "set var $b = 3", "set var $a = 'x'", "show conv") == [
        "$1 = 5",
        "$a = 120",
        "$b = 3",
    ]


def test_the_version_is_shown(shell: Shell) -> None:
    assert answers(shell, "show version") == [f"crs {__version__}"]
    assert answers(shell, "show version 3") == ["unexpected argument '3'"]
