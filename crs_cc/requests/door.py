"""The message and the slot: what goes through the door, byte for byte.

>>> slot_offset("run"), slot_offset("message"), SLOT.itemsize
(0, 64, 384)
"""

from __future__ import annotations

from typing import Final

import numpy as np

MESSAGE: Final = np.dtype(
    [
        ("i", "<i4", (8,)),  # integer arguments, then integer results
        ("f", "<f8", (4,)),  # floating arguments, then floating results
        ("size", "<i4"),  # bytes of `data` in use, 0 to 248
        ("result", "<i4"),  # the reply's result, what `__crs_request` gives
        ("data", "u1", (248,)),
    ]
)
"""The message that a program posts and the reply that it finds in its place: 320 bytes.

`struct __crs_message` in `crs_request.h` is the same for C; a test holds the two together.
"""

DATA_SIZE: Final = MESSAGE["data"].shape[0]

LARGEST: Final = 2**31 - 1
"""The largest number in a message; more is told as this."""

SLOT: Final = np.dtype(
    [
        ("run", "<i4"),  # 1: resume the robot in the next round
        ("status", "<i4"),  # how it came back, one of the STATUS constants
        ("code", "<i4"),  # the request it posted; 0 when it stopped for another reason
        ("error_kind", "<i4"),  # index into ERROR_KINDS
        ("error_site", "<i4"),  # number of the place in the code, see `runtime.codegen`
        ("error_address", "<u4"),  # the address or value that was refused
        ("fuel", "<i8"),  # in: fuel it may burn; out: what is left, below 0 when overdrawn
        ("statements", "<i8"),  # statements begun so far (debug density only)
        ("stop_from", "<i8"),  # statements that must have begun before one stops (the same)
        ("error_size", "<u4"),  # bytes of the access that failed; 0 where the code knows
        (
            "stop_before_all",
            "<u4",
        ),  # 1: every statement is marked, else those in `marks` (the same)
        ("stopped", "<u4"),  # 1 + number of the marked statement it stopped before, 0 for none
        ("reserved", "<u4"),
        ("message", MESSAGE),
    ]
)
"""One robot's slot: 384 bytes."""


def slot_offset(field: str) -> int:
    """Return the offset of a field in a robot's slot [bytes]."""
    return int(SLOT.fields[field][1])  # type: ignore[index]


RETURNED: Final = 0
SUSPENDED: Final = 1
FAILED: Final = 2

ERROR_KINDS: Final = (
    "none",
    "null pointer",
    "pointer outside memory",
    "wild pointer",  # into memory, but to no object
    "out of bounds",
    "use after free",
    "use after scope",
    "use after return",
    "uninitialised read",
    "invalid free",
    "double free",
    "missing argument",  # `va_arg` behind the last argument
    "no value returned",  # and yet used
    "mismatched call",  # through a pointer to a function that would misread its arguments
    "shift out of range",
    "signed overflow",
    "division by zero",
    "division overflow",
    "bad function pointer",
    "stack overflow",
    "damaged stack",
    "unreachable code reached",
    "abort called",
    "assertion failed",
    "array length not positive",
    "no memory for local array",
    "goto to no label",
    "longjmp without setjmp",
    "longjmp to a function that has returned",
    "unhandled signal",
    "internal trap",
)
"""What can stop a program, by the number in the slot."""

NUM_STATE: Final = 45
"""Length of the vendor's `State` array (vendor header `Nclient.h` 1.29)."""
