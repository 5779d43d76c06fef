"""The variables of a stopped program, with their values."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from crs_cc.debug.data.expression_compiler import TypeOf
from crs_cc.debug.data.memory_inspection import MemoryInspector
from crs_cc.debug.data.scope import FrameAddresses, Scopes, Storage, VariableKind, concrete
from crs_cc.debug.data.values import Value
from crs_cc.runtime.diagnosis.inspect import StackFrame


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable of a stopped program.

    Attributes:
        scope: "parameter", "local", "static" (of a function) or "global".
        is_hidden: whether it is shadowed at the current location.
    """

    name: str
    value: Value
    scope: VariableKind
    is_hidden: bool = False


def variables_of(
    scopes: Scopes, type_of: TypeOf, inspector: MemoryInspector, active: StackFrame
) -> list[Variable]:
    """Return the variables of a frame, those of the innermost block first.

    Parameters come last; variables that are declared later, or do not exist yet, are left out.
    """
    frame = FrameAddresses.of(inspector.stopped, active)
    sizes = frame.sizes(scopes.extents(active.function), inspector.stopped.memory)
    found: dict[str, None] = {}
    variables = []
    for storage in scopes.of(active.function):
        name, ctype = storage.variable.name, concrete(type_of(storage.variable), sizes)
        if ctype is None or not storage.is_visible(active.location):
            continue
        value = inspector.value(frame.address(storage), ctype)
        if storage.variable.is_indirect:
            value = value.target() or value
        if value.exists:
            variables.append(Variable(name, value, storage.kind, name in found))
            found[name] = None
    return sorted(variables, key=lambda each: each.scope == "parameter")


def globals_of(storages: Iterable[Storage], inspector: MemoryInspector) -> list[Variable]:
    """Return global variables, sorted by name."""
    return [
        Variable(
            storage.variable.name, inspector.value(storage.at, storage.variable.ctype), storage.kind
        )
        for storage in sorted(
            storages, key=lambda each: (each.variable.name, each.variable.location)
        )
    ]
