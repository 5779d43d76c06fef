"""Inspection of a stopped program's memory: objects at addresses, and why accesses are invalid.

An inspector is valid until the program resumes.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import Final

from crs_cc.debug.data.instruction_steps import SCRATCH
from crs_cc.debug.data.memory import SavedRegister
from crs_cc.debug.data.scope import FrameAddresses, frame_storage, is_own
from crs_cc.debug.data.values import GONE, Value
from crs_cc.debug.world.state_fields import StateField
from crs_cc.ir.instruction import ByteState
from crs_cc.ir.names import in_library
from crs_cc.ir.types import LONG, VOID, ArrayType, CType, IntegerType
from crs_cc.runtime.diagnosis.dead_frames import returned_local
from crs_cc.runtime.diagnosis.diagnose import diagnose
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.diagnosis.object_text import count, object_name
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.diagnosis.values import Style, Values, place_name
from crs_cc.runtime.diagnosis.variables import Variables
from crs_cc.runtime.layout import NULL_SIZE, STACK_TOP
from crs_cc.runtime.sites import CallSite

REPEATS: Final = 10
"""So many equal elements are written as one, as gdb does it."""

SHORT: Final = Style(longest=80, most_elements=16, repeats=REPEATS)
"""For lists of variables, a line for each."""

FULL: Final = Style(
    longest=100_000, most_elements=200, longest_text=200, most_nested=20, repeats=REPEATS
)
"""For a value that the user requested."""


STATE_NAMES: Final = ("State", "__report_State")
"""What the library calls `State[]`, in each dialect."""

_WORD: Final = 4
_WITHOUT: Final = bytes([ByteState.WITHOUT_VALUE])


def _no_name(_address: int, _target: CType) -> str:
    return ""


def _no_bytes(_address: int, _size: int) -> bytes:
    return b""


class MemoryInspector:
    """Describes the memory of a stopped program.

    Attributes:
        stopped: the program.
    """

    def __init__(
        self,
        stopped: StoppedProgram,
        scratch: Callable[[int, int], bytes] = _no_bytes,
        fields: tuple[StateField, ...] = (),
        full_style: Style = FULL,
        name_above: Callable[[int, CType], str] = _no_name,
    ) -> None:
        """Create an inspector.

        Args:
            stopped: the program.
            scratch: returns the bytes at addresses above its memory.
            fields: the fields of `State[]`.
            full_style: how values are written at length.
            name_above: names what is at addresses above its memory.
        """
        self.stopped = stopped
        self._full_style = full_style
        self._fields = fields
        self._scratch = scratch
        self._name_above = name_above
        self._variables = Variables(stopped)

    @property
    def short(self) -> Values:
        """Formats values in at most a line."""
        return self._values(SHORT)

    @property
    def full(self) -> Values:
        """Formats values at length."""
        return self._values(self._full_style)

    def _values(self, style: Style) -> Values:
        # To keep it would be a reference cycle, in which the whole program is.
        return Values(self.read, self.states, self.name_of, self.function_at, style)

    def read(self, address: int, size: int) -> bytes:
        """Return the bytes at an address, as many as exist."""
        if address >= SCRATCH:
            return self._scratch(address, size)
        return self._variables.read(address, size)

    def states(self, address: int, size: int) -> bytes:
        """Return the states of bytes; empty if all are initialised."""
        if address >= SCRATCH:
            return b""
        states = self._variables.states(address, size)
        saved = None if states.strip(GONE) else self._saved(address, size)
        if saved is None:
            return states
        return b"" if saved.has_value(self.stopped.memory) else _WITHOUT * size

    def is_accessible(self, address: int, size: int) -> bool:
        """Return whether C may access bytes, initialised or not."""
        there, states = self.read(address, size), self.states(address, size)
        return len(there) == size and ByteState.INACCESSIBLE not in states

    def value(self, address: int, ctype: CType) -> Value:
        """Return the object of a type at an address; it may be uninitialised."""
        content, states = self.read(address, ctype.size), self.states(address, ctype.size)
        fields = self._state_fields(address, ctype) if self._fields else ()
        return Value(self, ctype, content, states, address, fields=fields)

    def _state_fields(self, address: int, ctype: CType) -> tuple[StateField, ...]:
        """Return the fields of `State[]` at an address, if it is in there."""
        number = ctype.element if isinstance(ctype, ArrayType) else ctype
        if self._state is None or not isinstance(number, IntegerType) or number.size != _WORD:
            return ()
        first, rest = divmod(address - self._state, _WORD)
        return self._fields[first:][: ctype.size // _WORD] if first >= 0 and not rest else ()

    def vendor_state(self) -> list[tuple[StateField, Value]]:
        """Return the vendor's `State[]`; empty if the program has none."""
        if self._state is None:
            return []
        places = range(self._state, self._state + _WORD * len(self._fields), _WORD)
        return [
            (each, self.value(place, LONG))
            for each, place in zip(self._fields, places, strict=True)
        ]

    @cached_property
    def _state(self) -> int | None:
        """The address of the vendor's `State[]`; None if the program has none."""
        for name in STATE_NAMES:
            data = self.stopped.program.data.get(name)
            if data is not None and not is_own(data.location):
                return self.stopped.compiled.addresses[name]
        return None

    def function_at(self, pointer: int) -> str:
        """Return the name of the function of a function pointer, or ""."""
        if pointer >= SCRATCH:
            return self._name_above(pointer, VOID)
        return self._variables.values.function_at(pointer)

    def name_of(self, address: int, target: CType) -> str:
        """Return a description of the target of a pointer."""
        if address >= SCRATCH:
            return self._name_above(address, target) or f"{address:#x} (no object)"
        known = self._saved(address)
        if known is not None and known.address == address:
            return f"&{known.name}"
        if NULL_SIZE <= address < self.stopped.stack_pointer():
            gone = returned_local(self.stopped, address)
            what = f"ended {object_name(gone)}" if gone else "in a function that has returned"
            return f"{address:#x} ({what})"
        found = self._variables.objects.at(address)
        if found is None:
            return f"{address:#x} (no object)"
        named = self._variables.values.object_at(address, target)
        if named and found.state == "alive":
            return named
        return f"{named or hex(address)} ({_described(found, address)})"

    def symbol_at(self, address: int) -> str:
        """Return the name of the variable at an address, as gdb writes it: buf+6; or ""."""
        if address >= SCRATCH:
            return self._name_above(address, VOID).removeprefix("&")
        found = self._variables.objects.at(address)
        if found is None or not found.name or found.state != "alive":
            return ""
        offset = address - found.address
        if not 0 <= offset < found.size:
            return ""
        return f"{found.name}+{offset}" if offset else found.name

    def _saved(self, address: int, size: int = 1) -> SavedRegister | None:
        """Return the register that is saved at an address."""
        if address >= STACK_TOP:
            return None
        stack = self.stopped.stack
        around = bisect_right(stack, address, key=lambda each: each.fp)
        # Arguments of a function without room for its frame are above that.
        for active in [*stack[:1], *stack[around : around + 1]]:
            frame = FrameAddresses.of(self.stopped, active)
            for storage in frame_storage(self.stopped.compiled.info(active.function)):
                saved = frame.saved(storage)
                if saved and saved.address <= address and address + size <= saved.end:
                    return saved
        return None

    def explain(self, address: int, size: int, reading: bool) -> str:
        """Return why C may not read, or else write, bytes."""
        beside = self._saved(address)
        if beside is not None:
            return f"'{beside.name}' is in a register: nothing is adjacent to it"
        kind, blamed, found = diagnose(self.stopped, address, size, "read" if reading else "write")
        what = "an unknown object" if found is None else object_name(found)
        match kind:
            case "null pointer":
                return "the pointer is null" + (f" (and {address} more)" if address else "")
            case "uninitialised read":
                return f"{_part(found, address) or what} is uninitialised"
            case "use after free":
                return f"{what} is freed{_at(found.freed) if found else ''}"
            case "use after scope" | "use after return":
                return f"{what} is out of scope: its block has ended or not started"
            case "out of bounds" if found is not None:
                side = "before the start" if blamed < found.address else "past the end"
                return f"{address:#x} is {side} of {what}"
        return f"{address:#x} is not inside any object of the program"


def _part(found: Object | None, address: int) -> str:
    """Name the part of a variable at an address."""
    if found is None or found.variable is None:
        return ""
    return f"'{place_name(found.name, found.variable.ctype, address - found.address)}'"


def _described(found: Object, address: int) -> str:
    """Return a description of the object in or near which an address is."""
    distance = found.distance(address)
    where = ""
    if distance:
        where = "before " if distance < 0 else "past the end of "
        if distance > 1:
            where = f"{count(distance - 1, 'byte')} {where}"
    elif address != found.address and not found.name:
        where = f"{count(address - found.address, 'byte')} into "
    state = {"alive": "", "freed": "freed ", "ended": "ended "}[found.state]
    if found.kind == "heap block":
        made = f"{state}heap block of {count(found.size, 'byte')}"
        return f"{where}{made}{_at(found.allocated, 'from')}"
    return f"{where}{state}{object_name(found)}"


def _at(sites: tuple[CallSite, ...], word: str = "at") -> str:
    """Return a location in the user's code: ` at wander.c:12`."""
    for site in sites:
        if not in_library(site.location):
            return f" {word} {Path(site.location.file).name}:{site.location.line}"
    return ""
