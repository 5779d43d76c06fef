"""Alignment of objects and members: `_Alignas` and the attributes `aligned` and `packed`."""

from __future__ import annotations

from typing import Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import constant
from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.check.declarator import type_name
from crs_cc.frontend.check.scope import TypedefName
from crs_cc.frontend.parse.gnu_attributes import Attribute
from crs_cc.frontend.parse.nodes import Node
from crs_cc.frontend.preprocess.gnu import PACK

_LARGEST: Final = 4096
_BIGGEST: Final = 16
"""The alignment of `aligned` without a number: gcc's `__BIGGEST_ALIGNMENT__` on i386."""


def alignment(unit: Unit, node: Node) -> int:
    """Return the alignment that specifiers and attributes demand [bytes], 0 if none.

    Raises:
        CheckError: it is not a valid alignment.
    """
    largest = attribute_alignment(unit, attributes(node))
    for each in getattr(node, "align", None) or []:
        operand = each.alignment
        if isinstance(operand, c_ast.Typename):
            align = natural_alignment(unit, operand) or type_name(unit, operand).align
        else:
            align = _number(unit, operand, unit.at(each))
        largest = max(largest, align)
    return largest


def attributes(node: Node) -> list[Attribute]:
    """Return the attributes of a declaration, struct or union."""
    found = getattr(node, "attributes", None)
    return [each for each in found if type(each) is Attribute] if found else []


def has_attribute(node: Node, name: str) -> bool:
    """Return whether a declaration, struct, union or enum has an attribute."""
    return any(each.name == name for each in attributes(node))


def is_packed(node: Node) -> bool:
    """Return whether a member, struct or enum is `packed`."""
    return has_attribute(node, "packed")


def pack(node: Node) -> int:
    """Return the maximum alignment of `#pragma pack` for a struct [bytes], 0 if there is none."""
    return next((int(each.value) for each in attributes(node) if each.name == PACK), 0)


def attribute_alignment(unit: Unit, found: list[Attribute]) -> int:
    """Return the alignment that `aligned` attributes demand [bytes], 0 if there are none."""
    largest = 0
    for each in found:
        if each.name == "aligned":
            bare = each.value is None
            largest = max(largest, _BIGGEST if bare else _number(unit, each.value, each.location))
    return largest


def natural_alignment(unit: Unit, node: Node) -> int:
    """Return the alignment of a `typedef` with an attribute [bytes], 0 for any other type."""
    inner = node.type
    while isinstance(inner, c_ast.ArrayDecl):
        inner = inner.type
    if not isinstance(inner, c_ast.TypeDecl) or not isinstance(inner.type, c_ast.IdentifierType):
        return 0
    symbol = unit.scope.find(inner.type.names[0])
    return symbol.align if isinstance(symbol, TypedefName) else 0


def _number(unit: Unit, node: Node, location: Location) -> int:
    align = constant.integer(unit, node, "alignment")
    if align < 0 or align & (align - 1) or align > _LARGEST:
        raise CheckError(location, f"alignment {align} is not a small power of two")
    return align
