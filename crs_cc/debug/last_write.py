"""The last write of an object before a position, and the next one after it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import RecordedRun
from crs_cc.debug.timeline.run_event import StopRequest
from crs_cc.debug.watch import MemoryAccess, WatchedObject
from crs_cc.ir.types import CType
from crs_cc.runtime.diagnosis.inspect import StackFrame


@dataclass(frozen=True, slots=True)
class MemoryObject:
    """An object in the memory of a robot's program.

    Attributes:
        frame: the activation whose variable it is; None if it is static.
        type: its type, if it is known.
    """

    robot: int
    address: int
    size: int
    frame: StackFrame | None = None
    type: CType | None = field(default=None, compare=False)

    def is_same_memory(self, other: MemoryObject) -> bool:
        """Return whether it is the same memory as another object."""
        mine, its = (self.robot, self.address, self.size), (other.robot, other.address, other.size)
        return mine == its

    @property
    def watched(self) -> WatchedObject:
        """The object, as a watched range."""
        return WatchedObject(0, "write", self.address, self.size, self.frame)


@dataclass(frozen=True, slots=True)
class Write:
    """A write of an object.

    Attributes:
        before: the last position before it.
        access: what was done; None if the user changed the program there.
        edit: the user's change; empty for none.
    """

    before: Position
    access: MemoryAccess | None = None
    edit: str = ""


def last_write(run: RecordedRun, wanted: MemoryObject, before: Position) -> Write | None:
    """Return the last write of an object before a position; None if there is none.

    The run is off its timeline after that: `seek` must follow.

    Raises:
        InterruptedRunError: the user interrupts.
    """
    return next(writes_before(run, wanted, before), None)


def writes_before(run: RecordedRun, wanted: MemoryObject, before: Position) -> Iterator[Write]:
    """Return the writes of an object before a position, the last one first.

    A change by the user is the last one returned. The run is off its timeline after that.

    Raises:
        InterruptedRunError: the user interrupts.
    """
    limit = before
    edit = _last_edit(run, wanted, before)
    for begin in run.history.back_from(before):
        found: list[Write] = []
        run.arm(StopRequest(watched={wanted.robot: [wanted.watched]}, at_once=True))
        for event in run.replay(begin, limit, robots=[wanted.robot]):
            hits = (each for each in event.accesses if each.access.what == "write")
            found += [Write(each.before, each.access) for each in hits if each.before < before]
        if edit is not None and edit.before >= begin:
            yield from (each for each in reversed(found) if each.before >= edit.before)
            yield edit
            return
        yield from reversed(found)
        if (
            wanted.frame is not None
            and _sites_passed_at(run, begin, wanted.robot) < wanted.frame.entered
        ):
            return
        limit = begin


def _last_edit(run: RecordedRun, wanted: MemoryObject, before: Position) -> Write | None:
    """Return the last change of an object by the user."""
    first, end = wanted.address, wanted.address + wanted.size
    for change in reversed(run.history.changes):
        if change.robot != wanted.robot or change.position > before:
            continue
        spans = ((each.address, each.address + len(each.content)) for each in change.patches)
        if any(start < end and first < stop for start, stop in spans):
            return Write(change.position, None, change.text)
    return None


def _sites_passed_at(run: RecordedRun, snapshot: Position, robot: int) -> int:
    """Return the number of statements of a program that had started at a snapshot."""
    programs = run.history.at(snapshot).session.programs
    return int(programs[robot].slot["statements"][0]) if robot < len(programs) else 0
