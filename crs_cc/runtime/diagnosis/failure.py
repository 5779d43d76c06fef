"""Why a program was stopped: the place, the kind of error, and the object that it is about."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.core.source import Location
from crs_cc.runtime.diagnosis.inspect import StackFrame, Stopped
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.sites import Access


@dataclass(frozen=True, slots=True)
class Failure:
    """Why a program was stopped.

    Attributes:
        kind: one of `crs_cc.requests.ERROR_KINDS`.
        location: the place in the C source.
        value: the address or function pointer that was refused; 0 when there is none.
        stack: the active functions, the innermost, which failed at `location`, first; empty when
            it is not known.
        access: "read" or "write" when a bad access of memory failed.
        size: how many bytes were accessed.
        object: what lies at `value`, or near it; the variable that has no value yet.
        stopped: the program, to be read; None when its stack cannot be trusted.
    """

    kind: str
    location: Location
    value: int
    stack: tuple[StackFrame, ...] = ()
    access: Access = ""
    size: int = 0
    object: Object | None = None
    stopped: Stopped | None = None
