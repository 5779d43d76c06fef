"""Completion of command lines."""

from __future__ import annotations

import contextlib
import glob
import os
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Final

from crs_cc.debug.commands.command import Command, Completes
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.settings import SETTINGS
from crs_cc.debug.commands.stack import functions
from crs_cc.debug.commands.table import find, matching
from crs_cc.debug.data.notation import FUNCTIONS
from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import is_file
from crs_cc.debug.world.edits import FAULTS
from crs_cc.debug.world.events import KINDS
from crs_cc.ir.types import PointerType, RecordType
from crs_cc.sim.model.degradation import degradables

_LAST_EXPRESSION: Final = re.compile(r"(?:\b(?:struct|union|enum)\s+)?(?:[\w$.]|->|\[[^\[\]]*\])*$")
_MEMBER: Final = re.compile(r"(?P<base>.+)(?P<operator>\.|->)\w*")
_TAG: Final = re.compile(r"(?P<kind>struct|union|enum)\s+\w*")
_LAST_PART: Final = re.compile(r"\S*$")
_KEYWORD: Final = re.compile(r"(?<![\w.-])-?[a-z][a-z-]+")


_UNENDED: Final = ("/", ":", "(")
"""The characters after which a completed word continues."""


@dataclass(frozen=True, slots=True)
class Completion:
    """The completions of a line.

    Attributes:
        start: the start of the word to complete.
        words: its completions, sorted.
    """

    start: int
    words: tuple[str, ...]


def complete(context: CommandContext, text: str) -> Completion:
    """Return the completions of the last word of a line."""
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
    if not rest and not text.endswith(" "):
        return Completion(len(text), ())
    pattern = _LAST_EXPRESSION if command.completes == "expression" else _LAST_PART
    found = pattern.search(text)
    assert found
    settings = set(_settings(rest)) if command.name in {"set", "show"} else set()
    words = settings  # after the first word of one nothing else is meant
    if not settings or " " not in rest:
        words = settings | _keywords(command, found[0])
        if command.completes:
            words |= set(_ARGUMENTS[command.completes](context, found[0]))
    fitting = sorted(each for each in words if each.startswith(found[0]))
    return Completion(found.start(), tuple(fitting))


def ended(text: str) -> str:
    """Return a line or a word with its only completion, ready for the next word.

    >>> ended("continue"), ended("break wander.c:")
    ('continue ', 'break wander.c:')
    """
    return text if text.endswith(_UNENDED) else f"{text} "


def _keywords(command: Command, word: str) -> set[str]:
    """Return the words that a command's arguments may have, such as `once`; none for no word.

    >>> sorted(_keywords(find("goto")[0], "st"))
    ['end', 'output', 'start', 'stmt', 'tick']
    """
    return set(_KEYWORD.findall(command.syntax)) if word else set()


def _settings(beginning: str) -> Iterator[str]:
    """Return the next words of the settings whose names have a beginning.

    >>> sorted(_settings("print ")), sorted(_settings("li"))
    (['elements', 'pretty'], ['listsize'])
    """
    for each in SETTINGS:
        if each.name.startswith(beginning):
            yield each.name.split()[beginning.count(" ")]


def _setting(_context: CommandContext, _word: str) -> Iterable[str]:
    """Return nothing: names of settings depend on more than the last word, see `_settings`."""
    return ()


def _commands(_context: CommandContext, word: str) -> Iterable[str]:
    return matching(word)


def _places(context: CommandContext, word: str) -> Iterator[str]:
    """Return functions and files, and after a file its functions."""
    file, colon, _ = word.rpartition(":")
    for name, place in functions(context):
        if not colon or is_file(place.file, file):
            yield f"{file}{colon}{name}"
    for path in context.debugger.run.programs[context.debugger.view.robot].paths:
        yield f"{path.name}:"


def _expressions(context: CommandContext, word: str) -> Iterator[str]:
    """Return variables, functions and macros; members after an expression, tags after `struct`."""
    member, tag = _MEMBER.fullmatch(word), _TAG.fullmatch(word)
    if member is not None:
        yield from _members(context, member["base"], member["operator"])
        return
    if tag is not None:
        yield from _tags(context, tag["kind"])
        return
    if word.startswith("$"):
        yield from (f"${name}" for name in context.debugger.view.convenience_values if name)
        yield from (f"${name}(" for name in FUNCTIONS)
        return
    if word and context.debugger.view.vendor_state():
        yield "State"
    yield from _macros(context, word)
    with contextlib.suppress(DebugError):
        yield from (each.name for each in context.debugger.view.variables())
    yield from (each.name for each in context.debugger.view.globals_())
    yield from (name for name, _ in functions(context))


def _members(context: CommandContext, base: str, operator: str) -> Iterator[str]:
    """Return the members of an expression, with the expression."""
    with contextlib.suppress(DebugError):
        ctype = context.debugger.view.type_of(base)
        if operator == "->" and isinstance(ctype, PointerType):
            ctype = ctype.target
        if isinstance(ctype, RecordType):
            yield from (f"{base}{operator}{name}" for name in ctype.record.named)


def _tags(context: CommandContext, kind: str) -> Iterator[str]:
    with contextlib.suppress(DebugError):
        for _, ctype, name in context.debugger.view.file_names().types():
            if not name and str(ctype).startswith(f"{kind} "):
                yield str(ctype)


def _macros(context: CommandContext, word: str) -> Iterable[str]:
    """Return the names of macros; none for an empty word, as there are hundreds."""
    with contextlib.suppress(DebugError):
        return context.debugger.view.file_names().macros() if word else ()
    return ()


def _robots(context: CommandContext, _word: str) -> Iterable[str]:
    return context.debugger.names


def _breakpoints(context: CommandContext, _word: str) -> Iterable[str]:
    return [str(each.number) for each in context.debugger.stop_points.breakpoints]


def _displays(context: CommandContext, _word: str) -> Iterable[str]:
    return map(str, context.displays)


def _files(_context: CommandContext, word: str) -> Iterator[str]:
    for path in glob.glob(glob.escape(word) + "*"):  # noqa: PTH207 - as the user writes it
        yield path + "/" * os.path.isdir(path)  # noqa: PTH112


def _catches(_context: CommandContext, _word: str) -> Iterable[str]:
    return ("exit", *KINDS)


def _checkpoints(context: CommandContext, _word: str) -> Iterable[str]:
    return [str(each.number) for each in context.debugger.branches.current.checkpoints]


def _branches(context: CommandContext, _word: str) -> Iterable[str]:
    return context.debugger.branches.names()


def _edits(context: CommandContext, _word: str) -> Iterable[str]:
    """Return the words of changes to the world: names, devices and faults."""
    return (
        *context.debugger.session.environment.names,
        *degradables(),
        *FAULTS,
        "to",
        "from",
        "all",
    )


_ARGUMENTS: Final[dict[Completes, Callable[[CommandContext, str], Iterable[str]]]] = {
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
    "macro": _macros,
    "setting": _setting,
}
