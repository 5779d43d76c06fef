"""Traversal of the checked tree.

>>> from crs_cc.frontend.check.tree import Literal, Unary
>>> from crs_cc.ir.types import INT
>>> from crs_cc.core.source import Location
>>> here = Location("a.c", 1, 1)
>>> [each.value for each in parts(Unary(INT, here, "-", Literal(INT, here, 3)))]
[3]
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

from crs_cc.frontend.check import tree

_NODES = (
    tree.Expression, tree.ExpressionStatement, tree.Declare, tree.If, tree.Loop, tree.Switch,
    tree.CaseLabel, tree.Label, tree.Goto, tree.ComputedGoto, tree.Break, tree.Continue,
    tree.Return,
)  # fmt: skip
_NOT_PARTS = frozenset({"type", "location", "symbol", "labels", "member", "computed"})


@cache
def _slots(kind: type) -> tuple[str, ...]:
    names = [name for each in reversed(kind.__mro__) for name in getattr(each, "__slots__", ())]
    return tuple(name for name in names if name not in _NOT_PARTS)


@cache
def _is_node(kind: type) -> bool:
    return issubclass(kind, _NODES)


def parts(node: Any) -> Iterator[Any]:
    """Yield the direct children of a node, in the order of its attributes."""
    for name in _slots(node.__class__):
        value = getattr(node, name)
        if _is_node(value.__class__):
            yield value
        elif isinstance(value, list):
            yield from (each for each in value if _is_node(each.__class__))
        elif isinstance(value, tree.Initialiser):
            yield from (each.value for each in value.values)


def walk(nodes: list[Any]) -> Iterator[Any]:
    """Yield nodes and all their descendants in the order of the source."""
    stack = list(reversed(nodes))
    while stack:
        node = stack.pop()
        yield node
        stack.extend(reversed(list(parts(node))))
