"""Supply omitted parts of declarations: the `int` of C90, a type's declaration, a semicolon.

`main(argc, argv) char **argv; {...}` and `static count;` are valid in C90, which pycparser does
not parse. A missing semicolon is reported where the line ends, not where C would go on reading.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from pycparser import c_ast

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.error_limit import report
from crs_cc.frontend.parse.keyword_typos import KeywordTypos
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.syntax_errors import end_of
from crs_cc.frontend.parse.token_stream import TokenStream
from crs_cc.frontend.preprocess.tokens import shown

_BEFORE_TYPES: Final = frozenset(
    {"CONST", "VOLATILE", "STATIC", "EXTERN", "REGISTER", "TYPEDEF", "INLINE", "AUTO"}
)
_AFTER_TYPE_NAME: Final = frozenset({"ID", "TYPEID", "TIMES"})
"""What follows a name that is a type and not the name that is declared."""

_AFTER_DECLARATOR: Final = frozenset({"SEMI", "EQUALS", "COMMA", "RPAREN", "LPAREN", "LBRACKET"})
_IMPLICIT_INT: Final = "type specifier missing, defaults to 'int'"


class Omissions:
    """Supply the omitted parts of a file's declarations."""

    def __init__(
        self,
        stream: TokenStream,
        diagnostics: Diagnostics,
        typos: KeywordTypos,
        starts_declaration: Callable[[Token], bool],
    ) -> None:
        self._stream = stream
        self._diagnostics = diagnostics
        self._typos = typos
        self._starts_declaration = starts_declaration
        self._warned_of_int = False

    def insert_int(self, token: Token) -> None:
        """Insert `int` before a declaration without a type, which starts with `token`."""
        self._warn_of_int(token)
        self._stream.insert(token.copy("INT", "int"))

    def add_int(self, spec: Any, place: Token) -> None:
        """Add `int` to declaration specifiers without a type."""
        if not spec["type"]:
            self._warn_of_int(place)
            spec["type"].append(c_ast.IdentifierType(["int"], coord=place))

    def _warn_of_int(self, token: Token) -> None:
        """Warn about a missing `int`, once per file: in old code it is missing everywhere."""
        if not self._warned_of_int:
            self._diagnostics.warning(token.location, _IMPLICIT_INT, flag="implicit-int")
        self._warned_of_int = True

    def declare_unknown_type(self) -> bool:
        """Declare the next name as a type if nothing else makes sense; the checker reports it."""
        peek_type = self._stream.peek_type
        ahead = self._skip_qualifiers()
        self._typos.fix_specifier(ahead - 1)
        token = self._stream.peek(ahead)
        if token is None or token.type != "ID" or self._stream.is_declared(token.value):
            return False
        ahead += 1
        stars = ahead
        while peek_type(ahead) == "TIMES":
            ahead += 1
        if peek_type(ahead) != "ID":
            return False
        if ahead > stars and peek_type(ahead + 1) not in _AFTER_DECLARATOR:
            return False
        self._stream.declare_type(token.value)
        return True

    def _skip_qualifiers(self) -> int:
        """Return how many tokens ahead the first is that can be a type."""
        ahead = 1
        while self._stream.peek_type(ahead) in _BEFORE_TYPES:
            ahead += 1
        return ahead

    def end_members(self) -> None:
        """End a declaration after a list of members if another type follows on a later line."""
        if self._stream.buffer[self._stream.index - 1].type != "RBRACE":
            return
        ahead = self._skip_qualifiers()
        token = self._stream.peek(ahead)
        if token is None or not self._starts_declaration(token):
            return
        if token.type != "TYPEID" or self._stream.peek_type(ahead + 1) in _AFTER_TYPE_NAME:
            self.end_declaration()

    def end_declaration(self) -> None:
        """Report and insert a semicolon that is missing at the end of an earlier line."""
        index = self._stream.index
        before, token = self._stream.buffer[index - 1 : index + 1]
        if before.lineno == token.lineno:
            return
        report(self._diagnostics, end_of(before), f"expected ';' after '{shown(before.value)}'")
        self._stream.insert(token.copy("SEMI", ";"))
