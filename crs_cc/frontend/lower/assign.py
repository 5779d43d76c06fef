"""Lower assignments, compound assignments, increments and decrements."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.fold import wrap
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.lower.bit_field import fit_bits, read_bits, write_bits
from crs_cc.frontend.lower.calls import call_into
from crs_cc.frontend.lower.convert import convert_operand, unnarrowed
from crs_cc.frontend.lower.expressions import is_checked, operator_name, shift_count
from crs_cc.frontend.lower.lowerer import Lowering, Place, Rules, constant, place, value, value_into
from crs_cc.frontend.lower.memory import copy, load, store
from crs_cc.ir.instruction import Binary, Constant, Move, Operand, Register
from crs_cc.ir.types import (
    INT,
    CType,
    EnumType,
    FloatType,
    IntegerType,
    Member,
    PointerType,
    RecordType,
)


@dataclass(slots=True, eq=False)
class _Target:
    """The target of an assignment, with its address computed once.

    Attributes:
        register: the register of the variable, if it is kept in one; then `where` is unused.
        member: the member, if it is a bit-field.
    """

    type: CType
    location: Location
    register: Register | None
    where: Place
    member: Member | None = None

    def read(self, low: Lowering) -> Operand:
        """Return the current value."""
        if self.register is not None:
            return self.register
        if self.member is not None:
            return read_bits(low, self.where, self.member, self.location)
        return load(low, self.where, self.type, self.location)

    def write(self, low: Lowering, source: Operand) -> Operand:
        """Store a value of the target's type; return the value that the target then has."""
        if self.register is not None:
            low.move(self.register, source, self.location)
            return self.register
        if self.member is not None:
            write_bits(low, self.where, self.member, source, self.location)
            return fit_bits(low, self.member, source, self.location)
        store(low, self.where, self.type, source, self.location)
        return source


def _target(low: Lowering, expression: Expression) -> _Target:
    register = _register(low, expression)
    if register is not None:
        return _Target(expression.type, expression.location, register, (register, 0))
    member = None
    if isinstance(expression, tree.MemberAccess) and expression.member.bit_width is not None:
        member = expression.member
    where = place(low, expression)
    size = (member.spread or member.type.size) if member is not None else expression.type.size
    where = low.access(where, size, expression.location)
    return _Target(expression.type, expression.location, None, where, member)


def _register(low: Lowering, expression: Expression) -> Register | None:
    """Return the register of a variable that is kept in one."""
    if isinstance(expression, tree.ObjectName) and expression.symbol.link_name is None:
        found = low.local(expression.symbol)
        return found if isinstance(found, Register) else None
    return None


# Assignment


def _assign(low: Lowering, expression: tree.Assign, _into: Register | None) -> Operand:
    register = _register(low, expression.target)
    if register is not None:
        value_into(low, expression.value, register)
        return register
    target = _target(low, expression.target)
    return target.write(low, value(low, expression.value))


def _assign_effect(low: Lowering, expression: tree.Assign) -> None:
    if isinstance(expression.type, RecordType):
        _assign_record(low, expression)
        return
    register = _register(low, expression.target)
    if register is not None:
        value_into(low, expression.value, register)
        return
    target = _target(low, expression.target)
    if target.member is not None:
        source = value(low, expression.value)
        write_bits(low, target.where, target.member, source, target.location)
    else:
        source = value(low, unnarrowed(expression.value))
        store(low, target.where, target.type, source, target.location)


def _assign_record(low: Lowering, expression: tree.Assign) -> Place:
    where = place(low, expression.target)
    set_record(low, where, expression.value, expression.location)
    return where


def set_record(low: Lowering, where: Place, source: Expression, location: Location) -> None:
    """Store the value of a struct expression at a place."""
    if isinstance(source, tree.Call):
        address = low.address(where, location)
        call_into(low, source, address)
        return
    copy(low, where, place(low, source), source.type.size, location)


# Compound assignment


def _compound(low: Lowering, expression: tree.CompoundAssign) -> Operand:
    right = value(low, expression.value)  # first, as gcc does
    target = _target(low, expression.target)
    if isinstance(expression.computed, PointerType):
        return _move_pointer(low, expression, target, right)
    computed, location = expression.computed, expression.location
    if expression.op in {"<<", ">>"}:
        right = shift_count(low, right, computed, location)
    old = convert_operand(low, target.read(low), target.type, computed, location)
    name = operator_name(expression.op, computed)
    direct = target.register if computed == expression.type else None
    result = direct if direct is not None else low.register(old.type)
    low.emit(Binary(location, result, name, old, right, is_checked(expression.op, computed)))
    return _write_back(low, target, result, computed, expression.type)


def _write_back(
    low: Lowering, target: _Target, result: Operand, computed: CType, ctype: CType
) -> Operand:
    """Convert a result to the target's type and store it."""
    into = target.register
    made = convert_operand(low, result, computed, ctype, target.location, into=into)
    return target.write(low, made)


def _move_pointer(
    low: Lowering, expression: tree.CompoundAssign, target: _Target, index: Operand
) -> Operand:
    assert isinstance(expression.computed, PointerType)
    size, location = expression.computed.target.size, expression.location
    if isinstance(index, Constant):
        index = Constant("i32", wrap(int(index.value) * size, 32, signed=True))
    elif size != 1:
        index = low.binary(location, "i32.mul", index, Constant("i32", size))
    op = "i32.add" if expression.op == "+" else "i32.sub"
    moved = low.binary(location, op, target.read(low), index, target.register)
    return target.write(low, moved)


def _compound_value(
    low: Lowering, expression: tree.CompoundAssign, _into: Register | None
) -> Operand:
    return _compound(low, expression)


def _compound_effect(low: Lowering, expression: tree.CompoundAssign) -> None:
    _compound(low, expression)


# Increments


def _increment(low: Lowering, expression: tree.Increment, into: Register | None) -> Operand:
    target = _target(low, expression.target)
    location = expression.location
    old = target.read(low)
    if expression.is_postfix and target.register is not None:
        kept = low.register(target.register.type) if into in {None, target.register} else into
        assert kept is not None
        low.emit(Move(location, kept, target.register))
        _step(low, expression, target, target.register)
        return kept
    new = _step(low, expression, target, old)
    return old if expression.is_postfix else new


def _step(low: Lowering, expression: tree.Increment, target: _Target, old: Operand) -> Operand:
    """Store `old` plus one step; return the new value of the target."""
    ctype, location, step = expression.type, expression.location, expression.step
    if isinstance(ctype, PointerType):
        step *= ctype.target.size
    is_narrow = isinstance(ctype, IntegerType | EnumType) and ctype.size < INT.size
    computed: CType = INT if is_narrow else ctype
    one = constant(computed, step)
    name = "add"
    if isinstance(ctype, FloatType):
        one, name = constant(ctype, abs(step)), "add" if step > 0 else "sub"
    direct = None if is_narrow else target.register
    result = low.register(old.type) if direct is None else direct
    checked = is_checked("+", computed)
    low.emit(Binary(location, result, f"{old.type}.{name}", old, one, checked))
    return _write_back(low, target, result, computed, ctype)


def _increment_effect(low: Lowering, expression: tree.Increment) -> None:
    target = _target(low, expression.target)
    _step(low, expression, target, target.read(low))


RULES: Final = Rules(
    value={
        tree.Assign: _assign,
        tree.CompoundAssign: _compound_value,
        tree.Increment: _increment,
    },
    effect={
        tree.Assign: _assign_effect,
        tree.CompoundAssign: _compound_effect,
        tree.Increment: _increment_effect,
    },
    place={
        tree.Assign: _assign_record,
    },
)
