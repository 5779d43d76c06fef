"""The value of the expression after `#if` (C17 6.10.1).

All arithmetic is done in `intmax_t` and `uintmax_t`, 64 bits. Operators are kept on a stack until
one of lower precedence follows, so that the depth of nesting is not limited. An error is part of
the value: `0 && 1/0` is valid because the right side is not evaluated.

>>> from crs_cc.frontend.preprocess.tokens import tokenise
>>> evaluate(tokenise("(1 << 4) + 0x10 > 31 && -1 > 0u", 0))
True
>>> evaluate(tokenise("2 || 1 / 0", 0))
True
>>> evaluate(tokenise("1 +", 0))
Traceback (most recent call last):
crs_cc.frontend.preprocess.condition.ConditionError: unexpected end of the expression
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final, NamedTuple

from crs_cc.frontend.preprocess.constants import Value, constant
from crs_cc.frontend.preprocess.source_text import Position
from crs_cc.frontend.preprocess.tokens import CHARACTER, NAME, NUMBER, STRING, Token, shown

_COMPARE: Final[dict[str, Callable[[int, int], bool]]] = {
    "==": lambda left, right: left == right,
    "!=": lambda left, right: left != right,
    "<": lambda left, right: left < right,
    ">": lambda left, right: left > right,
    "<=": lambda left, right: left <= right,
    ">=": lambda left, right: left >= right,
}
_ARITHMETIC: Final[dict[str, Callable[[int, int], int]]] = {
    "+": lambda left, right: left + right,
    "-": lambda left, right: left - right,
    "*": lambda left, right: left * right,
    "&": lambda left, right: left & right,
    "|": lambda left, right: left | right,
    "^": lambda left, right: left ^ right,
}
_ROWS: Final = (",", "?", "||", "&&", "|", "^", "&", "== !=", "< > <= >=", "<< >>", "+ -", "* / %")
_PRECEDENCE: Final = {name: level for level, row in enumerate(_ROWS) for name in row.split()}
_UNARY: Final = len(_ROWS)


class ConditionError(Exception):
    """The expression has no value.

    Attributes:
        position: the position of the error; None for the end of the expression.
        hint: a hint for the user.
    """

    def __init__(self, position: Position | None, text: str, hint: str = "") -> None:
        self.position = position
        self.hint = hint
        super().__init__(text)


class _Operator(NamedTuple):
    """A pending operator: `(`, a unary one such as `-x`, a binary one, or `?` and then `?:`."""

    text: str
    precedence: int
    position: Position


def evaluate(tokens: Sequence[Token]) -> bool:
    """Return whether an expression is not 0; all macros in it must have been replaced.

    Raises:
        ConditionError: it has no value.
    """
    if not tokens:
        raise ConditionError(None, "expected an expression")
    value = _Evaluation().value(tokens)
    if value.problem:
        raise ConditionError(value.position, value.problem)
    return value.number != 0


class _Evaluation:
    """The stacks of operands and of pending operators."""

    def __init__(self) -> None:
        self.values: list[Value] = []
        self.operators: list[_Operator] = []

    def value(self, tokens: Sequence[Token]) -> Value:
        operand_next = True
        for index, token in enumerate(tokens):
            if operand_next:
                follower = tokens[index + 1].text if index + 1 < len(tokens) else ""
                operand_next = self._operand(token, follower)
            else:
                operand_next = self._operator(token)
        if operand_next:
            raise ConditionError(None, "unexpected end of the expression")
        self._apply_down_to(0)
        if self.operators:
            waiting = self.operators[-1]
            partner = ")" if waiting.text == "(" else ":"
            raise ConditionError(waiting.position, f"missing '{partner}' for '{waiting.text}'")
        return self.values[0]

    def _operand(self, token: Token, follower: str) -> bool:
        """Read a token where an operand must start; return whether one must still follow."""
        text = token.text
        if token.kind == NAME:
            if follower == "(":
                raise ConditionError(token.position, f"the macro '{shown(text)}' is not defined")
            self.values.append(Value(0, unsigned=False))
            return False
        if token.kind in (NUMBER, CHARACTER):
            self.values.append(constant(token))
            return False
        if text in ("+", "-", "!", "~"):
            self.operators.append(_Operator(text + "x", _UNARY, token.position))
            return True
        if text == "(":
            self.operators.append(_Operator(text, -1, token.position))
            return True
        what = "string" if token.kind == STRING else f"'{shown(text)}'"
        raise ConditionError(token.position, f"unexpected {what} in the expression")

    def _operator(self, token: Token) -> bool:
        """Read a token after an operand; return whether an operand must follow."""
        text = token.text
        if text in (")", ":"):
            opening = "(" if text == ")" else "?"
            self._apply_down_to(0)
            if not self.operators or self.operators[-1].text != opening:
                raise ConditionError(token.position, f"'{text}' without '{opening}' before it")
            waiting = self.operators.pop()
            if text == ":":
                self.operators.append(_Operator("?:", _PRECEDENCE["?"], waiting.position))
            return text == ":"
        level = _PRECEDENCE.get(text)
        if level is None:
            hint = "compare with '=='" if text == "=" else ""
            raise ConditionError(
                token.position, f"expected an operator before '{shown(text)}'", hint
            )
        self._apply_down_to(level + 1 if text == "?" else level)
        self.operators.append(_Operator(text, level, token.position))
        return True

    def _apply_down_to(self, level: int) -> None:
        """Apply the operators of at least this precedence, up to an open `(` or `?`."""
        while self.operators:
            top = self.operators[-1]
            if top.text in ("(", "?") or top.precedence < level:
                return
            self.operators.pop()
            self._apply(top)

    def _apply(self, operator: _Operator) -> None:
        values = self.values
        right = values.pop()
        if operator.precedence == _UNARY:
            values.append(_unary(operator.text[0], right))
            return
        left = values.pop()
        if operator.text == "?:":
            values.append(_choose(values.pop(), left, right))
        else:
            values.append(_binary(operator, left, right))


def _unary(operator: str, value: Value) -> Value:
    if operator == "!":
        return value.with_number(int(value.number == 0), unsigned=False)
    number = {"-": -value.number, "~": ~value.number, "+": value.number}[operator]
    return value.with_number(number, unsigned=value.unsigned)


def _choose(condition: Value, left: Value, right: Value) -> Value:
    """Return the value of `condition ? left : right` in their common type."""
    chosen = left if condition.number else right
    chosen = chosen.with_number(chosen.number, unsigned=left.unsigned or right.unsigned)
    return condition if condition.problem else chosen


def _binary(operator: _Operator, left: Value, right: Value) -> Value:
    text = operator.text
    if text in ("&&", "||"):
        short = bool(left.number) == (text == "||")
        judge = left if short or left.problem else right
        return judge.with_number(int(bool(judge.number)), unsigned=False)
    if text == ",":
        return left if left.problem else right
    faulty = left if left.problem else right
    if text in ("<<", ">>"):
        count = right.number if text == "<<" else -right.number
        return faulty.with_number(_shifted(left.number, count), unsigned=left.unsigned)
    unsigned = left.unsigned or right.unsigned
    a = left.with_number(left.number, unsigned=unsigned).number
    b = right.with_number(right.number, unsigned=unsigned).number
    if text in _COMPARE:
        return faulty.with_number(int(_COMPARE[text](a, b)), unsigned=False)
    if text in _ARITHMETIC:
        return faulty.with_number(_ARITHMETIC[text](a, b), unsigned=unsigned)
    if b == 0:
        problem = faulty.problem or "division by zero"
        return Value(0, unsigned, problem, faulty.position if faulty.problem else operator.position)
    quotient = abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)
    return faulty.with_number(quotient if text == "/" else a - quotient * b, unsigned=unsigned)


def _shifted(number: int, count: int) -> int:
    """Shift left, or right if negative; a count above 63 shifts out all bits (as in gcc)."""
    return number << min(count, 64) if count >= 0 else number >> min(-count, 64)


def resolve_defined(tokens: Sequence[Token], is_defined: Callable[[str], bool]) -> list[Token]:
    """Replace `defined NAME` and `defined(NAME)` by 0 or 1.

    Args:
        tokens: the expression.
        is_defined: returns whether a name is a macro.

    Raises:
        ConditionError: one of them is not well-formed.
    """
    result = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        if token.text == "defined":
            name, index = _operand_of_defined(tokens, index)
            answer = is_defined(name)
        else:
            result.append(token)
            index += 1
            continue
        result.append(Token(NUMBER, str(int(answer)), token.position, token.spaced))
    return result


def _operand_of_defined(tokens: Sequence[Token], index: int) -> tuple[str, int]:
    in_parentheses = index + 1 < len(tokens) and tokens[index + 1].text == "("
    at = index + 2 if in_parentheses else index + 1
    if at >= len(tokens) or tokens[at].kind != NAME:
        raise ConditionError(tokens[index].position, "'defined' must be followed by a name")
    if not in_parentheses:
        return tokens[at].text, at + 1
    if at + 1 >= len(tokens) or tokens[at + 1].text != ")":
        raise ConditionError(tokens[index].position, "missing ')' after 'defined'")
    return tokens[at].text, at + 2
