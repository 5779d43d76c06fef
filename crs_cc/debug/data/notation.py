"""Extensions of C expressions: slices, qualified names, and convenience variables.

>>> slice_in("a[i + 1..5]"), slice_in("*p@4"), slice_in("a[1]")
(Slice(base='a', first='i + 1', last='5'), Slice(base='*p', first='4', last=''), None)
>>> rewritten("turn::count + 'map.c'::size - $speed")[0]
'__crs_0 + __crs_1 - __crs_2'
>>> rewritten("'map.c'::size - $speed")[1]
(QualifiedName(inside='map.c', name='size'), ConvenienceVariable(name='speed'))
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

_STRING: Final = r'"(?:[^"\\]|\\.)*"'
_CHARACTER: Final = r"'(?:[^'\\]|\\.)*'"
_OUTER: Final = (
    r"(?:'(?P<quoted>[^'\n]+)'|(?P<path>(?:[\w.-]+/)*[\w.-]+\.[ch])|(?P<function>[A-Za-z_]\w*))"
    r"::(?P<name>[A-Za-z_]\w*)"
)
_SPECIAL: Final = re.compile(rf"{_STRING}|{_OUTER}|{_CHARACTER}|\$(?P<kept>\$?\w*)")
_TOKEN: Final = re.compile(rf"{_STRING}|{_CHARACTER}|\.\.\.|\.\.|.", re.DOTALL)
_SETS: Final = re.compile(r"\s*\$([A-Za-z_]\w*)\s*=(?!=)(.*)", re.DOTALL)

NAME: Final = "__crs_{}"
"""What stands in C for the names that C does not have."""


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


def slice_in(text: str) -> Slice | None:
    """Parse a slice; return None for other expressions."""
    text, opened = text.strip(), -1
    for symbol, start, depth in _tokens(text):
        if depth == 0 and symbol == "@":
            return Slice(text[:start].strip(), text[start + 1 :].strip(), "")
        if depth == 0 and symbol == "[":
            opened = start
    if opened < 0 or not text.endswith("]"):
        return None
    inside = text[opened + 1 : -1]
    for symbol, start, depth in _tokens(inside):
        if symbol == ".." and depth == 0:
            first, last = inside[:start].strip(), inside[start + 2 :].strip()
            return Slice(text[:opened].strip(), first, last)
    return None


def _tokens(text: str) -> Iterator[tuple[str, int, int]]:
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


def rewritten(text: str) -> tuple[str, tuple[QualifiedName | ConvenienceVariable, ...]]:
    """Return an expression in C, and the meanings of its names `__crs_0`, `__crs_1` and so on."""
    if "::" not in text and "$" not in text:
        return text, ()
    found: list[QualifiedName | ConvenienceVariable] = []

    def replaced(match: re.Match[str]) -> str:
        if match["name"] is not None:
            inside = match["quoted"] or match["path"] or match["function"]
            found.append(QualifiedName(inside, match["name"]))
        elif match["kept"] is not None:
            found.append(ConvenienceVariable(match["kept"]))
        else:
            return match[0]
        return NAME.format(len(found) - 1)

    return _SPECIAL.sub(replaced, text), tuple(found)


def restored(message: str, found: tuple[QualifiedName | ConvenienceVariable, ...]) -> str:
    """Restore the user's names in a message."""
    for number, each in enumerate(found):
        name = (
            f"${each.name}"
            if isinstance(each, ConvenienceVariable)
            else f"{each.inside}::{each.name}"
        )
        message = message.replace(NAME.format(number), name)
    return message
