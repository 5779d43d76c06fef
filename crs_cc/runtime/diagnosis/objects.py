"""Look up the object at an address of a stopped program: a variable, a string, a heap block.

Messages name the object that an invalid access belongs to: the one that it hits, or the nearest
one. `find_object` searches the frames of the active calls, the global objects, and
the heap.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final, Literal, TypeVar

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Slot, Variable
from crs_cc.ir.names import in_library
from crs_cc.ir.program import Data, Program
from crs_cc.runtime.compiled import Compiled
from crs_cc.runtime.diagnosis import heap
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.layout import HEADER_SIZE, STACK_TOP
from crs_cc.runtime.link import HEAP_SYMBOLS
from crs_cc.runtime.sites import CallSite, arguments_size

NEAR: Final = 4096
"""An object further away than this [bytes] is unrelated to an address."""

MARGIN: Final = 256
"""Distance up to which an access is attributed to an object; larger objects have a larger one."""

_NEIGHBOURS: Final = 3  # frames may overlap if a prototype is wrong


@dataclass(frozen=True, slots=True)
class Object:
    """An object in memory.

    Attributes:
        kind: "local" (parameters too), "argument" (variable arguments), "global" (static ones
            too), "string" (a literal), "temporary" (without a name) or "heap block".
        address: its first byte.
        size: in bytes; of a heap block, the size requested.
        name: its name in the source; empty if it has none.
        location: where it is declared, if known.
        variable: the C variable, if it is one.
        function: the function that a local belongs to.
        state: its lifetime: "alive", "ended" (its block or function was left) or "freed".
        allocated: the innermost calls that allocated a heap block, the innermost first.
        freed: the calls that freed it.
    """

    kind: Literal["local", "argument", "global", "string", "temporary", "heap block"]
    address: int
    size: int
    name: str = ""
    location: Location | None = None
    variable: Variable | None = None
    function: str = ""
    state: Literal["alive", "ended", "freed"] = "alive"
    allocated: tuple[CallSite, ...] = ()
    freed: tuple[CallSite, ...] = ()

    def distance(self, address: int) -> int:
        """Return the distance of an address: 0 inside, else bytes to the nearest end.

        It is negative before the object; the first byte after it is at distance 1.
        """
        if address < self.address:
            return address - self.address
        return max(0, address - (self.address + self.size) + 1)


class Objects:
    """The objects of a stopped program, for lookup by address; the program must stay stopped."""

    def __init__(self, stopped: StoppedProgram) -> None:
        self._stopped = stopped

    @cached_property
    def _locals(self) -> list[Object]:
        return sorted(_locals(self._stopped), key=_start)

    @cached_property
    def _globals(self) -> list[Object]:
        return sorted(_globals(self._stopped.program, self._stopped.compiled), key=_start)

    @cached_property
    def _blocks(self) -> list[heap.Block]:
        return list(heap.blocks(self._stopped.memory, self._stopped.compiled.addresses))

    def at(self, address: int) -> Object | None:
        """Return the object at an address, or else the nearest one; None if none is near."""
        compiled = self._stopped.compiled
        found: list[Object]
        if address < STACK_TOP:
            found = _around(self._locals, address)
        elif address < compiled.addresses[HEAP_SYMBOLS[0]]:
            found = _around(self._globals, address)
        else:
            found = [_heap_block(each, compiled) for each in _around(self._blocks, address)]
        nearest = min(found, key=lambda each: abs(each.distance(address)), default=None)
        if nearest is not None and nearest.distance(address) and _is_of_library(nearest):
            mine = [each for each in found if not _is_of_library(each)]
            close = [each for each in mine if abs(each.distance(address)) <= MARGIN]
            nearest = min(close, key=lambda each: abs(each.distance(address)), default=nearest)
        if nearest is None or abs(nearest.distance(address)) > NEAR:
            return None
        return nearest


def _is_of_library(found: Object) -> bool:
    return found.location is not None and in_library(found.location)


def find_object(stopped: StoppedProgram, address: int) -> Object | None:
    """Return the object at an address, or else the nearest one; None if none is near."""
    return Objects(stopped).at(address)


_Placed = TypeVar("_Placed", Object, heap.Block)


def _start(each: Object | heap.Block) -> int:
    return each.address


def _around(each: list[_Placed], address: int) -> list[_Placed]:
    """Return the objects around an address; there may be empty ones at the same address."""
    behind = bisect_right(each, address, key=_start)
    return each[max(0, behind - _NEIGHBOURS) : behind + 1]


def of_variable(stopped: StoppedProgram, variable: Variable) -> Object:
    """Return a variable of the innermost function as an object, at its spill slot."""
    address, function = 0, ""
    if stopped.stack:
        innermost = stopped.stack[0]
        frame, function = stopped.compiled.info(innermost.function).frame, innermost.function
        homes = [at for place, at in frame.offsets.items() if place.variable is variable]
        address = innermost.fp - frame.size + homes[0] if homes else 0
    size, name, location = variable.ctype.size, variable.name, variable.location
    return Object("local", address, size, name, location, variable, function)


def _locals(stopped: StoppedProgram) -> Iterator[Object]:
    """Return the slots in the frames of the active calls, and variable arguments."""
    for each in stopped.stack:
        info = stopped.compiled.info(each.function)
        start = each.fp - info.frame.size
        for place, offset in info.frame.offsets.items():
            if isinstance(place, Slot):
                made = _local(place, start + offset, each.function)
                ended = len(stopped.shadow) and place.size and not stopped.shadow[made.address]
                yield replace(made, state="ended") if ended else made
        if info.function.variadic and len(stopped.shadow):
            word = int(stopped.memory[each.fp : each.fp + 8].view("<u8")[0])
            passed = each.fp + HEADER_SIZE + arguments_size(word)
            first = start + info.frame.varargs
            yield Object("argument", first, max(0, passed - first), function=each.function)


def _local(slot: Slot, address: int, function: str) -> Object:
    variable = slot.variable
    if variable is None:
        return Object("temporary", address, slot.size, function=function)
    name, location = variable.name, variable.location
    return Object("local", address, slot.size, name, location, variable, function)


def _globals(program: Program, compiled: Compiled) -> Iterator[Object]:
    """Return the global objects, without those that only the library knows."""
    for data in program.data.values():
        if not _is_private(data):
            yield _global(data, compiled.addresses[data.name])


def _is_private(data: Data) -> bool:
    """Return whether an object of the library cannot be named by programs."""
    return in_library(data.location) and (":" in data.name or data.name.startswith("_"))


def _global(data: Data, address: int) -> Object:
    variable = data.variable
    if variable is None:
        kind: Literal["string", "temporary"] = "string" if ':"' in data.name else "temporary"
        return Object(kind, address, data.size, location=data.location)
    name, location = variable.name, variable.location
    return Object("global", address, data.size, name, location, variable)


def _heap_block(block: heap.Block, compiled: Compiled) -> Object:
    """Return a heap block; a freed one extends over its whole chunk."""
    return Object(
        "heap block",
        block.address,
        block.size,
        state="alive" if block.in_use else "freed",
        allocated=_calls(block.allocated, compiled),
        freed=_calls(block.freed, compiled),
    )


def _calls(numbers: Sequence[int], compiled: Compiled) -> tuple[CallSite, ...]:
    sites = compiled.call_sites
    return tuple(sites[number - 1] for number in numbers if 0 < number <= len(sites))
