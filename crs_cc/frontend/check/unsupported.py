"""What is not compiled, by name: every pycparser node class is checked, a part, or refused here.

A test holds this: a node class that a later pycparser adds cannot slip through.
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
    c_ast.InferredType: "a type inferred from 'auto' is not supported",
}
"""Node classes of C23, and what is said of them."""

PARTS: Final[dict[type, str]] = {
    c_ast.Alignas: "alignment.alignment",
    c_ast.ArrayDecl: "declare.declared_type",
    c_ast.ArrayDesignator: "check_init.initialise",
    c_ast.DeclList: "check_stmt.for_",
    c_ast.EllipsisParam: "declare.declared_type",
    c_ast.Enum: "declare_tag.enum_type",
    c_ast.Enumerator: "declare_tag.enum_type",
    c_ast.EnumeratorList: "declare_tag.enum_type",
    c_ast.FileAST: "parse.parse, which gives its content",
    c_ast.FuncDecl: "declare.declared_type",
    c_ast.GenericAssociation: "check_expr.generic",
    c_ast.IdentifierType: "declare.declared_type",
    c_ast.InitList: "check_init.initialise",
    c_ast.NamedInitializer: "check_init.initialise",
    c_ast.ParamList: "declare.declared_type",
    c_ast.PtrDecl: "declare.declared_type",
    c_ast.Struct: "declare_tag.record_type",
    c_ast.TypeDecl: "declare.declared_type",
    c_ast.TypeOf: "declare.declared_type",
    c_ast.Typename: "declare.type_name",
    c_ast.Union: "declare_tag.record_type",
}
"""Node classes that have no meaning alone, and who reads them."""


def refused(unit: Unit, node: Node) -> CheckError:
    """Build the error for a node that is not compiled."""
    unexpected = f"'{node.__class__.__name__}' is not expected here"
    return CheckError(unit.at(node), REFUSED.get(node.__class__, unexpected))
