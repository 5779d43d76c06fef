"""Conditions of breakpoints as WebAssembly, which programs test themselves.

The test of a site is a function of the lower end of the stopped frame. It returns 0 if the
condition is certainly false. Whatever else there is to say is left to the debugger, which evaluates
the condition again: a variable without value, a pointer to nothing, a division by zero.
Expressions that do more than compute from the program's memory are not translated at all.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import wasmtime

from crs_cc.ir import instruction as ir
from crs_cc.ir.loops import postorder
from crs_cc.ir.program import Function
from crs_cc.ir.value_type import MEMORY_SIZE, MemoryType, ValueType
from crs_cc.runtime.codegen import shadow
from crs_cc.runtime.codegen.flow_graph import FAULTED, Node
from crs_cc.runtime.codegen.memory_instructions import LOADS
from crs_cc.runtime.codegen.structuring import emit
from crs_cc.runtime.executable import engine
from crs_cc.runtime.layout import MEMORY_BYTES, NULL_SIZE
from crs_cc.runtime.site_tests import SiteTests
from crs_cc.runtime.wasm import PAGE, TYPE_I32_I32, Code, Instr, Module

MEMORY, SHADOW = range(2)
"""The imported memories; the second in checked builds only."""

_SP: Final = 0
_VALUED: Final[dict[int, tuple[str, Instr, str]]] = {
    1: ("i32.load8_u", ("i32.const", 0x80), "i32"),
    2: ("i32.load16_u", ("i32.const", 0x8080), "i32"),
    4: ("i32.load", ("i32.const", 0x8080_8080), "i32"),
    8: ("i64.load", ("i64.const", 0x8080_8080_8080_8080), "i64"),
}
"""By the number of bytes: the load of their states, and the bits that say that they have values."""
_DIVISIONS: Final = ("div_s", "div_u", "rem_s", "rem_u")
_NO_CODE: Final = ir.Statement | ir.Lifetime | ir.Seal | ir.Bounds | ir.SameObject | ir.Passed


@dataclass(frozen=True, slots=True)
class PassedVariable:
    """A variable whose address is an argument of a condition's function.

    Attributes:
        at: its address, or its offset from the lower end of the frame.
        in_frame: whether it is in the frame.
        in_register: whether it is in a register, which has been saved there: its bytes have no
            states.
        flag: the offset of its initialised flag; None if it needs none.
        is_indirect: whether it is a hidden pointer to the variable.
    """

    at: int
    in_frame: bool
    in_register: bool = False
    flag: int | None = None
    is_indirect: bool = False


def site_tests(tests: Mapping[int, Code], *, checked: bool) -> SiteTests:
    """Compile tests, by the numbers of their sites, for a checked build or another one."""
    imports = [("crs", "memory", MEMORY_BYTES // PAGE)]
    imports += [("crs", "shadow", shadow.PAGES)] if checked else []
    module = Module(functions=list(tests.values()), own_imports=imports)
    module.exports = [(str(site), "func", number) for number, site in enumerate(tests)]
    return SiteTests(tuple(tests), wasmtime.Module(engine(), module.to_binary()))


class _UntranslatableError(Exception):
    """The expression does more than compute from the program's memory."""


def condition_code(
    function: Function,
    passed: Sequence[PassedVariable],
    addresses: Mapping[str, int],
    *,
    checked: bool,
) -> Code | None:
    """Return the test of a condition; None if it cannot be translated.

    Args:
        function: the condition's function; it returns an i32.
        passed: its arguments.
        addresses: those of the program's objects.
        checked: whether the program has states of its bytes.
    """
    try:
        return _Condition(function, passed, addresses, checked=checked).code()
    except _UntranslatableError:
        return None


