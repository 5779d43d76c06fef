r"""Preprocessing tokens (C17 6.4), split by one regular expression.

>>> [token.text for token in tokenise(r'x+++=L"a\"b"[0x1e+2]', 0)]
['x', '++', '+=', 'L"a\\"b"', '[', '0x1e+2', ']']
>>> [(token.kind, token.position, token.spaced) for token in tokenise("f (.5)", 100)][:3]
[('name', 100, False), ('punctuator', 102, True), ('number', 103, False)]
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.frontend.preprocess.source_text import Position, printable

NAME: Final = "name"
NUMBER: Final = "number"
STRING: Final = "string"
CHARACTER: Final = "character"
PUNCTUATOR: Final = "punctuator"
UNCLOSED: Final = "unclosed"
"""An unmatched quote and the rest of the line."""
OTHER: Final = "other"
"""A character that is not part of C, or a string in typographic quotes."""
PLACEMARKER: Final = "placemarker"
"""The result of `##` with an empty argument (C17 6.10.3.3); removed from expansions."""

HASH: Final = frozenset({"#", "%:"})
PASTE: Final = frozenset({"##", "%:%:"})

_UNIVERSAL: Final = r"\\u[0-9a-fA-F]{4}|\\U[0-9a-fA-F]{8}"
IDENTIFIER: Final = rf"(?:[^\W0-9]|\$|{_UNIVERSAL})[\w$]*+(?:(?:{_UNIVERSAL})[\w$]*+)*"
PP_NUMBER: Final = r"\.?[0-9][\w.]*+(?:(?:(?<=[eEpP])[+-]|'(?=\w))[\w.]*+)*"
"""A number, perhaps with C23's separators of digits."""

STRING_LITERAL: Final = r'(?:u8|[uUL])?"[^"\\]*+(?:\\.[^"\\]*+)*"'
CHARACTER_CONSTANT: Final = r"(?:u8|[uUL])?'[^'\\]*+(?:\\.[^'\\]*+)*'"
_PUNCTUATORS: Final = (
    r"\.\.\.|<<=|>>=|%:%:|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|\#\#"
    r"|<:|:>|<%|%>|%:|[-+*/%&|^~!<>=?:;,.(){}\[\]\#]"
)
_TYPESET_STRING: Final = r'[\u201c-\u201f][^\u201c-\u201f"]*+[\u201c-\u201f"]'
_TYPESET_CHARACTER: Final = r"[\u2018-\u201b](?:\\.|.)[\u2018-\u201b']"
_TOKEN: Final = re.compile(
    f"(?P<{STRING}>{STRING_LITERAL})"
    f"|(?P<{CHARACTER}>{CHARACTER_CONSTANT})"
    f"|(?P<{NAME}>{IDENTIFIER})"
    f"|(?P<{NUMBER}>{PP_NUMBER})"
    f"|(?P<{PUNCTUATOR}>{_PUNCTUATORS})"
    f"|(?P<{UNCLOSED}>[\"'].*)"
    rf"|(?P<{OTHER}>{_TYPESET_STRING}|{_TYPESET_CHARACTER}|[^ \t\v\f])"
)


@dataclass(slots=True)
class Token:
    """A preprocessing token, immutable, since tokens are shared.

    Attributes:
        kind: one of the constants above.
        text: its spelling.
        position: its position in the source, or that of the macro call that it comes from.
        spaced: whether it follows white space.
        painted: whether it is the name of a macro inside its own expansion, which is not
            replaced again (C17 6.10.3.4).
    """

    kind: str
    text: str
    position: Position
    spaced: bool
    painted: bool = False

    def moved(self, position: Position, spaced: bool) -> Token:
        """Return the same token at another position."""
        return Token(self.kind, self.text, position, spaced, self.painted)

    def respelled(self, text: str) -> Token:
        """Return the same token in another spelling."""
        return Token(self.kind, text, self.position, self.spaced, self.painted)


def tokenise(line: str, position: Position) -> list[Token]:
    """Split a logical line, whose first character is at a position, into tokens."""
    tokens = []
    end = 0
    for match in _TOKEN.finditer(line):
        start, stop = match.span()
        kind = match.lastgroup
        assert kind is not None
        tokens.append(Token(kind, match.group(), position + start, start != end))
        end = stop
    return tokens


def spell(tokens: Sequence[Token]) -> str:
    """Return the text of tokens, with one space where there was white space between them."""
    parts = [(" " if token.spaced else "") + token.text for token in tokens]
    return "".join(parts).lstrip()


def shown(text: str, limit: int = 60) -> str:
    """Return a text as quoted in messages: printable and not too long."""
    text = printable(text)
    return text if len(text) <= limit else text[: limit - 3] + "..."
