"""One IR function as one WebAssembly function, see `convention`.

The function keeps its registers in WebAssembly locals. To suspend (a request, out of fuel,
a suspended callee, a breakpoint) it stores in local `label` the
landing where it will resume and leaves through its epilogue, which saves the registers to their
spill slots in the frame. When it is called again it reloads them and jumps to that landing. See
`layout` for the frame and `dispatch` for landings.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.definite_assignment import Assignments
from crs_cc.ir.instruction import (
    Block,
    Branch,
    Call,
    Constant,
    Instruction,
    Jump,
    LongJump,
    Register,
    Request,
    Return,
    SetJump,
    Statement,
    Stop,
    Store,
    Switch,
)
from crs_cc.ir.liveness import Liveness, all_instructions
from crs_cc.ir.names import in_library
from crs_cc.ir.program import Function
from crs_cc.requests import MESSAGE, SUSPENDED, slot_offset
from crs_cc.runtime.codegen import frame_states, jumps, stopping
from crs_cc.runtime.codegen.activation import Activation
from crs_cc.runtime.codegen.body import Body
from crs_cc.runtime.codegen.build import Build
from crs_cc.runtime.codegen.call_checks import check_pointer, check_value
from crs_cc.runtime.codegen.checked_arithmetic import CheckedArithmetic
from crs_cc.runtime.codegen.checked_memory import CheckedMemory
from crs_cc.runtime.codegen.convention import GENERAL_FORM, Convention
from crs_cc.runtime.codegen.deferred_checks import DeferredChecks
from crs_cc.runtime.codegen.flow_graph import LANDING, UNWIND, Landing, Node, take_apart
from crs_cc.runtime.codegen.fuel_charges import charge, early_charges, exact_charges
from crs_cc.runtime.codegen.indices import (
    CALL_TYPE,
    FUEL,
    LABEL,
    MAILBOX,
    MEMORY,
    SHADOW,
    SLOT_GLOBAL,
    SP,
    with_parameters,
)
from crs_cc.runtime.codegen.inline_ranges import Place, copy_between
from crs_cc.runtime.codegen.inlined_calls import InlinedCalls, all_bodies, inlined_calls
from crs_cc.runtime.codegen.large_functions import homes_of, move_locals
from crs_cc.runtime.codegen.passing import arguments_size, pass_arguments
from crs_cc.runtime.codegen.plain_memory import PlainMemory
from crs_cc.runtime.codegen.registers import Registers
from crs_cc.runtime.codegen.rotation import rotated_loops
from crs_cc.runtime.codegen.selection import Selector
from crs_cc.runtime.codegen.signatures import named_call
from crs_cc.runtime.codegen.stop_marks import begin, has_statements, self_resuming, stop_if_marked
from crs_cc.runtime.codegen.struct_registers import with_structs_in_registers
from crs_cc.runtime.codegen.structuring import emit
from crs_cc.runtime.codegen.switches import lower_switch
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.codegen.value_numbering import sole_predecessors
from crs_cc.runtime.codegen.watchpoints import Watchpoints
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.compiled import FunctionInfo
from crs_cc.runtime.layout import RESULT, STACK_SIZE, Frame, lay_out
from crs_cc.runtime.sites import Site, StatementSite
from crs_cc.runtime.wasm import TYPE_CALL, UNLIKELY, Code, Instr

MESSAGE_OFFSET = slot_offset("message")
RESULT_OFFSET = MESSAGE_OFFSET + int(MESSAGE.fields["result"][1])  # type: ignore[index]

MAX_OUTLINED: Final = 8
"""Functions with more calls resume themselves."""


def generate(function: Function, names: Symbols, build: Build) -> tuple[Code, FunctionInfo]:
    """Generate the code of a verified function."""
    return _FunctionCode(function, names, build).run()


class _FunctionCode:
    def __init__(self, function: Function, names: Symbols, build: Build) -> None:
        self.original = function
        partly = with_structs_in_registers(function, None if build.debug else names.bodies)
        function = self.function = partly.function
        self.fields = partly.homes
        self.build = build
        self.checked, self.debug = build.checked, build.debug
        self.steps = build.debug and has_statements(function)
        self.shadowed = build.checked and not function.trusted
        self.marks = SHADOW + 1 if build.checked else SHADOW
        self.names = names
        liveness = Liveness(function)
        self.assigned = Assignments(function, steps=self.steps) if self.shadowed else None
        self.deferred = None
        more: list[Register] = []
        if self.shadowed:
            self.deferred = DeferredChecks(function, liveness, keep=self.debug)
            more = [*(self.deferred.registers if self.debug else []), *self.fields]
        self.flags = self.assigned.flags if self.assigned else {}
        more = [*self.flags.values(), *more]
        inlined = {} if self.debug else inlined_calls(function.blocks, names.bodies)
        self.registers = Registers(function, liveness, more, inlined=inlined, debug=self.debug)
        self.saved = self.registers.saved
        self.homes = homes_of(function, self.registers, checked=self.shadowed, steps=self.steps)
        self.frame = self._frame(sum(body.charge for body in all_bodies(inlined).values()))
        self.writer = Writer(names, self.frame)
        self.watching = self._watchpoints()
        self.memory, self.selector = self._selection(inlined)
        self.activation = Activation(
            function, build, self.writer, self.registers,
            homes=self.homes, members=self.fields, watching=self.watching,
        )  # fmt: skip
        self.inlined = InlinedCalls(
            self.writer, inlined, checked=build.checked, traps_overflow=build.trap_overflow
        )
        self.nodes = {block: Node() for block in function.blocks}
        headers = self.registers.headers
        self.fuel = (
            exact_charges(function) if self.debug else early_charges(function, headers, partly.fuel)
        )
        self.latches = {} if self.debug else rotated_loops(function, headers)
        self.bottoms = {header: Node() for header in self.latches}
        self.here = function.blocks[0]
        self.landings: list[tuple[Landing, Instruction]] = []
        self.failing: list[tuple[Landing, Instruction]] = []
        self.calls: list[Landing] = []

    def _frame(self, charge: int) -> Frame:
        """Lay out the frame, with a charge for inlined functions."""
        charge += self.registers.charge
        if not self.names.conventions[self.function.name].is_general:
            charge += GENERAL_FORM
        if self.deferred and not self.debug:
            charge += self.deferred.charge
        saved = [each for each in self.saved if each not in self.fields]
        kept = [*saved, *self.homes.values()]
        size = arguments_size(self.function, self.names)
        stamped = self.debug and not self.function.trusted
        frame = lay_out(self.original, kept, size, charge, checked=self.checked, stamped=stamped)
        for register, (slot, offset) in self.fields.items():
            frame.offsets[register] = frame.offsets[slot] + offset
        return frame

    def _watchpoints(self) -> Watchpoints | None:
        if not self.build.watch or self.function.trusted:
            return None
        library = in_library(self.function.location)
        return Watchpoints(self.writer, self.build.watch, self.marks, library=library)

    def _selection(self, inlined: dict[Call, Body]) -> tuple[PlainMemory, Selector]:
        """Return what accesses memory, and what selects instructions."""
        writer, arithmetic = self.writer, None
        memory = PlainMemory(writer, shadowed=self.checked)
        if self.deferred and self.assigned:
            sole = {}
            if not self.debug:  # where memory changes at statements
                headers = self.registers.headers
                sole = sole_predecessors(self.function, headers, inlined)
            lasting = frame_states.lasting(self.function)
            memory = CheckedMemory(writer, self.deferred, self.assigned, sole, lasting)
            arithmetic = CheckedArithmetic(writer, traps_overflow=self.build.trap_overflow)
        return memory, Selector(writer, memory, arithmetic, self.watching)

    # -- the whole ----------------------------------------------------------------------------

    def run(self) -> tuple[Code, FunctionInfo]:
        """Return the code and its debug information."""
        if self.frame.size > STACK_SIZE:  # its offsets might not fit an instruction
            return self.code(self.activation.overflow()), self.info()
        for register in self.registers.lasting:
            self.writer.take_local(register)
        for block in self.function.blocks:
            self.block(block)
        landings = [landing for landing, _ in self.landings]
        resumes = self.names.next_outlined if self.is_outlined() else 0
        first = self.nodes[self.function.blocks[0]]
        entry = self.activation.connect(first, landings, resumes=resumes)
        again = self.activation.resumption(landings) if resumes else None
        for number, (landing, _) in enumerate(self.failing, start=len(self.landings) + 1):
            landing.number = number
        code = self.code(self.body_from(entry))
        if again is not None:
            self.names.outlined.append(self.code(self.body_from(again)))
            take_apart(again)
        take_apart(entry)
        if self.checked:
            self.names.call_landings += [landing.number for landing in self.calls]
        return code, self.info()

    def is_outlined(self) -> bool:
        """Return whether another function resumes this one.

        Then the values that are live in it do not meet those that were saved. It is twice the code,
        so it is for functions without loops, where the time goes to calls.
        """
        calls = all(isinstance(it, Call) for _, it in self.landings)
        is_plain = not self.registers.headers and not self.homes
        is_small = self.names.bodies.is_small(self.function.name)
        if is_small or self.build.debug or in_library(self.function.location):
            return False
        return is_plain and calls and 0 < len(self.landings) <= MAX_OUTLINED

    def body_from(self, entry: Node) -> list[Instr]:
        """Return the code from an entry on."""
        body = emit(entry, self.activation.failed()) + self.activation.epilogue()
        body = self.in_frame(body) if self.homes else body
        return (self_resuming(body) if self.steps else body) + self.activation.no_value()

    def code(self, body: list[Instr]) -> Code:
        """Return the code with the types of its parameters and locals."""
        kind = self.activation.convention.type
        body = with_parameters(body, len(kind[0]) - len(TYPE_CALL[0]))
        return Code(self.function.name, kind, self.writer.local_types, body)

    def in_frame(self, body: list[Instr]) -> list[Instr]:
        """Return the code of a large function with its registers in the frame."""
        offsets, local_of = self.frame.offsets, self.writer.locals
        homes = {local_of[each]: (each.type, offsets[home]) for each, home in self.homes.items()}
        return move_locals(body, homes, self.writer.local_types)

    def info(self) -> FunctionInfo:
        places = {0: self.function.location}
        landings = self.landings + self.failing
        places.update((landing.number, it.location) for landing, it in landings)
        active = [(each, it) for each, it in landings if not each.after_call]
        callees = {each.number: it.callee for each, it in active if isinstance(it, Call)}
        known = self.assigned.unset if self.assigned else {}
        unset = {each.number: known[it] for each, it in self.landings if it in known}
        return FunctionInfo(self.original, self.frame, places, callees, self.flags, unset)

    # -- suspending ---------------------------------------------------------------------------

    def add_landing(self, node: Node, it: Instruction) -> Landing:
        landing = Landing(node)
        self.landings.append((landing, it))
        return landing

    def suspend(self, landing: Landing) -> list[Instr]:
        return [*stopping.status(SUSPENDED), *self.unwind(landing)]

    def unwind(self, landing: Landing) -> list[Instr]:
        return [(LANDING, landing), ("local.set", LABEL), (UNWIND,)]

    # -- blocks -------------------------------------------------------------------------------

    def block(self, block: Block) -> None:
        self.here = block
        if block not in self.registers.headers:
            self.write(block, self.nodes[block], [])
            return
        landing = self.add_landing(self.nodes[block], all_instructions(block)[0])
        landing.prepaid = prepaid = self.fuel.received[block]
        test: list[Instr] = [("local.get", FUEL), ("i64.const", -prepaid), ("i64.lt_s",), UNLIKELY]
        test += [*charge(-prepaid), *self.suspend(landing), ("end",)]
        self.write(block, self.nodes[block], test)
        if block in self.bottoms:
            self.write(block, self.bottoms[block], test)

    def write(self, block: Block, node: Node, test: list[Instr]) -> None:
        """Write a block, after a test whether the function must be suspended."""
        selector, writer = self.selector, self.writer
        selector.forget()
        self.memory.begin(block)
        code = writer.code = node.code
        code += test
        code += charge(self.fuel.charges[block])
        writer.prepaid = self.fuel.prepaid[block]
        last = self.registers.last_uses(block)
        for number, instruction in enumerate(block.instructions):
            if not isinstance(instruction, Statement):
                selector.before(instruction)
                selector.select(instruction)
            elif self.steps:
                node = self.statement(node, instruction)
            for register in last[number]:
                writer.release(register)
        if block.terminator is not None:
            selector.before(block.terminator)
        self.terminator(node, block)
        self.memory.end(block)
        for register in last[-1]:
            writer.release(register)

    def statement(self, node: Node, statement: Statement) -> Node:
        """Debug builds: stop before a marked statement, when enough sites have been passed."""
        return self.stop_site(node, statement, after_call=False)

    def behind(self, node: Node, call: Call) -> Node:
        """Debug builds: stop after a marked call, before its result is used."""
        return self.stop_site(node, call, after_call=True)

    def stop_site(self, node: Node, it: Instruction, *, after_call: bool) -> Node:
        following = Node()
        landing = self.add_landing(following, it)
        landing.after_call = after_call
        site = StatementSite(self.function.name, it.location, after_call)
        number = self.names.statement_number(site)
        watching, suspend = self.watching is not None, self.unwind(landing)
        node.code += stop_if_marked(self.marks, number, suspend, watching=watching)
        node.jump(following)
        following.code += begin(self.marks, recorded=watching and not after_call)
        self.selector.forget()
        self.writer.code = following.code
        return following

    def target(self, block: Block) -> Node:
        """Return the node of a successor: at a rotated loop's end, the copy of its header there."""
        return (self.bottoms if self.here in self.latches.get(block, ()) else self.nodes)[block]

    def terminator(self, node: Node, block: Block) -> None:
        match block.terminator:
            case Jump(target=target):
                node.jump(self.target(target))
            case Branch() as branch:
                self.writer.push(branch.condition)
                node.exit = "branch"
                node.targets = [self.target(branch.then), self.target(branch.otherwise)]
            case Switch() as switch:
                lower_switch(self.writer, node, switch, self.nodes)
            case Return(value=value):
                self.activation.leave(node, value)
            case Call() as call:
                self.call(node, call)
            case Request() as request:
                self.request(node, request)
            case Stop(kind=kind, location=location, value=value):
                self.writer.fail(Site(kind, location), [self.writer.value(value)])
            case SetJump() as jump:
                self.set_jump(node, jump)
            case LongJump() as jump:
                self.long_jump(node, jump)

    def call(self, node: Node, call: Call) -> None:
        selector, writer = self.selector, self.writer
        if call in self.inlined.calls:
            then = self.target(call.then)
            self.inlined.write(node, call, then, self.memory, self._fail_again)
            self.memory.after(call)
            return
        self.pass_arguments(call)
        after = Node()
        node.jump(after)
        selector.forget()
        writer.code = after.code
        self._enter(call, after)

    def convention(self, call: Call) -> Convention | None:
        """Return how a call is made; None for the general form of a function."""
        named = named_call(call)
        if named is None:
            return None
        found = self.names.conventions.get(named.callee)
        return found if found is not None and found.matches(named) else None

    def pass_arguments(self, call: Call) -> None:
        """Store the arguments that are passed in memory, and the header."""
        convention = self.convention(call)
        registers = convention.registers if convention else (None,) * len(call.arguments)
        in_registers = [each is not None for each in registers]
        names, memory = self.function.name, self.memory
        pass_arguments(call, names, memory, self.build, in_registers=in_registers)

    def push_arguments(self, call: Call) -> None:
        """Push the arguments that are passed in registers."""
        code, convention = self.writer.code, self.convention(call)
        code += [("local.get", SP), ("local.get", FUEL)]
        registers = convention.registers if convention else ()
        for argument, memory in zip(call.arguments, registers, strict=False):
            if memory is not None:
                self.writer.push(argument.value)

    def _fail_again(self, call: Call) -> None:
        """Make a call that was inlined and has failed; it fails again, or returns."""
        self.pass_arguments(call)
        landing = Landing(Node())
        self.failing.append((landing, call))
        self.calls.append(landing)
        value, code = self._call_named(call, str(call.callee)), self.writer.code
        code += [("local.set", FUEL), *stopping.IF_STOPPED]
        code += [(LANDING, landing), ("local.set", LABEL), (UNWIND,), *stopping.END]
        self._take_result(call, value)

    def _enter(self, call: Call, after: Node) -> None:
        """Call the callee, fresh or resumed: this is where a suspended caller resumes."""
        landing = self.add_landing(after, call)
        landing.prepaid = stopping.STOPPED
        self.calls.append(landing)
        if isinstance(call.callee, Register):
            check_pointer(self.writer, call, call.callee, shapes=self.shadowed)
            self.push_arguments(call)
            self.writer.push(call.callee)
            after.code.append(("call_indirect", CALL_TYPE, 0))
            value = self._returned(call, None)
        else:
            value = self._call_named(call, call.callee)
        after.code += [("local.set", FUEL), *stopping.IF_STOPPED]
        after.code += [(LANDING, landing), ("local.set", LABEL), (UNWIND,), *stopping.END]
        if self.steps and value is not None:  # where debuggers look for it
            self.writer.store_at(SP, RESULT, value, value.type)
        if call.result is not None:
            if self.shadowed:
                check_value(self.writer, call)
            self._take_result(call, value)
            self.selector.after(call)
        end = self.behind(after, call) if self.steps else after
        end.jump(self.target(call.then))

    def _call_named(self, call: Call, callee: str) -> Register | None:
        """Call a function by its own form or, if arguments do not suit it, the general one."""
        self.push_arguments(call)
        convention = self.convention(call)
        called = self.names.general if convention is None else self.names.functions
        self.writer.code.append(("call", called[callee]))
        return self._returned(call, convention)

    def _take_result(self, call: Call, value: Register | None) -> None:
        """Move the returned value, which is in memory if it is not given, to the call's result."""
        if call.result is None:
            if value is not None:
                self.writer.release(value)
            return
        if value is None:
            self.writer.load_at(SP, RESULT, call.result.type)
        else:
            self.writer.push(value)
            self.writer.release(value)
        self.writer.pop(call.result)

    def _returned(self, call: Call, convention: Convention | None) -> Register | None:
        """Pop the returned value, which is none yet if the callee has stopped."""
        if convention is None or convention.result is None:
            return None
        if call.result is None and not self.steps:
            self.writer.code.append(("drop",))
            return None
        value = Register(-1, convention.result)
        self.writer.pop(value)
        return value

    def request(self, node: Node, request: Request) -> None:
        """Copy the message to the slot and suspend; copy the reply back when resumed."""
        selector, writer = self.selector, self.writer
        after = Node()
        landing = self.add_landing(after, request)
        self.memory.check_message(request.message, request.location)
        slot, size = ("global.get", SLOT_GLOBAL), MESSAGE.itemsize
        posted = Place(MAILBOX, slot, MESSAGE_OFFSET)
        node.code += copy_between(posted, Place(MEMORY, writer.value(request.message)), size)
        node.code.append(slot)
        writer.push(request.code)
        node.code.append(("i32.store", MAILBOX, slot_offset("code")))
        node.code += self.suspend(landing)
        selector.forget()
        writer.code = after.code
        if not self.checked:  # the program may have damaged the register that it saved
            self.memory.check_message(request.message, request.location)
        after.code += copy_between(Place(MEMORY, writer.value(request.message)), posted, size)
        self.memory.set_message(request.message)
        after.code += [slot, ("i32.load", MAILBOX, RESULT_OFFSET)]
        writer.pop(request.result)
        after.jump(self.target(request.then))

    def set_jump(self, node: Node, jump: SetJump) -> None:
        """Store the landing to return to; `longjmp` passes the value in the frame."""
        selector, writer = self.selector, self.writer
        landed, after = Node(), self.target(jump.then)
        landing = self.add_landing(landed, jump)
        zero = Constant("i32", 0)
        self.memory.store(Store(jump.location, jump.buffer, 0, zero, "i32"))
        node.code += [writer.value(jump.buffer), (LANDING, landing), ("i32.store", MEMORY, 0)]
        writer.push(zero)
        writer.pop(jump.result)
        selector.after(jump)
        node.jump(after)
        selector.forget()
        writer.code = landed.code
        writer.load_at(SP, self.frame.jump_value, "i32")
        writer.pop(jump.result)
        selector.after(jump)
        landed.jump(after)

    def long_jump(self, node: Node, jump: LongJump) -> None:
        """Start unwinding; `leave` and `resume` do the rest."""
        writer = self.writer
        site = self.names.number(Site("longjmp to a function that has returned", jump.location))
        operands = [jump.activation, jump.place, jump.value, Constant("i32", site)]
        node.code += jumps.start([writer.value(each) for each in operands])
        node.code.append((UNWIND,))
