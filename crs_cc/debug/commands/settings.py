"""The settings of the debugger: one table for `set`, `show` and the settings file.

Only a session at a terminal reads the file: what a script prints does not depend on it.

>>> settings = Settings()
>>> settings.change("listsize", "20")
>>> settings["listsize"], settings["history save"], parse_setting("listsize 20")[1]
(20, 1, '20')
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from crs_cc.core.suggest import unknown
from crs_cc.debug.commands.user_files import read_lines, write_lines
from crs_cc.debug.errors import DebugError

_SWITCH: Final = {"on": 1, "off": 0}
_UNLIMITED: Final = "unlimited"


@dataclass(frozen=True, slots=True)
class Setting:
    """A setting.

    Attributes:
        name: its name, maybe of two words.
        default: its value at first; 0 and 1 are off and on if it is a switch.
        summary: its meaning, in a line.
        lowest: the smallest value.
        highest: the largest value.
        is_switch: whether it is on or off.
    """

    name: str
    default: int
    summary: str
    lowest: int = 0
    highest: int = 1
    is_switch: bool = False

    def text(self, value: int) -> str:
        """Return a value as the user writes it."""
        if self.is_switch:
            return ("off", "on")[value]
        return _UNLIMITED if value == self.highest else str(value)

    def parse(self, text: str) -> int:
        """Return the value of a text; raise DebugError if it is invalid."""
        if self.is_switch:
            if text not in _SWITCH:
                raise DebugError(f"invalid value '{text}' of '{self.name}' (expected on or off)")
            return _SWITCH[text]
        if text == _UNLIMITED:
            return self.highest
        is_number = text.isascii() and text.isdigit() and len(text) < 10
        if not is_number or not self.lowest <= int(text) <= self.highest:
            wanted = f"{self.lowest} to {self.highest:,}"
            raise DebugError(f"invalid value '{text}' of '{self.name}' (expected {wanted})")
        return int(text)


SETTINGS: Final = (
    Setting("listsize", 10, "Number of source lines that list shows.", 1, 10_000),
    Setting("print elements", 200, "Number of array elements that print shows.", 1, 100_000),
    Setting(
        "print pretty", 0, "Whether print shows each member of a struct on a line.", is_switch=True
    ),
    Setting("backtrace limit", 100, "Number of frames that backtrace shows.", 1, 100_000),
    Setting("history save", 1, "Whether commands are kept in a file.", is_switch=True),
    Setting("history size", 1000, "Number of commands that the file keeps.", 0, 100_000),
)

WITHOUT_EFFECT: Final = {
    "confirm": "no command asks for confirmation",
    "pagination": "output is not paged",
    "height": "output is not paged",
    "width": "lines are as wide as the terminal",
    "args": "program arguments are given on the command line: crs debug wander.c -- 500",
    "breakpoint": "locations must exist when a breakpoint is set",
    "can-use-hw-watchpoints": "there are no hardware watchpoints, and none are needed",
    "commands": "the cursor keys and Ctrl-R find earlier commands",
    "cwd": "programs have no files",
    "disassembly-flavor": "there are no machine instructions",
    "environment": "programs have no environment",
    "exec-direction": 'each command has one that goes back, such as "reverse-step"',
    "follow-fork-mode": "programs cannot fork",
    "language": "the language is C",
    "logging": "use the terminal's, or redirect the output of a script",
    "max-value-size": 'see "print elements"',
    "output-radix": "print/x, print/o and print/t show other bases",
    "prompt": "the prompt is fixed",
    "radix": "print/x, print/o and print/t show other bases",
    "scheduler-locking": "all robots share one time",
    "startup-with-shell": "programs run in the simulator",
    "step-mode": "step enters functions that have source",
    "style": "the terminal determines the colours; NO_COLOR=1 disables them",
    "trace-commands": "scripts show their commands, unless crs debug has -q",
    "tui": "the full screen is laid out by the size of the terminal",
    "verbose": "there are no messages to add",
}
"""Settings that are common in gdb scripts, and why they have no effect here."""

_BY_NAME: Final = {each.name: each for each in SETTINGS}


def parse_setting(text: str) -> tuple[Setting | None, str]:
    """Return the setting at the start of a text, if any, and the rest."""
    words = text.split()
    for count in (2, 1):
        found = _BY_NAME.get(" ".join(words[:count]))
        if found is not None:
            return found, " ".join(words[count:])
    return None, text


class Settings:
    """The values of the settings."""

    def __init__(self) -> None:
        """Set all to their defaults."""
        self._values = {each.name: each.default for each in SETTINGS}
        self._kept: dict[str, int] = {}
        self._file: Path | None = None

    @property
    def values(self) -> Mapping[str, int]:
        """The values by name, now and later."""
        return self._values

    def __getitem__(self, name: str) -> int:
        return self._values[name]

    def change(self, name: str, text: str) -> None:
        """Set a value, and write it to the file that keeps the settings, if there is one.

        Raises:
            DebugError: the text is no value of this setting.
        """
        self._values[name] = value = _BY_NAME[name].parse(text)
        if self._file is not None:
            self._kept[name] = value
            write_lines(self._file, self._kept_lines())

    @contextmanager
    def temporarily(self, changes: Iterable[tuple[str, str]]) -> Iterator[None]:
        """Change settings by name; they have their old values afterwards.

        Raises:
            DebugError: there is no such setting, or the text is no value of it.
        """
        before = dict(self._values)
        try:
            for name, text in changes:
                if name not in _BY_NAME:
                    raise DebugError(unknown("setting", name, list(_BY_NAME)))
                self._values[name] = _BY_NAME[name].parse(text)
            yield
        finally:
            self._values.update(before)

    def load(self, path: Path) -> Iterator[str]:
        """Take over the values in a file; return a message for each line that is invalid."""
        for number, line in enumerate(read_lines(path), start=1):
            found, rest = parse_setting(line)
            if found is None:
                yield f"{path}:{number}: unknown setting '{line}'"
                continue
            try:
                self._values[found.name] = self._kept[found.name] = found.parse(rest)
            except DebugError as error:
                yield f"{path}:{number}: {error}"

    def save_to(self, path: Path | None) -> None:
        """Write changes from now on to a file."""
        self._file = path

    def _kept_lines(self) -> list[str]:
        return [
            f"{each.name} {each.text(self._kept[each.name])}"
            for each in SETTINGS
            if each.name in self._kept
        ]
