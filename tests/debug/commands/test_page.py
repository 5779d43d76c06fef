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

steps through a control program and its world together, forward and backward. Programs and worlds
are those of `crs run`, and so are the options, but for those that end or show a run (`--max-time`,
`--plot`, `--trace`, `--json`, `--summary`). The run stands still while you look: nothing in it
depends on how long you take, or on being watched. An error of a program always stops it.

**Screens.** On a terminal there is the full screen (`--tui`), where F1 tells the keys; `--repl` is
a plain prompt. Both take the commands below, and so does the debug console of an editor
([editors.md](editors.md)).

**Commands** have gdb's names. They can be shortened as long as it is clear which one is meant
(`reverse-c`), have the short names listed here (`rc`), and are completed by the tabulator key. An
empty line does the last one again if it moves the run or lists something. A mistake is answered in
one line, and changes nothing.

**Backward.** Programs and world go back together, to the byte; forward again, the same happens,
and what programs read is what they have read before. A line that is reached backward is reached at
its beginning. What programs had printed stays on the screen, and comes again; `output` shows what
has been written up to where the run stands.

**Other runs.** Where you change something (a variable, a place in the world) the run is another one
from there on: what was ahead is forgotten, what was before stays. `branch` keeps it.

**Several robots.** Each has its own program and functions; time is common. A breakpoint stops any
of them, unless it names one. Lines that they print begin with the robot's name.

**Instants.** `goto 12.3` is a time in seconds, `goto tick 120` the beginning of a timestep,
`goto stmt 40210` the instant before a statement of the robot's program, as `when` tells.

**Interrupting.** Ctrl-C stops what runs. Where a program waits for input, it ends the input. At the
prompt it drops what was typed, and Ctrl-D ends the debugger.

**Input.** What programs read is typed between the commands, or comes from `--input FILE`; it never
comes from a script.

**Scripts.** `-x FILE` and `-ex COMMAND` do commands first, `--batch` ends behind them: with status
0 if all of them could be done, else 1. A command that cannot be done does not keep the next ones
from being done. Lines that begin with `#` are comments. A script cannot start programs, nor write
to any file but those of `save breakpoints`.

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
