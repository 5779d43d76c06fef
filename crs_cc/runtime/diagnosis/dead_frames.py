"""Find the local variable that was at an address below the stack pointer.

Memory does not record which functions have returned. But a function's frame is right below that
of its caller, so the variables of each function that an active one may have called can have been in
one place only. If just one of the user's variables can have been at the address, it was that one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from crs_cc.ir.instruction import Call, Register, Slot, Variable
from crs_cc.ir.names import in_library
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.layout import NULL_SIZE

FARTHEST_CALL: Final = 3
"""Maximum number of calls from an active function; further away the guess is unlikely."""

NEAREST_CALLERS: Final = 4
"""Maximum number of active functions that may have called the one that has returned."""

MOST: Final = 5000
"""Maximum number of possible calls to consider."""


def returned_local(stopped: StoppedProgram, address: int) -> Object | None:
    """Return the variable that was at an address; None if none or several are possible."""
    found: dict[Variable | None, Object] = {}
    for number, (callee, fp) in enumerate(_calls(stopped, address)):
        if number > MOST:
            return None
        frame = stopped.compiled.info(callee).frame
        for slot, offset in frame.offsets.items():
            made = _local(slot, fp - frame.size + offset, callee)
            if made is not None and made.distance(address) == 0:
                found[made.variable] = made
    return next(iter(found.values())) if len(found) == 1 else None


def _calls(stopped: StoppedProgram, address: int) -> Iterator[tuple[str, int]]:
    """Yield functions that may have had an address in their frames, and their frame pointers."""
    frames = [(each.function, each.fp, FARTHEST_CALL) for each in stopped.stack]
    above = [each for each in frames if each[1] > address]
    for caller, fp, depth in (work := above[:NEAREST_CALLERS]):
        sp = fp - stopped.compiled.info(caller).frame.size
        if depth == 0 or sp <= max(address, NULL_SIZE):
            continue
        for callee in _callees(stopped, caller):
            yield callee, sp
            work.append((callee, sp, depth - 1))


def _local(place: Register | Slot, address: int, function: str) -> Object | None:
    variable = place.variable if isinstance(place, Slot) else None
    if variable is None or in_library(variable.location):
        return None
    name, size = variable.name, variable.ctype.size
    return Object("local", address, size, name, variable.location, variable, function, "ended")


def _callees(stopped: StoppedProgram, caller: str) -> list[str]:
    blocks = stopped.program.functions[caller].blocks
    calls = (each.terminator for each in blocks)
    names = (call.callee for call in calls if isinstance(call, Call))
    return list(dict.fromkeys(each for each in names if isinstance(each, str)))
