"""Numbered sites in the code: where a program can fail, calls, or can be stopped.

A failing program stores the number of its `Site`. Every call stores the number of its `CallSite` in
the header of the function that it calls (checked builds only), so that the stack can be walked
while the program runs: the heap records the calls that allocated and freed each block. The header's
first eight bytes hold a call word, until the returned value replaces it:

    bits 0 to 23    number of the call site, from 1
    bits 24 to 41   size of the caller's frame, in units of 16 bytes: its own header is above it
    bits 42 to 63   size of the arguments that were passed, in units of 4 bytes

>>> hex(call_word(5, frame_size=96, arguments_size=8))
'0x80006000005'
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Variable
from crs_cc.ir.types import ArrayType, CType

Access = Literal["", "read", "write"]

SITE_BITS: Final = 24
FRAME_BITS: Final = 18
FRAME_UNIT: Final = 16  # bytes
ARGUMENT_UNIT: Final = 4  # bytes


@dataclass(frozen=True, slots=True)
class Site:
    """A site that can fail.

    Attributes:
        kind: one of `requests.ERROR_KINDS`, or "memory" for accesses, whose kind shows only from
            the address, see `diagnosis.diagnose`.
        location: the place in the C source.
        access: what an access does; empty for all other failures.
        size: the number of accessed bytes; 0 if it is in the slot's `error_size`.
        variable: the variable to blame, where that is known.
        array: the type of the array whose index is out of bounds.
        ctype: the type that `va_arg` reads.
    """

    kind: str
    location: Location
    access: Access = ""
    size: int = 0
    variable: Variable | None = None
    array: ArrayType | None = None
    ctype: CType | None = None


@dataclass(frozen=True, slots=True)
class CallSite:
    """A place that calls: in which function, and where; the types of its variable arguments."""

    function: str
    location: Location
    passed: tuple[CType, ...] = ()


@dataclass(frozen=True, slots=True)
class StatementSite:
    """A site in the user's code at which a debugger can stop: in which function, and where.

    Attributes:
        after_call: whether it is right behind a call in the middle of a statement, where the call
            has just returned; otherwise it is before a statement.
    """

    function: str
    location: Location
    after_call: bool = False


def call_word(site: int, frame_size: int, arguments_size: int) -> int:
    """Return the call word that a call stores in the callee's header."""
    arguments = arguments_size // ARGUMENT_UNIT
    return site + (frame_size // FRAME_UNIT << SITE_BITS) + (arguments << SITE_BITS + FRAME_BITS)


def call_site(word: int) -> int:
    """Return the number of the call site in a call word."""
    return word & ((1 << SITE_BITS) - 1)


def arguments_size(word: int) -> int:
    """Return the size of the arguments in a call word [bytes]."""
    return (word >> SITE_BITS + FRAME_BITS) * ARGUMENT_UNIT
