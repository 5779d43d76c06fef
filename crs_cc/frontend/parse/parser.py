"""Text to pycparser's tree, with messages that a programmer can read.

pycparser stops at the first error and refuses some of the C of 1990 (`main(argc, argv) char
**argv; {...}`, `static count;`). This parser makes up for both: it tells what was expected, skips
to the end of the statement or declaration, and goes on; and it puts in the `int` that old
programs leave out, with a warning. The nodes' `coord` is a `Token`, which knows its place in the
user's own file.

>>> from crs_cc.frontend.parse.lexer import lex
>>> from crs_cc.core.source import Diagnostics, Location
>>> diagnostics = Diagnostics()
>>> def locate(line, column): return Location("a.c", line, column)
>>> nodes = parse(lex("main() { return 0 }", locate, diagnostics), diagnostics)
>>> for message in diagnostics.messages:
...     print(message.render())
a.c:1:1: warning: type specifier missing, defaults to 'int'
a.c:1:18: error: expected ';' after '0'
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterable
from typing import Any, Final, NoReturn, TypeAlias

from pycparser import c_ast
from pycparser.c_parser import ParseError

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.error_limit import GiveUp, report
from crs_cc.frontend.other_language_hint import CPLUSPLUS, is_cplusplus
from crs_cc.frontend.parse.expressions import NAMES
from crs_cc.frontend.parse.gnu import AUTO_TYPE
from crs_cc.frontend.parse.gnu_attributes import take_attributes
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.misspelt import MisspeltParser, closest_keyword
from crs_cc.frontend.preprocess.tokens import shown

Node: TypeAlias = Any
"""A node of pycparser's tree."""

_BEFORE_TYPES: Final = frozenset(
    {"CONST", "VOLATILE", "STATIC", "EXTERN", "REGISTER", "TYPEDEF", "INLINE", "AUTO"}
)
_NAMED: Final = frozenset({"ID", "TYPEID", "TIMES"})
"""What follows the name of a type, where it is not a name that is declared."""

_STATEMENT_ENDS: Final = frozenset({"SEMI", "LBRACE", "RBRACE"})
_LOOKAHEAD: Final = 64
"""How many ends of file stand behind the last token; nothing looks further ahead."""

_MOST_DERIVATIONS: Final = 200
"""How many pointers, arrays and functions one declarator may stack up."""

_IMPLICIT_INT: Final = "type specifier missing, defaults to 'int'"

PREDECLARED_TYPES: Final = ("__builtin_va_list", AUTO_TYPE)
"""Type names that every file knows."""

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
    "At end of input": "unexpected end of the file",
}


class Broken(c_ast.Node):  # type: ignore[misc]
    """Stands for a declaration or statement that could not be understood.

    Attributes:
        names: the names in it, which it may have declared.
    """

    __slots__ = ("coord", "names")

    def __init__(self, names: list[str], coord: Token) -> None:
        self.names = names
        self.coord = coord

    def children(self) -> tuple[()]:
        """Gives the nodes inside: none."""
        return ()


def parse(tokens: list[Token], diagnostics: Diagnostics) -> list[Node]:
    """Parses a preprocessed file.

    Args:
        tokens: the file.
        diagnostics: takes the messages.

    Returns:
        The external declarations that could be understood.

    Raises:
        GiveUp: when the file is hopeless or nested too deeply.
    """
    parser = _Parser(tokens, diagnostics)
    try:
        return parser.translation_unit()
    except RecursionError:
        diagnostics.error(parser.place(), "the program is nested too deeply here")
        raise GiveUp from None


def parse_expression(
    tokens: list[Token], type_names: Iterable[str], diagnostics: Diagnostics
) -> Node | None:
    """Parses an expression that stands alone; None when it could not be understood.

    Args:
        tokens: the expression.
        type_names: what names stand for types.
        diagnostics: takes the messages.
    """
    return _Parser(tokens, diagnostics).expression(type_names)


def _behind(token: Token) -> Location:
    """Gives the place where a token ends."""
    place = token.location
    return Location(place.file, place.line, place.column + len(token.value))


