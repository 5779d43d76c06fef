"""Parses expressions and blocks so that each node knows where it begins and ends.

pycparser notes one token for each expression, for most of them that of their first operand: `a / b`
and `a / b / c` would look alike to whoever is told of a mistake in one of them. This part of the
parser makes the `coord` of every operator a `Span`, and it is faster where there is just a name or
a number.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from pycparser import c_ast

from crs_cc.frontend.parse.gnu import GnuParser
from crs_cc.frontend.parse.lexer import Span

if TYPE_CHECKING:
    from crs_cc.frontend.parse.parser import Node

NAMES: Final = frozenset({"ID", "TYPEID"})
"""Types of the tokens that are identifiers."""

_LEAVES: Final = frozenset({"ID", "INT_CONST_DEC"})
_SUFFIXES: Final = frozenset({"LBRACKET", "LPAREN", "PERIOD", "ARROW", "PLUSPLUS", "MINUSMINUS"})
_PREFIXES: Final = frozenset(
    {"PLUSPLUS", "MINUSMINUS", "AND", "TIMES", "PLUS", "MINUS", "NOT", "LNOT"}
)
_PRECEDENCE: Final = {
    "LOR": 0, "LAND": 1, "OR": 2, "XOR": 3, "AND": 4, "EQ": 5, "NE": 5,
    "LT": 6, "GT": 6, "LE": 6, "GE": 6, "LSHIFT": 7, "RSHIFT": 7, "PLUS": 8, "MINUS": 8,
    "TIMES": 9, "DIVIDE": 9, "MOD": 9,
}  # fmt: skip
"""How tightly each binary operator binds (C17 6.5.5 to 6.5.14)."""


class ExpressionParser(GnuParser):
    """pycparser's parser with other methods for expressions; it reads the tokens in `_buffer`."""

    _buffer: list[Any]
    _index: int

    def _span(self, start: int) -> Span:
        """Gives the tokens from number `start` up to the last one that was read."""
        return Span(self._buffer[start], self._buffer[self._index - 1])

    def _parse_compound_statement(self, **how: Any) -> Node:
        start = self._index
        node = super()._parse_compound_statement(**how)
        node.coord = self._span(start)
        return node

    def _parse_iteration_statement(self) -> Node:
        start = self._index
        node = super()._parse_iteration_statement()
        node.coord = self._span(start)
        return node

    def _parse_conditional_expression(self) -> Node:
        """Parses `a ? b : c`, and gcc's `a ?: c`."""
        start = self._index
        condition = self._parse_binary_expression()
        if self._accept("CONDOP") is None:
            return condition
        then = None if self._peek_type() == "COLON" else self._parse_expression()
        self._expect("COLON")
        otherwise = self._parse_conditional_expression()
        return c_ast.TernaryOp(condition, then, otherwise, self._span(start))

    def _parse_binary_expression(self, min_prec: int = 0, lhs: Node | None = None) -> Node:
        """Parses operators that bind at least as tightly as `min_prec` says."""
        start = self._index
        left = self._parse_cast_expression() if lhs is None else lhs
        while True:
            token = self._peek()
            precedence = -1 if token is None else _PRECEDENCE.get(token.type, -1)
            if precedence < min_prec:
                return left
            self._index += 1
            right = self._parse_binary_expression(precedence + 1)
            left = c_ast.BinaryOp(token.value, left, right, self._span(start))

    def _parse_unary_expression(self) -> Node:
        token, start = self._peek(), self._index
        node = super()._parse_unary_expression()
        if token is not None and token.type in _PREFIXES:
            node.coord = self._span(start)
        return node

    def _parse_postfix_expression(self) -> Node:
        start = self._index
        node = self._parse_operand()
        while (suffix := self._peek_type()) in _SUFFIXES:
            node = self._parse_suffix(node, suffix)
            node.coord = self._span(start)
        return node

    def _parse_operand(self) -> Node:
        """Parses a compound literal or a primary expression."""
        found = self._try_parse_paren_type_name()
        if found is None:
            return self._parse_primary_expression()
        ctype, mark, parenthesis, storage = found
        if self._peek_type() != "LBRACE":
            self._reset(mark)
            return self._parse_primary_expression()
        return c_ast.CompoundLiteral(ctype, self._parse_initializer(), storage, parenthesis)

    def _parse_suffix(self, node: Node, suffix: str | None) -> Node:
        """Parses what follows an operand: an index, arguments, a member, `++` or `--`."""
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

    def _parse_cast_expression(self) -> Node:
        token = self._peek()
        if token is None or token.type not in _LEAVES:
            return super()._parse_cast_expression()
        following = self._buffer[self._index + 1]
        if following is not None and following.type in _SUFFIXES:
            return self._parse_postfix_expression()
        self._index += 1
        if token.type == "ID":
            return c_ast.ID(token.value, token)
        return c_ast.Constant("int", token.value, token)
