"""Definitions that a program lacks, but which expressions may use.

They are the functions and objects of the user's that nothing uses, so that the linker has left them
out, and those of the library that do not need the simulated world. Objects are fresh for each
expression.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from crs_cc.debug.data.expression_memory import EvaluationError
from crs_cc.ir.names import LIBRARY, plain_name
from crs_cc.ir.program import Data, Function, Program
from crs_cc.session.library import library

_PURE: Final = tuple(f"{LIBRARY}{part}/" for part in ("math", "stdlib", "string", "wide"))
"""The parts of the library that programs need not have linked for expressions to use them."""


class SpareDefinitions:
    """The definitions that one program lacks."""

    def __init__(self, program: Program) -> None:
        """Set the program."""
        self._unused = program.unused or Program()

    def lend(self, name: str) -> Function | Data | None:
        """Return a definition by the linker's name; None if there is none."""
        own = self._unused.functions.get(name) or self._unused.data.get(name)
        if own is not None:
            return own
        found = library().find(name)
        return None if found is None or not found.location.file.startswith(_PURE) else found

    def check(self, changed: Iterable[str]) -> None:
        """Check that none of the objects that an expression has changed is the user's.

        Raises:
            EvaluationError: one is: the change would be lost.
        """
        for name in changed:
            if name in self._unused.data:
                raise EvaluationError(
                    f"'{plain_name(name)}' cannot be changed: the program does not use it, so it is"
                    " not in its memory"
                )
