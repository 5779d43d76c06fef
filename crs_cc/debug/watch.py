"""Watched objects in one robot's memory, and the accesses to them since the last stop.

While something is watched, the robot's program runs in its watching build (`codegen.watchpoints`),
else in the debug build; the frames are the same, and `WatchSet.arm` moves it from one to the other.
Watched objects and accesses are outside of the program's state: no snapshot has them, and
slots are not touched. So `stop_before_all`, `stop_from` and the marks belong to stepping. A program
that accesses a watched object stops before its next statement even if its slot does not ask for it;
`take` then returns the accesses, and nothing if the program has stopped for another reason, or for
an access that does not count (a `change` that changes nothing): then the caller
resumes the program, unless it should stop there anyway.

The program stops before the first statement that starts after the access. So the statement that
started last, one before, is the one to go back to; if it was the last one of a function whose
value the access used, `MemoryAccess.location` is that of the access itself.

A watch on a local variable lasts as long as the function's activation, which is identified by
its frame and by how many statements had started when it was entered (`StackFrame.entered`). So it
is active again when the run goes back into it, and inactive before it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, Literal, TypeAlias

import numpy as np

from crs_cc.core.arrays import Records
from crs_cc.core.source import Location
from crs_cc.debug.errors import DebugError
from crs_cc.ir.instruction import plain_states
from crs_cc.ir.names import in_library, plain_name
from crs_cc.runtime.codegen.watchpoints import accesses
from crs_cc.runtime.diagnosis.inspect import StackFrame
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.layout import STACK_TOP
from crs_cc.runtime.watch_ranges import (
    ENTER,
    LONGEST,
    RANGE,
    RANGES,
    READ,
    RETURN,
    WRITE,
    grains,
    offset,
)

MAX: Final = RANGES // 2
"""Most objects of one robot that can be watched at once: each needs a range, some one more."""

AccessKind = Literal["write", "read", "access", "change"]
KINDS: Final[dict[AccessKind, int]] = {
    "write": WRITE,
    "read": READ,
    "access": READ | WRITE,
    "change": WRITE,
}

Content: TypeAlias = tuple[bytes, bytes]
"""The bytes of an object, and their `ByteState`s (none in unchecked builds)."""


@dataclass(frozen=True, slots=True)
class WatchedObject:
    """A watched object.

    Attributes:
        kind: which accesses count.
        address: its first byte.
        size: its size [bytes].
        frame: the activation whose variable it is; None if it is static.
    """

    number: int
    kind: AccessKind
    address: int
    size: int
    frame: StackFrame | None = None


@dataclass(frozen=True, slots=True)
class MemoryAccess:
    """An access to a watched object.

    Attributes:
        watched: the object.
        what: whether it was written, or only read, or its function has returned.
        old: the bytes before.
        new: the bytes now.
        location: the location in the user's files, of the call if the library did it, or None.
        function: the user's function there, by the linker's name; empty if unknown.
        library: the C name of the library function that was called there, or empty.
    """

    watched: WatchedObject
    what: Literal["write", "read", "return"]
    old: Content
    new: Content
    location: Location | None = None
    function: str = ""
    library: str = ""


class WatchSet:
    """The watched objects in one robot's memory."""

    def __init__(
        self, fleet: Fleet, robot: int, watching: Callable[[Executable], Executable]
    ) -> None:
        """Store the robot with its debug build, and the function that makes the watching build."""
        self._fleet = fleet
        self._robot = robot
        self._plain = fleet.executable(robot)
        self._watching = watching
        self._wanted: tuple[WatchedObject, ...] = ()
        self._over: set[int] = set()
        self._before: dict[int, Content] = {}
        self._rows: dict[
            tuple[int, bool], int
        ] = {}  # by number, and whether of a header: its range
        self._places: list[tuple[Location, str]] = []

    def is_of(self, executable: Executable) -> bool:
        """Return whether this is the robot's program, in its plain build."""
        return self._plain is executable

    def arm(self, wanted: Sequence[WatchedObject]) -> None:
        """Set the watched objects; accesses to unchanged ones are kept.

        Raises:
            DebugError: there are too many, or memory is exhausted.
        """
        if len(wanted) > MAX:
            raise DebugError(f"at most {MAX} objects of a robot's program can be watched at once")
        if tuple(wanted) == self._wanted:
            return
        self._wanted = tuple(wanted)
        try:
            build = self._watching(self._plain) if wanted else self._plain
            self._fleet.exchange(self._robot, build)
        except OSError as error:
            self._wanted = ()
            raise DebugError(f"cannot set watchpoints: {error.strerror}") from None
        self.forget()

    def forget(self) -> None:
        """Discard accesses and values after the program's memory was restored."""
        if not self._wanted:
            return
        self._over = self._ended()
        self._before = {each.number: self._content(each) for each in self._wanted}
        self._enter()

    def is_pending(self) -> bool:
        """Return whether there are accesses to `take`."""
        return bool(self._rows) and bool(self._ranges()["hits"].any())

    def take(self) -> list[MemoryAccess]:
        """Return the accesses since the last call."""
        if not self.is_pending():
            return []
        found = [self._access(each) for each in self._wanted if each.number not in self._over]
        self._fleet.watched[self._robot]["pending"] = 0
        self._ranges()["hits"] = 0
        gone = {each.watched.number for each in found if each and each.what == "return"}
        if gone:
            self._over |= gone
            self._enter()
        return [each for each in found if each is not None]

    # -- the ranges ----------------------------------------------------------------------------

    def _ranges(self) -> Records:
        ranges: Records = self._fleet.watched[self._robot]["ranges"][0]
        return ranges[: len(self._rows)]

    def _enter(self) -> None:
        """Write the watched ranges to where the program reads them."""
        rows: list[tuple[int, int, int, int]] = []
        self._rows = {}
        for each in self._wanted:
            if each.number in self._over:
                continue
            since = 0 if each.frame is None else each.frame.entered
            self._rows[each.number, False] = len(rows)
            rows.append((each.address, each.size, KINDS[each.kind], since))
            if each.frame is not None:
                self._rows[each.number, True] = len(rows)
                rows.append((each.frame.fp, 1, ENTER | RETURN, since))
        watched = self._fleet.watched[self._robot]
        watched["pending"] = 0
        watched["end"] = offset("ranges") + len(rows) * RANGE.itemsize
        ranges = self._ranges()
        ranges["hits"] = 0
        for row, (first, size, kinds, since) in zip(ranges, rows, strict=True):
            row["first"], row["size"], row["kinds"], row["since"] = first, size, kinds, since
        self._bound([each[:2] for each in rows])

    def _bound(self, parts: Sequence[tuple[int, int]]) -> None:
        """Write the bounds of all ranges, each given by first address and size."""
        watched = self._fleet.watched[self._robot]
        for field in ("first", "span", "lowest", "highest", "grains"):
            watched[field] = 0
        for first, size in parts:
            watched["grains"] |= np.uint64(grains(first, size))
        if parts:
            first = min(each for each, _ in parts) - (LONGEST - 1)
            watched["first"] = first
            watched["span"] = max(first + size for first, size in parts) - first
        on_stack = [(first, size) for first, size in parts if first < STACK_TOP]
        if on_stack:
            watched["lowest"] = min(first for first, _ in on_stack)
            watched["highest"] = max(first + size for first, size in on_stack)

    def _hits(self, number: int, *, header: bool) -> Records | None:
        """Return the range of an object, or of its frame's header, if it was hit."""
        at = self._rows.get((number, header))
        row: Records | None = None if at is None else self._ranges()[at]
        return row if row is not None and row["hits"] else None

    # -- what happened -------------------------------------------------------------------------

    def _access(self, watched: WatchedObject) -> MemoryAccess | None:
        """Return the access to an object, None if none counts."""
        number, frame = watched.number, watched.frame
        old, new = self._before[number], self._content(watched)
        if frame is not None:
            if self._begun() <= frame.entered:  # no statement of the function has started yet
                self._before[number] = new
                return None
            header = self._hits(number, header=True)
            if header is not None and int(header["hits"]) & RETURN:
                return MemoryAccess(watched, "return", old, new, *self._place(header))
        row = self._hits(number, header=False)
        if row is None:
            return None
        self._before[number] = new
        if watched.kind == "change" and old == new:
            return None
        what: Literal["write", "read"] = "write" if int(row["hits"]) & WRITE else "read"
        return MemoryAccess(watched, what, old, new, *self._place(row))

    def _place(self, row: Records) -> tuple[Location | None, str, str]:
        """Return where an access was made: location, function, and library function."""
        detail = self._plain.detail()
        number = int(row["place"])
        if number:
            if not self._places:
                sites = accesses(detail.program)
                self._places = [(each.location, each.function) for each in sites]
            return *self._places[number - 1], ""
        for call in row["callers"].tolist():
            site = detail.compiled.call_sites[call - 1] if call else None
            if site is not None and not in_library(site.location):
                info = detail.compiled.info(site.function)
                callee = info.callees.get(info.calls[call], "")
                name = plain_name(callee) if isinstance(callee, str) else ""
                return site.location, site.function, name
        return None, "", ""

    # -- the program ---------------------------------------------------------------------------

    def _begun(self) -> int:
        return int(self._fleet.slots["statements"][self._robot])

    def _content(self, watched: WatchedObject) -> Content:
        part = slice(watched.address, watched.address + watched.size)
        robot = self._robot
        states = self._fleet.shadow(robot)[part].tobytes()
        return self._fleet.memory(robot)[part].tobytes(), plain_states(states)

    def _ended(self) -> set[int]:
        """Return the numbers of the variables whose functions have returned."""
        own = [each for each in self._wanted if each.frame is not None]
        if not own:
            return set()
        stack = self._fleet.stopped(self._robot).stack
        active = {(each.fp, each.function, each.entered) for each in stack}
        begun = self._begun()
        return {
            each.number
            for each in own
            if each.frame
            and each.frame.entered < begun
            and (each.frame.fp, each.frame.function, each.frame.entered) not in active
        }
