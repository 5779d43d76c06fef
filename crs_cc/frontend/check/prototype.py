"""Functions of our headers, whose types are remembered from one program to the next.

A prototype that names no struct, union or enum has the same type wherever its type names have the
same types as before.
"""

from __future__ import annotations

from typing import Final

from pycparser import c_ast

from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.declaration import declare_as, declared_or_broken
from crs_cc.frontend.check.declarator import basic_type
from crs_cc.frontend.check.scope import TypedefName
from crs_cc.frontend.parse.nodes import Node, Prototype
from crs_cc.ir.types import CType, FloatType, IntegerType, PointerType, VoidType

_PLAIN: Final = (
    c_ast.Decl,
    c_ast.FuncDecl,
    c_ast.ParamList,
    c_ast.EllipsisParam,
    c_ast.PtrDecl,
    c_ast.TypeDecl,
    c_ast.Typename,
)
"""The nodes of a prototype that depend on nothing but the type names in it."""


def declare_prototype(unit: Unit, node: Prototype) -> None:
    """Check a declaration of a function.

    Raises:
        CheckError: it has an error.
    """
    if node.known is not None and all(
        _type(unit, name) == ctype for name, ctype in node.known[1].items()
    ):
        declare_as(unit, node.declaration, node.known[0])
        return
    ctype = declared_or_broken(unit, node.declaration)
    if not node.is_checked:
        node.known = _lasting(unit, node.declaration.type, ctype)
        node.is_checked = True
    declare_as(unit, node.declaration, ctype)


def _lasting(unit: Unit, node: Node, ctype: CType) -> tuple[CType, dict[str, CType | None]] | None:
    """Return the type of a declarator and the types it depends on; None if it may be another."""
    names = _type_names(node)
    types = {name: _type(unit, name) for name in names or ()}
    if names is None or not all(map(_is_same_everywhere, types.values())):
        return None
    return ctype, types


def _type(unit: Unit, name: str) -> CType | None:
    """Return the type of a type name."""
    symbol = unit.scope.names.get(name)
    return symbol.type if isinstance(symbol, TypedefName) else None


def _type_names(node: Node) -> set[str] | None:
    """Return the type names in a declarator; None if its type depends on anything else."""
    if isinstance(node, c_ast.IdentifierType):
        if basic_type(tuple(node.names)) is not None:
            return set()
        return set(node.names) if len(node.names) == 1 else None
    if not isinstance(node, _PLAIN):
        return None
    found: set[str] = set()
    for _, child in node.children():
        names = _type_names(child)
        if names is None:
            return None
        found |= names
    return found


def _is_same_everywhere(ctype: CType | None) -> bool:
    """Return whether equal types of two programs are the same: not those with members."""
    while isinstance(ctype, PointerType):
        ctype = ctype.target
    return isinstance(ctype, VoidType | IntegerType | FloatType)
