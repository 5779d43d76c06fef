"""Classify an invalid memory access from the state in which the program stopped.

The failing check stored only the address. The offending byte is found in the
shadow memory; the object that it belongs to, or is near, in frames, globals and heap.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.ir.instruction import ByteState
from crs_cc.ir.names import in_library
from crs_cc.runtime.diagnosis.dead_frames import returned_local
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.diagnosis.objects import MARGIN, Object, find_object
from crs_cc.runtime.layout import MEMORY_BYTES, NULL_SIZE, STACK_TOP
from crs_cc.runtime.sites import Access

_WITH_SOME_VALUE: Final = 0x80


def diagnose(
    stopped: StoppedProgram, address: int, size: int, access: Access
) -> tuple[str, int, Object | None]:
    """Return the kind of error, the first offending byte, and the object there or nearest to it.

    Args:
        stopped: the program.
        address: the first byte of the access.
        size: number of bytes accessed; 0 if `address` is known to be the offending one.
        access: read or write.
    """
    if address < NULL_SIZE:
        return "null pointer", address, None
    states = stopped.shadow[address : address + max(1, size)]
    bad = np.flatnonzero(states == ByteState.INACCESSIBLE)
    if len(bad):
        first = address + int(bad[0])
        found = find_object(stopped, first)
        kind = _kind(stopped, first, found)
        if kind == "use after return":
            found = returned_local(stopped, first)
        return kind, first, found
    constant = np.flatnonzero(states == ByteState.CONSTANT)
    is_unset = (states != ByteState.INACCESSIBLE) & (states < _WITH_SOME_VALUE)
    if len(constant) and (access == "write" or not is_unset.any()):
        first = address + int(constant[0])  # a read of what is written later is checked for it
        return "write to read-only memory", first, find_object(stopped, first)
    if len(states) < max(1, size):
        return "pointer outside memory", max(address, MEMORY_BYTES), None
    without = np.flatnonzero(is_unset)
    first = address + (int(without[0]) if len(without) else 0)
    kind = "uninitialised read" if access == "read" else "out of bounds"
    return kind, first, find_object(stopped, first)


def _kind(stopped: StoppedProgram, address: int, found: Object | None) -> str:
    """Return the kind of error of an access to an inaccessible byte."""
    if found is not None and found.distance(address) == 0 and found.state != "alive":
        return "use after scope" if found.state == "ended" else "use after free"
    if address < stopped.stack_pointer():
        return "use after return" if address >= _deepest(stopped) else "wild pointer"
    if address < STACK_TOP and (found is None or _is_in_library(found)):
        return "use after return"  # and other functions were called since
    if found is None:
        return "wild pointer"
    if found.kind == "argument":
        return "missing argument"
    near = abs(found.distance(address)) <= max(MARGIN, found.size)
    return "out of bounds" if near else "wild pointer"


def _is_in_library(found: Object) -> bool:
    return found.location is not None and in_library(found.location)


def _deepest(stopped: StoppedProgram) -> int:
    """Return the lowest address that the stack has reached."""
    return NULL_SIZE + int(np.argmax(stopped.memory[NULL_SIZE:STACK_TOP] != 0))
