"""Lowering: checked C to IR, one function at a time.

A `Lowering` holds the function under construction, the block that takes the next instruction, and
the `Rules`: which function lowers which class of nodes. The modules above this one define rules for
their nodes, `rules` combines them, and `value`, `effect`, `place`, `branch` and `statements` look
them up, so that a rule can lower the parts of its node without knowing their rules.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final, TypeAlias, TypeVar

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.conversion import is_scalar
from crs_cc.frontend.check.fold import wrap
from crs_cc.frontend.check.scope import ENTRIES
from crs_cc.ir.instruction import (
    Address,
    Base,
    Binary,
    Block,
    Branch,
    Constant,
    Instruction,
    Jump,
    Lifetime,
    Load,
    Move,
    Operand,
    Register,
    Slot,
    Statement,
    Store,
    Terminator,
    Variable,
)
from crs_cc.ir.operators import OPERATORS
from crs_cc.ir.program import Function
from crs_cc.ir.types import CType, EnumType, FloatType, IntegerType, PointerType
from crs_cc.ir.value_type import VALUE_TYPE, MemoryType, ValueType

if TYPE_CHECKING:
    from crs_cc.frontend.check.scope import ObjectSymbol
    from crs_cc.frontend.lower.unit_state import UnitState

ACTIVATIONS: Final = "__crs_activations"
"""The library's counter of calls of functions that use `setjmp`."""

MAX_REGISTERS: Final = 10_000
"""Beyond so many registers, variables are kept in memory: WebAssembly allows 50,000 locals."""

Made = TypeVar("Made")

Place: TypeAlias = tuple[Base, int]
"""The address of an object: `base + offset`."""


def _for_each(make: Callable[[], Made]) -> dict[ValueType, Made]:
    return {"i32": make(), "i64": make(), "f32": make(), "f64": make()}


LowerValue: TypeAlias = "Callable[[Lowering, Any, Register | None], Operand]"
LowerEffect: TypeAlias = "Callable[[Lowering, Any], None]"
LowerPlace: TypeAlias = "Callable[[Lowering, Any], Place]"
LowerBranch: TypeAlias = "Callable[[Lowering, Any, Block, Block], None]"
LowerStatement: TypeAlias = "Callable[[Lowering, Any], None]"


@dataclass(frozen=True, slots=True)
class Rules:
    """The functions that lower nodes, by class of node, for each use of an expression.

    Attributes:
        value: return its value as an operand, in the given register if there is one.
        effect: evaluate it for its side effects only.
        place: return the base and offset of the object that it designates.
        branch: jump to one of two blocks.
        statement: lower a statement.
    """

    value: Mapping[type, LowerValue] = field(default_factory=dict)
    effect: Mapping[type, LowerEffect] = field(default_factory=dict)
    place: Mapping[type, LowerPlace] = field(default_factory=dict)
    branch: Mapping[type, LowerBranch] = field(default_factory=dict)
    statement: Mapping[type, LowerStatement] = field(default_factory=dict)

    def __or__(self, other: Rules) -> Rules:
        """Return the rules of both."""
        return Rules(
            {**self.value, **other.value},
            {**self.effect, **other.effect},
            {**self.place, **other.place},
            {**self.branch, **other.branch},
            {**self.statement, **other.statement},
        )


