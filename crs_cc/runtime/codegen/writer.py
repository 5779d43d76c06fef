"""The writer of a function's code: locals for registers, values, addresses, failures.

The cold path of a failed check stores the number of its site and leaves the function.
"""

from __future__ import annotations

from crs_cc.ir.instruction import VARARGS, Base, Constant, Operand, Register, Slot
from crs_cc.ir.value_type import MemoryType, ValueType
from crs_cc.runtime.codegen.flow_graph import FAULTED, SIDE_EXIT, Node
from crs_cc.runtime.codegen.fuel_charges import FREE_BYTES, charge
from crs_cc.runtime.codegen.indices import ADDRESS, FIXED_LOCALS, FUEL, MEMORY, SITE, SP
from crs_cc.runtime.codegen.memory_instructions import LOADS, STORES
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.layout import Frame
from crs_cc.runtime.sites import Site
from crs_cc.runtime.wasm import UNLIKELY, Instr


class Writer:
    """Appends instructions to the code of one function.

    Attributes:
        code: the list that it appends to.
        names: the program's symbols.
        frame: the layout of the function's slots and registers.
        locals: the local of each register that has one.
        local_types: the types of the locals after the parameters.
        prepaid: the fuel paid for later blocks, which a failure gives back.
        side_exit: where to go instead of failing, in an inlined call.
    """

    def __init__(self, names: Symbols, frame: Frame) -> None:
        self.names = names
        self.frame = frame
        self.code: list[Instr] = []
        self.local_types: list[ValueType] = list(FIXED_LOCALS)
        self.locals: dict[Register, int] = {}
        self.prepaid = 0
        self.side_exit: Node | None = None
        self._released: set[Register] = set()
        self._free: dict[ValueType, list[int]] = {"i32": [], "i64": [], "f32": [], "f64": []}

    # -- locals ------------------------------------------------------------------------------

    def take_local(self, register: Register) -> None:
        """Allocate a local for a register until it is released."""
        free = self._free[register.type]
        if free:
            self.locals[register] = free.pop()
            return
        self.local_types.append(register.type)
        self.locals[register] = len(self.local_types) + 1

    def release(self, register: Register) -> None:
        """Free a register's local; when assigned again it is given a new one."""
        self._free[register.type].append(self.locals[register])
        self._released.add(register)

    def value(self, operand: Operand) -> Instr:
        """Return the instruction that pushes an operand's value."""
        if isinstance(operand, Constant):
            return (f"{operand.type}.const", operand.value)
        return ("local.get", self.locals[operand])

    def push(self, operand: Operand) -> None:
        """Push an operand's value."""
        self.code.append(self.value(operand))

    def pop(self, register: Register) -> None:
        """Pop a value into a register."""
        if register not in self.locals or register in self._released:
            self._released.discard(register)
            self.take_local(register)
        self.code.append(("local.set", self.locals[register]))

    # -- errors ------------------------------------------------------------------------------

    def fail(self, site: Site, value: list[Instr]) -> None:
        """Stop the program with a failure; `value` pushes the address or number to report."""
        if self.side_exit is not None:
            self.code.append((SIDE_EXIT, self.side_exit))
            return
        number = self.names.number(site)
        self.code += charge(-self.prepaid)
        self.code += [*value, ("local.set", ADDRESS)]
        self.code += [("i32.const", number), ("local.set", SITE), (FAULTED,)]

    def fail_if(self, site: Site, value: list[Instr]) -> None:
        """Stop the program if the i32 on the stack is not zero."""
        self.code.append(UNLIKELY)
        self.fail(site, value)
        self.code.append(("end",))

    # -- memory ------------------------------------------------------------------------------

    def address(self, base: Base, offset: int) -> None:
        """Push an address."""
        match base:
            case Register():
                self.push(base)
            case Slot():
                self.code.append(("local.get", SP))
                offset += self.frame.varargs if base is VARARGS else self.frame.offsets[base]
            case str():
                self.code.append(("i32.const", self.names.addresses[base] + offset))
                return
        if offset:
            self.code += [("i32.const", offset), ("i32.add",)]

    def store_at(self, base: int, offset: int, value: Operand, memory: MemoryType) -> None:
        """Store into the frame, relative to local `base`."""
        self.code.append(("local.get", base))
        self.push(value)
        self.code.append((STORES[memory], MEMORY, offset))

    def load_at(self, base: int, offset: int, memory: MemoryType) -> None:
        """Push a value of the frame, relative to local `base`."""
        self.code += [("local.get", base), (LOADS[memory], MEMORY, offset)]

    def charge(self, size: Operand) -> None:
        """Charge fuel for moving `size` bytes, in proportion to the time it takes."""
        if isinstance(size, Constant) and size.value < FREE_BYTES:
            return
        self.code += [("local.get", FUEL), self.value(size)]
        self.code += [("i32.const", FREE_BYTES.bit_length() - 1), ("i32.shr_u",)]
        self.code += [("i64.extend_i32_u",), ("i64.sub",), ("local.set", FUEL)]
