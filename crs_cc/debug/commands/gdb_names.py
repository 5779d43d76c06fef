"""Correspondence between the commands and gdb's.

>>> gdb_name("info globals"), gdb_name("finish"), gdb_name("goto")
('info variables', 'finish', '')
"""

from __future__ import annotations

from typing import Final

from crs_cc.debug.commands.table import GROUPS

_FROM_GDB: Final = frozenset(
    {"running", "breakpoints", "data", "stack", "symbols", "scripts", "support"}
)
"""The groups of commands that have the names, and the meaning, that gdb's have."""

_OWN: Final = frozenset({"tick", "reverse-tick", "goto", "wwatch", "log"})
"""The commands of those groups that gdb does not have."""

_OTHERS: Final = {
    "info globals": "info variables",
    "robots": "info threads",
    "robot": "thread",
    "checkpoint": "checkpoint",
    "restart": "restart",
    "info checkpoints": "info checkpoints",
}
"""Commands that gdb has by another name, or that are in another group."""

_MIN_LENGTH: Final = 3
"""Shorter abbreviations of commands that do not exist are not recognised."""

LACKING: Final = (
    (
        "attach, detach, kill, disconnect, inferior, info inferiors, target, info proc",
        "programs run in the simulator, and end with the debugger",
    ),
    (
        "file, exec-file, core-file, symbol-file, load, generate-core-file, gcore, info files",
        "start the debugger with other files; `save run.mcap` saves a run",
    ),
    (
        "cd, pwd, directory, path, info sharedlibrary",
        "file names are given on the command line; all sources are known",
    ),
    ("edit, make", "edit and build in your editor; see docs/editors.md"),
    (
        "set args, show args, run ARGS",
        "give arguments on the command line: `crs debug wander.c -- 500`",
    ),
    ("record, record stop, info record", "the whole run is always recorded"),
    (
        "info registers, info all-registers, disassemble, compile",
        "`crs compile --emit wat` prints a program's code",
    ),
    (
        "handle, info signals, signal, queue-signal",
        "programs receive only signals that they send to themselves",
    ),
    ("interrupt", "Ctrl-C stops a running program"),
    ("bookmark, goto-bookmark, info bookmarks", "see `checkpoint`, `restart` and `note`"),
    (
        "trace, tstart, tstop, tstatus, actions, collect, ftrace, strace",
        "`log` and `history` give this information without tracepoints",
    ),
    (
        "dump, append, restore",
        "scripts by others must not be able to write files; `x` shows memory, `set` changes it",
    ),
    ("find, explore", "`x` and `print` show memory and its objects"),
    (
        "macro define, macro list, macro undef, info macros",
        "macros are those of the source: see `info macro` and `macro expand`",
    ),
    ("hbreak, thbreak", "use `break` and `tbreak`: there are no hardware breakpoints"),
    ("tui, layout, focus, refresh, winheight", "`crs debug --tui` starts in full-screen mode"),
    ("return", "set the variable on which the result depends, or go back"),
    (
        "define, document, alias, if, while, python, py, guile, pipe",
        "scripts can contain only debugger commands; see `source`",
    ),
)
"""Commands that gdb has and we do not, and what to do or to know."""


def unsupported_reason(text: str) -> str:
    """Return why a line of gdb is no command here, and what to do; "" if there is nothing to say.

    >>> print(unsupported_reason("disas main"))
    'disassemble' does not exist here: "crs compile --emit wat" prints a program's code
    """
    words = text.split()
    for names, reason in LACKING:
        for name in names.split(", "):
            parts = name.split()
            pairs = zip(words, parts, strict=False)
            if len(words) >= len(parts) and all(_abbreviates(*pair) for pair in pairs):
                quoted = reason.replace("`", '"')
                return f"'{name}' does not exist here: {quoted}"
    return ""


def _abbreviates(word: str, name: str) -> bool:
    return word == name or (len(word) >= _MIN_LENGTH and name.startswith(word))


def gdb_name(command: str) -> str:
    """Return gdb's name of a command; "" if gdb has no such command."""
    if command in _OTHERS:
        return _OTHERS[command]
    group = next(each for each in GROUPS if any(one.name == command for one in each.commands))
    return command if group.name in _FROM_GDB and command not in _OWN else ""
