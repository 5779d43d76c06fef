"""The code of small functions in place of calls.

Where a check in the inlined code fails, control goes to a side exit of the call. It restores the
fuel and makes the call after all; this fails in the same way, now with a frame on the stack, so
that reports are the same as without inlining. Where a struct that is passed has members without a
value, the call may succeed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from crs_cc.ir.instruction import (
    Block,
    Branch,
    Call,
    Constant,
    Jump,
    Load,
    Register,
    Return,
    Statement,
    Stop,
    Switch,
)
from crs_cc.runtime.codegen.body import Body
from crs_cc.runtime.codegen.checked_arithmetic import CheckedArithmetic
from crs_cc.runtime.codegen.checked_memory import CheckedMemory
from crs_cc.runtime.codegen.convention import NARROW
from crs_cc.runtime.codegen.flow_graph import Node
from crs_cc.runtime.codegen.indices import FUEL
from crs_cc.runtime.codegen.plain_memory import PlainMemory
from crs_cc.runtime.codegen.selection import Selector
from crs_cc.runtime.codegen.small_functions import Bodies
from crs_cc.runtime.codegen.switches import lower_switch
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.sites import Site

MAX_INLINED: Final = 300
"""The limit on the fuel of all functions inlined in one function."""


def inlined_calls(blocks: list[Block], bodies: Bodies) -> dict[Call, Body]:
    """Return the calls of a function to be inlined, as many as the limit allows."""
    found: dict[Call, Body] = {}
    size = 0
    for block in blocks:
        call = block.terminator
        body = bodies.of(call) if isinstance(call, Call) else None
        if body is not None and isinstance(call, Call):
            size += sum(body.fuel.values())
            if size > MAX_INLINED:
                break
            found[call] = body
    return found


class _Expansion:
    """A call in whose place code is written.

    Attributes:
        body: the function.
        then: the node where control continues after the call.
        side_exit: where control goes when a check fails; None if none can.
        nodes: the node of each block of the function.
    """

    def __init__(self, call: Call, body: Body, then: Node, side_exit: Node | None) -> None:
        self.call = call
        self.body = body
        self.then = then
        self.side_exit = side_exit
        self.nodes = {block: Node(side_exit=side_exit) for block in body.function.blocks}


def all_bodies(calls: dict[Call, Body]) -> dict[str, Body]:
    """Return all functions that are inlined in one."""
    return {body.function.name: body for body in calls.values()}


class InlinedCalls:
    """Writes the inlined calls of one function."""

    def __init__(
        self, writer: Writer, calls: dict[Call, Body], *, checked: bool, traps_overflow: bool
    ) -> None:
        self.writer = writer
        self.calls = calls
        self.checked = checked
        self.traps_overflow = traps_overflow
        self._fuel = Register(-1, "i64")
        self._selectors: dict[str, Selector] = {}
        self._memories: dict[str, PlainMemory] = {}
        for body in all_bodies(calls).values():
            self._add(body)

    def _add(self, body: Body) -> None:
        """Make the parts that generate the code of a function."""
        name, writer = body.function.name, self.writer
        memory, arithmetic = PlainMemory(writer, shadowed=False), None
        if self.checked:
            memory = CheckedMemory(writer, body.deferred, body.assigned, {})
            arithmetic = CheckedArithmetic(writer, traps_overflow=self.traps_overflow)
        self._memories[name] = memory
        self._selectors[name] = Selector(writer, memory, arithmetic, None)
        for register in body.registers.lasting:
            writer.take_local(register)

    def write(
        self,
        node: Node,
        call: Call,
        then: Node,
        memory: PlainMemory,
        make_call: Callable[[Call], None],
    ) -> None:
        """Write the code of a function in place of a call.

        Args:
            node: the node that ends with the call.
            call: the call.
            then: where control continues.
            memory: accesses the memory for the calling function.
            make_call: writes the code that makes the call after all.
        """
        writer, body = self.writer, self.calls[call]
        side = Node() if body.can_fail else None
        if side is not None:
            writer.code.append(("local.get", FUEL))
            writer.pop(self._fuel)
        writer.side_exit = node.side_exit = side
        before = memory.facts.copy() if isinstance(memory, CheckedMemory) else None
        self._pass_structs(call, body, memory)
        self._body(node, _Expansion(call, body, then, side), memory)
        writer.side_exit = None
        if side is not None:
            side.code += [writer.value(self._fuel), ("local.set", FUEL)]
            writer.code = side.code
            if isinstance(memory, CheckedMemory) and before is not None:
                before, memory.facts = memory.facts, before
            make_call(call)
            if isinstance(memory, CheckedMemory) and before is not None:
                memory.facts = before
            if self.checked and body.may_pass_uninitialised():
                side.jump(then)

    def _pass_structs(self, call: Call, body: Body, memory: PlainMemory) -> None:
        """Load the members of the structs that are passed."""
        for argument, parameter in zip(call.arguments, body.function.parameters, strict=False):
            if parameter.memory is None and isinstance(argument.value, Register):
                base, location = argument.value, call.location
                size = Constant("i32", argument.size)
                memory.check_passed(base, size, location)
                self.writer.charge(size)
                for each in body.members[parameter]:
                    load = Load(location, each.register, base, each.offset, each.memory)
                    memory.load(load)

    def _body(self, node: Node, expansion: _Expansion, memory: PlainMemory) -> None:
        """Write the code of an inlined function; `node` continues with it."""
        call, body = expansion.call, expansion.body
        self._pass_values(call, body)
        node.jump(expansion.nodes[body.function.blocks[0]])
        own, selector = self._memories[body.function.name], self._selectors[body.function.name]
        selector.forget()
        passed = [
            (argument.value, parameter.place)
            for argument, parameter in zip(call.arguments, body.function.parameters, strict=False)
            if isinstance(parameter.place, Register)
        ]
        if isinstance(memory, CheckedMemory) and isinstance(own, CheckedMemory):
            for argument, place in passed:
                memory.pass_facts(argument, place, own)
            places = [own.places.of(place, 0) for _, place in passed]
        for block in body.function.blocks:
            self._block(block, expansion)
            if len(body.function.blocks) > 1:
                selector.forget()
        if isinstance(memory, CheckedMemory) and isinstance(own, CheckedMemory):
            if body.has_effects:  # it may have stored values that are not there
                memory.proved.forget_values()
            for (argument, _), known in zip(passed, places, strict=True):
                memory.add_callee_facts(argument, known, own)

    def _pass_values(self, call: Call, body: Body) -> None:
        """Move arguments to the registers of parameters."""
        writer = self.writer
        for argument, parameter in zip(call.arguments, body.function.parameters, strict=False):
            place = parameter.place
            if isinstance(place, Register) and place in body.registers.lasting:
                writer.push(argument.value)
                if parameter.memory is not None and argument.memory != parameter.memory:
                    writer.code += NARROW[parameter.memory]
                writer.pop(place)

    def _block(self, block: Block, expansion: _Expansion) -> None:
        writer, body = self.writer, expansion.body
        selector, node = self._selectors[body.function.name], expansion.nodes[block]
        writer.code = node.code
        fuel = ("i64.const", body.fuel[block])
        writer.code += [("local.get", FUEL), fuel, ("i64.sub",), ("local.set", FUEL)]
        last = body.registers.last_uses(block)
        for number, it in enumerate(block.instructions):
            if not isinstance(it, Statement):
                selector.before(it)
                selector.select(it)
            for register in last[number]:
                writer.release(register)
        if block.terminator is not None:
            selector.before(block.terminator)
        self._end(block, expansion)
        for register in last[-1]:
            writer.release(register)

    def _end(self, block: Block, expansion: _Expansion) -> None:
        """Write the end of a block of an inlined function."""
        writer, nodes = self.writer, expansion.nodes
        node = nodes[block]
        match block.terminator:
            case Jump(target=target):
                node.jump(nodes[target])
            case Branch() as branch:
                writer.push(branch.condition)
                node.exit = "branch"
                node.targets = [nodes[branch.then], nodes[branch.otherwise]]
            case Switch() as switch:
                lower_switch(writer, node, switch, nodes)
            case Return(value=value):
                if expansion.call.result is not None and value is not None:
                    writer.push(value)
                    writer.pop(expansion.call.result)
                node.jump(expansion.then)
            case Stop(kind=kind, location=location):
                writer.fail(Site(kind, location), [("i32.const", 0)])
