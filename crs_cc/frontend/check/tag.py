"""Structs, unions and enums (C17 6.7.2.1 to 6.7.2.3)."""

from __future__ import annotations

from typing import Literal

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import constant, variable_record, vla
from crs_cc.frontend.check.alignment import (
    alignment,
    attribute_alignment,
    attributes,
    has_attribute,
    is_packed,
    natural_alignment,
    pack,
)
from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.check.conversion import is_integer
from crs_cc.frontend.check.declarator import LARGEST_OBJECT, declared_type, specifies, type_name
from crs_cc.frontend.check.mode import with_mode
from crs_cc.frontend.check.scope import EnumConstant, Tag
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import (
    BOOL,
    INT,
    LLONG,
    UINT,
    ULLONG,
    ArrayType,
    CType,
    Enumeration,
    EnumType,
    FunctionType,
    IntegerType,
    Member,
    Record,
    RecordType,
    is_complete,
    qualify,
    unqualified,
)


@specifies(c_ast.Struct, c_ast.Union)
def record_type(unit: Unit, node: Node) -> CType:
    """Return the type of a struct or union specifier, defining it if it has a body."""
    known = unit.specified.get(node)
    if known is not None:
        return known
    location = unit.at(node)
    kind: Literal["struct", "union"] = "struct" if isinstance(node, c_ast.Struct) else "union"
    tag = _tag(unit, node.name, defines=node.decls is not None)
    if tag is None:
        ctype = RecordType(Record(kind, node.name))
        if node.name is not None:
            unit.scope.tags[node.name] = Tag(ctype, location)
    elif not isinstance(tag.type, RecordType) or tag.type.record.kind != kind:
        text = f"use of '{node.name}' with tag type that does not match its declaration"
        raise CheckError(location, text, f"declared at {tag.location}")
    else:
        ctype = tag.type
    unit.specified[node] = ctype
    if node.decls is not None:
        _define(unit, ctype.record, node, tag)
    return ctype


def _tag(unit: Unit, name: str | None, *, defines: bool) -> Tag | None:
    """Return the tag of a specifier; a definition ignores those of outer scopes."""
    if name is None:
        return None
    return unit.scope.tags.get(name) if defines else unit.scope.find_tag(name)


def _define(unit: Unit, record: Record, node: Node, tag: Tag | None) -> None:
    location = unit.at(node)
    if record.members is not None:
        first = "" if tag is None else f"first defined at {tag.location}"
        raise CheckError(location, f"redefinition of '{record.kind} {node.name}'", first)
    if tag is not None:
        tag.location = location
    members: list[Member] = []
    packed = is_packed(node)
    for each in node.decls:
        if isinstance(each, c_ast.StaticAssert):
            unit.attempt(static_assert, each)
        elif isinstance(each, c_ast.Decl):
            member = unit.attempt(_member, each, each is node.decls[-1], packed)
            if member is not None:
                members.append(member)
    _check_names(unit, members, node)
    align = attribute_alignment(unit, attributes(node))
    record.is_transparent = has_attribute(node, "transparent_union")
    if any(vla.is_variable(each.type) for each in members):
        variable_record.complete(unit, record, members, max(1, align), location)
        return
    record.complete(members, max(1, align), pack(node))
    if record.size > LARGEST_OBJECT:
        raise CheckError(location, f"'{record.kind} {node.name or '<anonymous>'}' is too large")


def _member(unit: Unit, node: Node, is_last: bool, in_packed: bool) -> Member:
    ctype = with_mode(node, declared_type(unit, node.type))
    location = unit.at_name(node)
    if node.name is None and isinstance(node.type, c_ast.Struct | c_ast.Union):
        ctype = qualify(ctype, "const" in node.quals, "volatile" in node.quals)
    if isinstance(ctype, FunctionType):
        raise CheckError(location, f"member '{node.name}' declared as a function")
    is_flexible = is_last and isinstance(ctype, ArrayType) and ctype.length is None
    if not is_complete(ctype) and not is_flexible:
        raise CheckError(location, f"member '{node.name}' has incomplete type '{ctype}'")
    natural = natural_alignment(unit, node)
    packed = in_packed or is_packed(node)
    member = Member(node.name, ctype, align=alignment(unit, node), natural=natural, packed=packed)
    if node.bitsize is not None:
        member.bit_width = _width(unit, node, ctype, location)
    return member


