"""Warns of what looks like something else: `if (a = b)`, `x =+ 1`, `if (x);`.

Only the tokens show it, so the parser tells.
"""

from __future__ import annotations

from typing import Any, Final, TypeAlias

from pycparser import c_ast

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.parse.expressions import ExpressionParser
from crs_cc.frontend.parse.lexer import Token

Node: TypeAlias = Any

_TURNED: Final = frozenset({"+", "-", "*", "&", "!"})
"""Operators that may have changed places with a `=`."""

_CONDITIONS: Final = frozenset({"IF", "WHILE"})


class WarningParser(ExpressionParser):
    """The parser of expressions, with warnings."""

    _diagnostics: Diagnostics

    def _parse_assignment_expression(self) -> Node:
        start = self._index
        target = self._parse_conditional_expression()
        if not self._is_assignment_op():
            return target
        token = self._advance()
        first = self._index
        value = self._parse_assignment_expression()
        if token.value == "=":
            self._warn_turned(token, first)
            self._warn_condition(token, start, value)
        return c_ast.Assignment(token.value, target, value, self._span(start))

    def _warn_turned(self, token: Token, first: int) -> None:
        """Warns of `x =+ 1`: one word to the eye, two to the compiler."""
        operator, operand = self._buffer[first : first + 2]
        if operator.value not in _TURNED or not _adjacent(token, operator) or operand is None:
            return
        if not _adjacent(operator, operand) and operand.lineno == operator.lineno:
            what = operator.value
            hint = f"write '{what}=', or put a space between '=' and '{what}'"
            if what == "!":
                hint = "write '!=', or put a space between '=' and '!'"
            self._diagnostics.warning(token.location, f"'={what}' means '= {what}' here", hint)

    def _warn_condition(self, token: Token, start: int, value: Node) -> None:
        """Warns of `if (a = b)` and `while (a = 1)`, but not of `if ((a = b))`.

        `while (*to++ = *from++)` is how C of 1978 was written.
        """
        before = self._buffer[start - 2 : start] if start >= 2 else []
        following = self._buffer[self._index]
        if [each.type for each in before[1:]] != ["LPAREN"] or before[0].type not in _CONDITIONS:
            return
        is_plain = isinstance(value, c_ast.Constant | c_ast.ID)
        if before[0].type == "WHILE" and not is_plain:
            return
        if following is not None and following.type == "RPAREN":
            text = "the result of an assignment is the condition"
            hint = "write '==' to compare, or a second pair of parentheses if it is meant"
            self._diagnostics.warning(token.location, text, hint)

    def _parse_selection_statement(self) -> Node:
        node = super()._parse_selection_statement()
        if isinstance(node, c_ast.If) and node.iffalse is None:
            self._warn_empty("if", node.iftrue)
        return node

    def _parse_iteration_statement(self) -> Node:
        node = super()._parse_iteration_statement()
        following = self._buffer[self._index]
        if following is not None and following.type == "LBRACE":
            keyword = "for" if isinstance(node, c_ast.For) else "while"
            self._warn_empty(keyword, node.stmt)
        return node

    def _warn_empty(self, keyword: str, body: Node) -> None:
        """Warns of `if (x);`, unless a macro or a line of its own lies before the semicolon."""
        if not isinstance(body, c_ast.EmptyStatement):
            return
        before, semicolon = self._buffer[self._index - 2 : self._index]
        if semicolon is body.coord and before.type == "RPAREN" and _adjacent(before, semicolon):
            text = f"the body of this '{keyword}' is empty"
            hint = "take the ';' away, or put it on a line of its own if it is meant"
            self._diagnostics.warning(semicolon.location, text, hint)


def _adjacent(left: Token, right: Token) -> bool:
    """Tells whether two tokens of the user's text touch each other."""
    a, b = left.location, right.location
    return (a.file, a.line, a.column + len(left.value)) == (b.file, b.line, b.column)
