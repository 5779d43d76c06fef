r"""Convenience functions that need the debugger: their calls are replaced by what they return.

Those that are functions of C under another name are in `notation.FUNCTIONS`.

>>> calls_in('$_regex(name, "a(.*") && x == 1')
[Call(name='_regex', arguments=('name', '"a(.*"'), start=0, end=21)]
>>> checkable('$_regex(name, "a(.*") && x == $_thread')
'1 && x == 1'
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.debug.data.notation import tokens
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.ir.names import plain_name
from crs_cc.ir.types import ArrayType, EnumType, PointerType, VoidType
from crs_cc.runtime.diagnosis.inspect import StackFrame

_STRING: Final = r'"(?:[^"\\]|\\.)*"'
_UNSET: Final = re.compile(r"\s*\$([A-Za-z_]\w*)\s*")
MAX_TEXT: Final = 1000
"""Longer texts are truncated to this length [bytes]."""


@dataclass(frozen=True, slots=True)
class Call:
    """A call of a convenience function, or the use of a value.

    Attributes:
        name: the name without the dollar.
        arguments: the arguments as they are written.
        start: where it begins in the expression.
        end: where it ends.
    """

    name: str
    arguments: tuple[str, ...]
    start: int
    end: int


class ConvenienceFunctions:
    """The convenience functions for expressions in one robot's program."""

    def __init__(
        self,
        evaluate: Callable[[str, StackFrame | None], Value],
        stack: Sequence[StackFrame],
        robot: int,
        settings: Mapping[str, int],
    ) -> None:
        """Store the data that the functions need.

        Args:
            evaluate: evaluates an argument.
            stack: the frames of the program, innermost first.
            robot: the number of the robot.
            settings: the values of the settings of the debugger by name.
        """
        self._evaluate = evaluate
        self._stack = stack
        self._robot = robot
        self._settings = settings

    def expanded(self, text: str, frame: StackFrame | None) -> str:
        """Return an expression with the calls replaced by their values.

        Raises:
            DebugError: an argument is missing or invalid.
        """
        if "$" not in text:
            return text
        return _replaced(text, lambda call: _literal(self._value(call, frame)))

    def _value(self, call: Call, frame: StackFrame | None) -> int | str:
        least, most, function = _FUNCTIONS[call.name]
        if not least <= len(call.arguments) <= most:
            wanted = str(least) if least == most else f"{least} or {most}"
            raise DebugError(f"${call.name} expects {wanted} arguments, not {len(call.arguments)}")
        return function(self, call.arguments, frame)

    def _text(self, argument: str, frame: StackFrame | None) -> str:
        """Return the text that an argument is or points to."""
        value = self._evaluate(argument, frame)
        if isinstance(value.type, ArrayType):
            content = value.content
        elif isinstance(value.type, PointerType) and isinstance(value.number, int):
            content = value.inspector.read(value.number, MAX_TEXT)
        else:
            raise DebugError(f"'{argument}' is not a string")
        return content.partition(b"\0")[0].decode(errors="replace")

    def _whole(self, arguments: Sequence[str], frame: StackFrame | None) -> int:
        """Return the second argument, a number of frames; 1 if there is none."""
        if len(arguments) == 1:
            return 1
        number = self._evaluate(arguments[1], frame).number
        if not isinstance(number, int) or number < 0:
            raise DebugError(f"'{arguments[1]}' is not a number of frames")
        return number

    def _names(self, frame: StackFrame | None) -> list[str]:
        """Return the names of the functions from a frame outward."""
        first = next((at for at, each in enumerate(self._stack) if each is frame), 0)
        return [plain_name(each.function) for each in self._stack[first:]]

    # -- the functions -------------------------------------------------------------------------

    def _regex(self, arguments: Sequence[str], frame: StackFrame | None) -> int:
        text, pattern = (self._text(each, frame) for each in arguments)
        return int(_pattern(pattern).search(text) is not None)

    def _as_string(self, arguments: Sequence[str], frame: StackFrame | None) -> str:
        value = self._evaluate(arguments[0], frame)
        if not isinstance(value.type, EnumType):
            raise DebugError(f"'{arguments[0]}' is not a value of an enumeration")
        return value.text

    def _isvoid(self, arguments: Sequence[str], frame: StackFrame | None) -> int:
        return int(isinstance(self._evaluate(arguments[0], frame).type, VoidType))

    def _caller_is(self, arguments: Sequence[str], frame: StackFrame | None) -> int:
        wanted = self._text(arguments[0], frame)
        return int(self._caller(arguments, frame) == wanted)

    def _caller_matches(self, arguments: Sequence[str], frame: StackFrame | None) -> int:
        pattern, caller = self._text(arguments[0], frame), self._caller(arguments, frame)
        return int(caller is not None and _pattern(pattern).match(caller) is not None)

    def _caller(self, arguments: Sequence[str], frame: StackFrame | None) -> str | None:
        names, number = self._names(frame), self._whole(arguments, frame)
        return names[number] if number < len(names) else None

    def _any_caller_is(self, arguments: Sequence[str], frame: StackFrame | None) -> int:
        wanted, number = self._text(arguments[0], frame), self._whole(arguments, frame)
        return int(wanted in self._names(frame)[: number + 1])

    def _any_caller_matches(self, arguments: Sequence[str], frame: StackFrame | None) -> int:
        pattern, number = self._text(arguments[0], frame), self._whole(arguments, frame)
        names = self._names(frame)[: number + 1]
        return int(any(_pattern(pattern).match(each) for each in names))

    def _gdb_setting(self, arguments: Sequence[str], frame: StackFrame | None) -> int:
        name = self._text(arguments[0], frame)
        if name not in self._settings:
            raise DebugError(f"unknown setting '{name}'")
        return self._settings[name]

    def _thread(self, _arguments: Sequence[str], _frame: StackFrame | None) -> int:
        return self._robot

    def _inferior(self, _arguments: Sequence[str], _frame: StackFrame | None) -> int:
        return 1