def _width(unit: Unit, node: Node, ctype: CType, location: Location) -> int:
    name = f"bit-field '{node.name}'" if node.name is not None else "unnamed bit-field"
    if not is_integer(ctype):
        raise CheckError(location, f"{name} has non-integral type '{ctype}'")
    width = constant.integer(unit, node.bitsize, "bit-field width")
    most = 1 if isinstance(ctype, IntegerType) and ctype.name == BOOL.name else 8 * ctype.size
    if width < 0 or (width == 0 and node.name is not None):
        raise CheckError(location, f"{name} has {'negative' if width < 0 else 'zero'} width")
    if width > most:
        raise CheckError(location, f"width of {name} ({width} bits) exceeds that of its type")
    return width


def _check_names(unit: Unit, members: list[Member], node: Node) -> None:
    seen: set[str] = set()
    for member in members:
        names = [member.name] if member.name is not None else []
        if member.name is None and isinstance(member.type, RecordType):
            names = list(member.type.record.named)
        for name in names:
            if name in seen:
                unit.error(unit.at(node), f"duplicate member '{name}'")
            seen.add(name)


@specifies(c_ast.Enum)
def enum_type(unit: Unit, node: Node) -> CType:
    """Return the type of an enum specifier, declaring its constants if it has a body."""
    known = unit.specified.get(node)
    if known is not None:
        return known
    location = unit.at(node)
    tag = _tag(unit, node.name, defines=node.values is not None)
    if tag is not None and not isinstance(tag.type, EnumType):
        text = f"use of '{node.name}' with tag type that does not match its declaration"
        raise CheckError(location, text, f"declared at {tag.location}")
    ctype = EnumType(Enumeration(node.name)) if tag is None else tag.type
    assert isinstance(ctype, EnumType)
    if tag is None and node.name is not None:
        unit.scope.tags[node.name] = Tag(ctype, location)
    unit.specified[node] = ctype
    if node.values is not None:
        if ctype.definition.constants is not None and tag is not None:
            text = f"redefinition of 'enum {node.name}'"
            raise CheckError(location, text, f"first defined at {tag.location}")
        ctype.definition.constants = {}
        _declare_constants(unit, ctype.definition, node)
    return ctype


def _fixed_type(unit: Unit, node: Node) -> IntegerType | None:
    """Return the type after the colon of an enum's tag (C23 6.7.2.2); None if there is none."""
    if node.underlying_type is None:
        return None
    ctype = unqualified(type_name(unit, node.underlying_type))
    if not isinstance(ctype, IntegerType):
        raise CheckError(unit.at(node), f"underlying type '{ctype}' of an enum is not an integer")
    return ctype


def _declare_constants(unit: Unit, definition: Enumeration, node: Node) -> None:
    """Declare the constants; one that fits is an `int`, others have the type of the enum."""
    value, constants, large = 0, {}, []
    fixed = _fixed_type(unit, node)
    for each in node.values.enumerators:
        if not isinstance(each, c_ast.Enumerator):
            continue
        location = unit.at(each)
        if each.value is not None:
            found = unit.attempt(constant.integer, each.value, f"value of '{each.name}'")
            value = value if found is None else found
        constants[each.name] = value
        ctype = INT if INT.smallest <= value <= INT.largest else UINT
        if not 0 <= value <= UINT.largest and ctype is UINT:
            ctype = LLONG if value <= LLONG.largest else ULLONG
        known = unit.scope.names.get(each.name)
        if known is not None:
            unit.error(location, f"redefinition of '{each.name}'", f"first at {known.location}")
        unit.scope.names[each.name] = made = EnumConstant(
            each.name, ctype, location, value, definition
        )
        if fixed is not None and not fixed.smallest <= value <= fixed.largest:
            unit.error(location, f"'{each.name}' does not fit into '{fixed}'")
        if ctype is not INT or fixed is not None:
            large.append(made)
        value += 1
    definition.complete(constants, is_packed(node))
    definition.integer = fixed or definition.integer
    for made in large:
        made.type = definition.integer


def static_assert(unit: Unit, node: Node) -> None:
    """Check `_Static_assert` (C17 6.7.10)."""
    if constant.integer(unit, node.cond, "static assertion") == 0:
        message = "" if node.message is None else f": {node.message.value}"
        raise CheckError(unit.at(node), f"static assertion failed{message}")