@dataclass(slots=True, eq=False)
class Lowering:
    """A function under construction.

    Attributes:
        unit: the state shared by the functions of the file.
        rules: the functions that lower nodes.
        block: the block that takes the next instruction; unreachable after a jump.
        places: the register or slot of each local variable.
        result_pointer: the address for a struct result.
        breaks: the targets of `break`, innermost last, each with the number of scopes there.
        continues: the same of `continue`.
        scopes: the slots whose lifetime ends with each open block, innermost last.
        cases: the blocks of case labels.
        labels: the blocks of named labels.
        chooser: for computed gotos, the register with the label's number and the block that
            switches on it.
        references: the global names that are used, with the block that uses them.
    """

    unit: UnitState
    function: Function
    rules: Rules
    block: Block
    places: dict[ObjectSymbol, Register | Slot] = field(default_factory=dict)
    result_pointer: Register | None = None
    breaks: list[tuple[Block, int]] = field(default_factory=list)
    continues: list[tuple[Block, int]] = field(default_factory=list)
    scopes: list[list[Slot]] = field(default_factory=list)
    cases: dict[tree.CaseLabel, Block] = field(default_factory=dict)
    labels: dict[str, Block] = field(default_factory=dict)
    chooser: tuple[Register, Block] | None = None
    references: list[tuple[Block, str, Location]] = field(default_factory=list)
    block_count: int = 0
    _activation: Register | None = None
    _temporaries: dict[ValueType, list[Register]] = field(default_factory=lambda: _for_each(list))
    _used: dict[ValueType, int] = field(default_factory=lambda: _for_each(int))
    _first: dict[ValueType, int] = field(default_factory=lambda: _for_each(int))

    # Blocks

    def new_block(self, name: str) -> Block:
        """Return a new block, to be opened by `start`."""
        self.block_count += 1
        return Block(f"{name}.{self.block_count}")

    def start(self, block: Block, location: Location) -> None:
        """Continue in a block; the current one falls through to it unless it has ended."""
        if self.block.terminator is None:
            self.block.terminator = Jump(location, block)
        self.function.blocks.append(block)
        self.block = block

    def end(self, terminator: Terminator) -> None:
        """End the current block; what follows is unreachable until `start`."""
        if self.block.terminator is None:
            self.block.terminator = terminator
        self.block = Block("dead")

    def emit(self, instruction: Instruction) -> None:
        """Append an instruction to the current block."""
        self.block.instructions.append(instruction)

    def leave_scopes(self, kept: int, location: Location) -> None:
        """End the lifetimes of all open blocks but the `kept` outermost."""
        for slots in self.scopes[kept:]:
            for slot in slots:
                self.emit(Lifetime(location, slot, begins=False))

    def mark(self, location: Location) -> None:
        """Mark the start of a statement."""
        self.block.instructions.append(Statement(location))
        self._used = dict(self._first)

    # Registers and slots

    def register(self, value_type: ValueType) -> Register:
        """Return a register for a temporary value of the current statement."""
        pool, used = self._temporaries[value_type], self._used[value_type]
        self._used[value_type] = used + 1
        if used == len(pool):
            pool.append(self.new_register(value_type))
        return pool[used]

    def new_register(self, value_type: ValueType, variable: Variable | None = None) -> Register:
        """Return a new register."""
        registers = self.function.registers
        made = Register(len(registers), value_type, variable)
        registers.append(made)
        return made

    def used_registers(self) -> dict[ValueType, int]:
        """Return the number of temporary registers of the current statement."""
        return dict(self._used)

    @contextmanager
    def inner_statements(self) -> Iterator[None]:
        """Keep the temporaries of the current statement while statements inside it are lowered."""
        outer, self._first = self._first, dict(self._used)
        try:
            yield
        finally:
            self._first = outer

    def reuse_registers(self, used: dict[ValueType, int]) -> None:
        """Free the temporaries that were taken since `used_registers`."""
        self._used = dict(used)

    def slot(
        self, name: str, ctype: CType, align: int = 0, variable: Variable | None = None
    ) -> Slot:
        """Return a new frame slot."""
        made = Slot(name, ctype.size, max(align, ctype.align), variable)
        self.function.slots.append(made)
        return made

    def local(self, symbol: ObjectSymbol) -> Register | Slot:
        """Return the register or slot of a local variable."""
        found = self.places.get(symbol)
        if found is None:
            variable = symbol.variable() if symbol.name else None
            if symbol.in_memory or len(self.function.registers) > MAX_REGISTERS:
                found = self.slot(symbol.name, symbol.type, symbol.align, variable)
            else:
                found = self.new_register(value_type(symbol.type), variable)
            self.places[symbol] = found
        return found

    def move(self, target: Register, source: Operand, location: Location) -> None:
        """Move an operand into a register unless it is there already."""
        if target is not source:
            self.block.instructions.append(Move(location, target, source))

    def binary(
        self,
        location: Location,
        op: str,
        left: Operand,
        right: Operand,
        into: Register | None = None,
    ) -> Register:
        """Emit a binary operation and return its result."""
        result = self.register(OPERATORS[op].result) if into is None else into
        self.block.instructions.append(Binary(location, result, op, left, right))
        return result

    def activation(self) -> Register:
        """Return the number that identifies this call of the function, for `setjmp`."""
        if self._activation is None:
            made, entry = self.new_register("i32"), self.function.blocks[0]
            location = self.function.location
            self._activation = made
            self.references.append((entry, ACTIVATIONS, location))
            entry.instructions[:0] = [
                Load(location, made, ACTIVATIONS, 0, "i32"),
                Binary(location, made, "i32.add", made, Constant("i32", 1)),
                Store(location, ACTIVATIONS, 0, made, "i32"),
            ]
        return self._activation

    # Addresses

    def refer(self, name: str, location: Location) -> str:
        """Record that a global name is used."""
        self.references.append((self.block, name, location))
        return name

    def address(self, place: Place, location: Location, into: Register | None = None) -> Operand:
        """Return the address of a place as a value."""
        base, offset = place
        if isinstance(base, Register):
            if offset == 0:
                return base
            constant = Constant("i32", wrap(offset, 32, signed=True))
            return self.binary(location, "i32.add", base, constant, into)
        result = self.register("i32") if into is None else into
        self.block.instructions.append(Address(location, result, base, offset))
        return result

    def access(self, place: Place, size: int, location: Location) -> Place:
        """Return a place that `Load` and `Store` accept: inside its object, or in a register.

        Args:
            place: the place.
            size: the number of accessed bytes.
            location: the location for messages.
        """
        base, offset = place
        if isinstance(base, Register):
            if offset >= 0:
                return place
        else:
            room = base.size if isinstance(base, Slot) else self.unit.sizes.get(base, 0)
            if 0 <= offset <= room - size:
                return place
        made = self.address(place, location)
        assert isinstance(made, Register)
        return made, 0


