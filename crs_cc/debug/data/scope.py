"""Name lookup where a program has stopped, and the addresses of variables.

A name refers to the variable of the innermost block that declares it before the location (C17
6.2.1). Each variable has a `Storage`: in the frame of its function or, if it is static, at a fixed
address.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal

from crs_cc.core.arrays import ByteArray
from crs_cc.core.source import Location
from crs_cc.debug.data.memory import SavedRegister
from crs_cc.frontend.check.scope import ObjectSymbol
from crs_cc.frontend.check.vla import EXTENT
from crs_cc.ir.instruction import Register, Variable
from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.program import Data, Program
from crs_cc.ir.types import (
    ArrayType,
    CType,
    PointerType,
    Record,
    RecordType,
    is_variably_modified,
)
from crs_cc.runtime.compiled import Compiled, FunctionInfo
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram
from crs_cc.runtime.layout import NULL_SIZE, RESUME
from crs_cc.session.library import HEADERS

_SYSTEM: Final = f"{HEADERS}/"
"""What the library's headers declare has its place there."""

_WORD: Final = struct.Struct("<I")

VariableKind = Literal["parameter", "local", "static", "global"]


@dataclass(frozen=True, slots=True)
class Storage:
    """The storage of a variable.

    Attributes:
        kind: its kind; "static" is local to a function.
        at: its address; in a frame, the offset from the frame's lower end.
        in_frame: whether it is in a frame.
        register: its register while the program runs.
        flag: the offset of the register's initialised flag.
        passed: the offset where it was passed, if it is a parameter.
    """

    variable: Variable
    kind: VariableKind
    at: int
    in_frame: bool = False
    register: Register | None = None
    flag: int | None = None
    passed: int | None = None

    def is_visible(self, place: Location) -> bool:
        """Return whether the name means this variable at a place, if no inner one has it.

        A function without room for its frame is before its parameters.
        """
        return self.kind == "parameter" or self.variable.is_visible(place)


def is_own(location: Location) -> bool:
    """Return whether a location is in the user's files, not in the library or its headers."""
    return not in_library(location) and not location.file.startswith(_SYSTEM)


class Scopes:
    """The variables of a program."""

    def __init__(self, program: Program, compiled: Compiled) -> None:
        self._compiled = compiled
        self._statics: dict[str, list[Storage]] = {}
        self._globals: list[Storage] = []
        self._extents: dict[str, tuple[Storage, ...]] = {}
        for data in program.data.values():
            if data.variable is not None:
                self._enter(data, data.variable)

    def _enter(self, data: Data, variable: Variable) -> None:
        """Enter an object: `wander.c:turn.count` is a function's, `wander.c:count` is not."""
        address, name = self._compiled.addresses[data.name], plain_name(data.name)
        function, dot, _ = name.partition(".")
        if dot:
            self._statics.setdefault(function, []).append(Storage(variable, "static", address))
        elif is_own(variable.location):
            self._globals.append(Storage(variable, "global", address))

    def globals_(self) -> list[Storage]:
        """Return the global variables of the user's own files that the program uses."""
        return self._globals

    def extents(self, function: str) -> tuple[Storage, ...]:
        """Return the hidden variables that hold the sizes of variably modified types."""
        if function not in self._extents:
            found = frame_storage(self._compiled.info(function))
            self._extents[function] = tuple(each for each in found if each.variable.name == EXTENT)
        return self._extents[function]

    def of(self, function: str) -> list[Storage]:
        """Return all variables of a function, those of the innermost blocks first."""
        info = self._compiled.info(function)
        known = {(each.variable.name, each.variable.location): each for each in frame_storage(info)}
        file = info.function.location.file
        statics = [
            each
            for each in self._statics.get(plain_name(function), ())
            if each.variable.location.file == file
        ]
        found = [each for each in [*known.values(), *statics] if each.variable.name.isidentifier()]
        return sorted(found, key=_order, reverse=True)

    def functions(self, name: str) -> list[str]:
        """Return the linker's names of the functions of a name, those of the user's own first."""
        known = [
            info.function.name
            for info in self._compiled.functions
            if plain_name(info.function.name) == name
        ]
        place = {each: self._compiled.info(each).function.location for each in known}
        return sorted(known, key=lambda each: in_library(place[each]))

    def static(self, name: str, file: str) -> Storage | None:
        """Return a global variable that a file declares, by the file's name or the end of that."""
        for each in self._globals:
            known = each.variable.location.file
            if each.variable.name == name and (known == file or known.endswith(f"/{file}")):
                return each
        return None


def _order(storage: Storage) -> tuple[Location, Location, Location]:
    """Sort outer blocks before inner ones, and in a block the last declaration first."""
    place = storage.variable.location
    outside = Location(place.file)
    first, last = storage.variable.block or (outside, outside)
    return first, last, Location(place.file, -place.line, -place.column)


