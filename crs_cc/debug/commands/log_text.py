"""The texts of log points, from a format string and expressions."""

from __future__ import annotations

import re
from collections.abc import Sequence

from crs_cc.debug.commands.c_format import CONVERSION, string_literal
from crs_cc.debug.errors import DebugError


def log_text(literal: str, expressions: Sequence[str]) -> str:
    r"""Return the text of a log point with the expressions in braces, see `debug.log_message`.

    Raises:
        DebugError: the format is not a string, or the number of expressions is wrong.

    >>> log_text(r'"%d of %5s\n"', ["left + 1", "name"])
    '{%d left + 1} of {%5s name}'
    """
    left = list(expressions)

    def with_expressions(found: re.Match[str]) -> str:
        if found["kind"] is None:
            return "%"
        count = 1 + found[0].count("*")
        if len(left) < count:
            raise DebugError("not enough arguments for the format")
        own = ", ".join(left[:count])
        del left[:count]
        return f"{{{found[0]} {own}}}"

    made = CONVERSION.sub(with_expressions, string_literal(literal).removesuffix("\n"))
    if left:
        raise DebugError(f"too many arguments for the format: {', '.join(left)}")
    return made
