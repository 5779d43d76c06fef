"""The verifier's rules for a basic block.

There is a method for each kind of instruction, which yields its violations, and a table of them by
class.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from typing import Final, get_args

from crs_cc.core.source import Location
from crs_cc.ir import instruction as ir
from crs_cc.ir.operators import OPERATORS
from crs_cc.ir.program import Function, Program
from crs_cc.ir.value_type import MEMORY_SIZE, VALUE_TYPE, MemoryType, ValueType
from crs_cc.requests import ERROR_KINDS

Faults = Iterator[str]
_BITS: Final = {"i32": 32, "i64": 64}


class BlockVerifier:
    """Checks the blocks of one function.

    Attributes:
        program: the program that the function belongs to.
    """

    def __init__(self, program: Program, function: Function) -> None:
        self.program = program
        self.function = function
        self._registers = set(map(id, function.registers))
        self._blocks = set(map(id, function.blocks))
        own = [each.place for each in function.parameters if isinstance(each.place, ir.Slot)]
        self._slots = set(map(id, [*function.slots, *own]))

    def check(self, block: ir.Block) -> Iterator[tuple[Location | None, str]]:
        """Yield the violations in a block, each with its location if that is known."""
        for instruction in block.instructions:
            if isinstance(instruction, get_args(ir.Terminator)):
                kind = type(instruction).__name__
                yield instruction.location, f"{kind} is in the middle of the block"
            for what in self._instruction(instruction):
                yield instruction.location, what
        if block.terminator is None:
            yield None, "has no terminator"
        elif not isinstance(block.terminator, get_args(ir.Terminator)):
            yield None, f"ends with {type(block.terminator).__name__}, which is not a terminator"
        else:
            for what in self._instruction(block.terminator):
                yield block.terminator.location, what
            for target in block.successors():
                if id(target) not in self._blocks:
                    yield (
                        block.terminator.location,
                        f"target '{target.label}' is not in this function",
                    )

    def _instruction(self, instruction: ir.Instruction) -> Faults:
        rule = _RULES.get(type(instruction))
        if rule is None:
            yield f"{type(instruction).__name__} is not an instruction"
            return
        if not isinstance(instruction.location, Location):
            yield f"{type(instruction).__name__} has no location"
        yield from rule(self, instruction)

    # Operands

    def _register(
        self, what: str, register: ir.Register, wanted: ValueType | None = None
    ) -> Faults:
        if id(register) not in self._registers:
            yield f"{what} is a register of another function (%{register.index})"
        if wanted is not None and register.type != wanted:
            yield f"{what} has type {register.type}, not {wanted}"

    def _operand(self, what: str, operand: ir.Operand, wanted: ValueType | None = None) -> Faults:
        if isinstance(operand, ir.Register):
            yield from self._register(what, operand, wanted)
            return
        if not isinstance(operand, ir.Constant):
            yield f"{what} is neither a register nor a constant"
            return
        if wanted is not None and operand.type != wanted:
            yield f"{what} has type {operand.type}, not {wanted}"
        bits = _BITS.get(operand.type)
        if bits is None:
            if not isinstance(operand.value, float):
                yield f"{what} is the {operand.type} constant {operand.value!r}, not a float"
        elif type(operand.value) is not int:
            yield f"{what} is the {operand.type} constant {operand.value!r}, not an integer"
        elif not -(1 << bits - 1) <= operand.value < 1 << bits - 1:
            yield f"{what} is {operand.value}, outside the signed range of {operand.type}"

    def _base(self, base: ir.Base) -> Faults:
        if isinstance(base, ir.Register):
            yield from self._register("base", base, "i32")
        elif isinstance(base, ir.Slot):
            if base is ir.VARARGS:
                if not self.function.variadic:
                    yield "base is VARARGS, but the function is not variadic"
            elif id(base) not in self._slots:
                yield f"base is slot '{base.name}' of another function"
        elif not self._is_known(base):
            yield f"base '{base}' is neither defined nor listed as undefined"

    def _is_known(self, name: str) -> bool:
        program = self.program
        return name in program.functions or name in program.data or name in program.undefined

    def _access(self, base: ir.Base, offset: int, memory: MemoryType) -> Faults:
        yield from self._base(base)
        if isinstance(base, str):
            if base in self.program.functions:
                yield f"accesses the code of function '{base}'"
            data = self.program.data.get(base)
            size = None if data is None else data.size
        else:
            size = base.size if isinstance(base, ir.Slot) else None
        if size is not None and not 0 <= offset <= size - MEMORY_SIZE[memory]:
            name = base.name if isinstance(base, ir.Slot) else base
            yield f"{memory} at {offset} is outside '{name}', which has {size} bytes"

    # Instructions

    def _nothing(self, _instruction: ir.Statement | ir.Jump) -> Faults:
        return iter(())

    def _move(self, move: ir.Move) -> Faults:
        yield from self._register("result", move.result)
        yield from self._operand("source", move.source, move.result.type)

    def _unary(self, unary: ir.Unary) -> Faults:
        yield from self._operation(unary.op, unary.result, {"source": unary.source})

    def _binary(self, binary: ir.Binary) -> Faults:
        operands = {"left": binary.left, "right": binary.right}
        yield from self._operation(binary.op, binary.result, operands)

    def _operation(self, op: str, result: ir.Register, operands: dict[str, ir.Operand]) -> Faults:
        operator = OPERATORS.get(op)
        if operator is None or len(operator.operands) != len(operands):
            yield f"'{op}' is not an operator of {len(operands)} operand(s)"
            return
        yield from self._register(f"result of {op}", result, operator.result)
        for (name, operand), wanted in zip(operands.items(), operator.operands, strict=True):
            yield from self._operand(f"{name} operand of {op}", operand, wanted)

    def _load(self, load: ir.Load) -> Faults:
        yield from self._access(load.base, load.offset, load.memory)
        yield from self._register("result", load.result, VALUE_TYPE[load.memory])
        if load.within is not None:
            yield from self._base(load.within)

    def _store(self, store: ir.Store) -> Faults:
        yield from self._access(store.base, store.offset, store.memory)
        yield from self._operand("source", store.source, VALUE_TYPE[store.memory])
        if store.within is not None:
            yield from self._base(store.within)

    def _address(self, address: ir.Address) -> Faults:
        yield from self._base(address.base)
        yield from self._register("result", address.result, "i32")

    def _bounds(self, bounds: ir.Bounds) -> Faults:
        yield from self._base(bounds.base)
        yield from self._operand("index", bounds.index, "i32")
        if bounds.element is not None:
            yield from self._register("element", bounds.element[0], "i32")
        if bounds.array.length is None:
            yield "the length of the array is unknown"

    def _same_object(self, pair: ir.SameObject) -> Faults:
        yield from self._operand("left", pair.left, "i32")
        yield from self._operand("right", pair.right, "i32")

    def _passed(self, passed: ir.Passed) -> Faults:
        yield from self._register("address", passed.address, "i32")

    def _copy(self, copy: ir.Copy) -> Faults:
        yield from self._operand("target", copy.target, "i32")
        yield from self._operand("source", copy.source, "i32")
        yield from self._operand("size", copy.size, "i32")

    def _fill(self, fill: ir.Fill) -> Faults:
        yield from self._operand("target", fill.target, "i32")
        yield from self._operand("value", fill.value, "i32")
        yield from self._operand("size", fill.size, "i32")

    def _lifetime(self, lifetime: ir.Lifetime) -> Faults:
        yield from self._base(lifetime.slot)

    def _seal(self, seal: ir.Seal) -> Faults:
        yield from self._base(seal.slot)

    def _mark(self, mark: ir.Mark) -> Faults:
        yield from self._trusted()
        yield from self._operand("target", mark.target, "i32")
        yield from self._operand("size", mark.size, "i32")
        if mark.state not in set(ir.ByteState):
            yield f"{mark.state} is not a state of bytes"

    def _mark_unset(self, mark: ir.MarkUnset) -> Faults:
        yield from self._trusted()
        for name in ("target", "size", "origin"):
            yield from self._operand(name, getattr(mark, name), "i32")

    def _callers(self, callers: ir.Callers) -> Faults:
        yield from self._trusted()
        yield from self._operand("target", callers.target, "i32")

    def _state(self, state: ir.State) -> Faults:
        yield from self._trusted()
        yield from self._operand("address", state.address, "i32")
        yield from self._register("result", state.result, "i32")

    def _trusted(self) -> Faults:
        if not self.function.trusted:
            yield "touches the shadow memory in a function that is not trusted"

    # Terminators

    def _branch(self, branch: ir.Branch) -> Faults:
        yield from self._operand("condition", branch.condition, "i32")

    def _switch(self, switch: ir.Switch) -> Faults:
        type_ = switch.value.type
        if type_ not in _BITS:
            yield f"value has type {type_}, not i32 or i64"
            return
        yield from self._operand("value", switch.value)
        for value, times in Counter(value for value, _ in switch.cases).items():
            yield from self._operand("case", ir.Constant(type_, value))
            if times > 1:
                yield f"case {value} occurs {times} times"

    def _return(self, leave: ir.Return) -> Faults:
        if leave.value is None:
            return
        if self.function.result is None:
            yield "returns a value from a function without a result"
        else:
            yield from self._operand("returned value", leave.value, self.function.result)

    def _call(self, call: ir.Call) -> Faults:
        if isinstance(call.callee, ir.Register):
            yield from self._register("callee", call.callee, "i32")
        elif call.callee in self.program.data:
            yield f"callee '{call.callee}' is an object, not a function"
        elif not self._is_known(call.callee):
            yield f"callee '{call.callee}' is neither defined nor listed as undefined"
        for number, argument in enumerate(call.arguments):
            yield from self._argument(f"argument {number}", argument)
        if call.result is not None:
            yield from self._register("result", call.result)

    def _argument(self, what: str, argument: ir.Argument) -> Faults:
        if argument.memory is None:
            yield from self._operand(f"address of {what}", argument.value, "i32")
            if argument.size < 0:
                yield f"{what} has negative size {argument.size}"
            return
        yield from self._operand(what, argument.value, VALUE_TYPE[argument.memory])
        if argument.size != MEMORY_SIZE[argument.memory]:
            yield f"{what} is stored as {argument.memory}, but has size {argument.size}"

    def _request(self, request: ir.Request) -> Faults:
        yield from self._operand("code", request.code, "i32")
        yield from self._operand("message", request.message, "i32")
        yield from self._register("result", request.result, "i32")

    def _stop(self, stop: ir.Stop) -> Faults:
        if stop.kind not in ERROR_KINDS[1:]:
            yield f"'{stop.kind}' is not a kind of error"
        yield from self._operand("value", stop.value, "i32")

    def _set_jump(self, jump: ir.SetJump) -> Faults:
        yield from self._register("buffer", jump.buffer, "i32")
        yield from self._register("activation", jump.activation, "i32")
        yield from self._register("result", jump.result, "i32")

    def _long_jump(self, jump: ir.LongJump) -> Faults:
        yield from self._operand("activation", jump.activation, "i32")
        yield from self._operand("place", jump.place, "i32")
        yield from self._operand("value", jump.value, "i32")


_RULES: Final[dict[type[ir.Instruction], Callable[..., Faults]]] = {
    ir.Statement: BlockVerifier._nothing,
    ir.Move: BlockVerifier._move,
    ir.Unary: BlockVerifier._unary,
    ir.Binary: BlockVerifier._binary,
    ir.Load: BlockVerifier._load,
    ir.Store: BlockVerifier._store,
    ir.Address: BlockVerifier._address,
    ir.Bounds: BlockVerifier._bounds,
    ir.SameObject: BlockVerifier._same_object,
    ir.Passed: BlockVerifier._passed,
    ir.Copy: BlockVerifier._copy,
    ir.Fill: BlockVerifier._fill,
    ir.Lifetime: BlockVerifier._lifetime,
    ir.Seal: BlockVerifier._seal,
    ir.Mark: BlockVerifier._mark,
    ir.MarkUnset: BlockVerifier._mark_unset,
    ir.Callers: BlockVerifier._callers,
    ir.State: BlockVerifier._state,
    ir.Jump: BlockVerifier._nothing,
    ir.Branch: BlockVerifier._branch,
    ir.Switch: BlockVerifier._switch,
    ir.Return: BlockVerifier._return,
    ir.Call: BlockVerifier._call,
    ir.Request: BlockVerifier._request,
    ir.Stop: BlockVerifier._stop,
    ir.SetJump: BlockVerifier._set_jump,
    ir.LongJump: BlockVerifier._long_jump,
}
