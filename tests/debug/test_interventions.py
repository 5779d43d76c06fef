"""What the user has done to a run is listed in its order, and taken back."""

from __future__ import annotations

import pytest

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.errors import DebugError
from crs_cc.debug.interventions import interventions, revert
from tests.debug.debuggers import debugger_of

ADD = """\
#include <stdio.h>
#include <unistd.h>
int total;
int main(void)
{
    int n, i;
    for (i = 0; i < 3; i++) {
        if (scanf("%d", &n) != 1)
            break;
        usleep(200000);
        total += n;
        printf("total %d\\n", total);
    }
    return total;
}
"""


class User:
    """Types lines when asked."""

    def __init__(self, *lines: str) -> None:
        self.lines = [f"{line}\n".encode() for line in lines]
        self.asked = 0

    def read(self, _robot: int, _wanted: int) -> bytes:
        self.asked += 1
        return self.lines.pop(0) if self.lines else b""


def session(user: User, *, is_typed: bool = True) -> Shell:
    debugger = debugger_of(ADD, read=user.read)
    debugger.run.console.is_typed = is_typed
    return Shell(debugger)


def said(shell: Shell, command: str) -> list[str]:
    return [line.text for line in shell.execute(command)]


def test_changes_and_typed_lines_are_listed_in_the_order_of_the_run() -> None:
    shell = session(User("1", "2", "3"))
    said(shell, "break 11")
    said(shell, "run")
    said(shell, "set var total = 100")
    said(shell, "continue")
    assert [each.split("  ")[-1] for each in said(shell, "info edits")] == [
        'robot0: typed "1"', "robot0: total = 100", 'robot0: typed "2"',
    ]  # fmt: skip


def test_a_mistyped_line_is_requested_again() -> None:
    user = User("1", "22", "3", "2", "5", "6")
    shell = session(user)
    said(shell, "continue")
    assert shell.debugger.session.exit_status(0) == 26
    said(shell, "undo 2")
    assert len(interventions(shell.debugger)) == 1
    assert shell.debugger.view.evaluate_pure("total").number == 1
    said(shell, "continue")
    assert (shell.debugger.session.exit_status(0), user.asked) == (1 + 2 + 5, 5)


def test_the_first_line_can_be_taken_back() -> None:
    user = User("1", "2", "3", "7", "8", "9")
    shell = session(user)
    said(shell, "continue")
    revert(shell.debugger, 0)
    said(shell, "continue")
    assert shell.debugger.session.exit_status(0) == 7 + 8 + 9
    with pytest.raises(DebugError):
        revert(shell.debugger, 3)


def test_a_change_before_a_line_stays_when_that_is_taken_back() -> None:
    shell = session(User("1", "2", "3", "50"))
    said(shell, "break 11")
    said(shell, "run")
    said(shell, "set var total = 100")
    said(shell, "continue")
    said(shell, "undo 3")
    assert len(interventions(shell.debugger)) == 2
    said(shell, "delete")
    said(shell, "continue")
    assert shell.debugger.session.exit_status(0) == 100 + 1 + 3 + 50


def test_run_begins_anew_unless_it_is_to_keep_what_was_done() -> None:
    user = User("1", "2", "3", "10", "20", "30")
    shell = session(user)
    said(shell, "set var total = 1000")
    said(shell, "continue")
    assert said(shell, "run -keep")[0] != ""
    assert (shell.debugger.session.exit_status(0), user.asked) == (1006 & 255, 3)
    assert said(shell, "run")[0].startswith("Discarded 4 changes")
    assert (shell.debugger.session.exit_status(0), user.asked) == (60, 6)
    assert said(shell, "run nothing") == ["unexpected argument 'nothing' (expected -keep)"]


def test_input_of_a_file_is_read_again_and_not_listed() -> None:
    user = User("1", "2", "3")
    shell = session(user, is_typed=False)
    said(shell, "set var total = 1000")
    said(shell, "continue")
    assert [each.text for each in interventions(shell.debugger)] == ["total = 1000"]
    said(shell, "run")
    assert (shell.debugger.session.exit_status(0), user.asked) == (6, 3)
