"""Warnings about library functions that always fail, because each robot runs one program only.

They link, and say so when they are called (`crs/refuse.h`); a program that needs them does not get
far, which its author should know before a run.
"""

from __future__ import annotations

from itertools import chain
from pathlib import Path
from typing import Any, Final

from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.scope import FunctionSymbol

_NO_OTHER_PROCESS: Final = "a robot runs one process"
_NO_OTHER_PROGRAM: Final = "there are no other programs to start"
_SEVERAL_CLIENTS: Final = "to serve several clients, use select() or poll()"
_OTHER_ROBOT: Final = "run the other program as that of another robot"

_REASONS: Final = {
    "fork": (_NO_OTHER_PROCESS, _SEVERAL_CLIENTS),
    "vfork": (_NO_OTHER_PROCESS, _SEVERAL_CLIENTS),
    "pipe": (_NO_OTHER_PROCESS, ""),
    **dict.fromkeys(
        ("execl", "execle", "execlp", "execv", "execve", "execvp", "popen", "system"),
        (_NO_OTHER_PROGRAM, _OTHER_ROBOT),
    ),
    "pthread_create": ("a program has one thread", ""),
}
"""Why a function fails, and what to do instead."""


def warn_unavailable(unit: Unit, nodes: list[list[Any]]) -> None:
    """Warn about the first call of each function of the library that always fails.

    Args:
        unit: the file.
        nodes: all nodes of each function.
    """
    told: set[str] = set()
    for node in chain.from_iterable(nodes):
        symbol = _called(node)
        if symbol is None or symbol.name in told or not _is_library(unit, symbol):
            continue
        told.add(symbol.name)
        reason, hint = _REASONS[symbol.name]
        text = f"'{symbol.name}' always fails here: {reason}"
        unit.warning(node.location, text, hint, flag="unavailable-function")


def _called(node: Any) -> FunctionSymbol | None:
    """Return the function that a call names, if it might be one of these."""
    if isinstance(node, tree.Call) and isinstance(node.callee, tree.FunctionName):
        symbol = node.callee.symbol
        return symbol if symbol.name in _REASONS else None
    return None


def _is_library(unit: Unit, symbol: FunctionSymbol) -> bool:
    """Return whether a function is the library's, also if no header has declared it."""
    if symbol.is_defined or not symbol.is_external:
        return False
    in_header = any(Path(symbol.location.file).is_relative_to(each) for each in unit.headers)
    return in_header or symbol.is_implicit
