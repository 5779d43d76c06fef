"""What expressions use outside their program: the world, and the programs of other robots.

These values are copied into an expression when it is evaluated, and cannot be assigned to. A
pointer of another program means nothing in this one, so it has become `const void *`.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from typing import Final, Protocol

from crs_cc.debug.data.notation import ExternalName
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.ir.types import (
    VOID,
    ArrayType,
    CType,
    FunctionType,
    PointerType,
    RecordType,
    qualify,
)

_ADDRESS: Final = PointerType(qualify(VOID, const=True, volatile=False))


@dataclass(frozen=True, slots=True)
class ExternalUse:
    """A value from outside that an expression uses.

    Attributes:
        type: the type that it was compiled with.
        state: what this type depends on; compiled again when it is different.
    """

    name: ExternalName
    type: CType
    state: Hashable


class ExternalValues(Protocol):
    """The world and the robots around a program."""

    def is_robot(self, name: str) -> bool:
        """Return whether there is a robot of that name."""

    def is_object(self, name: str) -> bool:
        """Return whether the world has a robot or an object of that name."""

    def state(self, name: ExternalName) -> Hashable:
        """Return the data on which the type of a value depends."""

    def value(self, name: ExternalName) -> Value:
        """Return a value; raise DebugError if it does not exist or cannot be read."""


class NoExternalValues:
    """No world: a program on its own."""

    def is_robot(self, _name: str) -> bool:
        """Return False."""
        return False

    def is_object(self, _name: str) -> bool:
        """Return False."""
        return False

    def state(self, _name: ExternalName) -> Hashable:
        """Return nothing."""
        return None

    def value(self, _name: ExternalName) -> Value:
        """Raise DebugError."""
        raise DebugError("there is no world")


def external_use(external: ExternalValues, name: ExternalName) -> ExternalUse:
    """Return the use of a value in an expression.

    Raises:
        DebugError: it does not exist, or holds pointers of another program.
    """
    value = external.value(name)
    ctype = _ADDRESS if isinstance(value.type, PointerType) else value.type
    if isinstance(ctype, FunctionType) or (ctype is not _ADDRESS and _has_pointers(ctype)):
        raise DebugError("it holds pointers of another program: use its members")
    return ExternalUse(name, qualify(ctype, const=True, volatile=False), external.state(name))


def _has_pointers(ctype: CType) -> bool:
    """Return whether a part of a value is a pointer."""
    if isinstance(ctype, ArrayType):
        return _has_pointers(ctype.element)
    if isinstance(ctype, RecordType):
        return any(_has_pointers(each.type) for each in ctype.record.members or ())
    return isinstance(ctype, PointerType)
