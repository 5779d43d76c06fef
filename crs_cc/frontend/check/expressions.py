"""Check names, constants, members, casts and the other primary and postfix expressions."""

from __future__ import annotations

from typing import Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import complex_numbers, conversion, fold, tree, variable_record, vla
from crs_cc.frontend.check.alignment import natural_alignment
from crs_cc.frontend.check.checker import CheckError, Unit, checks, expression
from crs_cc.frontend.check.declarator import type_name
from crs_cc.frontend.check.initializer import initialise
from crs_cc.frontend.check.scope import (
    BrokenName,
    EnumConstant,
    FunctionSymbol,
    ObjectSymbol,
    TypedefName,
)
from crs_cc.frontend.check.suspicious_operands import warn_size
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.check.type_compat import compatible
from crs_cc.frontend.parse import literal
from crs_cc.frontend.parse.nodes import Node
from crs_cc.frontend.preprocess.options import is_c90
from crs_cc.ir.types import (
    BOOL,
    CHAR,
    NULLPTR,
    UINT,
    VOID,
    ArrayType,
    CType,
    FunctionType,
    Member,
    PointerType,
    RecordType,
    VoidType,
    is_complete,
    qualify,
    unqualified,
)

_PREDEFINED: Final[dict[str, CType]] = {"bool": BOOL, "nullptr_t": NULLPTR}
_IMAGINARY = frozenset("ijIJ")
_FUNCTION_NAMES = {"__func__", "__FUNCTION__", "__PRETTY_FUNCTION__"}


def rvalue(unit: Unit, node: Node) -> Expression:
    """Check an expression whose value is used."""
    return conversion.decay(expression(unit, node))


@checks(c_ast.ID)
def name(unit: Unit, node: Node) -> Expression:
    """Resolve a name."""
    location = unit.at(node)
    symbol = unit.scope.find(node.name)
    if isinstance(symbol, ObjectSymbol):
        symbol.is_used = True
        found = tree.ObjectName(symbol.type, location, symbol)
        if symbol.constant is not None:
            found.is_constant = symbol.is_constexpr or unit.static_initialisers > 0
        if symbol.is_indirect:
            assert isinstance(symbol.type, PointerType)
            return tree.Dereference(symbol.type.target, location, found)
        return found
    if isinstance(symbol, FunctionSymbol):
        symbol.is_used = True
        return tree.FunctionName(symbol.type, location, symbol)
    if isinstance(symbol, EnumConstant):
        return tree.Literal(symbol.type, location, symbol.value)
    if isinstance(symbol, BrokenName):
        raise CheckError(location, "")
    if isinstance(symbol, TypedefName):
        raise CheckError(location, f"unexpected type name '{node.name}': expected an expression")
    if node.name in _FUNCTION_NAMES and unit.function is not None:
        content = unit.function.symbol.name.encode("utf-8", "surrogateescape") + b"\0"
        ctype = ArrayType(qualify(CHAR, const=True, volatile=False), len(content))
        return tree.StringLiteral(ctype, location, content)
    raise unknown_name(unit, node.name, location)


def unknown_name(unit: Unit, unknown: str, location: Location) -> CheckError:
    """Return the error for an undeclared name; without text if it was reported before."""
    place = unit.function.symbol.name if unit.function is not None else ""
    if (unknown, place) in unit.unknown:
        return CheckError(location, "")
    unit.unknown.add((unknown, place))
    return CheckError(location, f"use of undeclared identifier '{unknown}'", unit.suggest(unknown))


@checks(c_ast.Constant)
def constant(unit: Unit, node: Node) -> Expression:
    """Check a number, character or string."""
    location = unit.at(node)
    try:
        if node.type == "string":
            content, element = literal.string(node.value)
            length = len(content) // element.size
            return tree.StringLiteral(ArrayType(element, length), location, content)
        if node.type in _PREDEFINED:
            return tree.Literal(_PREDEFINED[node.type], location, int(node.value == "true"))
        if node.type == "char":
            code, of_characters = literal.character(node.value)
            return tree.Literal(of_characters, location, code)
        if not _IMAGINARY.isdisjoint(node.value):
            return _imaginary(node.value, location)
        value, ctype = literal.number(node.value, is_c90(unit.standard))
    except ValueError as problem:
        raise CheckError(location, str(problem)) from None
    return tree.Literal(ctype, location, value)


