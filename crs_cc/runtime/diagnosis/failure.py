"""The failure of a program: location, kind of error, and object concerned."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.core.source import Location
from crs_cc.ir.types import ArrayType, CType
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.sites import Access


@dataclass(frozen=True, slots=True)
class Failure:
    """A run-time error.

    Attributes:
        kind: one of `crs_cc.requests.ERROR_KINDS`.
        location: the location in the C source.
        value: the invalid address or function pointer, 0 if there is none.
        stack: the active calls, the innermost, which failed at `location`, first; empty if
            unknown.
        access: "read" or "write" for an invalid memory access.
        size: number of bytes accessed.
        object: the object at or near `value`; the uninitialised variable.
        array: the array whose index, `value`, is out of bounds, and its address.
        ctype: the type that `va_arg` reads.
        other: the second of two objects concerned.
        stopped: the program, for inspection; None if its stack cannot be trusted.
    """

    kind: str
    location: Location
    value: int
    stack: tuple[StackFrame, ...] = ()
    access: Access = ""
    size: int = 0
    object: Object | None = None
    stopped: StoppedProgram | None = None
    array: tuple[ArrayType, int] | None = None
    other: Object | None = None
    ctype: CType | None = None
