"""An interpreter of IR on a stopped program's memory, for the user's expressions.

The program itself runs as machine code; an expression, and the functions of the
program that it calls, are interpreted here. Their own variables, and the strings in the expression,
are in scratch memory above the program's. What they print is collected. Whatever else would leave
the program (a request) or the functions (`longjmp`) is refused, and so is a long evaluation.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, Protocol

import numpy as np

from crs_cc.debug.data.expression_memory import EvaluationError, Scratch
from crs_cc.debug.data.instruction_steps import (
    SCRATCH,
    SCRATCH_BYTES,
    CallFrame,
    InstructionSteps,
    loaded,
    operand_value,
    store,
)
from crs_cc.debug.data.operators import signed, unsigned
from crs_cc.debug.data.unused_objects import UnusedObjects
from crs_cc.debug.timeline.change import STREAMS, UNLINKED
from crs_cc.ir import instruction as ir
from crs_cc.ir.names import plain_name
from crs_cc.ir.program import Data, Function, Program
from crs_cc.ir.types import CType, FloatType, PointerType, VoidType
from crs_cc.ir.value_type import MemoryType
from crs_cc.requests import CODES, DATA_SIZE, MESSAGE

MAX_INSTRUCTIONS: Final = 1_000_000
MAX_CALLS: Final = 200
CALLED_ONLY: Final = 0xF000_0000
"""The first address of functions to which no pointer of the program can point."""
Printed = tuple[int, bytes]
"""A stream, and what was written to it."""
FindDefinition = Callable[[str], Function | Data | None]
"""Returns the library's function or object of a name."""


def _nothing(_name: str) -> None:
    return None


class InterpreterMemory(Protocol):
    """A stopped program's memory.

    Attributes:
        trusting: whether accesses are not checked, as for the allocator.
    """

    trusting: bool

    def read(self, address: int, size: int, *, judged: bool = True) -> bytes:
        """Return bytes; they must be initialised if `judged`.

        Raises:
            EvaluationError: C may not read them.
        """

    def write(self, address: int, content: bytes, states: bytes = b"") -> None:
        """Write bytes; they become initialised unless `states` says otherwise.

        Raises:
            EvaluationError: C may not write them.
        """

    def states(self, address: int, size: int) -> bytes:
        """Return the `ByteState`s of bytes."""

    def state(self, address: int) -> int:
        """Return the `ByteState` of a byte."""

    def mark(self, address: int, size: int, state: int) -> None:
        """Set the `ByteState`s of bytes."""