class _Parser(MisspeltParser):
    """pycparser's parser, with recovery, and with faster access to the tokens.

    It overrides these of pycparser 3.12's methods: access to tokens, how errors are raised, how
    coordinates are made, the entries to declarations and statements, and expressions.
    """

    def __init__(self, tokens: list[Token], diagnostics: Diagnostics) -> None:
        super().__init__()
        rest, self._before = take_attributes(tokens, diagnostics)
        self._buffer: list[Any] = [*rest, *[None] * _LOOKAHEAD]
        self._index = 0
        self._diagnostics = diagnostics
        self._last_patch = -1
        self._blamed = ""
        self._said_int = False
        self._typedef_checked_token: Token | None = None
        self._type_names: dict[int, tuple[Any, int]] = {}
        self._scope_stack = [dict.fromkeys(PREDECLARED_TYPES, True)]

    def translation_unit(self) -> list[Node]:
        """Parses the whole file."""
        found: list[Node] = []
        while self._peek() is not None:
            start = self._index
            try:
                found.extend(self._parse_external_declaration())
            except ParseError:
                self._forget_scopes(1)
                found.append(self._skip(start, is_in_block=False))
        return found

    def expression(self, type_names: Iterable[str]) -> Node | None:
        """Parses an expression, and nothing behind it."""
        self._scope_stack = [dict.fromkeys([*PREDECLARED_TYPES, *type_names], True)]
        with contextlib.suppress(ParseError):
            try:
                node = self._parse_expression()
            except RecursionError:
                self._diagnostics.error(self.place(), "the expression is nested too deeply here")
                return None
            if (left := self._peek()) is None:
                return node
            report(self._diagnostics, left.location, f"unexpected '{left.value}' here")
        return None

    # Tokens

    def _peek(self, k: int = 1) -> Any:
        token = self._buffer[self._index + k - 1]
        if token is not self._typedef_checked_token:
            if token is not None and token.type in NAMES:
                token.type = "TYPEID" if self._is_type_in_scope(token.value) else "ID"
            self._typedef_checked_token = token
        return token

    def _peek_type(self, k: int = 1) -> str | None:
        token = self._peek(k)
        return None if token is None else token.type

    def _advance(self) -> Any:
        token = self._peek()
        if token is None:
            self._parse_error("At end of input", None)
        self._index += 1
        return token

    def _accept(self, token_type: str) -> Any:
        token = self._peek()
        if token is not None and token.type == token_type:
            self._index += 1
            return token
        return None

    def _mark(self) -> int:
        return self._index

    def _reset(self, mark: int) -> None:
        self._index = mark

    def _tok_coord(self, tok: Token) -> Token:
        return tok

    # Messages

    def _parse_error(self, msg: str, coord: object) -> NoReturn:
        """Reports an error at `coord`, or at the next token when that is not a token."""
        following = self._buffer[self._index]
        token = coord if isinstance(coord, Token) else following
        text = _PLAIN_TEXT.get(msg)
        if text is None:
            text = msg[:1].lower() + msg[1:]
        elif following is not None and text.startswith("expected"):
            token = following
            text = f"{text} before '{token.value}'"
        hint = (
            self._turned_operator()
            if following is not None
            else self._opened("LBRACE", "to close the")
        )
        brace = hint.partition("'{'")[2]
        if not brace or brace != self._blamed.partition("'{'")[2]:
            place = self.place() if token is None else token.location
            report(self._diagnostics, place, text, hint)
        raise ParseError(text)

    def _turned_operator(self) -> str:
        """Gives a hint to an operator whose signs are in the wrong order or apart: `=>`, `= =`."""
        pair = {each.value for each in self._buffer[max(self._index - 1, 0) : self._index + 1]}
        if "=" not in pair or not pair <= {"=", "<", ">"}:
            return ""
        other = max(pair - {"="}, default="=")
        return f"did you mean '{other}='?"

    def place(self) -> Location:
        """Gives the place of the next token, at the end of the file that of the last one."""
        token: Token | None = self._buffer[self._index]
        if token is None:
            token = next(each for each in reversed(self._buffer) if each is not None)
        return token.location

    def _expect(self, token_type: str) -> Any:
        """Takes the next token, which must be of one type.

        A semicolon that is missing at the end of a line is made up, so that what follows is
        still understood.
        """
        token = self._peek()
        if token is not None:
            kind = token.type
            if token_type == kind or (kind == "TYPEID" and token_type in NAMES):
                self._index += 1
                return token
            return self._missing(token_type, token)
        return self._parse_error("At end of input", None)

    def _missing(self, wanted: str, token: Token) -> Token:
        text, hint = f"expected {_SPELLING.get(wanted, wanted.lower())} before '{token.value}'", ""
        before = self._buffer[self._index - 1] if self._index else token
        ends = before.lineno < token.lineno or token.type == "RBRACE"
        may_patch = wanted == "SEMI" and ends
        place = token.location
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
            place = _behind(before)
        hint = self._foreign() or hint
        is_misspelt = wanted == "WHILE" and closest_keyword(token.value, ["while"])
        report(self._diagnostics, place, text, "did you mean 'while'?" if is_misspelt else hint)
        if is_misspelt:
            self._index += 1
            return token
        if may_patch and self._index != self._last_patch:
            self._last_patch = self._index
            return token.copy("SEMI", ";")
        raise ParseError(text)

    def _foreign(self) -> str:
        """Gives a hint where the tokens around the next one are of another language."""
        around = [each for each in self._buffer[max(0, self._index - 2) : self._index + 2] if each]
        declared = set[str]().union(*self._scope_stack)
        words = [each.value for each in around if each.value not in declared]
        return CPLUSPLUS if is_cplusplus(words) else ""

    def _opened(self, opening: str, what: str) -> str:
        """Gives a hint to the last parenthesis, bracket or brace that is still open."""
        depth, closing = 0, _CLOSING[opening]
        for token in reversed(self._buffer[: self._index]):
            depth += {closing: 1, opening: -1}.get(token.type, 0)
            if depth < 0:
                return f"{what} {_SPELLING[opening]} at {token.location}"
        return ""

    # Recovery

    def _parse_block_item(self) -> Node:
        start, depth = self._index, len(self._scope_stack)
        try:
            self._mend_statement()
            self._declare_unknown_type()
            return super()._parse_block_item()
        except ParseError:
            if self._buffer[self._index] is None:
                raise
            self._forget_scopes(depth)
            return self._skip(start, is_in_block=True)

    def _forget_scopes(self, depth: int) -> None:
        del self._scope_stack[depth:]
        self._typedef_checked_token = None

    def _skip(self, start: int, *, is_in_block: bool) -> Broken:
        """Goes behind the end of a broken declaration or statement that began at `start`."""
        stop, self._index, depth = self._index, start, 0
        broken = Broken([], self._buffer[start])
        while (token := self._buffer[self._index]) is not None:
            if token.type == "RBRACE" and depth == 0 and is_in_block:
                break
            self._index += 1
            if token.type in NAMES and depth == 0:
                broken.names.append(token.value)
            depth += {"LBRACE": 1, "RBRACE": -1}.get(token.type, 0)
            is_end = token.type in {"SEMI", "RBRACE"} and depth <= 0
            if is_end and self._index >= stop:
                following = self._buffer[self._index]
                if token.type == "SEMI" or following is None or following.type != "SEMI":
                    break
        return broken

    # Declarations that end without a semicolon, where C would read on into the next one

    def _parse_struct_or_union_specifier(self) -> Node:
        node = super()._parse_struct_or_union_specifier()
        self._end_members()
        return node

    def _parse_enum_specifier(self) -> Node:
        node = super()._parse_enum_specifier()
        self._end_members()
        return node

    def _end_members(self) -> None:
        """Ends a declaration after its members if another type follows on a later line."""
        if self._buffer[self._index - 1].type != "RBRACE":
            return
        ahead = 1
        while self._peek_type(ahead) in _BEFORE_TYPES:
            ahead += 1
        token = self._peek(ahead)
        is_type = token is not None and self._starts_declaration(token)
        if is_type and (token.type != "TYPEID" or self._peek_type(ahead + 1) in _NAMED):
            self._end_declaration()

    def _parse_id_declarator(self) -> Node:
        declarator = super()._parse_id_declarator()
        arguments = declarator.args if isinstance(declarator, c_ast.FuncDecl) else None
        has_names = arguments is not None and isinstance(arguments.params[0], c_ast.ID)
        if not has_names and self._starts_declaration():
            self._end_declaration()
        return declarator

    def _end_declaration(self) -> None:
        """Reports a missing semicolon at the end of an earlier line, and puts it in."""
        before, token = self._buffer[self._index - 1 : self._index + 1]
        if before.lineno == token.lineno:
            return
        report(self._diagnostics, _behind(before), f"expected ';' after '{shown(before.value)}'")
        self._buffer.insert(self._index, token.copy("SEMI", ";"))
        self._typedef_checked_token = None

    # The C of 1990, and names of types that nobody declared

    def _parse_external_declaration(self) -> list[Node]:
        token = self._peek()
        if token is not None and token.type in {"ID", "TIMES", "LPAREN"}:
            self._declare_unknown_type()
            if self._peek_type() in {"ID", "TIMES", "LPAREN"}:
                self._put_in_int(token)
        elif token is not None and not self._starts_external(token):
            self._index += 1
            report(
                self._diagnostics, token.location, f"expected a declaration before '{token.value}'"
            )
            raise ParseError
        found: list[Node] = super()._parse_external_declaration()
        if found and isinstance(found[0], c_ast.FuncDef):
            found[0].body.coord = self._buffer[self._index - 1]  # where it can fall off its end
        return found

    def _starts_external(self, token: Token) -> bool:
        others = {"SEMI", "PPHASH", "PPPRAGMA", "_PRAGMA", "_STATIC_ASSERT"}
        return token.type in others or self._starts_declaration(token)

    def _put_in_int(self, token: Token) -> None:
        self._warn_of_int(token)
        self._buffer.insert(self._index, token.copy("INT", "int"))
        self._typedef_checked_token = None

    def _warn_of_int(self, token: Token) -> None:
        """Says that an `int` is left out, once in a file: where it is habit, it is everywhere."""
        if not self._said_int:
            self._diagnostics.warning(token.location, _IMPLICIT_INT)
        self._said_int = True

    def _parse_declaration_specifiers(self, allow_no_type: bool = False) -> Any:
        self._declare_unknown_type()
        spec, saw_type, place = super()._parse_declaration_specifiers(allow_no_type)
        if not spec["type"]:
            self._warn_of_int(place)
            spec["type"].append(c_ast.IdentifierType(["int"], coord=place))
        return spec, saw_type, place

    def _parse_struct_declaration(self) -> list[Node] | None:
        self._declare_unknown_type()
        found: list[Node] | None = super()._parse_struct_declaration()
        return found

    def _parse_identifier_list_opt(self) -> Node:
        if self._declare_unknown_type() or self._starts_declaration():
            return self._parse_parameter_type_list()
        return super()._parse_identifier_list_opt()

    def _declare_unknown_type(self) -> bool:
        """Takes the next name for a type if nothing else makes sense; the checker will object."""
        ahead = 1
        while self._peek_type(ahead) in _BEFORE_TYPES:
            ahead += 1
        self._mend_specifier(ahead - 1)
        token = self._peek(ahead)
        if token is None or token.type != "ID":
            return False
        if any(token.value in scope for scope in self._scope_stack):
            return False
        ahead += 1
        stars = ahead
        while self._peek_type(ahead) == "TIMES":
            ahead += 1
        if self._peek_type(ahead) != "ID":
            return False
        if ahead > stars and self._peek_type(ahead + 1) not in {
            "SEMI", "EQUALS", "COMMA", "RPAREN", "LPAREN", "LBRACKET",
        }:  # fmt: skip
            return False
        self._scope_stack[0][token.value] = True
        self._typedef_checked_token = None
        return True

    def _type_modify_decl(self, decl: Any, modifier: Any) -> Node:
        tail, depth = decl, 0
        while not isinstance(tail, c_ast.TypeDecl):
            tail, depth = tail.type, depth + 1
        if depth > _MOST_DERIVATIONS:
            self._parse_error("Declarator is nested too deeply", tail.coord)
        return super()._type_modify_decl(decl, modifier)

    # No C before 2023 has attributes.

    def _parse_attribute_specifier_sequence(self) -> list[Node]:
        return []

    # A type name may be tried at one place twice; nested ones would be tried 2^depth times.

    def _try_parse_paren_type_name(self) -> Any:
        token = self._peek()
        if token is None or token.type != "LPAREN":
            return None
        mark = self._index
        known = self._type_names.get(mark)
        if known is not None:
            self._index = known[1]
            return known[0]
        result = super()._try_parse_paren_type_name()
        if result is not None:
            self._type_names[mark] = (result, self._index)
        return result
