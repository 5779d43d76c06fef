"""The grammar's tokens and expressions: names, operators, and what GNU C adds to them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final, NoReturn

from pycparser import c_ast
from pycparser.c_parser import CParser

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.parse.attributes import Attributes
from crs_cc.frontend.parse.gnu_attributes import take_attributes
from crs_cc.frontend.parse.header_memory import HeaderTokens, unaffected
from crs_cc.frontend.parse.keyword_typos import KeywordTypos
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.nodes import (
    PREDECLARED_TYPES,
    TYPE_ARGUMENTS,
    LabelAddress,
    Node,
    Range,
    StatementExpression,
)
from crs_cc.frontend.parse.omissions import Omissions
from crs_cc.frontend.parse.syntax_errors import SyntaxErrors
from crs_cc.frontend.parse.token_stream import NAMES, TokenStream
from crs_cc.frontend.parse.token_warnings import TokenWarnings

_LEAVES: Final = frozenset({"ID", "INT_CONST_DEC"})
_SUFFIXES: Final = frozenset({"LBRACKET", "LPAREN", "PERIOD", "ARROW", "PLUSPLUS", "MINUSMINUS"})
_COMPLEX_PARTS: Final = frozenset({"__REAL", "__IMAG"})
_PREFIXES: Final = _COMPLEX_PARTS | {
    "PLUSPLUS", "MINUSMINUS", "AND", "TIMES", "PLUS", "MINUS", "NOT", "LNOT",
}  # fmt: skip
_PRECEDENCE: Final = {
    "LOR": 0, "LAND": 1, "OR": 2, "XOR": 3, "AND": 4, "EQ": 5, "NE": 5,
    "LT": 6, "GT": 6, "LE": 6, "GE": 6, "LSHIFT": 7, "RSHIFT": 7, "PLUS": 8, "MINUS": 8,
    "TIMES": 9, "DIVIDE": 9, "MOD": 9,
}  # fmt: skip
"""How tightly each binary operator binds (C17 6.5.5 to 6.5.14)."""


class ExpressionGrammar(CParser):  # type: ignore[misc]
    """A parser for the expressions of one file."""

    def __init__(
        self,
        tokens: Sequence[Token],
        diagnostics: Diagnostics,
        standard: str = "gnu17",
        type_names: Iterable[str] = (),
        *,
        headers: Mapping[Token, HeaderTokens] | None = None,
    ) -> None:
        """Take the tokens, out of which attributes are taken and kept apart.

        Args:
            tokens: the file.
            diagnostics: receives the messages.
            standard: the C standard, a key of `STANDARDS`.
            type_names: further names that are types.
            headers: the parts of the file that come from our headers, by their first tokens.
        """
        rest, before = take_attributes(tokens, diagnostics)
        self._headers = unaffected(headers, before) if headers else {}
        stream = self._stream = TokenStream(rest, [*PREDECLARED_TYPES, *type_names])
        super().__init__(dialect="c23")
        self._standard = standard
        self._scope_stack = stream.scopes
        self._peek = stream.peek
        self._peek_type = stream.peek_type
        self._accept = stream.accept
        self._mark = stream.mark
        self._reset = stream.reset
        self._diagnostics = diagnostics
        self._errors = SyntaxErrors(stream, diagnostics)
        self._warnings = TokenWarnings(stream, diagnostics)
        self._attributes = Attributes(before, stream, self._attribute_operand)
        self._typos = KeywordTypos(stream, diagnostics)
        self._omissions = Omissions(stream, diagnostics, self._typos, self._starts_declaration)
        self._type_names: dict[int, tuple[Any, int]] = {}

    # Tokens

    @property
    def _typedef_checked_token(self) -> Token | None:
        """The token whose kind fits the scopes; pycparser resets it when it changes them."""
        return self._stream.classified

    @_typedef_checked_token.setter
    def _typedef_checked_token(self, token: Token | None) -> None:
        self._stream.classified = token

    def _advance(self) -> Any:
        token = self._peek()
        if token is None:
            self._parse_error("At end of input", None)
        self._stream.index += 1
        return token

    def _expect(self, token_type: str) -> Any:
        token = self._peek()
        if token is None:
            self._parse_error("At end of input", None)
        kind = token.type
        if token_type == kind or (kind == "TYPEID" and token_type in NAMES):
            self._stream.index += 1
            return token
        return self._errors.missing(token_type, token)

    def _tok_coord(self, tok: Token) -> Token:
        return tok

    def _parse_error(self, msg: str, coord: object) -> NoReturn:
        self._errors.unexpected(msg, coord)

    # Expressions

    def _parse_constant_expression(self) -> Any:
        """Parse `first ... last` too, for `case` and designators."""
        first = super()._parse_constant_expression()
        if self._accept("ELLIPSIS") is None:
            return first
        return Range(first, super()._parse_constant_expression(), first.coord)

    def _parse_assignment_expression(self) -> Node:
        start = self._stream.index
        target = self._parse_conditional_expression()
        if not self._is_assignment_op():
            return target
        token = self._advance()
        first = self._stream.index
        value = self._parse_assignment_expression()
        self._warnings.assignment(token, start, first, value)
        return c_ast.Assignment(token.value, target, value, self._stream.span(start))

    def _parse_conditional_expression(self) -> Node:
        """Parse `a ? b : c` and GNU's `a ?: c`."""
        start = self._stream.index
        condition = self._parse_binary_expression()
        if self._accept("CONDOP") is None:
            return condition
        then = None if self._peek_type() == "COLON" else self._parse_expression()
        self._expect("COLON")
        otherwise = self._parse_conditional_expression()
        return c_ast.TernaryOp(condition, then, otherwise, self._stream.span(start))

    def _parse_binary_expression(self, min_prec: int = 0, lhs: Node | None = None) -> Node:
        """Parse operators with a precedence of at least `min_prec`."""
        stream = self._stream
        start = stream.index
        left = self._parse_cast_expression() if lhs is None else lhs
        while True:
            token = stream.peek()
            precedence = -1 if token is None else _PRECEDENCE.get(token.type, -1)
            if precedence < min_prec:
                return left
            stream.index += 1
            second = stream.index
            right = self._parse_binary_expression(precedence + 1)
            self._warnings.operation(token, (left, start), (right, second))
            left = c_ast.BinaryOp(token.value, left, right, stream.span(start))

    def _parse_cast_expression(self) -> Node:
        stream = self._stream
        token = stream.peek()
        if token is None or token.type not in _LEAVES:
            return super()._parse_cast_expression()
        following = stream.buffer[stream.index + 1]
        if following is not None and following.type in _SUFFIXES:
            return self._parse_postfix_expression()
        stream.index += 1
        if token.type == "ID":
            return c_ast.ID(token.value, token)
        return c_ast.Constant("int", token.value, token)

    def _starts_expression(self, tok: Token | None = None) -> bool:
        token = tok or self._peek()
        is_part = token is not None and token.type in _COMPLEX_PARTS
        return is_part or bool(super()._starts_expression(tok))

    def _parse_unary_expression(self) -> Node:
        start, kind = self._stream.index, self._peek_type()
        if kind == "_ALIGNOF":
            return self._alignof()
        if kind == "LAND":
            token = self._advance()
            return LabelAddress(self._expect("ID").value, token)
        if kind in _COMPLEX_PARTS:
            name = self._advance().value.rstrip("_")
            node = c_ast.UnaryOp(name, self._parse_cast_expression())
        else:
            node = super()._parse_unary_expression()
        if kind in _PREFIXES:
            node.coord = self._stream.span(start)
        return node

    def _alignof(self) -> Node:
        """Parse `_Alignof (type)` and GNU's `__alignof__ expression`."""
        token = self._advance()
        found = self._try_parse_paren_type_name()
        if found is not None and self._peek_type() != "LBRACE":
            return c_ast.UnaryOp("_Alignof", found[0], token)
        if found is not None:
            self._reset(found[1])
        return c_ast.UnaryOp("_Alignof", self._parse_unary_expression(), token)

    def _parse_postfix_expression(self) -> Node:
        start = self._stream.index
        node = self._operand()
        while (suffix := self._peek_type()) in _SUFFIXES:
            node = self._suffix(node, suffix)
            node.coord = self._stream.span(start)
        return node

    def _operand(self) -> Node:
        """Parse a compound literal or a primary expression."""
        found = self._try_parse_paren_type_name()
        if found is None:
            return self._parse_primary_expression()
        ctype, mark, parenthesis, storage = found
        if self._peek_type() != "LBRACE":
            self._reset(mark)
            return self._parse_primary_expression()
        return c_ast.CompoundLiteral(ctype, self._parse_initializer(), storage, parenthesis)

    def _suffix(self, node: Node, suffix: str | None) -> Node:
        """Parse what follows an operand: an index, arguments, a member, `++` or `--`."""
        token = self._advance()
        if suffix == "LBRACKET":
            subscript = self._parse_expression()
            self._expect("RBRACKET")
            return c_ast.ArrayRef(node, subscript)
        if suffix == "LPAREN":
            arguments = None
            if self._peek_type() != "RPAREN":
                arguments = self._parse_argument_expression_list()
            self._expect("RPAREN")
            return c_ast.FuncCall(node, arguments)
        if suffix in {"PLUSPLUS", "MINUSMINUS"}:
            return c_ast.UnaryOp(f"p{token.value}", node)
        name = self._advance()
        if name.type not in NAMES:
            self._parse_error("Invalid struct reference", name)
        return c_ast.StructRef(node, token.value, c_ast.ID(name.value, name))

    def _parse_primary_expression(self) -> Any:
        """Parse statements in parentheses, and builtins whose arguments are types, too."""
        token = self._peek()
        if token is not None and token.type == "LPAREN" and self._peek_type(2) == "LBRACE":
            self._advance()
            body = self._parse_compound_statement()
            self._expect("RPAREN")
            return StatementExpression(body, token)
        if token is None or token.type != "ID" or token.value not in TYPE_ARGUMENTS:
            return super()._parse_primary_expression()
        self._advance()
        self._expect("LPAREN")
        types = [self._parse_type_name()]
        while self._accept("COMMA"):
            types.append(self._parse_type_name())
        self._expect("RPAREN")
        return c_ast.FuncCall(c_ast.ID(token.value, token), c_ast.ExprList(types, token), token)

    def _try_parse_paren_type_name(self) -> Any:
        """Parse `(type)`, once at each position: nested ones would be tried 2^depth times."""
        token = self._peek()
        if token is None or token.type != "LPAREN":
            return None
        mark = self._stream.index
        known = self._type_names.get(mark)
        if known is not None:
            self._stream.index = known[1]
            return known[0]
        result = super()._try_parse_paren_type_name()
        if result is not None:
            self._type_names[mark] = (result, self._stream.index)
        return result
