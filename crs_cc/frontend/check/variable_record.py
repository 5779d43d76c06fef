"""Structs and unions with members of variable length (GNU C), which only functions can define.

The size of such a type, and the offset of each member after the first one of variable length, are
kept in hidden variables, as the sizes of variable length arrays are (see `vla`).
"""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree, vla
from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.check.conversion import convert
from crs_cc.frontend.check.scope import ObjectSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.ir.types import CHAR, INT, UINT, VOID, CType, Member, PointerType, Record


def complete(
    unit: Unit, record: Record, members: list[Member], align: int, location: Location
) -> None:
    """Set the members of a struct or union, and record the computation of their offsets.

    Args:
        unit: the file that is checked.
        record: the struct or union.
        members: the members, at least one of which has a variable length.
        align: the minimum alignment of the whole [bytes].
        location: the location of the definition.

    Raises:
        CheckError: there is a bit-field, or an anonymous member.
    """
    for member in members:
        if member.name is None or member.bit_width is not None:
            what = "anonymous member" if member.bit_width is None else "bit-field"
            text = f"{what} beside a member of variable length is not supported"
            raise CheckError(location, text, "put it into a struct of its own, with a name")
    record.members, record.named = members, {each.name: each for each in members if each.name}
    wanted = [
        max(each.align, 1 if each.packed else each.natural or each.type.align) for each in members
    ]
    record.align = max(align, *wanted)
    record.extent = ObjectSymbol(vla.EXTENT, UINT, location)
    if unit.function is None:
        return  # it was said that a length must be constant
    effects = unit.function.effects
    lay_out = _largest if record.kind == "union" else _in_turn
    size = lay_out(members, wanted, effects, location)
    effects.append(vla.set_extent(record.extent, _rounded(size, record.align)))


def _largest(
    members: list[Member], _wanted: list[int], effects: list[Expression], location: Location
) -> Expression:
    """Return the size of the largest member."""
    found = ObjectSymbol("", UINT, location)
    for member in members:
        so_far, size = tree.ObjectName(UINT, location, found), vla.size(member.type, location)
        if member is not members[0]:
            is_less = tree.Binary(INT, location, "<", so_far, size)
            size = tree.Conditional(UINT, location, is_less, size, so_far)
        effects.append(vla.set_extent(found, size))
    return tree.ObjectName(UINT, location, found)


def _in_turn(
    members: list[Member], wanted: list[int], effects: list[Expression], location: Location
) -> Expression:
    """Set the offsets of members, one after the other, and return the end of the last one."""
    end: Expression = tree.integer(0, UINT, location)
    for member, align in zip(members, wanted, strict=True):
        start = _rounded(end, align)
        if isinstance(start, tree.Literal):
            member.offset = int(start.value)
        else:
            member.place = place = ObjectSymbol("", UINT, location)
            effects.append(vla.set_extent(place, start))
            start = tree.ObjectName(UINT, location, place)
        end = _sum(start, vla.size(member.type, location))
    return end


def _rounded(value: Expression, align: int) -> Expression:
    """Return a number of bytes, rounded up to a multiple of a power of two."""
    location = value.location
    if align == 1:
        return value
    if isinstance(value, tree.Literal):
        return tree.integer(-(-int(value.value) // align) * align, UINT, location)
    mask = tree.integer(UINT.largest + 1 - align, UINT, location)
    raised = _sum(value, tree.integer(align - 1, UINT, location))
    return tree.Binary(UINT, location, "&", raised, mask)


def _sum(left: Expression, right: Expression) -> Expression:
    if isinstance(left, tree.Literal) and isinstance(right, tree.Literal):
        return tree.integer(int(left.value) + int(right.value), UINT, left.location)
    return tree.Binary(UINT, left.location, "+", left, right)


def access(record: Expression, member: Member, ctype: CType) -> Expression:
    """Return the access of a member whose offset is variable."""
    location = record.location
    assert isinstance(member.place, ObjectSymbol)
    offset = convert(tree.ObjectName(UINT, location, member.place), INT)
    start = convert(address_of(record), PointerType(CHAR))
    moved = tree.PointerAdd(PointerType(CHAR), location, start, offset, False)
    return tree.Dereference(ctype, location, convert(moved, PointerType(ctype)))


def copy(target: Expression, value: Expression, location: Location) -> Expression:
    """Return the assignment of a struct of variable size."""
    operands = [convert(address_of(each), PointerType(VOID)) for each in (target, value)]
    operands.append(vla.size(target.type, location))
    done = tree.Intrinsic(PointerType(VOID), location, "__builtin_memmove", operands)
    return tree.Dereference(target.type, location, convert(done, PointerType(target.type)))


def choice(condition: Expression, then: Expression, otherwise: Expression) -> Expression:
    """Return `condition ? then : otherwise` for structs of variable size."""
    pointer, location = PointerType(then.type), then.location
    addresses = address_of(then), address_of(otherwise)
    chosen = tree.Conditional(pointer, location, condition, *addresses)
    return tree.Dereference(then.type, location, chosen)


def address_of(record: Expression) -> Expression:
    """Return the address of a struct."""
    if isinstance(record, tree.Dereference):
        return record.pointer
    return tree.AddressOf(PointerType(record.type), record.location, record)
