"""The rules that lower a checked C file: those of all modules in one table."""

from __future__ import annotations

from typing import Final

from crs_cc.frontend.lower import (
    assign,
    calls,
    convert,
    expressions,
    initializer,
    lvalues,
    statements,
)

RULES: Final = (
    expressions.RULES
    | convert.RULES
    | lvalues.RULES
    | assign.RULES
    | calls.RULES
    | initializer.RULES
    | statements.RULES
)
