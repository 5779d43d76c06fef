"""Text to pycparser's tree, with messages that a programmer can read.

pycparser stops at the first error and refuses some of the C of 1990 (`main(argc, argv) char
**argv; {...}`, `static count;`). This parser makes up for both: it tells what was expected, skips
to the end of the statement or declaration, and goes on; and it puts in the `int` that old
programs leave out, with a warning. The nodes' `coord` is a `Location` in the user's own file.

>>> from crs_cc.source import Diagnostics, Location
>>> diagnostics = Diagnostics()
>>> tree = parse("main() { return 0 }", "a.c", lambda line, column: Location("a.c", line, column),
...              diagnostics)
>>> for message in diagnostics.messages:
...     print(message.render())
a.c:1:1: warning: type specifier missing, defaults to 'int'
a.c:1:19: error: expected ';' before '}'
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, NoReturn, TypeAlias

from pycparser import c_ast
from pycparser.c_lexer import Token
from pycparser.c_parser import CParser, ParseError

from crs_cc.source import Diagnostics, Location

Node: TypeAlias = Any
"""A node of pycparser's tree."""

Locate: TypeAlias = Callable[[int, int], Location]

MOST_ERRORS: Final = 20
"""After so many errors in one file the rest would mostly be echoes."""

PREDECLARED_TYPES: Final = ("__builtin_va_list",)
"""Type names that every file knows."""

_SPELLING: Final = {
    "SEMI": "';'", "LPAREN": "'('", "RPAREN": "')'", "LBRACE": "'{'", "RBRACE": "'}'",
    "LBRACKET": "'['", "RBRACKET": "']'", "COLON": "':'", "COMMA": "','", "EQUALS": "'='",
    "WHILE": "'while'", "ID": "identifier",
}  # fmt: skip
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
    "At end of input": "unexpected end of the file",
}


class TooManyErrors(Exception):  # noqa: N818 - it stops the work, the errors are recorded
    """There are so many errors that going on makes no sense."""


def parse(text: str, name: str, locate: Locate, diagnostics: Diagnostics) -> list[Node]:
    """Parses a preprocessed file.

    Args:
        text: the text, without comments and directives apart from `#pragma`.
        name: the file's name.
        locate: gives the user's place for a line and column of the text.
        diagnostics: takes the messages.

    Returns:
        The external declarations that could be understood.

    Raises:
        TooManyErrors: when the file is hopeless.
        RecursionError: when the file is nested too deeply for the stack.
    """
    tree = _Parser(locate, diagnostics).parse(text, name)
    return list(tree.ext)


