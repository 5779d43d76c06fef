"""The message and the slot: the binary interface between program and runtime.

A slot is followed by its program's `TIMING`, which is private to the runtime and not part of
this interface.

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
        ("result", "<i4"),  # the reply's result, returned by `__crs_request`
        ("data", "u1", (248,)),
    ]
)
"""The message that a program posts, which the reply overwrites: 320 bytes.

`struct __crs_message` in `crs_request.h` is its C declaration; a test compares the two.
"""

DATA_SIZE: Final = MESSAGE["data"].shape[0]

LARGEST: Final = 2**31 - 1
"""The largest number in a message; larger values are clamped to it."""

SLOT: Final = np.dtype(
    [
        ("run", "<i4"),  # 1: resume the robot in the next round
        ("status", "<i4"),  # why it stopped, one of the STATUS constants
        ("code", "<i4"),  # the request that it posted; 0 if it stopped for another reason
        ("error_kind", "<i4"),  # index into ERROR_KINDS
        ("error_site", "<i4"),  # number of the location in the code, see `runtime.codegen`
        ("error_address", "<u4"),  # the invalid address or value
        ("fuel", "<i8"),  # in: fuel that it may use; out: the rest, negative if overdrawn
        ("statements", "<i8"),  # sites passed so far, see `StatementSite` (debug builds only)
        ("stop_from", "<i8"),  # number of sites passed before it may stop (the same)
        ("error_size", "<u4"),  # size of the failed access; 0 if the code implies it
        (
            "stop_before_all",
            "<u4",
        ),  # 1: every statement is marked, 2: every site, 0: those in `marks` (the same)
        ("stopped", "<u4"),  # 1 + number of the marked site it stopped at, 0 for none
        ("error_base", "<u4"),  # address of the array whose bounds an index exceeds; second pointer
        ("message", MESSAGE),
    ]
)
"""One robot's slot: 384 bytes."""


TIMING: Final = np.dtype(
    {
        "names": [
            "clock_s", "due_s", "speed_hz", "fuel", "pending", "alive", "asks",
            "compared_site", "compared_left", "compared_right",
        ],
        "formats": ["<f8", "<f8", "<f8", "<i8", "<i8", "?", "<i4", "<u4", "<u4", "<u4"],
        "offsets": [0, 8, 16, 24, 32, 40, 44, 48, 52, 56],
        "itemsize": 64,  # a cache line
    }
)  # fmt: skip
"""What is known of a program's time, see `session.session_state`. `asks` is 1 if the program has
stopped for something that is not answered where rounds are run: its request, its end or its
failure. `compared_site` is 1 + the number of the location where a checked program has first
compared pointers to different objects, followed by the pointers; 0 if it has not."""

SYSTEM_CALL: Final = 1000
"""Processor time of a request to the host [instructions]; chosen by us: 20 microseconds
on a host of 50 MHz."""


def slot_offset(field: str) -> int:
    """Return the offset of a field in a robot's slot [bytes]."""
    return int(SLOT.fields[field][1])  # type: ignore[index]


def timing_offset(field: str) -> int:
    """Return the offset of a field of `TIMING` from the start of the slot before it [bytes]."""
    return SLOT.itemsize + int(TIMING.fields[field][1])  # type: ignore[index]


RETURNED: Final = 0
SUSPENDED: Final = 1
FAILED: Final = 2

ERROR_KINDS: Final = (
    "none",
    "null pointer",
    "pointer outside memory",
    "wild pointer",  # into memory, but to no object
    "out of bounds",
    "write to read-only memory",
    "use after free",
    "use after scope",
    "use after return",
    "uninitialised read",
    "invalid free",
    "double free",
    "overlapping copy",  # by `memcpy`, `strcpy`, `sprintf`
    "unrelated pointers",  # compared or subtracted
    "missing argument",  # `va_arg` after the last argument
    "mismatched argument",  # `va_arg` of another type than was passed
    "no value returned",  # but used
    "mismatched call",  # through a pointer to a function with other parameter types
    "shift out of range",
    "signed overflow",
    "division by zero",
    "division overflow",
    "bad function pointer",
    "stack overflow",
    "corrupted stack",
    "unreachable code reached",
    "abort called",
    "assertion failed",
    "non-positive array length",
    "no memory for local array",
    "invalid goto target",
    "longjmp without setjmp",
    "longjmp to a function that has returned",
    "unhandled signal",
    "internal trap",
)
"""Run-time errors, by their number in the slot."""

NUM_STATE: Final = 45
"""Length of the vendor's `State` array (vendor header `Nclient.h` 1.29)."""
