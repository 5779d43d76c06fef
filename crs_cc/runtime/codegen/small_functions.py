"""Small functions: bounded work, no test of the fuel, and code in place of calls.

A function without loops whose work, that of the small functions that it calls included, is bounded
does not test the fuel at its start, in any build. So builds suspend at the same places whether or
not they inline it.

An inlined call must leave no trace when it fails: the call is then made after all (see
`inlined_calls`), and fails again with its frame on the stack. So only functions are inlined in
which nothing can fail after a change of memory.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from crs_cc.ir.definite_assignment import Assignments
from crs_cc.ir.instruction import (
    Address,
    Binary,
    Block,
    Bounds,
    Branch,
    Call,
    Constant,
    Instruction,
    Jump,
    Load,
    Move,
    Passed,
    Register,
    Return,
    SameObject,
    Slot,
    Statement,
    Stop,
    Store,
    Switch,
    Unary,
)
from crs_cc.ir.liveness import Liveness, all_instructions
from crs_cc.ir.loops import loop_headers
from crs_cc.ir.program import Function
from crs_cc.ir.remembered import remembered
from crs_cc.ir.value_type import MEMORY_SIZE
from crs_cc.runtime.codegen.body import Body
from crs_cc.runtime.codegen.deferred_checks import DeferredChecks
from crs_cc.runtime.codegen.expansion import Expanded, expand
from crs_cc.runtime.codegen.registers import Registers
from crs_cc.runtime.codegen.scalar_replacement import ReadCheck, WriteCheck, replace_slots
from crs_cc.runtime.codegen.signatures import ends_without_value
from crs_cc.runtime.codegen.value_numbering import KnownBytes, ValueNumbers

MAX_WORK: Final = 60
"""The fuel of the largest small function, with that of the functions that it calls."""

_ENDS: Final = (Jump, Branch, Switch, Return, Stop, Call)
_INLINED: Final = (
    Statement, Move, Unary, Binary, Load, Store, Address, Bounds, SameObject,
    Passed, WriteCheck, ReadCheck,
)  # fmt: skip
_SHIFTS: Final = frozenset({"shl", "shr_s", "shr_u"})
_DIVISIONS: Final = frozenset({"div_s", "div_u", "rem_s", "rem_u"})


def small_functions(functions: Mapping[str, Function]) -> dict[str, Function]:
    """Return the small functions of a program; none of them is recursive."""
    work: dict[str, int] = {}
    pending: dict[str, list[str]] = {}
    callers: dict[str, list[str]] = {}
    for name, function in functions.items():
        own = _own_work(function)
        if own <= MAX_WORK:
            callees = [end.callee for end in calls_of(function)]
            work[name], pending[name] = own, [each for each in callees if isinstance(each, str)]
            for callee in pending[name]:
                callers.setdefault(callee, []).append(name)
    small: dict[str, Function] = {}
    ready = [name for name, callees in pending.items() if not callees]
    for name in ready:  # callees first: those of a cycle are never ready
        if work[name] > MAX_WORK:
            continue
        small[name] = functions[name]
        for caller in callers.get(name, ()):
            work[caller] += work[name]
            pending[caller].remove(name)
            if not pending[caller]:
                ready.append(caller)
    return small


@remembered
def _own_work(function: Function) -> int:
    """Return the fuel of all blocks of a function; more than the limit if it cannot be small."""
    ends = [block.terminator for block in function.blocks]
    is_plain = len(ends) <= MAX_WORK and all(
        isinstance(end, _ENDS) and not (isinstance(end, Call) and isinstance(end.callee, Register))
        for end in ends
    )
    if not is_plain or function.trusted or function.variadic or loop_headers(function):
        return MAX_WORK + 1
    return sum(block.fuel for block in function.blocks)


@remembered
def calls_of(function: Function) -> list[Call]:
    """Return the calls of a function."""
    return [end for block in function.blocks if isinstance(end := block.terminator, Call)]


class Bodies:
    """The bodies of a program's functions, analysed when they are first asked for."""

    def __init__(
        self, small: Mapping[str, Function], *, checked: bool, traps_overflow: bool
    ) -> None:
        self.small = small
        self.checked = checked
        self.traps_overflow = traps_overflow
        self._known: dict[str, Body | None] = {}

    def is_small(self, name: str) -> bool:
        """Return whether a function is small."""
        return name in self.small

    def of(self, call: Call) -> Body | None:
        """Return the body to be inlined for a call; None if it cannot be."""
        name = call.callee
        if not isinstance(name, str) or name not in self.small:
            return None
        if name not in self._known:
            self._known[name] = self._analyse(self.small[name])
        body = self._known[name]
        return body if body is not None and _fits(call, body.function) else None

    def _analyse(self, original: Function) -> Body | None:
        if original.result is not None and ends_without_value(original):
            return None
        expanded = expand(original, {call: self.of(call) for call in calls_of(original)})
        if expanded is None:
            return None
        replaced = replace_slots(expanded.function, expanded.fuel)
        if replaced is None:
            return None
        function = replaced.function
        if not all(isinstance(it, _INLINED) for block in function.blocks
                   for it in block.instructions):  # fmt: skip
            return None
        assigned, liveness = Assignments(function), Liveness(function)
        if assigned.flags:
            return None
        deferred = DeferredChecks(function, liveness, keep=False)
        if self.checked and not _same_checks(original, expanded, deferred):
            return None
        registers = Registers(function, liveness, [], inlined=(), debug=False)
        body = Body(function, replaced.fuel, replaced.members, registers, assigned, deferred)
        body.can_fail = self.checked and any(body.members.values())
        return body if self._leaves_no_trace(body) else None

    def _leaves_no_trace(self, body: Body) -> bool:
        """Return whether nothing in a function can fail after a change; note what it does."""
        blocks = _in_order(body.function)
        changed = dict.fromkeys(blocks, False)
        for block in blocks:
            places, written = ValueNumbers(), KnownBytes()
            after_load = {
                store
                for load, store in body.deferred.changing.items()
                if body.deferred.flag_of(load) is None
            }
            has_changed = changed[block]
            for it in all_instructions(block):
                fails, changes = self._fails(it, places, written), isinstance(it, Store)
                fails &= it not in after_load
                if fails and has_changed:
                    return False
                body.can_fail |= fails
                body.can_fail_inside |= fails and not isinstance(it, ReadCheck | WriteCheck)
                has_changed |= changes
                places.update(it)
            body.has_effects |= has_changed
            for target in block.successors():
                changed[target] |= has_changed
        return True

    def _fails(self, it: Instruction, places: ValueNumbers, written: KnownBytes) -> bool:
        """Return whether an instruction can fail, given what was written before in its block."""
        match it:
            case WriteCheck(target=target, size=size) | ReadCheck(target=target, size=size):
                written.add(places.of(target, 0), size, valued=False)
                return self.checked
            case Load(base=Register()):
                return self.checked
            case Store(base=Register() as base):
                where, size = places.of(base, it.offset), MEMORY_SIZE[it.memory]
                known = written.has(where, size, valued=False)
                written.add(where, size, valued=False)
                return self.checked and not known
            case Bounds() | SameObject() | Passed():
                return self.checked
            case Binary():
                return self._operation_fails(it)
        return isinstance(it, Stop)

    def _operation_fails(self, it: Binary) -> bool:
        op = it.op.partition(".")[2]
        if op in _DIVISIONS and it.op[0] == "i":
            return not (isinstance(it.right, Constant) and it.right.value not in (0, -1))
        if not (it.checked and self.checked):
            return False
        bits = int(it.op[1:3])
        fits = isinstance(it.right, Constant) and 0 <= it.right.value < bits
        return not fits if op in _SHIFTS else self.traps_overflow


