"""The operators of `#if` that test for features: `__has_include` and others (C23 6.10.1).

>>> attribute_version("nodiscard"), attribute_version("gnu::packed"), attribute_version("unheard")
('202003L', '1', '0')
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from crs_cc.frontend.preprocess.condition import ConditionError
from crs_cc.frontend.preprocess.macros import FEATURE_TESTS
from crs_cc.frontend.preprocess.regular_file import Refusal
from crs_cc.frontend.preprocess.tokens import NAME, NUMBER, STRING, Token, spell

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.frontend.preprocess.state import State

HEADER: Final = re.compile(r"[ \t\v\f]*(?:\"([^\"]*)\"|<([^>]*)>)")
_ATTRIBUTES: Final = {
    "deprecated": "201904L", "fallthrough": "201904L", "maybe_unused": "201904L",
    "nodiscard": "202003L", "noreturn": "202202L", "_Noreturn": "202202L",
    "gnu::aligned": "1", "gnu::packed": "1", "gnu::unused": "1", "gnu::noreturn": "1",
    "gnu::format": "1", "gnu::weak": "1", "gnu::cleanup": "1", "gnu::constructor": "1",
}  # fmt: skip


def attribute_version(name: str) -> str:
    """Return the value of `__has_c_attribute` for an attribute."""
    return _ATTRIBUTES.get(name.replace("__", ""), "0")


def resolve_features(state: State, tokens: Sequence[Token], *, expanded: bool) -> list[Token]:
    """Replace these operators in an expression by numbers.

    Args:
        state: the run.
        tokens: the expression.
        expanded: whether its macros have been replaced, so that no header is named by one.

    Raises:
        ConditionError: one of them is not well-formed.
    """
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        if token.text not in FEATURE_TESTS:
            result.append(token)
            index += 1
            continue
        inside, stop = _operand(tokens, index)
        if inside[0].kind == NAME and token.text != "__has_c_attribute" and not expanded:
            result += tokens[index:stop]
        else:
            value = _value(state, token, inside)
            result.append(Token(NUMBER, value, token.position, token.spaced))
        index = stop
    return result


def _operand(tokens: Sequence[Token], index: int) -> tuple[Sequence[Token], int]:
    """Return the tokens between the parentheses after an operator, and the index after them."""
    operator = tokens[index]
    what = "an attribute" if operator.text == "__has_c_attribute" else "a header"
    if [each.text for each in tokens[index + 1 : index + 2]] != ["("] or index + 2 >= len(tokens):
        text = f"'{operator.text}' must be followed by {what} in parentheses"
        raise ConditionError(operator.position, text)
    stop = index + 2
    if tokens[stop].text == "<":
        while stop < len(tokens) and tokens[stop].text[-1:] != ">":
            stop += 1
    depth = 0
    while stop < len(tokens) and (tokens[stop].text != ")" or depth):
        depth += {"(": 1, ")": -1}.get(tokens[stop].text, 0)
        stop += 1
    if stop >= len(tokens) or stop == index + 2:
        raise ConditionError(operator.position, f"missing ')' after '{operator.text}'")
    return tokens[index + 2 : stop], stop + 1


def _value(state: State, operator: Token, inside: Sequence[Token]) -> str:
    if operator.text == "__has_c_attribute":
        return attribute_version("".join(each.text for each in inside))
    is_only = operator.text == "__has_include" and inside[0].kind == STRING and len(inside) > 1
    match = HEADER.match(spell(inside))
    if match is None or is_only:
        raise ConditionError(operator.position, 'write "name.h" or <name.h>')
    name, quoted = match[1] or match[2] or "", match[1] is not None
    found = state.headers.find(name, quoted=quoted, folder=state.reader.folder)
    if isinstance(found, Refusal):
        return "0"
    if operator.text == "__has_embed":
        return "1" if found.read() else "2"
    return "1"