class _Parser(CParser):  # type: ignore[misc]
    """pycparser's parser, with recovery.

    It overrides these of pycparser 3.12's methods: how errors are raised, how coordinates are
    made, and the entries to declarations and statements.
    """

    def __init__(self, locate: Locate, diagnostics: Diagnostics) -> None:
        super().__init__()
        self._locate = locate
        self._diagnostics = diagnostics
        self._last_patch = -1
        self._type_names: dict[int, tuple[Any, int]] = {}

    # Messages

    def _tok_coord(self, tok: Token) -> Location:
        return self._locate(tok.lineno, tok.column)

    def _lex_error_func(self, msg: str, line: int, column: int) -> None:
        self._report(self._locate(line, column), msg[:1].lower() + msg[1:])

    def _parse_error(self, msg: str, coord: object) -> NoReturn:
        """Reports an error at `coord`, or at the next token when that is not a place."""
        token = self._tokens.peek()
        if not isinstance(coord, Location):
            coord = self._end_of_file() if token is None else self._tok_coord(token)
        text = _PLAIN_TEXT.get(msg)
        if text is None:
            text = msg[:1].lower() + msg[1:]
        elif token is not None and text.startswith("expected"):
            coord = self._tok_coord(token)
            text = f"{text} before '{token.value}'"
        self._report(coord, text)
        raise ParseError(text)

    def _report(self, place: Location, text: str) -> None:
        self._diagnostics.error(place, text)
        if len(self._diagnostics.errors) >= MOST_ERRORS:
            raise TooManyErrors

    def _end_of_file(self) -> Location:
        last = next((tok for tok in reversed(self._tokens._buffer) if tok is not None), None)
        return self._locate(1, 1) if last is None else self._tok_coord(last)

    def _expect(self, wanted: str) -> Token:
        """Takes the next token, which must be of one type.

        A semicolon that is missing at the end of a line is made up, so that what follows is
        still understood.
        """
        token = self._peek()
        if token is None:
            self._parse_error("At end of input", None)
        if token.type == wanted or (wanted == "ID" and token.type == "TYPEID"):
            return self._advance()
        text = f"expected {_SPELLING.get(wanted, wanted.lower())} before '{token.value}'"
        position = self._tokens.mark()
        before = self._tokens._buffer[position - 1] if position else token
        may_patch = wanted == "SEMI" and before.lineno < token.lineno
        place = self._locate(before.lineno, before.column) if may_patch else self._tok_coord(token)
        if may_patch and place.column:
            place = Location(place.file, place.line, place.column + len(before.value))
        self._report(place, text)
        if may_patch and position != self._last_patch:
            self._last_patch = position
            return Token("SEMI", ";", token.lineno, token.column, token.filename)
        raise ParseError(text)

    # Recovery

    def _parse_translation_unit(self) -> list[Node]:
        found: list[Node] = []
        self._scope_stack[0].update(dict.fromkeys(PREDECLARED_TYPES, True))
        while self._peek() is not None:
            start = self._tokens.mark()
            try:
                found.extend(self._parse_external_declaration())
            except ParseError:
                self._forget_scopes(1)
                self._skip(start, is_in_block=False)
        return found

    def _parse_block_item(self) -> Node:
        start, depth = self._tokens.mark(), len(self._scope_stack)
        try:
            self._declare_unknown_type()
            return super()._parse_block_item()
        except ParseError:
            if self._tokens.peek() is None:
                raise
            self._forget_scopes(depth)
            self._skip(start, is_in_block=True)
            return []

    def _forget_scopes(self, depth: int) -> None:
        del self._scope_stack[depth:]
        self._typedef_checked_token = None

    def _skip(self, start: int, *, is_in_block: bool) -> None:
        """Goes behind the end of a broken declaration or statement that began at `start`."""
        stop = self._tokens.mark()
        self._tokens.reset(start)
        depth = 0
        while (token := self._tokens.peek()) is not None:
            if token.type == "RBRACE" and depth == 0 and is_in_block:
                return
            self._tokens.next()
            depth += {"LBRACE": 1, "RBRACE": -1}.get(token.type, 0)
            is_end = token.type in {"SEMI", "RBRACE"} and depth <= 0
            if is_end and self._tokens.mark() >= stop:
                following = self._tokens.peek()
                if token.type == "SEMI" or following is None or following.type != "SEMI":
                    return

    # The C of 1990, and names of types that nobody declared

    def _parse_external_declaration(self) -> list[Node]:
        token = self._peek()
        if token is not None and token.type in {"ID", "TIMES", "LPAREN"}:
            self._declare_unknown_type()
            if self._peek_type() != "TYPEID":
                self._put_in_int(token)
        elif token is not None and not self._starts_external(token):
            self._tokens.next()
            self._report(self._tok_coord(token), f"expected a declaration before '{token.value}'")
            raise ParseError
        found: list[Node] = super()._parse_external_declaration()
        return found

    def _starts_external(self, token: Token) -> bool:
        others = {"SEMI", "PPHASH", "PPPRAGMA", "_PRAGMA", "_STATIC_ASSERT"}
        return token.type in others or self._starts_declaration(token)

    def _put_in_int(self, token: Token) -> None:
        self._diagnostics.warning(
            self._tok_coord(token), "type specifier missing, defaults to 'int'"
        )
        made_up = Token("INT", "int", token.lineno, token.column, token.filename)
        self._tokens._buffer.insert(self._tokens.mark(), made_up)
        self._typedef_checked_token = None

    def _parse_declaration_specifiers(self, allow_no_type: bool = False) -> Any:
        self._declare_unknown_type()
        spec, saw_type, place = super()._parse_declaration_specifiers(allow_no_type)
        if not spec["type"]:
            self._diagnostics.warning(place, "type specifier missing, defaults to 'int'")
            spec["type"].append(c_ast.IdentifierType(["int"], coord=place))
        return spec, saw_type, place

    def _parse_struct_declaration(self) -> list[Node] | None:
        self._declare_unknown_type()
        found: list[Node] | None = super()._parse_struct_declaration()
        return found

    def _parse_identifier_list_opt(self) -> Node:
        if self._declare_unknown_type():
            return self._parse_parameter_type_list()
        return super()._parse_identifier_list_opt()

    def _declare_unknown_type(self) -> bool:
        """Takes the next name for a type if nothing else makes sense; the checker will object."""
        token = self._peek()
        if token is None or token.type != "ID":
            return False
        if any(token.value in scope for scope in self._scope_stack):
            return False
        ahead = 2
        while self._peek_type(ahead) == "TIMES":
            ahead += 1
        if self._peek_type(ahead) != "ID":
            return False
        if ahead > 2 and self._peek_type(ahead + 1) not in {
            "SEMI", "EQUALS", "COMMA", "RPAREN", "LPAREN", "LBRACKET",
        }:  # fmt: skip
            return False
        self._scope_stack[0][token.value] = True
        self._typedef_checked_token = None
        return True

    # A type name may be tried at one place twice; nested ones would be tried 2^depth times.

    def _try_parse_paren_type_name(self) -> Any:
        token = self._peek()
        if token is None or token.type != "LPAREN":
            return None
        mark = self._tokens.mark()
        known = self._type_names.get(mark)
        if known is not None:
            self._tokens.reset(known[1])
            return known[0]
        result = super()._try_parse_paren_type_name()
        if result is not None:
            self._type_names[mark] = (result, self._tokens.mark())
        return result