def _same_checks(original: Function, expanded: Expanded, deferred: DeferredChecks) -> bool:
    """Return whether the loads whose checks are deferred are those of the original functions."""
    kept = expanded.deferred.items()
    if any(deferred.is_deferred(load) is not before for load, before in kept):
        return False
    before = DeferredChecks(original, Liveness(original), keep=False)
    loads = [it for block in original.blocks for it in block.instructions if isinstance(it, Load)]
    return all(
        isinstance(it.base, Slot) or before.is_deferred(it) == deferred.is_deferred(it)
        for it in loads
    )


def _in_order(function: Function) -> list[Block]:
    """Return the blocks of a function without loops, each after those that lead to it."""
    seen: set[Block] = set()
    order: list[Block] = []
    work = [(function.blocks[0], iter(function.blocks[0].successors()))]
    seen.add(function.blocks[0])
    while work:
        block, rest = work[-1]
        target = next((each for each in rest if each not in seen), None)
        if target is None:
            order.append(block)
            work.pop()
        else:
            seen.add(target)
            work.append((target, iter(target.successors())))
    return order[::-1]


def _fits(call: Call, callee: Function) -> bool:
    """Return whether arguments and result of a call are what the function takes and returns."""
    if call.result is not None and call.result.type != callee.result:
        return False
    if len(call.arguments) < len(callee.parameters):
        return False
    for argument, parameter in zip(call.arguments, callee.parameters, strict=False):
        if parameter.memory is None:
            if argument.memory is not None or argument.size != parameter.size:
                return False
            continue
        is_narrow = argument.memory == "i32" and MEMORY_SIZE[parameter.memory] < 4
        if argument.memory != parameter.memory and not is_narrow:
            return False
    return True
