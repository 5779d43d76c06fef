"""Functions and objects that are missing in a program, but can be used in expressions.

They are the functions of the user's that nothing uses, so that the linker has left them out, and
the definitions of the library that do not need the simulated world. Objects of the library are
fresh for each expression; those of the user's are in `unused_objects`.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.names import LIBRARY
from crs_cc.ir.program import Data, Function, Program
from crs_cc.session.library import library

_PURE: Final = tuple(f"{LIBRARY}{part}/" for part in ("math", "stdlib", "string", "wide"))
"""The parts of the library that programs need not have linked for expressions to use them."""


class UnlinkedDefinitions:
    """The definitions that one program lacks."""

    def __init__(self, program: Program) -> None:
        """Set the program."""
        self._unused = program.unused or Program()

    def get(self, name: str) -> Function | Data | None:
        """Return a definition by the linker's name; None if there is none."""
        own = self._unused.functions.get(name)
        if own is not None:
            return own
        found = library().find(name)
        return None if found is None or not found.location.file.startswith(_PURE) else found
