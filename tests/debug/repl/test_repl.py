from __future__ import annotations

import io
import weakref
from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.debug.repl.keyboard import Keyboard
from crs_cc.debug.repl.repl import Repl, Scripts
from crs_cc.debug.repl.terminal import Terminal
from crs_cc.runtime.fleet import Fleet
from tests.debug.debuggers import debugger_of

ENDLESS = "int i; int main(void) { for (;;) i++; }\n"


class Screen:
    """A prompt that nobody types at."""

    def __init__(self, source: str) -> None:
        self.stream = io.BytesIO()
        terminal = Terminal(self.stream, ["robot0"])
        self.keyboard = Keyboard(terminal)
        self.repl = Repl(debugger_of(source), terminal, self.keyboard)

    def at_log_points(self, do: Callable[[], None]) -> None:
        """Let something be done whenever a log point is passed."""
        self.repl.shell.debugger.stop_points.print_log = lambda _: do()

    def run(self, *commands: str, file: Path | None = None) -> list[str]:
        """Return the lines that are shown."""
        files = [] if file is None else [file]
        self.failed = self.repl.run(Scripts(files, commands), batch=True)
        return self.stream.getvalue().decode().splitlines()


@pytest.fixture
def endless() -> Screen:
    return Screen(ENDLESS)


def test_a_debugger_that_nobody_uses_is_freed_at_once_with_its_programs(
    tmp_path: Path, fleets: list[weakref.ref[Fleet]]
) -> None:
    """Whatever it has done: expressions of all kinds, stops, branches, scripts."""
    (tmp_path / "inner.dbg").write_text("print i\n")
    commands = [
        "break 1 if robot0::i > 2 && $_caller_is(\"main\", 0)", "log 1 i is {i}", "continue",
        "print $world.time", "print *&i", "info locals", f"source {tmp_path}/inner.dbg",
        "reverse-continue", "print i = 7", "branches", "whatis i",
    ]  # fmt: skip
    Screen(ENDLESS).run(*commands)
    assert [each() for each in fleets] == [None]


def test_ctrl_c_interrupts_the_run_and_the_script(endless: Screen) -> None:
    endless.at_log_points(endless.repl._interrupt)
    shown = endless.run("log 1 going on", "continue", "print 42")
    assert "Interrupted." in shown
    assert shown[-1] == "script interrupted"
    assert endless.failed == 1


def test_ctrl_c_interrupts_scripts_read_by_source(endless: Screen, tmp_path: Path) -> None:
    (tmp_path / "inner.dbg").write_text("continue\nprint 42\n")
    endless.at_log_points(endless.repl.shell.debugger.interrupt)
    shown = endless.run("log 1 going on", f"source {tmp_path}/inner.dbg", "print 43")
    assert "$1 = 43" in shown


def test_an_unreadable_script_is_a_failure(endless: Screen, tmp_path: Path) -> None:
    assert endless.run(file=tmp_path)[-1] == f"'{tmp_path}' cannot be read: Is a directory"
    assert endless.failed == 1


def test_log_messages_appear_in_order() -> None:
    screen = Screen("int i; int main(void)\n{\n i++;\n i++; return 0; }\n")
    shown = screen.run("log 4 i is {i}", "continue")
    assert shown[-2:] == [
        "i is 1",
        "All programs have ended: robot0 exited with 0. Step back, or quit.",
    ]