def _imaginary(text: str, location: Location) -> Expression:
    """Return GNU C's `2.0i` or `2i`."""
    value, base = literal.number("".join(each for each in text if each not in _IMAGINARY))
    parts = complex_numbers.zero(base, location), tree.Literal(base, location, value)
    return complex_numbers.build(base, *parts, location)


@checks(c_ast.ExprList)
def comma(unit: Unit, node: Node) -> Expression:
    """Check `a, b, c`."""
    result = rvalue(unit, node.exprs[0])
    for each in node.exprs[1:]:
        value = rvalue(unit, each)
        is_bare = isinstance(result, tree.Literal)
        result = value if is_bare else tree.Comma(value.type, result.location, result, value)
    return result


@checks(c_ast.StructRef)
def member(unit: Unit, node: Node) -> Expression:
    """Check `record.member` and `pointer->member`."""
    location = unit.at(node.field)
    record = expression(unit, node.name)
    if node.type == "->":
        record = conversion.decay(record)
        if not isinstance(record.type, PointerType):
            hint = "use '.'" if isinstance(record.type, RecordType) else ""
            text = f"member reference type '{record.type}' is not a pointer"
            raise CheckError(location, text, hint)
        record = tree.Dereference(record.type.target, record.location, record)
    return access(record, find_member(record.type, node.field.name, location))


def access(record: Expression, found: Member) -> Expression:
    """Return the access of a member, with the qualifiers of the whole (C17 6.5.2.3p3)."""
    ctype = qualify(found.type, record.type.const, record.type.volatile)
    if found.place is not None:
        return variable_record.access(record, found, ctype)
    return tree.MemberAccess(ctype, record.location, record, found)


def find_member(ctype: CType, wanted: str, location: Location) -> Member:
    """Return the member of a struct or union with a name; raise CheckError if there is none."""
    if not isinstance(ctype, RecordType):
        is_pointer = isinstance(ctype, PointerType) and isinstance(ctype.target, RecordType)
        hint = "use '->'" if is_pointer else ""
        text = f"member reference type '{ctype}' is not a structure or union"
        raise CheckError(location, text, hint)
    if ctype.record.members is None:
        raise CheckError(location, f"incomplete definition of type '{unqualified(ctype)}'")
    found = ctype.record.named.get(wanted)
    if found is None:
        members = ", ".join(ctype.record.named)
        text = f"no member named '{wanted}' in '{unqualified(ctype)}'"
        raise CheckError(location, text, f"its members are {members}" if members else "")
    return found


@checks(c_ast.Cast)
def cast(unit: Unit, node: Node) -> Expression:
    """Check `(type)value`."""
    location = unit.at(node)
    with vla.effects(unit) as effects:
        ctype = type_name(unit, node.to_type)
    value = expression(unit, node.expr)
    result = conversion.cast(unit, value, ctype)
    if result is not value and isinstance(result, tree.Convert | tree.Literal):
        result.location = location
    return vla.after(effects, result)


@checks(c_ast.CompoundLiteral)
def compound_literal(unit: Unit, node: Node) -> Expression:
    """Check `(type){...}` (C17 6.5.2.5)."""
    location = unit.at(node)
    ctype = type_name(unit, node.type)
    if vla.is_variable(ctype):
        raise CheckError(location, "compound literal cannot be of variable length array type")
    initialiser, ctype = initialise(unit, ctype, node.init, unit.function is None)
    symbol = ObjectSymbol("", ctype, location, is_defined=True, in_memory=True)
    if unit.function is None:
        symbol.link_name = unit.static_name(".literal")
        unit.objects.append(tree.ObjectDefinition(symbol, initialiser))
    return tree.CompoundLiteral(ctype, location, symbol, initialiser)


