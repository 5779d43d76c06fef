"""The start, suspension and end of a function's activations: all code outside its blocks."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from crs_cc.ir.instruction import ByteState, Call, Constant, LongJump, Operand, Register, SetJump
from crs_cc.ir.liveness import all_instructions, writes
from crs_cc.ir.program import Function, Parameter
from crs_cc.ir.value_type import MEMORY_SIZE, MemoryType
from crs_cc.requests import SUSPENDED
from crs_cc.runtime.codegen import failing, frame_states, jumps, shadow, spill_slots, stopping
from crs_cc.runtime.codegen.build import Build
from crs_cc.runtime.codegen.call_checks import NO_VALUE
from crs_cc.runtime.codegen.convention import NARROW
from crs_cc.runtime.codegen.dispatch import add_dispatchers
from crs_cc.runtime.codegen.flow_graph import Landing, Node
from crs_cc.runtime.codegen.indices import (
    ADDRESS,
    BEGUN_GLOBAL,
    FP,
    FUEL,
    LABEL,
    MEMORY,
    SITE,
    SP,
    STATUS_GLOBAL,
    passed,
)
from crs_cc.runtime.codegen.memory_instructions import STORES
from crs_cc.runtime.codegen.registers import Registers
from crs_cc.runtime.codegen.watchpoints import Watchpoints
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.layout import FUNCTION, NULL_SIZE, RESUME
from crs_cc.runtime.sites import Site
from crs_cc.runtime.wasm import UNLIKELY, Instr


class Activation:
    """Writes how a function starts, is suspended, resumes and returns."""

    def __init__(
        self,
        function: Function,
        build: Build,
        writer: Writer,
        registers: Registers,
        *,
        homes: Mapping[Register, Register],
        members: Iterable[Register],
        watching: Watchpoints | None,
    ) -> None:
        """Set what the code depends on.

        Args:
            function: the function.
            build: how it is compiled.
            writer: its writer.
            registers: its registers by lifetime.
            homes: the registers that live in the frame.
            members: the registers that are in the place of members of structs.
            watching: reports accesses to watchpoints; None in builds without watchpoints.
        """
        self.function = function
        self.build = build
        self.writer = writer
        self.frame = writer.frame
        self.registers = registers
        self.homes = list(homes.values())
        self.members = members
        self.watching = watching
        self.shadowed = build.checked and not function.trusted
        self.stamped = build.debug and not function.trusted
        self.convention = writer.names.conventions[function.name]
        self.passed = self._passed()
        self.kept = self._kept()
        self.number = writer.names.functions[function.name]

    def _passed(self) -> dict[Parameter, tuple[int, MemoryType]]:
        """Return the parameters in registers: the register, and the type in memory."""
        found: dict[Parameter, tuple[int, MemoryType]] = {}
        pairs = zip(self.function.parameters, self.convention.registers, strict=True)
        for parameter, memory in pairs:
            if memory is not None:
                found[parameter] = passed(len(found)), memory
        return found

    def _kept(self) -> dict[Parameter, Register]:
        """Return the parameters in registers that the function never changes."""
        if self.build.debug or not self.passed:
            return {}
        changed = {writes(it) for block in self.function.blocks for it in all_instructions(block)}
        lasting = set(self.registers.saved) - changed
        places = ((each, each.place) for each in self.passed)
        return {
            each: place
            for each, place in places
            if isinstance(place, Register) and place in lasting
        }

    # -- start ------------------------------------------------------------------------------------

    def connect(self, first: Node, landings: list[Landing], *, resumes: int = 0) -> Node:
        """Return the entry, which leads to the first block, or to one of the landings.

        Args:
            first: the node of the first block.
            landings: the points of resumption.
            resumes: the index of the function that resumes this one; 0 if it does itself.
        """
        entry, start = self._entry(), self._start(first, landings)
        is_small = self.writer.names.bodies.is_small(self.function.name)
        if is_small and not self.build.debug:  # it is never suspended
            entry.jump(start)
            for number, landing in enumerate(landings, start=1):  # where a call fails
                landing.number = number
            return entry
        rare = Node()
        entry.code += stopping.IS_NEGATIVE
        entry.exit, entry.targets, entry.unlikely = "branch", [rare, start], True
        if resumes:
            rare.code += [*self._passed_on(), ("call", resumes), ("return",)]
            return entry
        self._suspend_or_resume(rare, start, landings)
        return entry

    def _passed_on(self) -> list[Instr]:
        """Push all that was passed."""
        numbers = [FP, FUEL, *(number for number, _ in self.passed.values())]
        return [("local.get", number) for number in numbers]

    def _suspend_or_resume(self, rare: Node, start: Node, landings: list[Landing]) -> None:
        """Continue where the fuel is less than zero."""
        is_small = self.writer.names.bodies.is_small(self.function.name)
        resumption = rare
        if is_small:
            resumption = Node()
            rare.code += stopping.IS_STOPPED
            rare.exit, rare.targets = "branch", [resumption, start]
        else:
            rare.code += [*stopping.IS_STOPPED, ("i32.eqz",), ("if",)]
            rare.code += [*self._save_start(), ("end",)]
        self._resume(resumption, start, landings)

    def resumption(self, landings: list[Landing]) -> Node:
        """Return the entry of a function that resumes this one, and starts it again."""
        node, again, size = Node(), Node(), self.frame.size
        node.code += [("local.get", FP), ("i32.const", size), ("i32.sub",), ("local.set", SP)]
        again.code += [*self._passed_on(), ("call", self.number), ("return",)]
        self._suspend_or_resume(node, again, landings)
        return node

    def _entry(self) -> Node:
        """Set up the frame."""
        node, size = Node(), self.frame.size
        node.code += [("local.get", FP), ("i32.const", NULL_SIZE + size), ("i32.lt_u",), UNLIKELY]
        node.code += [*self.overflow(), ("end",)]
        node.code += [("local.get", FP), ("i32.const", size), ("i32.sub",), ("local.set", SP)]
        node.code += self.watching.test_frame() if self.watching else []
        return node

    def overflow(self) -> list[Instr]:
        """Fail without saving registers, which would write to the frame."""
        number = self.writer.names.number(Site("stack overflow", self.function.location))
        note = failing.note(("i32.const", number), ("local.get", FP))
        return [*note, ("global.set", STATUS_GLOBAL), *self._save_header(), *self._stop()]

    def _save_start(self) -> list[Instr]:
        """Suspend before the start."""
        return [*stopping.status(SUSPENDED), *self._save_header(), *self._stop()]

    def _save_header(self) -> list[Instr]:
        """Store the function's number, no landing, and the arguments passed in registers."""
        code: list[Instr] = [("local.get", FP), ("i64.const", self.number)]
        code.append(("i64.store", MEMORY, FUNCTION))
        if self.build.debug:
            return code
        for parameter, (number, _) in self.passed.items():
            code += self._keep(parameter, ("local.get", number))
        return code

    def _stop(self) -> list[Instr]:
        return [*stopping.PUSH_STOPPED, *self.no_value(), ("return",)]

    def no_value(self) -> list[Instr]:
        """Push an unused value, if the function returns one."""
        kind = self.function.result
        return [] if kind is None else [(f"{kind}.const", 0)]

    def _keep(self, parameter: Parameter, value: Instr) -> list[Instr]:
        """Store a parameter where it is passed in memory."""
        offset = self.frame.parameters[self.function.parameters.index(parameter)]
        memory = self.passed[parameter][1]
        at = offset - self.frame.size
        return [("local.get", FP), value, (STORES[memory], MEMORY, at)]

    def _resume(self, node: Node, start: Node, landings: list[Landing]) -> None:
        """Resume: go to the landing, with registers reloaded, or start."""
        first, writer = Node(), self.writer
        node.code += stopping.RESTORE
        writer.code = first.code
        for parameter, (number, memory) in self.passed.items():
            offset = self.frame.parameters[self.function.parameters.index(parameter)]
            writer.load_at(FP, offset - self.frame.size, memory)
            writer.code.append(("local.set", number))
        if not self.writer.names.bodies.is_small(self.function.name):
            writer.code += [*stopping.IS_NEGATIVE, UNLIKELY, *stopping.status(SUSPENDED)]
            writer.code += [*self._stop(), ("end",)]
        first.jump(start)
        if not landings:
            node.jump(first)
            return
        again, damaged = Node(), Node()
        writer.code = node.code
        writer.load_at(FP, RESUME, "i32")
        node.code.append(("local.tee", LABEL))
        node.exit, node.targets = "branch", [again, first]
        writer.code = damaged.code
        writer.fail(Site("corrupted stack", self.function.location), [("local.get", LABEL)])
        writer.code = again.code
        spill_slots.load(writer, self.frame, self.registers.saved, debug=self.build.debug)
        add_dispatchers(again, start, landings, LABEL, damaged)

    def _start(self, first: Node, landings: list[Landing]) -> Node:
        """Start a fresh call: load the parameters."""
        node, frame = Node(), self.frame
        code = self.writer.code = node.code
        if self.stamped:
            code += [("local.get", SP), ("global.get", BEGUN_GLOBAL)]
            code.append(("i64.store", MEMORY, frame.entered))
        code += spill_slots.clear(frame, self.homes)
        for parameter, offset in zip(self.function.parameters, frame.parameters, strict=True):
            self._load_parameter(parameter, offset)
        for parameter, (number, _) in self.passed.items():
            if parameter not in self.kept and not self.build.debug:
                code += self._keep(parameter, ("local.get", number))
        if self.build.debug and landings:
            code += spill_slots.clear(frame, self.registers.saved)
        if self.shadowed:
            code += frame_states.enter(self.function, frame, self.writer.names)
        code += self.watching.entering() if self.watching else []
        node.jump(first)
        return node

    def _load_parameter(self, parameter: Parameter, offset: int) -> None:
        place = parameter.place
        if not isinstance(place, Register) or place not in self.registers.lasting:
            return
        if parameter in self.passed:
            number, memory = self.passed[parameter]
            self.writer.code += [("local.get", number), *NARROW.get(memory, ())]
            self.writer.pop(place)
        elif parameter.memory:
            self.writer.load_at(SP, offset, parameter.memory)
            self.writer.pop(place)

    # -- end --------------------------------------------------------------------------------------

    def failed(self) -> list[Instr]:
        """Return the code on a failed check, before the epilogue."""
        note = failing.note(("local.get", SITE), ("local.get", ADDRESS))
        code = [*note, ("global.set", STATUS_GLOBAL), ("i32.const", 0), ("local.set", LABEL)]
        if self.shadowed:  # what the epilogue writes to the homes of members is shown
            for member in self.members:
                offset, size = self.frame.offsets[member], MEMORY_SIZE[member.type]
                code += shadow.fill(("local.get", SP), offset, size, ByteState.WITH_VALUE)
        return code

    def epilogue(self) -> list[Instr]:
        """Save the registers of a suspended function, and push its fuel, as one that stops."""
        code: list[Instr] = []
        writer = self.writer
        writer.code = code
        ends = [block.terminator for block in self.function.blocks]
        if any(isinstance(end, Call | LongJump) for end in ends):
            activations = [end.activation for end in ends if isinstance(end, SetJump)]
            activation = [writer.value(each) for each in activations[:1]]
            code += jumps.leave(activation, self.frame.jump_value, self._leaving())
        spill_slots.save(writer, self.frame, self.registers.saved, self.number)
        for parameter, register in self.kept.items():
            code += self._keep(parameter, writer.value(register))
        return [*code, *stopping.PUSH_STOPPED]

    def leave(self, node: Node, value: Operand | None) -> None:
        """Return from the function."""
        node.code += self._leaving()
        if value is None and self.function.name in self.writer.names.without_value:
            self.writer.store_at(FP, FUNCTION, Constant("i32", NO_VALUE), "i32")
        result = [self.writer.value(value)] if value is not None else self.no_value()
        node.code += [("local.get", FUEL), *result, ("return",)]

    def _leaving(self) -> list[Instr]:
        """Return the code at the frame's end: report it, and make it inaccessible."""
        code = [] if self.watching is None else self.watching.returning()
        return [*code, *(frame_states.leave(self.function, self.frame) if self.shadowed else [])]
