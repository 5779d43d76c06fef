"""Reads misspelt keywords as what they were meant to be: `retrun 0;`, `viod turn(int a)`.

Only a name that nobody declared is taken for a keyword, and only where what follows cannot follow
a name: then there is one error, at the name, and none for all that would come of it.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any, Final

from crs_cc.frontend.error_limit import report
from crs_cc.frontend.parse.attributes import AttributeParser
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.suspicious import Node

SPECIFIERS: Final = {
    each: each.upper()
    for each in (
        "auto", "char", "const", "double", "enum", "extern", "float", "inline", "int", "long",
        "register", "short", "signed", "static", "struct", "typedef", "union", "unsigned", "void",
        "volatile",
    )
}  # fmt: skip
"""The keywords that begin declarations, with their tokens' types."""

_WITH_CONDITION: Final = frozenset({"if", "while", "for", "switch"})
_ALONE: Final = frozenset({"break", "continue", "return"})
_BEFORE_OPERAND: Final = frozenset({"return", "case", "goto", "else"})
_BEFORE_STATEMENT: Final = frozenset({"else", "do"})

_NO_OPERATORS: Final = frozenset(
    {"ID", "TYPEID", "INT_CONST_DEC", "FLOAT_CONST", "CHAR_CONST", "STRING_LITERAL"}
)
_MEANT: Final[dict[str, frozenset[str]]] = (
    dict.fromkeys(_NO_OPERATORS, _BEFORE_OPERAND | SPECIFIERS.keys())
    | dict.fromkeys(("MINUS", "NOT", "LNOT", "PLUSPLUS", "MINUSMINUS"), frozenset({"return"}))
    | {
        "SEMI": _ALONE,
        "LBRACE": _BEFORE_STATEMENT,
        "keyword": _BEFORE_STATEMENT | SPECIFIERS.keys() | {"return"},
    }
)
"""What an unknown name at the beginning of a statement may have been, by what follows it."""


class MisspeltParser(AttributeParser):
    """The parser that knows keywords by their letters."""

    _scope_stack: list[dict[str, bool]]
    _typedef_checked_token: Token | None

    def _parse_statement(self) -> Node:
        self._mend_statement()
        return super()._parse_statement()

    def _parse_pragmacomp_or_statement(self) -> Node:
        node = super()._parse_pragmacomp_or_statement()
        self._mend_statement()  # an `else`, for which the `if` looks next
        return node

    def _mend_statement(self) -> None:
        """Mends a keyword at the beginning of a statement or of a declaration in a block."""
        token, following = self._buffer[self._index : self._index + 2]
        if token is None or following is None or token.type != "ID":
            return
        if any(token.value in scope for scope in self._scope_stack):
            return
        if following.type == "LPAREN":
            if self._has_body():
                self._mend(0, _WITH_CONDITION)
        elif following.type == "TIMES":
            self._mend_specifier(0)
        else:
            kind = "keyword" if _is_keyword(following) else following.type
            self._mend(0, _MEANT.get(kind, ()))

    def _mend_specifier(self, ahead: int) -> None:
        """Mends a keyword in a declaration, some tokens ahead."""
        token, following, name = self._buffer[self._index + ahead : self._index + ahead + 3]
        if token is None or following is None or token.type != "ID":
            return
        if following.type == "TIMES":
            is_meant = name is not None and name.type in {"ID", "TIMES"}
        else:
            is_meant = following.type in {"ID", "TYPEID"} or _is_keyword(following)
        if is_meant:
            self._mend(ahead, SPECIFIERS)

    def _has_body(self) -> bool:
        """Tells whether a statement follows the parentheses behind the next token."""
        depth, index = 0, self._index + 1
        while (token := self._buffer[index]) is not None:
            depth += {"LPAREN": 1, "RPAREN": -1}.get(token.type, 0)
            if depth == 0 or token.type in {"LBRACE", "RBRACE"}:
                break
            if token.type == "SEMI":
                return depth == 1
            index += 1
        behind = self._buffer[index + 1] if token is not None else None
        if depth or behind is None:
            return False
        is_far = behind.lineno > token.lineno  # where only a semicolon may be missing
        if behind.type == "LBRACE":
            return True
        return (behind.type in {"ID", "TYPEID"} or _is_keyword(behind)) and not is_far

    def _mend(self, ahead: int, keywords: Iterable[str]) -> None:
        """Makes a name that nobody declared the keyword that it is like, if it is like one."""
        index = self._index + ahead
        token = self._buffer[index]
        if any(token.value in scope for scope in self._scope_stack):
            return
        keyword = closest_keyword(token.value, keywords)
        if not keyword:
            return
        types = [name for scope in self._scope_stack for name, is_type in scope.items() if is_type]
        if keyword in SPECIFIERS and closest_keyword(token.value, [*types, keyword]) != keyword:
            return
        is_type = keyword in SPECIFIERS
        what = "unknown type name" if is_type else "use of undeclared identifier"
        report(
            self._diagnostics,
            token.location,
            f"{what} '{token.value}'",
            f"did you mean '{keyword}'?",
        )
        self._buffer[index] = token.copy(keyword.upper(), keyword)
        self._typedef_checked_token = None


def closest_keyword(word: str, keywords: Iterable[str]) -> str:
    """Gives the keyword that a word is like, "" when there is none.

    >>> closest_keyword("fro", ["for", "float"]), closest_keyword("flaot", ["for", "float"])
    ('for', 'float')
    >>> closest_keyword("speed", ["for", "float"])
    ''
    """
    known = sorted(keywords)
    letters = sorted(word.lower())
    for keyword in known:
        if word[:1].lower() in keyword[:2] and sorted(keyword) == letters:
            return keyword
    found = difflib.get_close_matches(word.lower(), known, 1, 0.8)
    return found[0] if found else ""


def _is_keyword(token: Any) -> bool:
    return bool(token.value[0].isalpha() and token.type not in _NO_OPERATORS)