class _Condition:
    def __init__(
        self,
        function: Function,
        passed: Sequence[PassedVariable],
        addresses: Mapping[str, int],
        *,
        checked: bool,
    ) -> None:
        self._function = function
        self._addresses = addresses
        self._checked = checked
        places = (each.place for each in function.parameters)
        self._passed = dict(zip(places, passed, strict=True))
        self._types: list[ValueType] = ["i32"]
        self._locals: dict[ir.Register, int] = {}
        self._address = 1

    def code(self) -> Code:
        """Return the function."""
        nodes = {block: Node() for block in self._function.blocks}
        first = Node(self._arguments())
        first.jump(nodes[self._function.blocks[0]])
        for block, node in nodes.items():
            for instruction in block.instructions:
                node.code += self._instruction(instruction)
            self._end(node, block, nodes)
        _check_forward(first)
        body = [*emit(first, []), ("i32.const", 1)]
        return Code("test", TYPE_I32_I32, self._types, body)

    def _arguments(self) -> list[Instr]:
        """Set the parameters to the addresses of the variables."""
        code: list[Instr] = []
        for place, variable in self._passed.items():
            if not isinstance(place, ir.Register):
                raise _UntranslatableError
            code += self._flag(variable) if variable.is_indirect else []
            code += self._variable(variable)
            if variable.is_indirect:
                code += [("i32.load", MEMORY, 0)]
            code.append(("local.set", self._local(place)))
        return code

    def _variable(self, variable: PassedVariable) -> list[Instr]:
        at: Instr = ("i32.const", variable.at)
        return [("local.get", _SP), at, ("i32.add",)] if variable.in_frame else [at]

    def _flag(self, variable: PassedVariable) -> list[Instr]:
        """Give up if a variable in a register has no value."""
        if variable.flag is None:
            return []
        load: Instr = ("i32.load", MEMORY, variable.flag)
        return [("local.get", _SP), load, ("i32.eqz",), *_GIVE_UP_IF]

    def _local(self, register: ir.Register) -> int:
        if register not in self._locals:
            self._types.append(register.type)
            self._locals[register] = len(self._types)
        return self._locals[register]

    def _push(self, operand: ir.Operand) -> Instr:
        if isinstance(operand, ir.Constant):
            return (f"{operand.type}.const", operand.value)
        return ("local.get", self._local(operand))

    # -- instructions ------------------------------------------------------------------------

    def _instruction(self, it: ir.Instruction) -> list[Instr]:
        match it:
            case ir.Move():
                return [self._push(it.source), self._set(it.result)]
            case ir.Unary() if ".trunc_f" not in it.op:
                return [self._push(it.source), (it.op,), self._set(it.result)]
            case ir.Binary():
                return [*self._binary(it), self._set(it.result)]
            case ir.Address():
                return [*self._base(it.base, it.offset), self._set(it.result)]
            case ir.Load():
                return [*self._load(it), self._set(it.result)]
        if isinstance(it, _NO_CODE):
            return []
        raise _UntranslatableError

    def _set(self, register: ir.Register) -> Instr:
        if register in self._passed:
            raise _UntranslatableError
        return ("local.set", self._local(register))

    def _binary(self, it: ir.Binary) -> list[Instr]:
        left, right = self._push(it.left), self._push(it.right)
        kind, _, name = it.op.partition(".")
        code: list[Instr] = []
        if name in _DIVISIONS:
            code += [right, (f"{kind}.eqz",), *_GIVE_UP_IF]
        if name == "div_s":  # the quotient of the least number and -1 does not fit
            code += [right, (f"{kind}.const", -1), (f"{kind}.eq",), *_GIVE_UP_IF]
        return [*code, left, right, (it.op,)]

    def _base(self, base: ir.Base, offset: int) -> list[Instr]:
        match base:
            case ir.Register():
                return [self._push(base), ("i32.const", offset), ("i32.add",)]
            case str() if base in self._addresses:
                return [("i32.const", self._addresses[base] + offset)]
        raise _UntranslatableError

    def _load(self, it: ir.Load) -> list[Instr]:
        load: Instr = (LOADS[it.memory], MEMORY, 0)
        address = self._base(it.base, it.offset)
        variable = self._passed.get(it.base) if isinstance(it.base, ir.Register) else None
        if variable is not None and variable.in_register and not variable.is_indirect:
            return [*self._flag(variable), *address, load]
        address.append(("local.tee", self._address))
        return [*address, *self._checks(it.memory), ("local.get", self._address), load]

    def _checks(self, memory: MemoryType) -> list[Instr]:
        """Give up if the bytes at the address on the stack are outside, or have no values."""
        size = MEMORY_SIZE[memory]
        code: list[Instr] = [
            ("i32.const", NULL_SIZE), ("i32.sub",),
            ("i32.const", MEMORY_BYTES - NULL_SIZE - size), ("i32.gt_u",), *_GIVE_UP_IF,
        ]  # fmt: skip
        if self._checked:
            load, bits, kind = _VALUED[size]
            code += [("local.get", self._address), (load, SHADOW, 0)]
            code += [bits, (f"{kind}.and",), bits, (f"{kind}.ne",), *_GIVE_UP_IF]
        return code

    # -- the ends of blocks ------------------------------------------------------------------

    def _end(self, node: Node, block: ir.Block, nodes: Mapping[ir.Block, Node]) -> None:
        match block.terminator:
            case ir.Jump(target=target):
                node.jump(nodes[target])
            case ir.Branch() as branch:
                node.code.append(self._push(branch.condition))
                node.exit = "branch"
                node.targets = [nodes[branch.then], nodes[branch.otherwise]]
            case ir.Return(value=value) if value is not None and value.type == "i32":
                node.code += [self._push(value), ("return",)]
            case _:
                raise _UntranslatableError


_GIVE_UP_IF: Final[list[Instr]] = [("if",), (FAULTED,), ("end",)]


def _check_forward(entry: Node) -> None:
    """Check that no jump leads back: the test always ends."""
    rank = {node: number for number, node in enumerate(postorder(entry))}
    for node, own in rank.items():
        if any(rank[target] >= own for target in node.targets):
            raise _UntranslatableError
