"""Keyboard shortcuts: the table for bindings, button bar and help page.

Function keys work everywhere, letters outside the command line. Terminals reserve some keys
(often F1, F10 and F11), so every action has a letter and a command, too.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Shortcut:
    """A keyboard shortcut.

    Attributes:
        keys: Textual's names of the keys that work everywhere, with commas between them.
        letter: the key for it outside the command line.
        shown: the display name of the first key.
        label: its label in the button bar; empty to omit it there.
        command: the debugger's command, or empty if `action` does it.
        action: the screen's own action.
        meaning: its description on the help page.
    """

    keys: str = ""
    letter: str = ""
    shown: str = ""
    label: str = ""
    command: str = ""
    action: str = ""
    meaning: str = ""


SHORTCUTS: Final = (
    Shortcut("f1", "question_mark", "F1", "help", action="help", meaning="this help"),
    Shortcut("f5", "c", "F5", "go", "continue", meaning="run to the next stop"),
    Shortcut(
        "f6,shift+f5,f17",
        "C",
        "F6",
        "back",
        "reverse-continue",
        meaning="run back to the previous stop",
    ),
    Shortcut("f10", "n", "F10", "next", "next", meaning="step over"),
    Shortcut("f8,shift+f10,f22", "N", "F8", "prev", "reverse-next", meaning="step over, backward"),
    Shortcut("f11", "s", "F11", "step", "step", meaning="step into"),
    Shortcut(
        "f7,shift+f11,f23", "S", "F7", "unstep", "reverse-step", meaning="step into, backward"
    ),
    Shortcut("f9", "b", "F9", "break", action="breakpoint", meaning="breakpoint at this line"),
    Shortcut("ctrl+q", "", "^Q", "quit", action="quit", meaning="quit"),
    Shortcut("f12", "f", "F12", "finish", "finish", meaning="run until the function returns"),
    Shortcut("shift+f12,f24", "F", command="reverse-finish", meaning="run back to the call"),
    Shortcut("", "h", action="here", meaning="run to this line"),
    Shortcut("", "o", action="file", meaning="next source file"),
    Shortcut("", "slash", action="search", meaning="search the source"),
    Shortcut("", "t", command="tick", meaning="one timestep forward"),
    Shortcut("", "T", command="reverse-tick", meaning="one timestep back"),
    Shortcut("", "u", command="up", meaning="select the caller"),
    Shortcut("", "d", command="down", meaning="select the callee"),
    Shortcut("f4", "z", "F4", "zoom", action="zoom", meaning="maximise the pane, or restore"),
    Shortcut("f2", "", "F2", "pane", action="pane(1)", meaning="next lower pane"),
    Shortcut("f3", "", action="pane(-1)", meaning="previous lower pane"),
    Shortcut("escape", "colon", action="type", meaning="command line on or off"),
    Shortcut("ctrl+c", "", "^C", "stop", action="interrupt", meaning="interrupt"),
)
"""All shortcuts; Shift with a function key is sent as the key 12 further by many terminals."""

_LETTERS: Final = {"question_mark": "?", "colon": ":", "slash": "/"}


def help_rows() -> list[tuple[str, str, str]]:
    """Return keys, command and meaning of each shortcut."""
    rows = []
    for each in SHORTCUTS:
        named = [_key_name(key) for key in each.keys.split(",") if key and key[-2:] not in _HIDDEN]
        letter = _LETTERS.get(each.letter, each.letter)
        rows.append((" ".join(filter(None, [*named, letter])), each.command, each.meaning))
    return rows


_HIDDEN: Final = ("17", "22", "23", "24")
"""Function keys that terminals send for Shift with another one."""


def _key_name(key: str) -> str:
    """Return the display name of a key.

    >>> _key_name("shift+f5"), _key_name("ctrl+c"), _key_name("escape")
    ('Shift-F5', 'Ctrl-C', 'Escape')
    """
    return "-".join(part.capitalize() for part in key.split("+"))