def memory_type(ctype: CType) -> MemoryType:
    """Return the memory type of a scalar type."""
    assert isinstance(ctype, IntegerType | FloatType | EnumType | PointerType)
    return ctype.memory


def value_type(ctype: CType) -> ValueType:
    """Return the type of the registers that hold a scalar."""
    return VALUE_TYPE[memory_type(ctype)]


def constant(ctype: CType, value: float) -> Constant:
    """Return a number as a constant of a scalar type."""
    wanted = value_type(ctype)
    if wanted in {"f32", "f64"}:
        return Constant(wanted, float(value))
    return Constant(wanted, wrap(int(value), 32 if wanted == "i32" else 64, signed=True))


def no_value(function: Function) -> Constant | None:
    """Return the result of a function that ends without `return`: 0 of main (C17 5.1.2.2.3)."""
    is_entry = function.name in ENTRIES and function.result == "i32"
    return Constant("i32", 0) if is_entry else None


def value(low: Lowering, expression: tree.Expression, into: Register | None = None) -> Operand:
    """Lower a scalar expression and return its value.

    Args:
        low: the function.
        expression: the expression.
        into: a register that may be used for the value.
    """
    return low.rules.value[expression.__class__](low, expression, into)


def value_into(low: Lowering, expression: tree.Expression, target: Register) -> None:
    """Lower a scalar expression and move its value into a register."""
    low.move(target, value(low, expression, target), expression.location)


def effect(low: Lowering, expression: tree.Expression) -> None:
    """Lower an expression for its side effects."""
    found = low.rules.effect.get(expression.__class__)
    if found is not None:
        found(low, expression)
    elif expression.__class__ in low.rules.value and is_scalar(expression.type):
        value(low, expression)
    elif expression.__class__ in low.rules.place:
        place(low, expression)


def place(low: Lowering, expression: tree.Expression) -> Place:
    """Lower an lvalue or a struct expression and return its place."""
    return low.rules.place[expression.__class__](low, expression)


def branch(low: Lowering, condition: tree.Expression, then: Block, otherwise: Block) -> None:
    """Branch to `then` if a scalar is not zero, else to `otherwise`."""
    found = low.rules.branch.get(condition.__class__)
    if found is not None:
        found(low, condition, then, otherwise)
        return
    low.end(Branch(condition.location, truth(low, condition), then, otherwise))


def truth(low: Lowering, condition: tree.Expression) -> Operand:
    """Lower a scalar and return an i32 that is zero if and only if the scalar is."""
    operand = value(low, condition)
    if operand.type == "i32":
        return operand
    zero = Constant(operand.type, 0 if operand.type == "i64" else 0.0)
    result = low.register("i32")
    low.emit(Binary(condition.location, result, f"{operand.type}.ne", operand, zero))
    return result


def statements(low: Lowering, body: list[tree.Statement]) -> None:
    """Lower statements one after the other."""
    rules = low.rules.statement
    for each in body:
        rules[each.__class__](low, each)