class Interpreter:
    """Evaluates functions of IR.

    Attributes:
        printed: the stream and bytes of each piece of output of the last evaluation.
    """

    def __init__(
        self,
        program: Program,
        addresses: Mapping[str, int],
        memory: InterpreterMemory,
        find_definition: FindDefinition = _nothing,
        unused: UnusedObjects | None = None,
    ) -> None:
        """Create an interpreter.

        Args:
            program: a linked program.
            addresses: of its objects, and function pointers of its functions.
            memory: its memory.
            find_definition: returns what the program lacks but an expression may use: functions of
                the library, and their objects, fresh for each expression.
            unused: the user's objects that the program does not use.
        """
        self._program = program
        self._addresses = dict(addresses)
        self._memory = memory
        self._unused = unused or UnusedObjects({})
        self._addresses.update(self._unused.addresses)
        functions = [*program.functions, *(program.unused or Program()).functions]
        called = [name for name in functions if name not in self._addresses]
        self._addresses.update({name: CALLED_ONLY + at for at, name in enumerate(called)})
        self._functions = {self._addresses[name]: name for name in functions}
        self._scratch = Scratch(SCRATCH, SCRATCH_BYTES)
        self._borrowed = Scratch(SCRATCH + SCRATCH_BYTES, SCRATCH_BYTES)
        self._find_definition = find_definition
        self._borrowed_names: list[str] = []
        self._left = MAX_INSTRUCTIONS
        self._depth = 0
        self._steps = InstructionSteps()
        self.printed: list[Printed] = []

    def evaluate(self, expression: Program, name: str, arguments: Sequence[int | bytes]) -> Any:
        """Call a function of an expression's program, which may use all of the stopped one.

        Args:
            expression: the expression's program.
            name: its function.
            arguments: what its registers hold at first; bytes are passed by address.

        Returns:
            Its value, or None. Scratch memory that it points to is valid
            until the next evaluation.

        Raises:
            EvaluationError: it cannot be evaluated.
        """
        self._left, self._memory.trusting = MAX_INSTRUCTIONS, False
        self._scratch.release(0)
        self._borrowed.release(0)
        self.printed = []
        for lent in self._borrowed_names:
            del self._addresses[lent]
        self._borrowed_names.clear()
        self._unused.begin()
        for data in expression.data.values():
            self._addresses[data.name] = self._scratch.allocate(data.size)
        for data in expression.data.values():
            self._fill(data)
        own, frame = expression.functions[name], CallFrame(self)
        for parameter, each in zip(own.parameters, arguments, strict=True):
            assert isinstance(parameter.place, ir.Register)
            address = self._kept(each) if isinstance(each, bytes) else each
            frame.values[parameter.place] = signed(address, 32)
        for slot in own.slots:
            frame.slots[slot] = self._scratch.allocate(max(1, slot.size))
        self._depth = 1
        try:
            return self._run(own, frame)
        except ArithmeticError as wrong:
            raise EvaluationError(str(wrong)) from None
        finally:
            self._depth = 0

    def scratch(self, address: int, size: int) -> bytes:
        """Return bytes of the scratch memory or of unused objects, fewer at their ends."""
        if address >= UNLINKED:
            return self._unused.peek(address, size, self.symbol_address)
        return (self._borrowed if address in self._borrowed else self._scratch).peek(address, size)

    def name_of(self, address: int, target: CType) -> str:
        """Return the name of a function that is only called, or of an unused object; else ""."""
        if address >= CALLED_ONLY:
            return plain_name(self._functions.get(address, ""))
        return self._unused.name_of(address, target) if address >= UNLINKED else ""

    def read_scratch(self, address: int, size: int) -> bytes:
        """Return bytes as `scratch` does; raise EvaluationError if they are not there."""
        if address >= UNLINKED:
            return self._unused.read(address, size, self.symbol_address)
        return (self._borrowed if address in self._borrowed else self._scratch).read(address, size)

    def _kept(self, content: bytes) -> int:
        address = self._scratch.allocate(len(content))
        self._scratch.write(address, content)
        return address

    def _fill(self, data: Data) -> None:
        address = self._addresses[data.name]
        self.write(address, (data.content or b"").ljust(data.size, b"\0"))
        for relocation in data.relocations:
            value = unsigned(self.symbol_address(relocation.symbol) + relocation.addend, 32)
            self.write(address + relocation.offset, value.to_bytes(4, "little"))

    def symbol_address(self, name: str) -> int:
        """Return the address of an object or function."""
        if name not in self._addresses and name not in self._program.functions:
            found = self._find_definition(name)
            if isinstance(found, Data):
                self._addresses[name] = self._borrowed.allocate(found.size)
                self._borrowed_names.append(name)
                self._fill(found)
        if name not in self._addresses:
            raise EvaluationError(f"'{plain_name(name)}' has no address here: it is unused")
        return self._addresses[name]

    # -- memory ------------------------------------------------------------------------------

    def read(self, address: int, size: int, *, judged: bool = True) -> bytes:
        """Return bytes; they must be initialised if `judged`."""
        if address < SCRATCH:
            return self._memory.read(address, size, judged=judged)
        return self.read_scratch(address, size)

    def write(self, address: int, content: bytes, states: bytes = b"") -> None:
        """Write bytes; they become initialised unless `states` says otherwise."""
        address = unsigned(address, 32)
        if address < SCRATCH:
            self._memory.write(address, content, states)
        elif address >= UNLINKED:
            self._unused.write(address, content, self.symbol_address)
        else:
            (self._borrowed if address in self._borrowed else self._scratch).write(address, content)

    def states(self, address: int, size: int) -> bytes:
        """Return the `ByteState`s of bytes of the program."""
        return self._memory.states(address, size)

    def state(self, address: int) -> int:
        """Return the `ByteState` of a byte of the program."""
        return self._memory.state(address)

    def mark(self, address: int, size: int, state: int) -> None:
        """Set the `ByteState`s of bytes of the program."""
        self._memory.mark(address, size, state)

    # -- calls -------------------------------------------------------------------------------

    def _call(self, function: Function, arguments: list[tuple[MemoryType | None, Any, int]]) -> Any:
        self._depth += 1
        if self._depth > MAX_CALLS:
            raise EvaluationError("too many nested calls")
        mark, frame, trusting = self._scratch.mark(), CallFrame(self), self._memory.trusting
        try:
            self._enter(function, frame, arguments)
            self._memory.trusting = function.trusted
            return self._run(function, frame)
        finally:
            self._depth -= 1
            self._memory.trusting = trusting
            self._scratch.release(mark)

    def _enter(
        self,
        function: Function,
        frame: CallFrame,
        arguments: list[tuple[MemoryType | None, Any, int]],
    ) -> None:
        """Lay out arguments, as a caller does, and slots."""
        sizes = [-(-size // 4) * 4 for _, _, size in arguments]
        wanted = sum(-(-each.size // 4) * 4 for each in function.parameters)
        at = start = self._scratch.allocate(max(sum(sizes), wanted))
        for (memory, value, size), room in zip(arguments, sizes, strict=True):
            if memory is None:
                self.write(at, self.read(unsigned(value, 32), size, judged=False))
            else:
                store(self, at, memory, value)
            at += room
        at = start
        for parameter in function.parameters:
            if isinstance(parameter.place, ir.Slot):
                frame.slots[parameter.place] = at
            elif parameter.memory is not None:
                frame.values[parameter.place] = loaded(self, at, parameter.memory)
            at += -(-parameter.size // 4) * 4
        frame.more = at
        for slot in function.slots:
            frame.slots[slot] = self._scratch.allocate(max(1, slot.size))

    def _run(self, function: Function, frame: CallFrame) -> Any:
        block = function.blocks[0]
        while True:
            self._spend(len(block.instructions) + 1)
            for step in self._steps.of(block):
                step(frame)
            end = block.terminator
            if isinstance(end, ir.Return):
                return None if end.value is None else operand_value(frame, end.value)
            block = self._next(frame, end)

    def _request(self, code: int, address: int) -> int:
        """Answer a request to print; refuse others, which are to the simulated world."""
        if code != CODES["WRITE"]:
            raise EvaluationError("the expression calls a function that needs the simulated world")
        content = self.read(unsigned(address, 32), MESSAGE.itemsize, judged=False)
        message = np.frombuffer(content, MESSAGE)[0]
        stream, size = int(message["i"][0]), int(message["size"])
        if stream not in STREAMS or not 0 <= size <= DATA_SIZE:
            return -1
        self.printed.append((stream, message["data"][:size].tobytes()))
        return size

    def _spend(self, instructions: int) -> None:
        self._left -= instructions
        if self._left < 0:
            raise EvaluationError(f"evaluation exceeds {MAX_INSTRUCTIONS:,} instructions")

    def _next(self, frame: CallFrame, end: Any) -> ir.Block:
        match end:
            case ir.Jump(target=target):
                return target
            case ir.Branch():
                return end.then if operand_value(frame, end.condition) else end.otherwise
            case ir.Switch():
                return dict(end.cases).get(operand_value(frame, end.value), end.default)
            case ir.Call():
                result = self._call_by(frame, end)
                if end.result is not None:
                    frame.values[end.result] = result
                return end.then
            case ir.Request():
                code, message = operand_value(frame, end.code), operand_value(frame, end.message)
                frame.values[end.result] = self._request(code, message)
                return end.then
            case ir.SetJump() | ir.LongJump():
                raise EvaluationError("the expression calls setjmp or longjmp")
            case ir.Stop(kind=kind):
                raise EvaluationError(kind)
        raise AssertionError(end)

    def _call_by(self, frame: CallFrame, call: ir.Call) -> Any:
        name = call.callee
        if isinstance(name, ir.Register):
            pointer = operand_value(frame, name)
            if pointer not in self._functions:
                raise EvaluationError(f"{unsigned(pointer, 32):#x} is not a function's address")
            name = self._functions[pointer]
        function = self._program.functions.get(name) or self._find_definition(name)
        if not isinstance(function, Function) or self._is_missing(function):
            raise EvaluationError(f"the program has no function '{plain_name(name)}'")
        arguments = [
            (each.memory, operand_value(frame, each.value), each.size) for each in call.arguments
        ]
        return self._call(function, arguments)

    def _is_missing(self, function: Function) -> bool:
        """Return whether a function works on a heap that the program lacks."""
        return function.trusted and function.name not in self._program.functions


def check_address(ctype: CType, result: float) -> None:
    """Raise EvaluationError if a result is the address of what an expression has made for itself.

    Addresses of texts will do: the texts are shown.
    """
    if not isinstance(ctype, PointerType) or ctype.target.size == 1:
        return
    if SCRATCH <= unsigned(int(result), 32) < SCRATCH + 2 * SCRATCH_BYTES:
        raise EvaluationError("the address of a value that is not in the program's memory")


def result_bytes(ctype: CType, result: Any) -> bytes:
    """Return the object representation of a value."""
    if isinstance(ctype, VoidType) or result is None:
        return b""
    if isinstance(ctype, FloatType):
        return struct.pack("<f" if ctype.size == 4 else "<d", result)
    return unsigned(int(result), 8 * ctype.size).to_bytes(ctype.size, "little")
