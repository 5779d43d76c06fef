"""Warnings that only the tokens can justify: `if (a = b)`, `x =+ 1`, `if (x);`, `0 < n < 10`."""

from __future__ import annotations

from typing import Final

from pycparser import c_ast

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.nodes import Node
from crs_cc.frontend.parse.token_stream import TokenStream

_REVERSIBLE: Final = frozenset({"+", "-", "*", "&", "!"})
"""Operators that form another one with a `=` on their other side."""

_RELATIONS: Final = frozenset({"<", ">", "<=", ">="})
_COMPARISONS: Final = _RELATIONS | {"==", "!="}
_BITWISE: Final = frozenset({"&", "|", "^"})

_CONDITIONS: Final = frozenset({"IF", "WHILE"})


class TokenWarnings:
    """Warn about correct code that looks like a typo, right after it was parsed."""

    def __init__(self, stream: TokenStream, diagnostics: Diagnostics) -> None:
        self._stream = stream
        self._diagnostics = diagnostics

    def assignment(self, token: Token, target: int, value: int, node: Node) -> None:
        """Check an assignment."""
        if token.value == "=":
            self._warn_reversed(token, value)
            self._warn_condition(token, target, node)

    def operation(self, token: Token, left: tuple[Node, int], right: tuple[Node, int]) -> None:
        """Check a binary operation.

        Args:
            token: its operator.
            left: its left operand, and where that starts.
            right: its right operand, and where that starts.
        """
        op = token.value
        if op in _RELATIONS and self._open_operator(*left) in _RELATIONS:
            text = "comparisons like 'a < b < c' do not have their mathematical meaning"
            self._diagnostics.warning(
                token.location, text, "write 'a < b && b < c'", flag="parentheses"
            )
        elif op in _BITWISE:
            inner = {self._open_operator(*left), self._open_operator(*right)} & _COMPARISONS
            for each in sorted(inner):
                text = f"'{op}' has lower precedence than '{each}', which is evaluated first"
                hint = f"write '(a {op} b) {each} c', or put parentheses around the comparison"
                self._diagnostics.warning(token.location, text, hint, flag="parentheses")

    def _open_operator(self, node: Node, start: int) -> str:
        """Return the operator of a binary operation that is not in parentheses, else ""."""
        if (
            not isinstance(node, c_ast.BinaryOp)
            or node.coord.first is not self._stream.buffer[start]
        ):
            return ""
        return str(node.op)

    def _warn_reversed(self, token: Token, first: int) -> None:
        """Warn about `x =+ 1`, which means `x = +1`."""
        operator, operand = self._stream.buffer[first : first + 2]
        if operator.value not in _REVERSIBLE or not _adjacent(token, operator) or operand is None:
            return
        if not _adjacent(operator, operand) and operand.lineno == operator.lineno:
            what = operator.value
            hint = f"write '{what}=', or put a space between '=' and '{what}'"
            if what == "!":
                hint = "write '!=', or put a space between '=' and '!'"
            self._diagnostics.warning(
                token.location, f"'={what}' means '= {what}' here", hint, flag="reversed-assignment"
            )

    def _warn_condition(self, token: Token, start: int, value: Node) -> None:
        """Warn about `if (a = b)` and `while (a = 1)`, but not about `if ((a = b))`.

        `while (*to++ = *from++)` is accepted: it is an idiom of K&R C.
        """
        buffer = self._stream.buffer
        before = buffer[start - 2 : start] if start >= 2 else []
        following = buffer[self._stream.index]
        if [each.type for each in before[1:]] != ["LPAREN"] or before[0].type not in _CONDITIONS:
            return
        is_plain = isinstance(value, c_ast.Constant | c_ast.ID)
        if before[0].type == "WHILE" and not is_plain:
            return
        if following is not None and following.type == "RPAREN":
            text = "using the result of an assignment as a condition without parentheses"
            hint = "use '==' to compare, or add parentheses if the assignment is intended"
            self._diagnostics.warning(token.location, text, hint, flag="parentheses")

    def selection(self, node: Node) -> None:
        """Check an `if` or `switch`."""
        if isinstance(node, c_ast.If) and node.iffalse is None:
            self._warn_empty("if", node.iftrue)

    def iteration(self, node: Node) -> None:
        """Check a loop."""
        following = self._stream.buffer[self._stream.index]
        if following is not None and following.type == "LBRACE":
            keyword = "for" if isinstance(node, c_ast.For) else "while"
            self._warn_empty(keyword, node.stmt)

    def _warn_empty(self, keyword: str, body: Node) -> None:
        """Warn about `if (x);`, unless the semicolon follows a macro or is on its own line."""
        if not isinstance(body, c_ast.EmptyStatement):
            return
        index = self._stream.index
        before, semicolon = self._stream.buffer[index - 2 : index]
        if semicolon is body.coord and before.type == "RPAREN" and _adjacent(before, semicolon):
            text = f"'{keyword}' statement has empty body"
            hint = "remove the ';', or put it on a separate line if it is intended"
            self._diagnostics.warning(semicolon.location, text, hint, flag="empty-body")


def _adjacent(left: Token, right: Token) -> bool:
    """Return whether there is nothing between two tokens in the user's file."""
    a, b = left.location, right.location
    return (a.file, a.line, a.column + len(left.value)) == (b.file, b.line, b.column)
