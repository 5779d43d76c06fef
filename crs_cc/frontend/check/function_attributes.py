"""Attributes of functions: `noreturn`, `format`, `constructor`, `weak`, ..."""

from __future__ import annotations

from crs_cc.frontend.check import constant
from crs_cc.frontend.check.alignment import attributes
from crs_cc.frontend.check.asm_label import alias, label_among
from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.check.scope import Format, FunctionSymbol
from crs_cc.frontend.parse.gnu_attributes import Attribute
from crs_cc.frontend.parse.nodes import Node

_LOWEST_PRIORITY = 65535
_FORMATS = {
    "printf": "printf", "gnu_printf": "printf", "scanf": "scanf", "gnu_scanf": "scanf",
}  # fmt: skip


def apply_attributes(unit: Unit, symbol: FunctionSymbol, node: Node) -> None:
    """Apply a declaration's attributes and specifiers to a function.

    Raises:
        CheckError: one of them is invalid.
    """
    if "_Noreturn" in (node.funcspec or []):
        symbol.is_noreturn = True
    found = attributes(node)
    if not found:
        return
    symbol.link_name = label_among(found) or symbol.link_name
    symbol.alias = alias(node) or symbol.alias
    for each in found:
        match each.name:
            case "noreturn":
                symbol.is_noreturn = True
            case "unused" | "used":
                symbol.is_used = True
            case "weak":
                symbol.is_weak = True
            case "constructor":
                symbol.starts = _priority(unit, each)
                symbol.is_used = True
            case "destructor":
                symbol.ends = _priority(unit, each)
                symbol.is_used = True
            case "format":
                symbol.format = _format(each)


def _priority(unit: Unit, attribute: Attribute) -> int:
    if attribute.value is None:
        return _LOWEST_PRIORITY
    return constant.integer(unit, attribute.value, f"priority of '{attribute.name}'")


def _format(attribute: Attribute) -> Format | None:
    """Return the meaning of `format(printf, 1, 2)`; None for kinds that are not checked."""
    words = [each.value for each in attribute.words]
    if len(words) != 3 or not words[1].isdigit() or not words[2].isdigit():
        raise CheckError(attribute.location, "'format' takes a kind and two numbers")
    kind = _FORMATS.get(words[0].strip("_"))
    return None if kind is None else Format(kind, int(words[1]) - 1, int(words[2]) - 1)
