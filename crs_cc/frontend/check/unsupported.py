"""Unsupported syntax: each pycparser node class is checked, part of another, or refused here.

A test checks this for all classes, so that one added by a later pycparser is noticed.
"""

from __future__ import annotations

from typing import Final

from pycparser import c_ast

from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.parse.nodes import Node

REFUSED: Final[dict[type, str]] = {
    c_ast.Attribute: "attributes in [[...]] are not supported",
    c_ast.AttributeDeclaration: "attributes in [[...]] are not supported",
    c_ast.AttributeSpecifier: "attributes in [[...]] are not supported",
    c_ast.AttributedStatement: "attributes in [[...]] are not supported",
    c_ast.AttributedType: "attributes in [[...]] are not supported",
    c_ast.BitIntType: "'_BitInt' is not supported",
}
"""Node classes of C23, and the errors for them."""

PARTS: Final[dict[type, str]] = {
    c_ast.Alignas: "alignment.alignment",
    c_ast.ArrayDecl: "declarator.declared_type",
    c_ast.ArrayDesignator: "initializer.initialise",
    c_ast.DeclList: "statements.for_",
    c_ast.EllipsisParam: "declarator.declared_type",
    c_ast.Enum: "tag.enum_type",
    c_ast.Enumerator: "tag.enum_type",
    c_ast.EnumeratorList: "tag.enum_type",
    c_ast.FileAST: "grammar.translation_unit, which returns its content",
    c_ast.FuncDecl: "declarator.declared_type",
    c_ast.GenericAssociation: "expressions.generic",
    c_ast.IdentifierType: "declarator.declared_type",
    c_ast.InferredType: "declaration.declared_or_broken",
    c_ast.InitList: "initializer.initialise",
    c_ast.NamedInitializer: "initializer.initialise",
    c_ast.ParamList: "declarator.declared_type",
    c_ast.PtrDecl: "declarator.declared_type",
    c_ast.Struct: "tag.record_type",
    c_ast.TypeDecl: "declarator.declared_type",
    c_ast.TypeOf: "declarator.declared_type",
    c_ast.Typename: "declarator.type_name",
    c_ast.Union: "tag.record_type",
}
"""Node classes that only occur inside others, and the functions that read them."""


def refused(unit: Unit, node: Node) -> CheckError:
    """Return the error for an unsupported node."""
    unexpected = f"'{node.__class__.__name__}' is not expected here"
    return CheckError(unit.at(node), REFUSED.get(node.__class__, unexpected))