@checks(c_ast.GenericSelection)
def generic(unit: Unit, node: Node) -> Expression:
    """Check `_Generic` and choose its association (C17 6.5.1.1)."""
    controlling = unqualified(rvalue(unit, node.expr).type)
    default = chosen = None
    types: list[CType] = []
    for association in node.associations:
        if association.type is None:
            if default is not None:
                raise CheckError(unit.at(association), "duplicate default generic association")
            default = association.expr
            continue
        ctype = type_name(unit, association.type)
        twin = next((each for each in types if compatible(each, ctype)), None)
        if twin is not None:
            text = f"type '{ctype}' in generic association compatible with previous type '{twin}'"
            raise CheckError(unit.at(association), text)
        types.append(ctype)
        if compatible(ctype, controlling):
            chosen = association.expr
    if chosen is not None:
        return expression(unit, chosen)
    if default is None:
        text = f"controlling expression type '{controlling}' not compatible with any association"
        raise CheckError(unit.at(node), text)
    return expression(unit, default)


def size_of(unit: Unit, node: Node) -> Expression:
    """Check `sizeof` and `_Alignof` (C17 6.5.3.4)."""
    location = unit.at(node)
    effects: list[Expression] = []
    if isinstance(node.expr, c_ast.Typename):
        with vla.effects(unit) as effects:
            ctype = type_name(unit, node.expr)
    else:
        operand = expression(unit, node.expr)
        ctype = operand.type
        warn_size(unit, operand, location)
        if vla.is_variable(ctype):
            effects = [conversion.convert(operand, VOID)]
        if isinstance(operand, tree.MemberAccess) and operand.member.bit_width is not None:
            raise CheckError(location, f"invalid application of '{node.op}' to bit-field")
    if not is_complete(ctype) and not isinstance(ctype, VoidType | FunctionType):
        raise CheckError(
            location, f"invalid application of '{node.op}' to incomplete type '{ctype}'"
        )
    if node.op == "sizeof":
        return vla.after(effects, vla.size(ctype, location))
    return tree.integer(_alignment(unit, node.expr, ctype), UINT, location)


def _alignment(unit: Unit, node: Node, ctype: CType) -> int:
    """Return the alignment of a type or, as gcc does, of an expression's object."""
    if isinstance(node, c_ast.Typename):
        return natural_alignment(unit, node) or ctype.align
    match expression(unit, node):
        case tree.ObjectName(symbol=symbol):
            return max(symbol.align, ctype.align)
        case tree.MemberAccess(member=member):
            return max(member.align, 1 if member.packed else member.natural or ctype.align)
    return ctype.align


def offset_of(unit: Unit, node: Node) -> Expression:
    """Check `__builtin_offsetof(type, member)`."""
    type_node, designator = node.args.exprs
    return _offset(unit, type_name(unit, type_node), designator)[1]


def _offset(unit: Unit, ctype: CType, node: Node) -> tuple[CType, Expression]:
    """Return the type of the member that a designator denotes, and its offset [bytes]."""
    location = unit.at(node)
    if isinstance(node, c_ast.ArrayRef):
        inner, offset = _offset(unit, ctype, node.name)
        index = conversion.convert(rvalue(unit, node.subscript), UINT)
        if not isinstance(inner, ArrayType) or not conversion.is_integer(index.type):
            raise CheckError(location, "invalid designator in 'offsetof'")
        size = tree.integer(inner.element.size, UINT, location)
        return inner.element, _computed("+", offset, _computed("*", index, size))
    offset = tree.integer(0, UINT, location)
    if isinstance(node, c_ast.StructRef):
        ctype, offset = _offset(unit, ctype, node.name)
        found = find_member(ctype, node.field.name, unit.at(node.field))
    else:
        found = find_member(ctype, node.name, location)
    if found.bit_width is not None:
        raise CheckError(location, f"cannot compute offset of bit-field '{found.name}'")
    inside = tree.integer(found.offset, UINT, location)
    return found.type, _computed("+", offset, inside)


def _computed(op: str, left: Expression, right: Expression) -> Expression:
    """Return `left op right` in `unsigned int`."""
    if isinstance(left, tree.Literal) and isinstance(right, tree.Literal):
        value = fold.binary(op, UINT, left.value, right.value)
        if value is not None:
            return tree.Literal(UINT, left.location, value)
    return tree.Binary(UINT, left.location, op, left, right)
