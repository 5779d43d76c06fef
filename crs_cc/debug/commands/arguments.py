"""Parsing of command arguments."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError

MAX: Final = 1_000_000_000

_FORMAT: Final = re.compile(r"/(-?\d*)([a-z]*)\s*")
_LETTERS: Final = "xduotcfsaiz"
_SIZES: Final = {"b": 1, "h": 2, "w": 4, "g": 8}
_IF: Final = re.compile(r"(?:^|\s)if\b\s*(.*)$", re.DOTALL)
_OF_ROBOT: Final = re.compile(r"(?:^|\s)(?:robot|thread)\s+(\S+)\s*$")


@dataclass(frozen=True, slots=True)
class OutputFormat:
    """An output format: what follows the `/` of `print/x` and `x/4xw`.

    Attributes:
        letter: `x` hexadecimal, `d` signed, `u` unsigned, `o` octal, `t` binary, `c` character,
            `f` floating, `s` string, `a` address; empty for the default of the type.
        count: the number of units, for `x`.
        size: the size of a unit [bytes], 1 for characters, 0 for the default of the type.
    """

    letter: str = ""
    count: int = 1
    size: int = 0


def parse_format(text: str) -> tuple[OutputFormat, str]:
    """Parse `/FMT` at the start of an argument; return it and the rest.

    Raises:
        DebugError: it is malformed.

    >>> parse_format("/4xw &count")
    (OutputFormat(letter='x', count=4, size=4), '&count')
    """
    if not text.startswith("/"):
        return OutputFormat(), text
    found = _FORMAT.match(text)
    assert found
    digits, letters = found[1], found[2]
    sizes = [each for each in letters if each in _SIZES]
    letters = letters.replace("r", "")  # "raw": there are no pretty-printers to leave out
    shapes = [each for each in letters if each in _LETTERS]
    if len(sizes) > 1 or len(shapes) > 1 or len(sizes) + len(shapes) < len(letters):
        raise DebugError(f"'/{digits}{letters}' is not a format: try \"help x\"")
    size = _SIZES[sizes[0]] if sizes else int(shapes == ["c"])
    return OutputFormat("".join(shapes), _count(digits or "1"), size), text[found.end() :]


def parse_pattern(text: str) -> re.Pattern[str]:
    """Return a regular expression for names.

    Raises:
        DebugError: it is malformed.
    """
    try:
        return re.compile(text)
    except re.error as error:
        raise DebugError(f"'{text}' is not a regular expression: {error}") from None


def parse_count(text: str) -> int:
    """Return a repeat count; the default is 1.

    Raises:
        DebugError: it is not a count.

    >>> parse_count("3"), parse_count("")
    (3, 1)
    """
    return _count(text.strip() or "1")


def _count(digits: str) -> int:
    if not re.fullmatch(r"0*[1-9]\d{0,9}", digits) or int(digits) > MAX:
        raise DebugError(f"invalid count '{digits}' (expected 1 to {MAX:,})")
    return int(digits)


def parse_numbers(text: str, newest: int | None = None) -> list[int]:
    """Return a list of numbers and ranges, expanded in order; `$` or `$bpnum` is the newest.

    Raises:
        DebugError: it is malformed.

    >>> parse_numbers("1 4-6")
    [1, 4, 5, 6]
    """
    numbers: list[int] = []
    for word in text.replace(",", " ").split():
        if word in {"$", "$bpnum"} and newest is not None:
            numbers.append(newest)
            continue
        found = re.fullmatch(r"(\d{1,9})(?:-(\d{1,9}))?", word)
        if not found:
            raise DebugError(f"'{word}' is not a number; see \"info breakpoints\"")
        first, last = int(found[1]), int(found[2] or found[1])
        if not first <= last < first + 1000:
            raise DebugError(f"'{word}' is not a range of numbers")
        numbers += range(first, last + 1)
    return numbers


@dataclass(frozen=True, slots=True)
class BreakpointArguments:
    """The arguments of `break`.

    Attributes:
        place: the location, or the expression to watch.
        robot: the robot's name or number, empty for all of them.
        condition: the condition, empty for none.
    """

    place: str
    robot: str = ""
    condition: str = ""


def parse_breakpoint_arguments(text: str) -> BreakpointArguments:
    """Return location, robot and condition.

    >>> parse_breakpoint_arguments("wander.c:12 robot 1 if x > 3")
    BreakpointArguments(place='wander.c:12', robot='1', condition='x > 3')
    """
    condition = ""
    if found := _IF.search(text):
        text, condition = text[: found.start()], found[1].strip()
        if not condition:
            raise DebugError("'if' needs a C expression")
    robot = ""
    if found := _OF_ROBOT.search(text):
        text, robot = text[: found.start()], found[1]
    return BreakpointArguments(text.strip(), robot, condition)


def parse_robot(text: str, names: Sequence[str]) -> int:
    """Return the number of a robot from its name or number.

    Raises:
        DebugError: there is no such robot.

    >>> parse_robot("left", ["left", "right"]), parse_robot("1", ["left", "right"])
    (0, 1)
    """
    text = text.strip()
    if text in names:
        return names.index(text)
    if text.isascii() and text.isdigit() and len(text) < 9 and int(text) < len(names):
        return int(text)
    raise DebugError(unknown("robot", text, names))


def require_argument(text: str, what: str) -> str:
    """Return a required argument; raise DebugError if it is empty."""
    text = text.strip()
    if not text:
        raise DebugError(f"missing argument: {what}")
    return text


def reject_arguments(text: str) -> None:
    """Raise DebugError if a command has arguments."""
    if text.strip():
        raise DebugError(f"unexpected argument '{text.strip()}'")


def split_arguments(text: str) -> list[str]:
    r"""Split at commas outside of parentheses, brackets, strings and characters.

    >>> split_arguments('"a, b", f(x, y), z')
    ['"a, b"', 'f(x, y)', 'z']
    """
    parts, depth, start = [], 0, 0
    for token in re.finditer(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'|.', text, re.DOTALL):
        depth += (token[0] in "([{") - (token[0] in ")]}")
        if token[0] == "," and depth == 0:
            parts.append(text[start : token.start()].strip())
            start = token.end()
    return [*parts, text[start:].strip()]
