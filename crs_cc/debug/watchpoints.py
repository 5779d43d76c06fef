"""Watchpoints: what is watched, given by an expression, and reports of accesses to it.

An expression is watched by its value, evaluated again whenever something that it depends on has
been written: `*p` is what `p` points to by then. By its location it is evaluated once: `*p` is what
`p` points to now. Either lasts as long as the function whose variables are concerned is active.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import Final

from crs_cc.debug.data.evaluate import Evaluator
from crs_cc.debug.data.memory_inspection import MemoryInspector
from crs_cc.debug.data.observation import UNREADABLE as UNREADABLE_NOW
from crs_cc.debug.data.observation import Content, Observation
from crs_cc.debug.data.values import GONE, Value
from crs_cc.debug.errors import DebugError
from crs_cc.debug.watch import (
    AccessKind,
    MemoryAccess,
    Watched,
    WatchedExpression,
    WatchedObject,
    WatchedWorld,
)
from crs_cc.ir.names import plain_name
from crs_cc.ir.types import CType
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram
from crs_cc.runtime.layout import HEADER_SIZE, STACK_TOP

_SIMPLE: Final = re.compile(r"[\w.\[\]]+|\w+->[\w.\[\]]+")
_MAX_DEPTH: Final = 20
UNREADABLE: Final = "unreadable"
"""The text of a value that cannot be read."""


@dataclass(frozen=True, slots=True)
class Watchpoint:
    """What a watchpoint watches.

    Attributes:
        text: the expression.
        watched: its bytes in memory, or the expression.
    """

    text: str
    type: CType
    watched: Watched

    @property
    def is_location(self) -> bool:
        """Return whether one object is watched, whatever the expression will mean later."""
        return isinstance(self.watched, WatchedObject)

    @property
    def note(self) -> str:
        """Return a remark on how long it lasts; empty for ever."""
        if isinstance(self.watched, WatchedWorld):
            return "evaluated at the start of each timestep"
        frame = self.watched.frame
        return f"lasts until '{plain_name(frame.function)}' returns" if frame else ""


def watched_object(
    number: int, text: str, kind: AccessKind, evaluator: Evaluator, frame: StackFrame | None
) -> Watchpoint:
    """Resolve the object that an expression names now.

    Raises:
        DebugError: it names no existing object.
    """
    place = evaluator.place(text, frame)
    if not place.size:
        raise DebugError(f"'{text}' has size 0 and cannot be watched")
    inspector = evaluator.inspector()
    if not inspector.is_accessible(place.address, place.size):
        raise DebugError(inspector.explain(place.address, place.size, False))
    owner = owner_of(inspector.stopped, place.address)
    return Watchpoint(
        text, place.type, WatchedObject(number, kind, place.address, place.size, owner)
    )


def watched_expression(
    number: int,
    text: str,
    kind: AccessKind,
    evaluator: Callable[[], Evaluator],
    frame: StackFrame | None,
) -> Watchpoint:
    """Resolve an expression that is to be evaluated again and again.

    Args:
        number: the number of the watchpoint.
        text: the expression.
        kind: which accesses count.
        evaluator: returns the evaluator of the robot's program, wherever the run is then.
        frame: the frame whose scope applies.

    Raises:
        DebugError: it is invalid, is constant, has side effects or, for other kinds than `change`,
            names no object.
    """
    now = evaluator()
    scope = now.scope_of(text, frame)
    if kind != "change" and not scope.is_place:
        raise DebugError(f"'{text}' is a value, not an object in memory")
    ctype = now.type_of(text, frame)
    if not ctype.size:
        raise DebugError(f"'{text}' has size 0 and cannot be watched")
    if now.has_effects(text, frame):
        raise DebugError(f"'{text}' would change the program")

    def observe() -> Observation | None:
        current = evaluator()
        stack = current.inspector().stopped.stack
        active = [_current_frame(stack, each) for each in (scope.frame, scope.innermost) if each]
        if None in active:
            return None
        return current.observe(text, scope.names, active[0] if active else None)

    found = observe() or UNREADABLE_NOW
    if not found.reads:
        if found.place is None and not found.is_elsewhere:
            raise DebugError(f"'{text}' is constant and cannot be watched")
        inspector = now.inspector()
        if found.place is not None and not inspector.is_accessible(*found.place):
            raise DebugError(inspector.explain(*found.place, False))
    return Watchpoint(text, ctype, WatchedExpression(number, kind, observe, scope.innermost))


def watched_world(
    number: int, text: str, robot: int, evaluator: Callable[[], Evaluator], *, rises: bool = False
) -> Watchpoint:
    """Resolve an expression that uses the world, to be evaluated at the start of each timestep.

    Args:
        number: the number of the watchpoint.
        text: the expression.
        robot: the robot in whose program it is evaluated.
        evaluator: returns the evaluator of this program, wherever the run is then.
        rises: whether to stop only when its value is not 0 any more.

    Raises:
        DebugError: it is invalid, uses local variables, or has side effects.
    """
    now = evaluator()
    names = now.global_scope(text)
    if now.has_effects(text):
        raise DebugError(f"'{text}' would change the program")
    condition = f"!!({text})" if rises else text

    def observe() -> Content:
        return evaluator().observe(condition, names).content

    return Watchpoint(
        text, now.type_of(condition), WatchedWorld(number, robot, observe, rises=rises)
    )


def _current_frame(stack: Sequence[StackFrame], frame: StackFrame) -> StackFrame | None:
    """Return the frame of an activation where it is now; None if it is not active."""
    return next((each for each in stack if same_activation(each, frame)), None)


def owner_of(stopped: StoppedProgram, address: int) -> StackFrame | None:
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
    if isinstance(watchpoint.watched, WatchedWorld) and watchpoint.watched.rises:
        return f"{watchpoint.text} is true"
    old, new = (content_value(inspector, watchpoint, each) for each in (access.old, access.new))
    if old is None or new is None:
        texts = [each.text if each else UNREADABLE for each in (old, new)]
        return f"{watchpoint.text}: {' -> '.join(texts)}, changed{by}{where}"
    if access.what == "read":
        return f"{watchpoint.text} = {new.text}, read{by}{where}"
    if access.old == access.new:
        return f"{watchpoint.text} = {new.text} (unchanged), written{by}{where}"
    name, old, new = _narrowed(watchpoint.text, old, new)
    how = "changed" if access.what == "change" else "written"
    return f"{name}: {old.text} -> {new.text}, {how}{by}{where}"


def content_value(
    inspector: MemoryInspector, watchpoint: Watchpoint, content: Content
) -> Value | None:
    """Return a value; None if it could not be read."""
    there, states = content
    if not there:
        return None
    known = states if states.strip(GONE) else b""  # registers have no states
    watched = watchpoint.watched
    address = watched.address if isinstance(watched, WatchedObject) else None
    return Value(inspector, watchpoint.type, there, known, address)


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
