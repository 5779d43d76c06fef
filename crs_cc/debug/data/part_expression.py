"""C expressions for the parts of values, as displayed in user interfaces."""

from __future__ import annotations

import re
from typing import Final

_POSTFIX: Final = r"(?:[\w.\[\]]|->)+"
"""Expressions that need no parentheses before another postfix operator (C17 6.5.2)."""


def child_expression(expression: str, name: str) -> str:
    """Return the C expression for a part of a value.

    >>> child_expression("row", "[2]"), child_expression("*here", "x")
    ('row[2]', 'here->x')
    >>> child_expression("next", "*"), child_expression("", "x")
    ('*next', '')
    """
    if not expression:
        return ""
    whole = expression if re.fullmatch(_POSTFIX, expression) else f"({expression})"
    if name == "*":
        return f"*{whole}"
    if name.startswith("["):
        return whole + name
    if name.startswith("<"):  # without a name: its members are those of the whole
        return expression
    pointer = re.fullmatch(rf"\*({_POSTFIX})", expression)
    return f"{pointer[1]}->{name}" if pointer else f"{whole}.{name}"
