"""The objects that pointers are computed from, found within a function.

A pointer that was computed from the name of an object, or from the result of `malloc`, must point
into that object where it is used (C17 6.5.6p8). The analysis follows registers through the graph of
blocks; where paths meet, a register has a base if all agree. `find_bases` notes the base in each
access through such a pointer, and removes checks of two pointers that have the same one.

An access that is only a few bytes from the last one through the same register needs no base:
between objects there are inaccessible bytes, where other checks find it. So a pointer that walks
through an array costs nothing.

An address that is corrected by the distance between two objects, as programs do after `realloc`,
has no known base any more.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Final, TypeAlias

from crs_cc.ir.instruction import (
    VARARGS,
    Address,
    Base,
    Binary,
    Block,
    Call,
    Constant,
    Instruction,
    Load,
    Move,
    Operand,
    Register,
    SameObject,
    SetJump,
    Slot,
    Store,
)
from crs_cc.ir.liveness import Liveness, writes
from crs_cc.ir.loops import postorder
from crs_cc.ir.program import Function
from crs_cc.ir.types import PointerType
from crs_cc.ir.value_type import MEMORY_SIZE

ALLOCATORS: Final = frozenset({"malloc", "calloc", "realloc"})
NEAR: Final = 16
"""No two objects are closer to each other [bytes], see `runtime.layout.red_zone`."""

_MAX_DISTANCE: Final = 64
"""The maximum distance that is followed, so that loops terminate [bytes]."""

MAX_BLOCKS: Final = 2000
"""Larger functions are not analysed."""

_Object: TypeAlias = "Slot | str | Instruction | Register"


@dataclass(frozen=True, slots=True)
class _Pointer:
    """An address in an object, or right after it.

    Attributes:
        object: the object, the call that allocated it, or, if it is unknown, where the pointer was
            assigned: an instruction or a parameter.
        offset: its offset; None if it is unknown.
        drift: the least and the greatest distance from a byte that is known to be inside.
    """

    object: _Object
    offset: int | None
    drift: tuple[int, int] | None


class _Distance:
    """The distance between two pointers, or what was computed from one."""


class _Index:
    """A product, which is no pointer."""


_DISTANCE: Final = _Distance()
_INDEX: Final = _Index()
_Known: TypeAlias = "dict[Register, _Pointer | _Distance | _Index]"
_SCALING: Final = frozenset({"i32.mul", "i32.shl"})
_DIVIDING: Final = frozenset({"i32.div_s", "i32.shr_s", "i32.div_u", "i32.shr_u"})


def find_bases(function: Function, sizes: Mapping[str, int]) -> None:
    """Note the base of each access in a function through a pointer that has a known one.

    Args:
        function: the function.
        sizes: the sizes of global objects, as far as they are known.
    """
    if len(function.blocks) <= MAX_BLOCKS and _has_bases(function):
        _Analysis(function, sizes).run()


def _has_bases(function: Function) -> bool:
    return any(
        isinstance(it, SameObject)
        or (isinstance(it, Address) and not isinstance(it.base, Register))
        for block in function.blocks
        for it in block.instructions
    ) or any(_allocates(block.terminator) for block in function.blocks)


def _allocates(it: object) -> bool:
    return isinstance(it, Call) and it.callee in ALLOCATORS


class _Analysis:
    def __init__(self, function: Function, sizes: Mapping[str, int]) -> None:
        self._function = function
        self._sizes = sizes
        self._passed = {each.place for each in function.parameters}
        self._liveness = Liveness(function)
        pointers = [each.place for each in function.parameters if _is_pointer(each.place)]
        start: _Known = {each: _Pointer(each, 0, None) for each in pointers}  # type: ignore[misc]
        self._at_start: dict[Block, _Known] = {function.blocks[0]: start}
        self._compared: set[tuple[Operand, Operand]] = set()

    def run(self) -> None:
        """Solve for the registers at the start of each block, then note bases."""
        order = postorder(self._function.blocks[0])[::-1]
        changed = True
        while changed:
            changed = False
            for block in order:
                known = self._transfer_block(block)
                for target in block.successors():
                    changed |= self._meet(target, known)
        for block in order:
            self._note(block)

    def _meet(self, block: Block, known: _Known) -> bool:
        """Merge the facts of a path into a block; return whether it has fewer facts than before."""
        live = self._liveness.at_start(block)
        known = {each: what for each, what in known.items() if live >> each.index & 1}
        before = self._at_start.get(block)
        if before is None:
            self._at_start[block] = known
            return True
        met: _Known = {}
        for register in {**before, **known}:
            what = _common(before.get(register), known.get(register))
            if what is not None:
                met[register] = what
        self._at_start[block] = met
        return met != before

    def _transfer_block(self, block: Block) -> _Known:
        """Return the facts at the end of a block."""
        known = self._at_start[block].copy()
        self._compared = set()
        for it in block.instructions:
            self._transfer(it, known)
        end = block.terminator
        if isinstance(end, SetJump):  # registers may have changed when it is returned to
            return {}
        if end is not None:
            self._transfer(end, known)
        return known

    def _note(self, block: Block) -> None:
        known = self._at_start[block].copy()
        self._compared = set()
        kept: list[Instruction] = []
        for it in block.instructions:
            if isinstance(it, Load | Store) and isinstance(it.base, Register):
                it.within = self._base(it, known.get(it.base), known)
            if not (isinstance(it, SameObject) and self._is_same(it, known)):
                kept.append(it)
            self._transfer(it, known)
        block.instructions = kept

    def _base(self, it: Load | Store, pointer: object, known: _Known) -> Base | None:
        """Return the base of an access, or nothing if it needs no check."""
        if not isinstance(pointer, _Pointer) or _is_near(pointer, it.offset):
            return None
        start, size = pointer.offset, self._size(pointer.object)
        if start is not None and 0 <= start + it.offset <= size - MEMORY_SIZE[it.memory]:
            return None
        if isinstance(pointer.object, Slot | str):
            return pointer.object
        if not _allocates(pointer.object):
            return None
        return next(
            (
                each
                for each, what in known.items()
                if isinstance(what, _Pointer) and what.object is pointer.object and what.offset == 0
            ),
            None,
        )

    def _size(self, what: _Object) -> int:
        if isinstance(what, Slot):
            return what.size
        if isinstance(what, str):
            return self._sizes.get(what, 0)
        if not isinstance(what, Call):
            return 0
        match [what.callee, *(each.value for each in what.arguments)]:
            case ["malloc", Constant(value=size)]:
                return int(size)
        return 0

    def _is_same(self, it: SameObject, known: _Known) -> bool:
        left, right = (self._what(each, known) for each in (it.left, it.right))
        if isinstance(left, _Pointer) and isinstance(right, _Pointer):
            return left.object is right.object
        return False

    def _what(self, operand: Operand, known: _Known) -> _Pointer | _Distance | _Index | None:
        return known.get(operand) if isinstance(operand, Register) else _INDEX

    def _transfer(self, it: Instruction, known: _Known) -> None:
        """Update the facts after an instruction."""
        if isinstance(it, SameObject):
            self._compared.add((it.left, it.right))
        if isinstance(it, Load | Store) and isinstance(it.base, Register):
            pointer = known.get(it.base)
            if isinstance(pointer, _Pointer):  # the access succeeds, or the program stops
                known[it.base] = replace(pointer, drift=(-it.offset, -it.offset))
        target = writes(it)
        if target is None or target.type != "i32":
            return
        for each in [each for each, what in known.items() if _is_in(what, it)]:
            del known[each]  # it points to where this has assigned before
        what = self._result(it, known)
        if what is None and _is_pointer(target):
            what = _Pointer(it, 0, None)
        known.pop(target, None)
        self._compared = {pair for pair in self._compared if target not in pair}
        if what is not None:
            known[target] = what

    def _result(self, it: Instruction, known: _Known) -> _Pointer | _Distance | _Index | None:
        match it:
            case Move(source=source):
                return self._what(source, known)
            case Address(base=Register() as base, offset=offset):
                return _moved(known.get(base), offset)
            case Address(base=Slot() as base, offset=offset):
                is_own = base is not VARARGS and base not in self._passed
                return self._start(base, offset) if is_own else None
            case Address(base=str() as base, offset=offset):
                return self._start(base, offset)
            case Binary():
                return self._computed(it, known)
            case Call():
                return _Pointer(it, 0, (0, 0)) if _allocates(it) else None
            case Load(memory=memory) if MEMORY_SIZE[memory] < 4:
                return _INDEX
        return None

    def _computed(self, it: Binary, known: _Known) -> _Pointer | _Distance | _Index | None:
        if it.op == "i32.add":
            return self._sum(it, known)
        if it.op == "i32.sub":
            return self._difference(it, known)
        if it.op not in _SCALING | _DIVIDING:
            return None
        left = self._what(it.left, known)
        if isinstance(left, _Distance):
            return left
        return _INDEX if it.op in _SCALING else None

    def _start(self, base: Slot | str, offset: int) -> _Pointer:
        inside = max(0, min(offset, self._size(base) - 1))
        return _Pointer(base, offset, (offset - inside, offset - inside))

    def _sum(self, it: Binary, known: _Known) -> _Pointer | _Distance | None:
        left, right = self._what(it.left, known), self._what(it.right, known)
        if isinstance(left, _Distance) or isinstance(right, _Distance):
            plain = not isinstance(left, _Pointer) and not isinstance(right, _Pointer)
            return _DISTANCE if plain else None
        if isinstance(left, _Pointer) == isinstance(right, _Pointer):
            return None
        pointer, other = (left, it.right) if isinstance(left, _Pointer) else (right, it.left)
        return _moved(pointer, int(other.value) if isinstance(other, Constant) else None)

    def _difference(self, it: Binary, known: _Known) -> _Pointer | _Distance | _Index | None:
        left, right = self._what(it.left, known), self._what(it.right, known)
        if isinstance(left, _Pointer) and isinstance(right, _Pointer):
            return _INDEX if left.object is right.object else _DISTANCE
        if isinstance(right, _Pointer | _Distance):
            return _DISTANCE
        if (it.left, it.right) in self._compared or isinstance(left, _Distance):
            return _DISTANCE
        if isinstance(it.right, Constant):
            return _moved(left, -int(it.right.value))
        if isinstance(right, _Index):
            return _moved(left, None)
        return _DISTANCE if isinstance(left, _Pointer) else None


def _moved(what: _Pointer | _Distance | _Index | None, distance: int | None) -> _Pointer | None:
    if not isinstance(what, _Pointer):
        return None
    if distance is None:
        return _Pointer(what.object, None, None)
    offset = None if what.offset is None else what.offset + distance
    drift = None if what.drift is None else (what.drift[0] + distance, what.drift[1] + distance)
    if drift is not None and max(map(abs, drift)) > _MAX_DISTANCE:
        drift = None
    return _Pointer(what.object, offset, drift)


def _is_in(what: object, assigned: Instruction) -> bool:
    return isinstance(what, _Pointer) and what.object is assigned


def _is_pointer(place: Register | Slot) -> bool:
    """Return whether a place is a register with a variable that is a pointer."""
    if not isinstance(place, Register) or place.variable is None:
        return False
    return isinstance(place.variable.ctype, PointerType)


def _common(
    left: _Pointer | _Distance | _Index | None, right: _Pointer | _Distance | _Index | None
) -> _Pointer | _Distance | _Index | None:
    """Return the common facts about a register on two paths."""
    if left == right:
        return left
    if isinstance(left, _Distance) or isinstance(right, _Distance):
        return _DISTANCE
    if isinstance(left, _Pointer) and isinstance(right, _Pointer) and left.object is right.object:
        offset = left.offset if left.offset == right.offset else None
        drift = None
        if left.drift is not None and right.drift is not None:
            drift = min(left.drift[0], right.drift[0]), max(left.drift[1], right.drift[1])
        return _Pointer(left.object, offset, drift)
    return None


def _is_near(pointer: _Pointer, offset: int) -> bool:
    """Return whether an access next to a pointer is in its object or where it is found."""
    drift = pointer.drift
    return drift is not None and drift[0] + offset >= -NEAR and drift[1] + offset <= NEAR
