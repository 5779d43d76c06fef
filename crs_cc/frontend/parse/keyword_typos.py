"""Replace misspelled keywords by the intended ones: `retrun 0;`, `viod turn(int a)`.

Only an undeclared name is taken for a keyword, and only where what follows cannot follow a name:
then there is one error, at the name, and none for its consequences.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any, Final

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.error_limit import report
from crs_cc.frontend.parse.token_stream import TokenStream

SPECIFIERS: Final = {
    each: each.upper()
    for each in (
        "auto", "char", "const", "double", "enum", "extern", "float", "inline", "int", "long",
        "register", "short", "signed", "static", "struct", "typedef", "union", "unsigned", "void",
        "volatile",
    )
}  # fmt: skip
"""The keywords that start declarations, with their tokens' types."""

_WITH_CONDITION: Final = frozenset({"if", "while", "for", "switch"})
_ALONE: Final = frozenset({"break", "continue", "return"})
_BEFORE_OPERAND: Final = frozenset({"return", "case", "goto", "else"})
_BEFORE_STATEMENT: Final = frozenset({"else", "do"})

_NO_OPERATORS: Final = frozenset(
    {"ID", "TYPEID", "INT_CONST_DEC", "FLOAT_CONST", "CHAR_CONST", "STRING_LITERAL"}
)
_CANDIDATES: Final[dict[str, frozenset[str]]] = (
    dict.fromkeys(_NO_OPERATORS, _BEFORE_OPERAND | SPECIFIERS.keys())
    | dict.fromkeys(("MINUS", "NOT", "LNOT", "PLUSPLUS", "MINUSMINUS"), frozenset({"return"}))
    | {
        "SEMI": _ALONE,
        "LBRACE": _BEFORE_STATEMENT,
        "keyword": _BEFORE_STATEMENT | SPECIFIERS.keys() | {"return"},
    }
)
"""What an unknown name at the start of a statement may have been, by what follows it."""


class KeywordTypos:
    """Find misspelled keywords at the next tokens."""

    def __init__(self, stream: TokenStream, diagnostics: Diagnostics) -> None:
        self._stream = stream
        self._diagnostics = diagnostics

    def fix_statement(self) -> None:
        """Fix a keyword that starts a statement or a declaration in a block."""
        token, following = self._stream.buffer[self._stream.index : self._stream.index + 2]
        if token is None or following is None or token.type != "ID":
            return
        if self._stream.is_declared(token.value):
            return
        if following.type == "LPAREN":
            if self._has_body():
                self._fix(0, _WITH_CONDITION)
        elif following.type == "TIMES":
            self.fix_specifier(0)
        else:
            kind = "keyword" if _is_keyword(following) else following.type
            self._fix(0, _CANDIDATES.get(kind, ()))

    def fix_specifier(self, ahead: int) -> None:
        """Fix a keyword in a declaration, some tokens ahead."""
        start = self._stream.index + ahead
        token, following, name = self._stream.buffer[start : start + 3]
        if token is None or following is None or token.type != "ID":
            return
        if following.type == "TIMES":
            is_meant = name is not None and name.type in {"ID", "TIMES"}
        else:
            is_meant = following.type in {"ID", "TYPEID"} or _is_keyword(following)
        if is_meant:
            self._fix(ahead, SPECIFIERS)

    def _has_body(self) -> bool:
        """Return whether a statement follows the parentheses after the next token."""
        buffer = self._stream.buffer
        depth, index = 0, self._stream.index + 1
        while (token := buffer[index]) is not None:
            depth += {"LPAREN": 1, "RPAREN": -1}.get(token.type, 0)
            if depth == 0 or token.type in {"LBRACE", "RBRACE"}:
                break
            if token.type == "SEMI":
                return depth == 1
            index += 1
        following = buffer[index + 1] if token is not None else None
        if depth or following is None:
            return False
        is_far = following.lineno > token.lineno  # where only a semicolon may be missing
        if following.type == "LBRACE":
            return True
        return (following.type in {"ID", "TYPEID"} or _is_keyword(following)) and not is_far

    def _fix(self, ahead: int, keywords: Iterable[str]) -> None:
        """Replace an undeclared name by the keyword that resembles it, if there is one."""
        token = self._stream.buffer[self._stream.index + ahead]
        if self._stream.is_declared(token.value):
            return
        keyword = closest_keyword(token.value, keywords)
        if not keyword:
            return
        scopes = self._stream.scopes
        types = [name for scope in scopes for name, is_type in scope.items() if is_type]
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
        self._stream.replace(ahead, token.copy(keyword.upper(), keyword))


def closest_keyword(word: str, keywords: Iterable[str]) -> str:
    """Return the keyword that resembles a word, "" if none does.

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
