"""Warnings about unused functions and variables."""

from __future__ import annotations

from typing import Any

from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit


def warn_unused_names(unit: Unit, nodes: list[list[Any]]) -> None:
    """Check the static functions and the local variables of a file, without its headers.

    Args:
        unit: the file.
        nodes: all nodes of each function.
    """
    for function, its_nodes in zip(unit.functions, nodes, strict=True):
        symbol = function.symbol
        if function.location.file != unit.name:
            continue
        if not symbol.is_external and not symbol.is_used:
            text = f"static function '{symbol.name}' is never called"
            unit.warning(function.location, text, flag="unused-function")
        for node in its_nodes:
            if isinstance(node, tree.Declare):
                _warn_variable(unit, node)


def _warn_variable(unit: Unit, node: tree.Declare) -> None:
    symbol = node.symbol
    if symbol.name.isidentifier() and not symbol.is_used and node.location == symbol.location:
        unit.warning(node.location, f"unused variable '{symbol.name}'", flag="unused-variable")
