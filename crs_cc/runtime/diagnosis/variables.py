"""The variables and arguments of a stopped program: names, types, contents and text."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from crs_cc.ir.instruction import Slot, Variable, plain_states
from crs_cc.ir.names import plain_name
from crs_cc.ir.types import ArrayType, CType, VoidType
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram
from crs_cc.runtime.diagnosis.objects import Objects
from crs_cc.runtime.diagnosis.values import Values, place_name
from crs_cc.runtime.layout import MEMORY_BYTES, NULL_SIZE


class Content(NamedTuple):
    """The content of a variable.

    Attributes:
        content: its bytes.
        states: their states; empty if all are initialised, and for registers.
    """

    variable: Variable
    content: bytes
    states: bytes = b""


class Variables:
    """Reads a stopped program.

    Attributes:
        objects: looks up the object at an address.
    """

    def __init__(self, stopped: StoppedProgram) -> None:
        self._stopped = stopped
        self.objects = Objects(stopped)
        addresses = stopped.compiled.addresses
        functions = stopped.program.functions
        self._pointers = {addresses[name]: name for name in functions if name in addresses}

    @property
    def values(self) -> Values:
        """Formats the values of its variables; to keep it would be a reference cycle."""
        return Values(self.read, self.states, self._object_name, self._function_name)

    def read(self, address: int, size: int) -> bytes:
        """Return the bytes at an address, as many as are accessible."""
        if address < NULL_SIZE:
            return b""
        return self._stopped.memory[address : min(address + size, MEMORY_BYTES)].tobytes()

    def states(self, address: int, size: int) -> bytes:
        """Return the states of these bytes; empty in unchecked builds."""
        return plain_states(self._stopped.shadow[address : address + size].tobytes())

    def show(self, found: Content) -> str:
        """Return a variable's value as text."""
        return self.values.show(found.variable.ctype, found.content, found.states)

    def _function_name(self, pointer: int) -> str:
        return plain_name(self._pointers[pointer]) if pointer in self._pointers else ""

    def _object_name(self, address: int, target: CType) -> str:
        """Return the name of a pointer's target, a variable or part of it; "" if unknown."""
        found = self.objects.at(address)
        if found is None or found.variable is None or found.distance(address):
            return ""
        return target_name(found.variable, address - found.address, target)

    def arguments(self, frame: StackFrame) -> list[Content]:
        """Return the parameters of an active call with the values passed."""
        info = self._stopped.compiled.info(frame.function)
        found = []
        for parameter, offset in zip(info.function.parameters, info.frame.parameters, strict=True):
            variable = parameter.variable or parameter.place.variable
            if variable is not None:
                address = frame.fp - info.frame.size + offset
                found.append(Content(variable, self.read(address, variable.ctype.size)))
        return found

    def of(self, frame: StackFrame) -> Iterator[Content]:
        """Return the variables of an active call with their current values."""
        info = self._stopped.compiled.info(frame.function)
        sp = frame.fp - info.frame.size
        if sp < NULL_SIZE:  # the stack overflowed before its frame
            yield from self.arguments(frame)
            return
        for place, offset in info.frame.offsets.items():
            if place.variable is not None and (self._stopped.saved or isinstance(place, Slot)):
                size = place.variable.ctype.size
                states = self.states(sp + offset, size) if isinstance(place, Slot) else b""
                yield Content(place.variable, self.read(sp + offset, size), states)

    def find(self, name: str, frame: StackFrame) -> Content | None:
        """Look up a name at the location of an active call."""
        place = frame.location
        seen = [
            (each.variable.location, number, each)
            for number, each in enumerate(self.of(frame))
            if each.variable.name == name and each.variable.is_visible(place)
        ]
        if seen:
            return max(seen)[2]
        static = f"{place.file}:{plain_name(frame.function)}.{name}"
        for wanted in (static, f"{place.file}:{name}", name):
            data = self._stopped.program.data.get(wanted)
            if data is not None and data.variable is not None:
                content = self.read(self._stopped.compiled.addresses[wanted], data.size)
                return Content(data.variable, content)
        return None


def target_name(variable: Variable, offset: int, target: CType) -> str:
    """Return the name of a pointer's target of a type, at an offset in a variable."""
    name, ctype = variable.name, variable.ctype
    if isinstance(ctype, ArrayType) and offset == 0:
        return name
    if isinstance(target, VoidType) and offset == 0:
        return f"&{name}"
    part = place_name(name, ctype, offset, target)
    return part.removesuffix("[0]") if part.endswith("[0]") else f"&{part}"
