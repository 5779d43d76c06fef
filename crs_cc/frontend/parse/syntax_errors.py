"""The messages for syntax errors: what was expected, and hints at the cause."""

from __future__ import annotations

from typing import Final, NoReturn

from pycparser.c_parser import ParseError

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.error_limit import report
from crs_cc.frontend.other_language_hint import CPLUSPLUS, is_cplusplus
from crs_cc.frontend.parse.keyword_typos import closest_keyword
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.token_stream import TokenStream
from crs_cc.frontend.preprocess.tokens import shown

_STATEMENT_ENDS: Final = frozenset({"SEMI", "LBRACE", "RBRACE"})

_SPELLING: Final = {
    "SEMI": "';'", "LPAREN": "'('", "RPAREN": "')'", "LBRACE": "'{'", "RBRACE": "'}'",
    "LBRACKET": "'['", "RBRACKET": "']'", "COLON": "':'", "COMMA": "','", "EQUALS": "'='",
    "WHILE": "'while'", "ID": "identifier",
}  # fmt: skip
_OPENING: Final = {"RPAREN": "LPAREN", "RBRACKET": "LBRACKET", "RBRACE": "LBRACE"}
_CLOSING: Final = {opening: closing for closing, opening in _OPENING.items()}
_PLAIN_TEXT: Final = {
    "Invalid expression": "expected an expression",
    "Invalid declaration": "expected a declaration",
    "Invalid declarator": "expected a name",
    "Invalid specifier list": "expected a type",
    "Invalid function definition": "expected a function body",
    "Invalid struct reference": "expected a member's name",
    "Invalid struct/union declaration": "expected a tag or '{'",
    "Invalid multiple types specified": "two types in one declaration",
    "Invalid typedef": "a function body cannot follow 'typedef'",
    "At end of input": "unexpected end of file",
}
"""Our wording of pycparser's messages."""


class SyntaxErrors:
    """Report the syntax errors of a file."""

    def __init__(self, stream: TokenStream, diagnostics: Diagnostics) -> None:
        self._stream = stream
        self._diagnostics = diagnostics
        self._last_patch = -1
        self._blamed = ""
        self._nested: Token | None = None

    def enter_nested(self) -> None:
        """Note a nested function at its brace, if it looks like one that is not meant to be one."""
        index = self._stream.index
        brace, last = self._stream.buffer[index], self._stream.buffer[index - 1]
        start = index - 1
        while start > 0 and self._stream.buffer[start - 1].lineno == last.lineno:
            start -= 1
        if self._nested is None and self._stream.buffer[start].column == 1:
            self._nested = brace

    def unexpected(self, msg: str, coord: object) -> NoReturn:
        """Report one of pycparser's errors.

        Args:
            msg: pycparser's message.
            coord: the token at fault; anything else means the next token.

        Raises:
            ParseError: always.
        """
        following = self._stream.buffer[self._stream.index]
        token = coord if isinstance(coord, Token) else following
        if following is None and self._nested is not None:
            token, msg = self._nested, "function definition is not allowed here"
            report(self._diagnostics, token.location, msg, self._opened_before(token))
            raise ParseError(msg)
        text = _PLAIN_TEXT.get(msg)
        if text is None:
            text = msg[:1].lower() + msg[1:]
        elif following is not None and text.startswith("expected"):
            token = following
            text = f"{text} before '{token.value}'"
        hint = (
            self._reversed_operator()
            if following is not None
            else self._opened("LBRACE", "to close the")
        )
        brace = hint.partition("'{'")[2]
        if not brace or brace != self._blamed.partition("'{'")[2]:
            place = self._stream.location() if token is None else token.location
            report(self._diagnostics, place, text, hint)
        raise ParseError(text)

    def missing(self, wanted: str, token: Token) -> Token:
        """Report that the next token is not the one that the grammar demands.

        Args:
            wanted: the type of token that the grammar demands.
            token: the next token.

        Returns:
            A token in its place: a semicolon that is missing at the end of a line is made up.

        Raises:
            ParseError: the code cannot be understood without it.
        """
        before = self._stream.buffer[self._stream.index - 1] if self._stream.index else token
        is_misspelt = wanted == "WHILE" and closest_keyword(token.value, ["while"])
        place, text, hint = self._missing_text(wanted, token, before)
        report(self._diagnostics, place, text, "did you mean 'while'?" if is_misspelt else hint)
        if is_misspelt:
            self._stream.index += 1
            return token
        ends_line = before.lineno < token.lineno or token.type == "RBRACE"
        if wanted == "SEMI" and ends_line and self._stream.index != self._last_patch:
            self._last_patch = self._stream.index
            return token.copy("SEMI", ";")
        raise ParseError(text)

    def _missing_text(self, wanted: str, token: Token, before: Token) -> tuple[Location, str, str]:
        """Return the location, text and hint for a missing token."""
        place, hint = token.location, ""
        text = f"expected {_SPELLING.get(wanted, wanted.lower())} before '{token.value}'"
        if wanted in _OPENING:
            hint = self._opened(_OPENING[wanted], "to close the")
        if wanted == "SEMI" and token.type == "LBRACE":
            text = "function definition is not allowed here"
            hint = self._blamed = self._opened("LBRACE", "a '}' may be missing for the")
            hint += "; functions inside functions are not supported" if hint else ""
        elif wanted == "SEMI" and token.type == "ELSE" and before.type in _STATEMENT_ENDS:
            text = "'else' without a previous 'if'"
        elif wanted == "SEMI" and before is not token:
            text = f"expected ';' after '{shown(before.value)}'"
            place = end_of(before)
        return place, text, self._other_language() or hint

    def _reversed_operator(self) -> str:
        """Return a hint at an operator whose characters are reversed or apart: `=>`, `= =`."""
        index = self._stream.index
        pair = {each.value for each in self._stream.buffer[max(index - 1, 0) : index + 1]}
        if "=" not in pair or not pair <= {"=", "<", ">"}:
            return ""
        other = max(pair - {"="}, default="=")
        return f"did you mean '{other}='?"

    def _other_language(self) -> str:
        """Return a hint if the tokens around the next one belong to another language."""
        index = self._stream.index
        around = [each for each in self._stream.buffer[max(0, index - 2) : index + 2] if each]
        words = [each.value for each in around if not self._stream.is_declared(each.value)]
        return CPLUSPLUS if is_cplusplus(words) else ""

    def _opened(self, opening: str, what: str) -> str:
        """Return a hint at the last parenthesis, bracket or brace that is still open."""
        return self._opened_up_to(self._stream.index, opening, what)

    def _opened_before(self, token: Token) -> str:
        """Return a hint at the last brace that is open before a token."""
        place = self._stream.buffer.index(token)
        return self._opened_up_to(place, "LBRACE", "a '}' may be missing for the")

    def _opened_up_to(self, index: int, opening: str, what: str) -> str:
        depth, closing = 0, _CLOSING[opening]
        for token in reversed(self._stream.buffer[:index]):
            depth += {closing: 1, opening: -1}.get(token.type, 0)
            if depth < 0:
                return f"{what} {_SPELLING[opening]} at {token.location}"
        return ""


def end_of(token: Token) -> Location:
    """Return the location right after a token."""
    place = token.location
    return Location(place.file, place.line, place.column + len(token.value))