_Function = Callable[[ConvenienceFunctions, Sequence[str], "StackFrame | None"], "int | str"]
_FUNCTIONS: Final[dict[str, tuple[int, int, _Function]]] = {
    "_regex": (2, 2, ConvenienceFunctions._regex),
    "_as_string": (1, 1, ConvenienceFunctions._as_string),
    "_isvoid": (1, 1, ConvenienceFunctions._isvoid),
    "_caller_is": (1, 2, ConvenienceFunctions._caller_is),
    "_caller_matches": (1, 2, ConvenienceFunctions._caller_matches),
    "_any_caller_is": (1, 2, ConvenienceFunctions._any_caller_is),
    "_any_caller_matches": (1, 2, ConvenienceFunctions._any_caller_matches),
    "_gdb_setting": (1, 1, ConvenienceFunctions._gdb_setting),
    "_thread": (0, 0, ConvenienceFunctions._thread),
    "_inferior": (0, 0, ConvenienceFunctions._inferior),
}
"""By name, the fewest and the most arguments, and what is done."""

_VALUES: Final = frozenset({"_thread", "_inferior"})
"""Those that are written without parentheses."""
_CALLED: Final = "|".join(sorted(set(_FUNCTIONS) - _VALUES, key=len, reverse=True))
_USE: Final = re.compile(
    rf"{_STRING}|\$(?:(?P<call>{_CALLED})\s*(?P<opened>\()|(?P<value>{'|'.join(_VALUES)})\b)"
)


def calls_in(text: str) -> list[Call]:
    """Return the outermost calls in an expression."""
    return list(_calls(text))


def _calls(text: str) -> Iterator[Call]:
    at = 0
    while (found := _USE.search(text, at)) is not None:
        at = found.end()
        if found["value"]:
            yield Call(found["value"], (), found.start(), at)
        elif found["call"]:
            arguments, at = _arguments(text, found.start("opened"))
            yield Call(found["call"], arguments, found.start(), at)


def _arguments(text: str, opened: int) -> tuple[tuple[str, ...], int]:
    """Return the arguments in parentheses that open at a place, and where these end."""
    rest, first, found = text[opened:], 1, list[str]()
    for symbol, at, depth in tokens(rest):
        if depth == 1 and symbol == ",":
            found.append(rest[first:at].strip())
            first = at + 1
        elif depth == 0 and symbol == ")":
            return (*found, rest[first:at].strip()), opened + at + 1
    raise DebugError("')' is missing")


def checkable(text: str) -> str:
    """Return an expression with the calls replaced by values of their types."""
    return _replaced(text, lambda call: '""' if call.name == "_as_string" else "1")


def _replaced(text: str, value: Callable[[Call], str]) -> str:
    pieces, at = [], 0
    for call in calls_in(text):
        pieces += [text[at : call.start], value(call)]
        at = call.end
    return "".join([*pieces, text[at:]])


def unset_variable(text: str, known: Mapping[str, object]) -> str | None:
    """Return the convenience variable that an expression is, if that has no value."""
    found = _UNSET.fullmatch(text)
    is_unset = found is not None and not {found[1]} & {*known, *_VALUES, "world"}
    return found[1] if found is not None and is_unset else None


def _pattern(text: str) -> re.Pattern[str]:
    try:
        return re.compile(text)
    except re.error as wrong:
        raise DebugError(f"invalid regular expression '{text}': {wrong}") from None


def _literal(value: int | str) -> str:
    """Return a value as C writes it."""
    if isinstance(value, int):
        return str(value)
    escaped = "".join(
        f"\\{each:03o}" if each < 32 or each in b'"\\' else chr(each)
        for each in value.encode("ascii", "replace")
    )
    return f'"{escaped}"'
