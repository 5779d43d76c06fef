r"""Integer and character constants in `#if` (C17 6.4.4, 6.10.1p4).

>>> from crs_cc.frontend.preprocess.tokens import tokenise
>>> [constant(token).number for token in tokenise(r"0x1fL 017 'A' '\377' 0xffffffffffffffff", 0)]
[31, 15, 65, -1, 18446744073709551615]
"""

from __future__ import annotations

import re
from typing import Final, NamedTuple

from crs_cc.frontend.preprocess.source_text import Position
from crs_cc.frontend.preprocess.tokens import CHARACTER, Token, shown

SUFFIX: Final = r"(?:[uU](?:ll|LL|[lL])?|(?:ll|LL|[lL])[uU]?)?"
INTEGER: Final = re.compile(
    rf"(?:0[xX](?P<hex>[0-9a-fA-F]+)|0[bB](?P<binary>[01]+)|(?P<octal>0[0-7]*)"
    rf"|(?P<decimal>[1-9][0-9]*))(?P<suffix>{SUFFIX})"
)
_RADIX: Final = {"hex": 16, "binary": 2, "octal": 8, "decimal": 10}
_ESCAPE: Final = re.compile(
    r"\\(?:(?P<octal>[0-7]{1,3})|x(?P<hex>[0-9a-fA-F]+)|u(?P<short>[0-9a-fA-F]{4})"
    r"|U(?P<long>[0-9a-fA-F]{8})|(?P<simple>.))|(?P<plain>[^\\])",
)
_SIMPLE: Final = {"n": 10, "t": 9, "r": 13, "a": 7, "b": 8, "f": 12, "v": 11, "e": 27}
_WIDTH: Final = {"": 8, "u8": 8, "L": 32, "u": 16, "U": 32}
MAX_DIGITS: Final = 1000


class Value(NamedTuple):
    """A value of type `intmax_t` or `uintmax_t`.

    Attributes:
        number: the value.
        unsigned: its type.
        problem: the error in it; "" if there is none.
        position: the position of the error.
    """

    number: int
    unsigned: bool
    problem: str = ""
    position: Position | None = None

    def with_number(self, number: int, *, unsigned: bool) -> Value:
        """Return the value of a number reduced to the type's range, with the same error."""
        number &= (1 << 64) - 1
        if not unsigned and number >> 63:
            number -= 1 << 64
        return Value(number, unsigned, self.problem, self.position)


def constant(token: Token) -> Value:
    """Return the value of a number or character constant; one with an error if it is invalid."""
    if token.kind == CHARACTER:
        return _character(token)
    match = INTEGER.fullmatch(token.text.replace("'", ""))
    if match is None or len(token.text) > MAX_DIGITS:
        problem = f"'{shown(token.text)}' is not an integer"
        return Value(0, unsigned=False, problem=problem, position=token.position)
    kind = next(each for each in _RADIX if match[each] is not None)
    number = int(match[kind], _RADIX[kind])
    if number >> 64:
        problem = f"{shown(token.text)} is too large"
        return Value(0, unsigned=False, problem=problem, position=token.position)
    unsigned = "u" in match["suffix"].lower() or bool(number >> 63)
    return Value(number, unsigned)


def _character(token: Token) -> Value:
    """Return a character constant's value; as in gcc, `'ab'` is `'a' * 256 + 'b'`."""
    prefix, _, rest = token.text.partition("'")
    width = _WIDTH[prefix]
    units: list[int] = []
    for match in _ESCAPE.finditer(rest[:-1]):
        units += _units(match, width)
    if not units:
        return Value(0, unsigned=False, problem="empty character constant", position=token.position)
    number = 0
    for unit in units[-4:]:
        number = (number << 8 | unit & 0xFF) if width == 8 else unit & ((1 << width) - 1)
    bits = width if len(units) == 1 or width > 8 else 32
    unsigned = prefix in ("u", "U")
    if not unsigned and number >> (bits - 1):
        number -= 1 << bits
    return Value(number, unsigned)


def _units(match: re.Match[str], width: int) -> list[int]:
    """Return the code units of one character or escape sequence."""
    if match["octal"]:
        return [int(match["octal"], 8)]
    if match["hex"]:
        return [int(match["hex"][-8:], 16)]
    if match["simple"]:
        return [_SIMPLE.get(match["simple"], ord(match["simple"]))]
    code = match["short"] or match["long"]
    character = chr(min(int(code, 16), 0x10FFFF)) if code else match["plain"]
    if width > 8:
        return [ord(character)]
    return list(character.encode("utf-8", "surrogateescape" if not code else "replace"))
