"""The messages of log points, from a format string and expressions."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from crs_cc.debug.errors import DebugError

_CONVERSION: Final = re.compile(
    r"%(?:%|[-+ #0]*\d*(?:\.\d+)?(?:hh|h|ll|l|L|z|t|j)?([diouxXcsfFeEgGap]))"
)
_ESCAPES: Final = {"n": "\n", "t": "\t", '"': '"', "\\": "\\", "'": "'"}


def log_text(literal: str, expressions: Sequence[str]) -> str:
    r"""Return the message of a log point with the expressions in braces.

    Raises:
        DebugError: the format is not a string, or the number of expressions is wrong.

    >>> log_text(r'"%d of %s\n"', ["left + 1", "name"])
    '{left + 1} of {name}'
    """
    if not re.fullmatch(r'"(?:[^"\\]|\\.)*"', literal):
        raise DebugError(f"{literal} is not a format string in double quotes")
    text = re.sub(r"\\(.)", lambda found: _ESCAPES.get(found[1], found[0]), literal[1:-1])
    left = list(expressions)

    def value(found: re.Match[str]) -> str:
        if not found[1]:
            return "%"
        if not left:
            raise DebugError("not enough arguments for the format")
        return f"{{{left.pop(0)}}}"

    made = _CONVERSION.sub(value, text.removesuffix("\n"))
    if left:
        raise DebugError(f"too many arguments for the format: {', '.join(left)}")
    return made
