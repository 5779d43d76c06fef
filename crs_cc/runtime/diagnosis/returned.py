"""Finds out which local variable an address was that lies in the dead part of the stack.

Nothing in memory tells which functions have returned. But a function's frame lies right below that
of its caller, so each function that an active one may have called can have had its variables in
one place only. When there is just one variable of the user's that can have been there, it was that.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from crs_cc.ir.names import in_library
from crs_cc.ir.program import Call, Register, Slot, Variable
from crs_cc.runtime.diagnosis.inspect import Stopped
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.layout import NULL_SIZE

FARTHEST_CALL: Final = 3
"""So many calls away from an active function the guess still is likely."""

NEAREST_CALLERS: Final = 4
"""So many active functions may have called the one that has returned."""

MOST: Final = 5000
"""After so many possible calls there is no telling."""


def returned_local(stopped: Stopped, address: int) -> Object | None:
    """Return the variable that an address was; None when none can have been there, or several."""
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


def _calls(stopped: Stopped, address: int) -> Iterator[tuple[str, int]]:
    """Return functions that may have had an address in their frames, and their frame pointers."""
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


def _callees(stopped: Stopped, caller: str) -> list[str]:
    blocks = stopped.program.functions[caller].blocks
    calls = (each.terminator for each in blocks)
    names = (call.callee for call in calls if isinstance(call, Call))
    return list(dict.fromkeys(each for each in names if isinstance(each, str)))