def frame_storage(info: FunctionInfo) -> Iterator[Storage]:
    """Return the variables in the frames of a function; the last place of one stored twice."""
    passed: dict[tuple[str, Location], int] = {}
    for parameter, offset in zip(info.function.parameters, info.frame.parameters, strict=True):
        variable = parameter.variable or parameter.place.variable
        if variable is not None:
            passed[variable.name, variable.location] = offset
    for place, offset in info.frame.offsets.items():
        variable = place.variable
        if variable is not None and variable.name:
            argument = passed.get((variable.name, variable.location))
            kind: VariableKind = "local" if argument is None else "parameter"
            register = place if isinstance(place, Register) else None
            flag = None if register is None else info.flags.get(register)
            at = None if flag is None else info.frame.offsets[flag]
            yield Storage(variable, kind, offset, True, register, at, argument)


@dataclass(frozen=True, slots=True)
class FrameAddresses:
    """The frame of an active function, in which homes become addresses.

    Attributes:
        sp: its lower end.
        place: the current location: variables that are declared later are uninitialised. None if
            it does not matter.
        unset: the registers that surely have none either.
    """

    sp: int
    place: Location | None
    unset: frozenset[Register] = frozenset()

    @classmethod
    def of(cls, stopped: StoppedProgram, active: StackFrame | None) -> FrameAddresses:
        """Find the frame; that of no function has nothing in it."""
        if active is None:
            return cls(0, Location(""))
        info = stopped.compiled.info(active.function)
        landing = _WORD.unpack_from(stopped.memory.data, active.fp + RESUME)[0]
        stands_there = info.landings.get(landing) == active.location  # or else it has failed
        unset = info.unset.get(landing, frozenset()) if stands_there else frozenset()
        if not stopped.saved and active is stopped.stack[0]:  # their values are unknown
            unset = frozenset(info.function.registers)
        return cls(active.fp - info.frame.size, active.location, unset)

    @property
    def has_overflowed(self) -> bool:
        """Whether the stack was too small: then only passed arguments exist."""
        return 0 < self.sp < NULL_SIZE or self.sp < 0

    def address(self, storage: Storage) -> int:
        """Return the address of a variable."""
        if not storage.in_frame:
            return storage.at
        if self.has_overflowed and storage.passed is not None:
            return self.sp + storage.passed
        return self.sp + storage.at

    def saved(self, storage: Storage) -> SavedRegister | None:
        """Return a variable that lives where C cannot reach it; None for all others."""
        if self.has_overflowed and storage.passed is not None:
            return SavedRegister(
                storage.variable.name, storage.variable.ctype, self.address(storage)
            )
        if storage.register is None:
            return None
        flag = None if storage.flag is None else self.sp + storage.flag
        variable = storage.variable
        is_later = self.place is not None and not storage.is_visible(self.place)
        is_unset = storage.register in self.unset or is_later
        return SavedRegister(variable.name, variable.ctype, self.address(storage), flag, is_unset)

    def sizes(self, extents: Sequence[Storage], memory: ByteArray) -> dict[Location, int]:
        """Return the sizes of types that only the running program knows, by their lengths' places.

        Two at one location, which come from one macro, cannot be distinguished.
        """
        found: dict[Location, int] = {}
        if not extents:
            return found
        twice: set[Location] = set()
        for storage in extents:
            place, saved = storage.variable.location, self.saved(storage)
            twice.update({place} if place in found else ())
            if saved is not None and saved.has_value(memory):
                found[place] = int(memory[saved.address :][:4].view("<u4")[0])
        return {place: size for place, size in found.items() if place not in twice}


def concrete(ctype: CType, sizes: Mapping[Location, int]) -> CType | None:
    """Return a type with the lengths that it has in the running program; None while unknown."""
    if not is_variably_modified(ctype):
        return ctype
    if isinstance(ctype, PointerType):
        target = concrete(ctype.target, sizes)
        return None if target is None else replace(ctype, target=target)
    if isinstance(ctype, RecordType):
        return _concrete_record(ctype, sizes)
    assert isinstance(ctype, ArrayType)
    element = concrete(ctype.element, sizes)
    if element is None or ctype.extent is None:
        return None if element is None else replace(ctype, element=element)
    assert isinstance(ctype.extent, ObjectSymbol)
    size = sizes.get(ctype.extent.location)
    return None if size is None else ArrayType(element, size // max(1, element.size))


def _concrete_record(ctype: RecordType, sizes: Mapping[Location, int]) -> RecordType | None:
    """Return a struct with members of variable length as it is in the running program."""
    record = Record(ctype.record.kind, ctype.record.tag, ctype.record.alias)
    members = []
    for member in ctype.record.members or []:
        target = member.type.target if isinstance(member.type, PointerType) else None
        known: CType | None
        if isinstance(target, RecordType) and target.record is ctype.record:
            known = PointerType(replace(target, record=record))
        else:
            known = concrete(member.type, sizes)
        if known is None:
            return None
        members.append(replace(member, type=known, place=None))
    record.complete(members, ctype.record.align)
    return replace(ctype, record=record)
