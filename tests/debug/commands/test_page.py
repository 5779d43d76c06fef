"""Writes `docs/debugger.md` from the table of commands. `--update-goldens` rewrites the page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.table import GROUPS

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "debugger.md"

INTRODUCTION = """\
<!-- made by tests/debug/commands/test_page.py of crs_cc/debug/commands; edit there,
     then pytest --update-goldens -->

# The debugger

    crs debug wander.c room.xml

steps through a control program and its world together, forward and backward. Programs, worlds
and options are those of `crs run`, except the options that end or show a run (`--max-time`,
`--plot`, `--trace`, `--json`, `--summary`). The run is paused while you inspect it: nothing in it
depends on how long you take, or on being observed. Runtime errors always stop the run.

**Screens.** On a terminal the default is the full screen (`--tui`), where F1 shows the keys;
`--repl` is a plain prompt. Both accept the commands below, and so does the debug console of an
editor ([editors.md](editors.md)).

**Commands** have gdb's names. They may be abbreviated as long as they are unambiguous
(`reverse-c`), have the aliases listed here (`rc`), and are completed by the tab key. An
empty line repeats the last command if it moves the run or lists something. An invalid command is
answered with a one-line message and changes nothing.

**Backward.** Programs and world go back together, to the byte; forward again, the same events
occur, and programs read the same input as before. A line that is reached backward is reached at
its start. Output of programs stays on the screen, and is repeated; `output` shows what
has been written up to the current position.

**Changes.** If you change something (a variable, a position in the world) a new history starts
there: the recorded future is discarded, the past is kept. `branch` keeps the old one.

**Several robots.** Each has its own program and stack; time is common. A breakpoint stops any
of them unless it names one. Lines that they print start with the robot's name.

**Times.** `goto 12.3` is a time in seconds, `goto tick 120` the start of a timestep,
`goto stmt 40210` the position before a statement of the robot's program, see `when`.

**Interrupting.** Ctrl-C interrupts the run. If a program waits for input, it ends the input. At the
prompt it discards the line, and Ctrl-D exits the debugger.

**Input.** Programs read what is typed between the commands, or `--input FILE`; they never
read from a script.

**Scripts.** `-x FILE` and `-ex COMMAND` execute commands first, `--batch` exits after them: with
status 0 if all of them succeeded, else 1. Execution continues after a command
that fails. Lines that start with `#` are comments. A script cannot start programs, nor write
to any files except those of `save breakpoints`.

    crs debug --batch -ex "break turn if speed > 100" -ex continue -ex backtrace wander.c room.xml

"""


def cell(text: str) -> str:
    """Return text that does not end a table's cell."""
    return text.replace("|", "\\|")


def row(command: Command) -> str:
    """Return a row of a table."""
    names = ", ".join(f"`{each}`" for each in command.aliases)
    said = " ".join(filter(None, [command.summary, command.text]))
    return f"| `{cell(command.usage)}` | {names} | {cell(said)} |"


def page() -> str:
    """Return the text of the page."""
    lines = []
    for group in GROUPS:
        lines += [f"## {group.name.capitalize()}\n", f"{group.summary}\n"]
        lines += ["| command | also | does |", "| --- | --- | --- |"]
        lines += [row(command) for command in group.commands]
        lines.append("")
    return INTRODUCTION + "\n".join(lines).rstrip("\n") + "\n"


def test_the_page_of_the_debugger_is_up_to_date(
    check_golden: Callable[[Path, bytes], None],
) -> None:
    check_golden(PAGE, page().encode())
