"""Watchpoints: objects given by an expression, and reports of accesses to them.

The expression is evaluated once: `*p` is what `p` points to now. An object on the stack is watched
as long as its function is active.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import PurePath
from typing import Final

from crs_cc.debug.data.evaluate import Evaluator
from crs_cc.debug.data.memory_inspection import MemoryInspector
from crs_cc.debug.data.values import GONE, Value
from crs_cc.debug.errors import DebugError
from crs_cc.debug.watch import AccessKind, Content, MemoryAccess, WatchedObject
from crs_cc.ir.names import plain_name
from crs_cc.ir.types import CType
from crs_cc.runtime.diagnosis.inspect import StackFrame, Stopped
from crs_cc.runtime.layout import HEADER_SIZE, STACK_TOP

_SIMPLE: Final = re.compile(r"[\w.\[\]]+|\w+->[\w.\[\]]+")
_MAX_DEPTH: Final = 20


@dataclass(frozen=True, slots=True)
class Watchpoint:
    """The object of a watchpoint.

    Attributes:
        text: the expression.
        watched: its bytes in memory.
    """

    text: str
    type: CType
    watched: WatchedObject

    @property
    def note(self) -> str:
        """Return a remark on how long it lasts; empty for ever."""
        frame = self.watched.frame
        return f"lasts until '{plain_name(frame.function)}' returns" if frame else ""


def watchpoint(
    number: int, text: str, kind: AccessKind, evaluator: Evaluator, frame: StackFrame | None
) -> Watchpoint:
    """Resolve the object that an expression names.

    Raises:
        DebugError: it names no existing object.
    """
    place = evaluator.place(text, frame)
    if not place.size:
        raise DebugError(f"'{text}' has size 0 and cannot be watched")
    inspector = evaluator.inspector()
    if not inspector.is_accessible(place.address, place.size):
        raise DebugError(inspector.explain(place.address, place.size, False))
    owner = _owner(inspector.stopped, place.address)
    return Watchpoint(
        text, place.type, WatchedObject(number, kind, place.address, place.size, owner)
    )


def _owner(stopped: Stopped, address: int) -> StackFrame | None:
    """Return the activation that owns an address on the stack."""
    if address >= STACK_TOP:
        return None
    for active in stopped.stack:
        frame = stopped.compiled.info(active.function).frame
        if address < active.fp + HEADER_SIZE + max(0, frame.varargs - frame.size - HEADER_SIZE):
            return active
    return None


def same_activation(one: StackFrame, other: StackFrame) -> bool:
    """Return whether two frames are the same activation."""
    return (one.fp, one.function, one.entered) == (other.fp, other.function, other.entered)


def change_text(watchpoint: Watchpoint, access: MemoryAccess, inspector: MemoryInspector) -> str:
    """Return a description of an access."""
    place = access.location
    where = f" at {PurePath(place.file).name}:{place.line}" if place else ""
    by = f" by {access.library}" if access.library else ""
    if access.what == "return":
        function = plain_name(watchpoint.watched.frame.function) if watchpoint.watched.frame else ""
        return f"{watchpoint.text} went out of scope: '{function}' has returned{where}"
    old, new = (_value(inspector, watchpoint, each) for each in (access.old, access.new))
    if access.what == "read":
        return f"{watchpoint.text} = {new.text}, read{by}{where}"
    if access.old == access.new:
        return f"{watchpoint.text} = {new.text} (unchanged), written{by}{where}"
    name, old, new = _narrowed(watchpoint.text, old, new)
    return f"{name}: {old.text} -> {new.text}, written{by}{where}"


def _value(inspector: MemoryInspector, watchpoint: Watchpoint, content: Content) -> Value:
    there, states = content
    known = states if states.strip(GONE) else b""  # registers have no states
    return Value(inspector, watchpoint.type, there, known, watchpoint.watched.address)


def _narrowed(name: str, old: Value, new: Value) -> tuple[str, Value, Value]:
    """Return the only element or member that has changed, if there is exactly one."""
    for _ in range(_MAX_DEPTH):
        if not (old.child_count > 1 and old.child_count == new.child_count):
            break
        pairs = zip(old.children(), new.children(), strict=True)
        changed = [
            (part, was, now)
            for (part, was), (_, now) in pairs
            if (was.content, was.states) != (now.content, now.states)
        ]
        if len(changed) != 1:
            break
        part, old, new = changed[0]
        base = name if _SIMPLE.fullmatch(name) else f"({name})"
        name = f"{base}{part}" if part.startswith("[") else f"{base}.{part}"
    return name, old, new
