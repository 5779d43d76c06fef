"""A lexer for preprocessed C that returns all tokens at once, for pycparser's parser.

pycparser's own lexer tries several patterns at every character. This one makes a single pass with
one pattern, which saves a good part of the time to compile a file.

>>> from crs_cc.core.source import Diagnostics, Location
>>> tokens = lex("x += 0x1F;", lambda line, column: Location("a.c", line, column), Diagnostics())
>>> [(each.type, each.value, each.column) for each in tokens]
[('ID', 'x', 1), ('PLUSEQUAL', '+=', 3), ('INT_CONST_DEC', '0x1F', 6), ('SEMI', ';', 10)]
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Final, TypeAlias

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.parse.keywords import keywords

Locate: TypeAlias = Callable[[int, int], Location]


class Token:
    """A token. Its location is computed on demand: most tokens are never reported.

    Attributes:
        type: pycparser's name for the kind of token.
        value: its text.
        lineno: its line in the preprocessed text, counted from 1.
        column: its column there, counted from 1.
    """

    __slots__ = ("_locate", "_location", "column", "lineno", "type", "value")

    def __init__(self, type_: str, value: str, lineno: int, column: int, locate: Locate) -> None:
        self.type = type_
        self.value = value
        self.lineno = lineno
        self.column = column
        self._locate = locate
        self._location: Location | None = None

    @property
    def location(self) -> Location:
        """The location in the user's file."""
        found = self._location
        if found is None:
            found = self._location = self._locate(self.lineno, self.column)
        return found

    def copy(self, type_: str, value: str) -> Token:
        """Return another token at the same location."""
        return Token(type_, value, self.lineno, self.column, self._locate)


class Span:
    """The tokens of an expression, from the first to the last; located on demand."""

    __slots__ = ("_location", "first", "last")

    def __init__(self, first: Token, last: Token) -> None:
        self.first = first
        self.last = last
        self._location: Location | None = None

    @property
    def location(self) -> Location:
        """The location of the first token, with the column of the last one."""
        found = self._location
        if found is None:
            start, end = self.first.location, self.last.location
            reaches = start.line == end.line and start.file == end.file
            column = max(start.column, end.column) if reaches else 0
            found = self._location = Location(start.file, start.line, start.column, column)
        return found


_PUNCTUATORS: Final = {
    "...": "ELLIPSIS", "<<=": "LSHIFTEQUAL", ">>=": "RSHIFTEQUAL", "++": "PLUSPLUS",
    "--": "MINUSMINUS", "->": "ARROW", "&&": "LAND", "||": "LOR", "<<": "LSHIFT",
    ">>": "RSHIFT", "<=": "LE", ">=": "GE", "==": "EQ", "!=": "NE", "*=": "TIMESEQUAL",
    "/=": "DIVEQUAL", "%=": "MODEQUAL", "+=": "PLUSEQUAL", "-=": "MINUSEQUAL",
    "&=": "ANDEQUAL", "|=": "OREQUAL", "^=": "XOREQUAL", "=": "EQUALS", "+": "PLUS",
    "-": "MINUS", "*": "TIMES", "/": "DIVIDE", "%": "MOD", "|": "OR", "&": "AND", "~": "NOT",
    "^": "XOR", "!": "LNOT", "<": "LT", ">": "GT", "?": "CONDOP", "(": "LPAREN", ")": "RPAREN",
    "[": "LBRACKET", "]": "RBRACKET", "{": "LBRACE", "}": "RBRACE", ",": "COMMA", ".": "PERIOD",
    ";": "SEMI", ":": "COLON",
}  # fmt: skip

_TOKEN: Final = re.compile(
    r"[ \t\f\v\r]*(?:"
    r"((?:L|u8|u|U)?\"(?:[^\"\\]|\\.)*\")"  # 1: string
    r"|((?:L|u8|u|U)?'(?:[^'\\]|\\.)*')"  # 2: character
    r"|([^\W\d][\w$]*|\$[\w$]*)"  # 3: identifier or keyword
    r"|(\.?\d(?:[eEpP][+-]|[\w.'])*)"  # 4: number
    r"|(\.\.\.|<<=|>>=|->|\+\+|--|&&|\|\||<<|>>|[-+*/%&|^=!<>]=|[-+*/%&|^=!<>~?:;,.(){}\[\]])"  # 5
    r"|(.))"  # 6: anything else
)
_STRING, _CHARACTER, _NAME, _NUMBER, _PUNCTUATOR = 1, 2, 3, 4, 5

_INTEGER: Final = re.compile(
    r"(?:0[xX][0-9a-fA-F]+|0[bB][01]+|0[0-7]*|[1-9][0-9]*)"
    r"(?:[uU](?:ll|LL|[lL])?|(?:ll|LL|[lL])[uU]?)?[ijIJ]?"
)
_FLOATING: Final = re.compile(
    r"(?:(?:[0-9]+\.[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?|[0-9]+[eE][+-]?[0-9]+"
    r"|0[xX](?:[0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)[pP][+-]?[0-9]+)(?:[fFlL]?[ijIJ]?|[ijIJ][fFlL])"
)


@cache
def _types(standard: str) -> dict[str, str]:
    return {**keywords(standard), **_PUNCTUATORS}


def lex(
    text: str,
    locate: Locate,
    diagnostics: Diagnostics,
    standard: str = "gnu17",
    first_line: int = 1,
) -> list[Token]:
    """Return the tokens of a preprocessed file.

    Args:
        text: the text, without comments and directives.
        locate: returns the user's location for a line and column of the text.
        diagnostics: receives errors; invalid tokens are left out.
        standard: the C standard, which determines the keywords.
        first_line: the line of the whole file that the text starts with.
    """
    tokens: list[Token] = []
    append = tokens.append
    types = _types(standard)
    for lineno, line in enumerate(text.split("\n"), first_line):
        for found in _TOKEN.finditer(line):
            kind = found.lastindex
            if kind is None:
                continue
            value = found.group(kind)
            column = found.start(kind) + 1
            if kind in {_NAME, _PUNCTUATOR}:
                append(Token(types.get(value, "ID"), value, lineno, column, locate))
                continue
            token = Token("", value, lineno, column, locate)
            token.type = _constant_type(kind, value)
            if token.type:
                append(token)
            else:
                text_ = _complaint(kind, value)
                diagnostics.error(token.location, text_)
    return tokens


def _constant_type(kind: int, value: str) -> str:
    """Return the type of a constant, "" if it is invalid."""
    if kind == _STRING:
        return "STRING_LITERAL"
    if kind == _CHARACTER:
        return "CHAR_CONST"
    if kind == _NUMBER:
        plain = value.replace("'", "")
        if _INTEGER.fullmatch(plain):
            return "INT_CONST_DEC"
        if _FLOATING.fullmatch(plain):
            return "FLOAT_CONST"
    return ""


def _complaint(kind: int, value: str) -> str:
    """Return the message for an invalid token."""
    if kind != _NUMBER:
        if value in {"'", '"'}:
            return f"missing terminating {value} character"
        return f"unexpected character '{value}'"
    if re.fullmatch(r"0[0-9]*[89][0-9]*", value):
        return f"invalid digit in octal constant '{value}'"
    number = re.match(r"0[xX][0-9a-fA-F]*|[0-9.]+", value)
    suffix = value[number.end() :] if number is not None else value
    return f"invalid suffix '{suffix}' on number '{value}'"
