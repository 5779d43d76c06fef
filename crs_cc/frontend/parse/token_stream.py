"""The tokens of a file with the parser's position in them, and the scopes of names there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Final

from crs_cc.core.source import Location
from crs_cc.frontend.parse.lexer import Span, Token

NAMES: Final = frozenset({"ID", "TYPEID"})
"""Types of the tokens that are identifiers."""

_LOOKAHEAD: Final = 64
"""How many ends of file follow the last token; nothing looks further ahead."""


class TokenStream:
    """Tokens to be parsed; whether a name is a type name depends on the scope that it is read in.

    Attributes:
        buffer: all tokens, followed by None.
        index: the position of the next token.
        scopes: for each open scope, the names declared in it and whether they are types.
        classified: the name token whose type is known to fit the scopes; None when they changed.
    """

    __slots__ = ("buffer", "classified", "index", "scopes")

    def __init__(self, tokens: Sequence[Token], type_names: Iterable[str]) -> None:
        self.buffer: list[Any] = [*tokens, *[None] * _LOOKAHEAD]
        self.index = 0
        self.scopes: list[dict[str, bool]] = [dict.fromkeys(type_names, True)]
        self.classified: Token | None = None

    def peek(self, k: int = 1) -> Any:
        """Return the k-th next token, None after the last one."""
        token = self.buffer[self.index + k - 1]
        if token is not self.classified:
            if token is not None and token.type in NAMES:
                token.type = "TYPEID" if self._is_type(token.value) else "ID"
            self.classified = token
        return token

    def peek_type(self, k: int = 1) -> str | None:
        """Return the type of the k-th next token, None after the last one."""
        token = self.peek(k)
        return None if token is None else token.type

    def accept(self, token_type: str) -> Any:
        """Consume and return the next token if it is of a type; return None if it is not."""
        token = self.peek()
        if token is not None and token.type == token_type:
            self.index += 1
            return token
        return None

    def mark(self) -> int:
        """Return the position."""
        return self.index

    def reset(self, mark: int) -> None:
        """Go to a position."""
        self.index = mark

    def _is_type(self, name: str) -> bool:
        for scope in reversed(self.scopes):
            if name in scope:
                return scope[name]
        return False

    def is_declared(self, name: str) -> bool:
        """Return whether a name is declared in any open scope."""
        return any(name in scope for scope in self.scopes)

    def declare_type(self, name: str) -> None:
        """Declare a type name in the outermost scope."""
        self.scopes[0][name] = True
        self.classified = None

    def close_scopes(self, depth: int) -> None:
        """Close the inner scopes until only `depth` are open."""
        del self.scopes[depth:]
        self.classified = None

    def insert(self, token: Token) -> None:
        """Insert a token before the next one."""
        self.buffer.insert(self.index, token)
        self.classified = None

    def replace(self, ahead: int, token: Token) -> None:
        """Replace the token that is some tokens ahead."""
        self.buffer[self.index + ahead] = token
        self.classified = None

    @contextmanager
    def reading(self, tokens: Sequence[Token]) -> Iterator[None]:
        """Read other tokens, then continue with these."""
        outer = self.buffer, self.index
        self.buffer, self.index = [*tokens, *[None] * _LOOKAHEAD], 0
        try:
            yield
        finally:
            self.buffer, self.index = outer

    def span(self, start: int) -> Span:
        """Return the tokens from a position up to the last one that was read."""
        return Span(self.buffer[start], self.buffer[self.index - 1])

    def location(self) -> Location:
        """Return the location of the next token, or of the last one at the end of the file."""
        token: Token | None = self.buffer[self.index]
        if token is None:
            token = next(each for each in reversed(self.buffer) if each is not None)
        return token.location
