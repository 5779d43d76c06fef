"""Extensions of C expressions: slices, qualified names, convenience names, and the world.

>>> slice_in("a[i + 1..5]"), slice_in("*p@4"), slice_in("a[1]")
(Slice(base='a', first='i + 1', last='5'), Slice(base='*p', first='4', last=''), None)
>>> rewritten("turn::count + 'map.c'::size - $speed")[0]
'__crs_0 + __crs_1 - __crs_2'
>>> rewritten("'map.c'::size - $speed")[1]
(QualifiedName(inside='map.c', name='size'), ConvenienceVariable(name='speed'))
>>> rewritten('$_streq(name, "left")')
('!__builtin_strcmp(name, "left")', ())
>>> rewritten("robot1::tab[i].x > $world.bin.x", {"robot1"}.__contains__)
('__crs_0 > __crs_1', (RobotName(robot='robot1', text='tab[i].x'), WorldName(path=('bin', 'x'))))
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Final, TypeAlias

_STRING: Final = r'"(?:[^"\\]|\\.)*"'
_CHARACTER: Final = r"'(?:[^'\\]|\\.)*'"
_IDENTIFIER: Final = r"[A-Za-z_]\w*"
_OUTER: Final = (
    rf"(?:'(?P<quoted>[^'\n]+)'|(?P<path>(?:[\w.-]+/)*[\w.-]+\.[ch])|(?P<function>{_IDENTIFIER}))"
    rf"::(?P<name>{_IDENTIFIER}|'|\()"
)
_OBJECT: Final = rf"(?:{_IDENTIFIER}|'[^'\n]+')"
_WORLD: Final = (
    rf"\$world\b(?:\s*\.\s*distance\s*\(\s*(?P<one>{_OBJECT})\s*,\s*(?P<other>{_OBJECT})\s*\)"
    rf"|(?P<steps>(?:\s*\.\s*{_OBJECT}){{0,2}}))"
)

FUNCTIONS: Final = {
    "_strlen": "__builtin_strlen",
    "_streq": "!__builtin_strcmp",
    "_memeq": "!__builtin_memcmp",
}
"""The convenience functions, which need not be declared in the program, and what they are in C."""

_CALLED: Final = rf"\$(?P<called>{'|'.join(FUNCTIONS)})(?=\s*\()"
_SPECIAL: Final = re.compile(
    rf"{_STRING}|{_WORLD}|{_OUTER}|{_CHARACTER}|{_CALLED}|\$(?P<kept>\$?\w*)"
)
_BARE: Final = re.compile(
    rf"{_STRING}|(?<![\w.$])(?<!->)(?<!::)(?:(?P<object>{_OBJECT})(?=\s*\.\s*[A-Za-z_])"
    rf"|distance\s*\(\s*(?P<one>{_OBJECT})\s*,\s*(?P<other>{_OBJECT})\s*\))|{_CHARACTER}"
)
_PRIMARY: Final = re.compile(rf"(?:{_OBJECT}::)?{_IDENTIFIER}")
_MEMBER: Final = re.compile(rf"\s*(?:\.(?!\.)|->)\s*{_IDENTIFIER}")
_OPEN: Final = re.compile(r"\s*\[")
_TOKEN: Final = re.compile(rf"{_STRING}|{_CHARACTER}|\.\.\.|\.\.|.", re.DOTALL)
_SETS: Final = re.compile(r"\s*\$([A-Za-z_]\w*)\s*=(?!=)(.*)", re.DOTALL)

NAME: Final = "__crs_{}"
"""The C text for names that C does not have."""


@dataclass(frozen=True, slots=True)
class Slice:
    """A slice: `base[first..last]`, or `base@first` if there is no `last`."""

    base: str
    first: str
    last: str


@dataclass(frozen=True, slots=True)
class QualifiedName:
    """`inside::name`: a variable of another function, or of a file."""

    inside: str
    name: str


@dataclass(frozen=True, slots=True)
class ConvenienceVariable:
    """`$name`: a convenience variable; the last value has no name, `$$2` the name `$2`."""

    name: str


@dataclass(frozen=True, slots=True)
class WorldName:
    """`$world.time`, `$world.robot0.x`; or all values of the world or of an object."""

    path: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class WorldDistance:
    """`$world.distance(one, other)`: the distance of two objects."""

    one: str
    other: str


@dataclass(frozen=True, slots=True)
class RobotName:
    """`robot::operand`: an expression in the program of a robot."""

    robot: str
    text: str


ExternalName: TypeAlias = WorldName | WorldDistance | RobotName
"""What does not belong to the program whose expression it is."""

SpecialName: TypeAlias = QualifiedName | ConvenienceVariable | ExternalName


def slice_in(text: str) -> Slice | None:
    """Parse a slice; return None for other expressions."""
    text, opened = text.strip(), -1
    for symbol, start, depth in tokens(text):
        if depth == 0 and symbol == "@":
            return Slice(text[:start].strip(), text[start + 1 :].strip(), "")
        if depth == 0 and symbol == "[":
            opened = start
    if opened < 0 or not text.endswith("]"):
        return None
    inside = text[opened + 1 : -1]
    for symbol, start, depth in tokens(inside):
        if symbol == ".." and depth == 0:
            first, last = inside[:start].strip(), inside[start + 2 :].strip()
            return Slice(text[:opened].strip(), first, last)
    return None


def tokens(text: str) -> Iterator[tuple[str, int, int]]:
    """Return the tokens with their offsets and the depth of parentheses."""
    depth = 0
    for match in _TOKEN.finditer(text):
        token = match[0]
        depth -= token in {")", "]", "}"}
        yield token, match.start(), depth
        depth += token in {"(", "[", "{"}


def convenience_assignment(text: str) -> tuple[str, str] | None:
    """Parse `$name = expression`; return None for other expressions."""
    match = _SETS.fullmatch(text)
    return None if match is None else (match[1], match[2].strip())


def _nothing(_name: str) -> bool:
    return False


def rewritten(
    text: str, is_robot: Callable[[str], bool] = _nothing
) -> tuple[str, tuple[SpecialName, ...]]:
    """Return an expression in C, and the meanings of its names `__crs_0`, `__crs_1` and so on.

    Args:
        text: the expression.
        is_robot: returns whether `name::` refers to the program of a robot.
    """
    if "::" not in text and "$" not in text:
        return text, ()
    found: list[SpecialName] = []
    pieces, at = [], 0
    while match := _SPECIAL.search(text, at):
        name, end = _special_name(match, is_robot)
        pieces.append(text[at : match.start()])
        called = FUNCTIONS.get(match["called"] or "", match[0])
        pieces.append(called if name is None else NAME.format(len(found)))
        found += [] if name is None else [name]
        at = end
    return "".join([*pieces, text[at:]]), tuple(found)


def _special_name(
    match: re.Match[str], is_robot: Callable[[str], bool]
) -> tuple[SpecialName | None, int]:
    """Return the name that a match of `_SPECIAL` is, None for C, and where it ends."""
    inside = match["quoted"] or match["path"] or match["function"]
    if inside is not None and is_robot(inside):
        start = match.start("name")
        end = operand_end(match.string, start)
        return RobotName(inside, match.string[start:end]), end
    if inside is not None:
        is_name = match["name"].isidentifier()
        return (QualifiedName(inside, match["name"]) if is_name else None), match.end()
    if match["one"] is not None:
        return WorldDistance(match["one"].strip("'"), match["other"].strip("'")), match.end()
    if match["steps"] is not None:
        steps = re.findall(_OBJECT, match["steps"])
        return WorldName(tuple(each.strip("'") for each in steps)), match.end()
    kept = match["kept"]
    return (None if kept is None else ConvenienceVariable(kept)), match.end()


def operand_end(text: str, start: int) -> int:
    """Return the end of an operand: a name or parentheses, and members and elements of that."""
    primary = _PRIMARY.match(text, start)
    end = _closing(text, start) if text[start] == "(" else primary.end() if primary else start
    while True:
        member, opened = _MEMBER.match(text, end), _OPEN.match(text, end)
        if member is not None:
            end = member.end()
        elif opened is not None:
            end = _closing(text, opened.end() - 1)
        else:
            return end


def _closing(text: str, start: int) -> int:
    """Return the end of the bracket that opens at a place; that of the text if it is not closed."""
    rest = text[start:]
    ends = (at + len(token) for token, at, depth in tokens(rest) if depth == 0 and at)
    return start + next(ends, len(rest))


def with_world(text: str, is_object: Callable[[str], bool], is_in_c: Callable[[str], bool]) -> str:
    """Return an expression with `$world.` before objects of the world that C does not know.

    >>> with_world("distance(r0, bin) < x.y && r0.x", {"r0", "bin"}.__contains__, "x".__eq__)
    '$world.distance(r0, bin) < x.y && $world.r0.x'
    """

    def replaced(match: re.Match[str]) -> str:
        names = [match[each] for each in ("object", "one", "other") if match[each] is not None]
        is_of_world = any(is_object(each.strip("'")) for each in names)
        return f"$world.{match[0]}" if is_of_world and not any(map(is_in_c, names)) else match[0]

    return _BARE.sub(replaced, text)


def restore_names(message: str, found: tuple[SpecialName, ...]) -> str:
    """Restore the user's names in a message."""
    for number, each in enumerate(found):
        message = message.replace(NAME.format(number), display_name(each))
    return message


def display_name(name: SpecialName) -> str:
    """Return a name as a user writes it.

    >>> display_name(WorldName(("robot0", "x"))), display_name(QualifiedName("turn", "count"))
    ('$world.robot0.x', 'turn::count')
    """
    match name:
        case ConvenienceVariable():
            return f"${name.name}"
        case QualifiedName():
            return f"{name.inside}::{name.name}"
        case RobotName():
            return f"{name.robot}::{name.text}"
        case WorldName():
            return ".".join(["$world", *name.path])
    return f"$world.distance({name.one}, {name.other})"
