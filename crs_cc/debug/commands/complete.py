"""What can stand next on a command line."""

from __future__ import annotations

import contextlib
import glob
import os
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.command import Completes
from crs_cc.debug.commands.stack import functions
from crs_cc.debug.commands.table import find, matching
from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import is_file
from crs_cc.debug.world.edits import FAULTS
from crs_cc.debug.world.events import KINDS
from crs_cc.sim.model.degradation import DEVICES

if TYPE_CHECKING:
    from crs_cc.debug.commands.shell import Shell

_LAST_WORD: Final = re.compile(r"[\w.]*$")
_LAST_PART: Final = re.compile(r"\S*$")


@dataclass(frozen=True, slots=True)
class Completion:
    """What can stand at the end of a line.

    Attributes:
        start: where the word begins that is being written.
        words: what it can become, sorted.
    """

    start: int
    words: tuple[str, ...]


def complete(shell: Shell, text: str) -> Completion:
    """Gives what the last word of a line can become."""
    names = sorted(matching(text.lstrip()))
    start = len(text) - len(text.lstrip())
    if names:
        if " " in text.strip():  # the second word of `info locals`
            start = text.rindex(" ") + 1
            names = [each.split()[1] for each in names]
        return Completion(start, tuple(dict.fromkeys(names)))
    try:
        command, rest = find(text)
    except DebugError:
        return Completion(len(text), ())
    if not command.completes or (not rest and not text.endswith(" ")):
        return Completion(len(text), ())
    pattern = _LAST_WORD if command.completes == "expression" else _LAST_PART
    found = pattern.search(text)
    assert found
    words = set(_ARGUMENTS[command.completes](shell, found[0]))
    fitting = sorted(each for each in words if each.startswith(found[0]))
    return Completion(found.start(), tuple(fitting))


def _commands(_shell: Shell, word: str) -> Iterable[str]:
    return matching(word)


def _places(shell: Shell, word: str) -> Iterator[str]:
    """Gives functions and files, and behind a file its functions."""
    file, colon, _ = word.rpartition(":")
    for name, place in functions(shell):
        if not colon or is_file(place.file, file):
            yield f"{file}{colon}{name}"
    for path in shell.debugger.run.programs[shell.debugger.view.robot].paths:
        yield f"{path.name}:"


def _expressions(shell: Shell, _word: str) -> Iterator[str]:
    with contextlib.suppress(DebugError):
        yield from (each.name for each in shell.debugger.view.variables())
    yield from (each.name for each in shell.debugger.view.globals_())
    yield from (name for name, _ in functions(shell))


def _robots(shell: Shell, _word: str) -> Iterable[str]:
    return shell.debugger.names


def _breakpoints(shell: Shell, _word: str) -> Iterable[str]:
    return [str(each.number) for each in shell.debugger.stop_points.breakpoints]


def _displays(shell: Shell, _word: str) -> Iterable[str]:
    return map(str, shell.displays)


def _files(_shell: Shell, word: str) -> Iterator[str]:
    for path in glob.glob(glob.escape(word) + "*"):  # noqa: PTH207 - as the user writes it
        yield path + "/" * os.path.isdir(path)  # noqa: PTH112


def _catches(_shell: Shell, _word: str) -> Iterable[str]:
    return ("exit", *KINDS)


def _checkpoints(shell: Shell, _word: str) -> Iterable[str]:
    return [str(each.number) for each in shell.debugger.branches.current.checkpoints]


def _branches(shell: Shell, _word: str) -> Iterable[str]:
    return shell.debugger.branches.names()


def _edits(shell: Shell, _word: str) -> Iterable[str]:
    """Gives what changes of the world are about: names, devices and faults."""
    return (*shell.debugger.session.environment.names, *DEVICES, *FAULTS, "to", "from", "all")


_ARGUMENTS: Final[dict[Completes, Callable[[Shell, str], Iterable[str]]]] = {
    "command": _commands,
    "place": _places,
    "expression": _expressions,
    "robot": _robots,
    "breakpoint": _breakpoints,
    "display": _displays,
    "file": _files,
    "catch": _catches,
    "checkpoint": _checkpoints,
    "branch": _branches,
    "edit": _edits,
}
