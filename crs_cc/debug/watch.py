"""Watched objects and expressions in one robot's memory, and the accesses since the last stop.

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

An expression is watched as the set of objects that its evaluation reads. Once one of them has
been written, the expression is evaluated again and the set is renewed, so `cur->next` follows
`cur`. At no statement in between can its value have changed: it is a function of what it reads.

A watch on a local variable exists as long as the function's activation, which is identified by
its frame and by how many statements had started when it was entered (`StackFrame.entered`). So it
is active again when the run goes back into it, and inactive before it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, Literal, TypeAlias

import numpy as np

from crs_cc.core.arrays import Records
from crs_cc.core.source import Location
from crs_cc.debug.data.observation import UNREADABLE, Content, Observation, Span
from crs_cc.debug.errors import DebugError
from crs_cc.ir.instruction import ByteState, plain_states
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

_MAX_READS: Final = 6
"""So many ranges are watched of what an expression reads; nearby ones are joined into one."""
MAX: Final = RANGES // (_MAX_READS + 2)
"""Most objects and expressions of one robot that can be watched at once.

Each needs ranges for what it reads, for the object that it names, and for a frame's header."""

AccessKind = Literal["write", "read", "access", "change"]
KINDS: Final[dict[AccessKind, int]] = {
    "write": WRITE,
    "read": READ,
    "access": READ | WRITE,
    "change": WRITE,
}

_VALUED: Final = bytes([ByteState.WITH_VALUE])

Role: TypeAlias = Literal["object", "read", "frame"]
"""What a range is watched for: the object itself, what its value depends on, a frame's header."""


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
class WatchedExpression:
    """A watched expression.

    Attributes:
        kind: which accesses to the object that it names count; a `change` is one of its value.
        observe: evaluates it in the stopped program; returns None if its function is not active.
        frame: the activation whose variables it uses; None if it uses only static ones.
    """

    number: int
    kind: AccessKind
    observe: Callable[[], Observation | None]
    frame: StackFrame | None = None


@dataclass(frozen=True, slots=True)
class WatchedWorld:
    """An expression that is evaluated at the start of each timestep, as it uses the world.

    Attributes:
        robot: the robot in whose program it is evaluated.
        observe: evaluates it; returns no bytes if that is impossible.
        rises: whether only a change from 0 counts.
        frame: None: it uses no local variables.
    """

    number: int
    robot: int
    observe: Callable[[], Content]
    rises: bool = False
    kind: AccessKind = "change"
    frame: StackFrame | None = None


Watched: TypeAlias = WatchedObject | WatchedExpression | WatchedWorld


@dataclass(frozen=True, slots=True)
class MemoryAccess:
    """An access to a watched object, or a change of a watched expression.

    Attributes:
        watched: the object or expression.
        what: whether it was written or only read, or its value was changed by a write to
            something else that it depends on, or its function has returned.
        old: the bytes before.
        new: the bytes now.
        location: the location in the user's files, of the call if the library did it, or None.
        function: the user's function there, by the linker's name; empty if unknown.
        library: the C name of the library function that was called there, or empty.
    """

    watched: Watched
    what: Literal["write", "read", "change", "return"]
    old: Content
    new: Content
    location: Location | None = None
    function: str = ""
    library: str = ""


class WatchSet:
    """The watched objects and expressions of one robot's program."""

    def __init__(self, fleet: Fleet, robot: int) -> None:
        """Store the robot with its debug build."""
        self._fleet = fleet
        self._robot = robot
        self._plain = fleet.executable(robot)
        self._wanted: tuple[Watched, ...] = ()
        self._over: set[int] = set()
        self._seen: dict[int, Observation] = {}
        self._rows: list[tuple[int, Role]] = []  # of each range: whose it is, and what for
        self._places: list[tuple[Location, str]] = []

    def is_of(self, executable: Executable) -> bool:
        """Return whether this is the robot's program, in its plain build."""
        return self._plain is executable

    def arm(self, wanted: Sequence[Watched], watching: Callable[[Executable], Executable]) -> None:
        """Set the watched ranges; accesses to those that remain are kept.

        Args:
            wanted: what is watched.
            watching: returns the watching build of a program.

        Raises:
            DebugError: there is too much, or memory is exhausted.
        """
        if len(wanted) > MAX:
            raise DebugError(f"at most {MAX} objects of a robot's program can be watched at once")
        if tuple(wanted) == self._wanted:
            return
        self._wanted = tuple(wanted)
        try:
            build = watching(self._plain) if wanted else self._plain
            self._fleet.exchange(self._robot, build)
        except OSError as error:
            self._wanted = ()
            raise DebugError(f"cannot set watchpoints: {error.strerror}") from None
        self.reset()

    def reset(self) -> None:
        """Discard accesses and values after the program's memory was restored."""
        if not self._wanted:
            return
        self._over = self._ended()
        self._seen = {each.number: self._evaluate(each) for each in self._wanted}
        self._enter()

    def is_pending(self) -> bool:
        """Return whether there are accesses to `drain`."""
        return bool(self._rows) and bool(self._ranges()["hits"].any())

    def drain(self) -> list[MemoryAccess]:
        """Return the accesses since the last call."""
        if not self.is_pending():
            return []
        before = dict(self._seen)
        active = [each for each in self._wanted if each.number not in self._over]
        found = [access for each in active for access in self._accesses(each)]
        self._fleet.watched[self._robot]["pending"] = 0
        self._ranges()["hits"] = 0
        gone = {each.watched.number for each in found if each.what == "return"}
        self._over |= gone
        if gone or any(_moved(before[number], now) for number, now in self._seen.items()):
            self._enter()
        return found

    # -- the ranges ----------------------------------------------------------------------------

    def _ranges(self) -> Records:
        ranges: Records = self._fleet.watched[self._robot]["ranges"][0]
        return ranges[: len(self._rows)]

    def _enter(self) -> None:
        """Write the watched ranges to where the program reads them."""
        rows: list[tuple[Span, int, int]] = []
        self._rows = []
        for each in self._wanted:
            if each.number in self._over:
                continue
            since = 0 if each.frame is None else each.frame.entered
            seen = self._seen[each.number]
            parts: list[tuple[Role, Span, int]] = [
                ("read", span, WRITE) for span in joined(seen.reads, _MAX_READS)
            ]
            if seen.place is not None:
                parts.insert(0, ("object", seen.place, KINDS[each.kind]))
            if each.frame is not None:
                parts.append(("frame", (each.frame.fp, 1), ENTER | RETURN))
            self._rows += [(each.number, role) for role, _, _ in parts]
            rows += [(span, kinds, since) for _, span, kinds in parts]
        watched = self._fleet.watched[self._robot]
        watched["pending"] = 0
        watched["end"] = offset("ranges") + len(rows) * RANGE.itemsize
        ranges = self._ranges()
        ranges["hits"] = 0
        for row, (span, kinds, since) in zip(ranges, rows, strict=True):
            row["first"], row["size"] = span
            row["kinds"], row["since"] = kinds, since
        self._bound([span for span, _, _ in rows])

    def _bound(self, parts: Sequence[Span]) -> None:
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

    def _hits(self, number: int) -> dict[Role, Records]:
        """Return the first range that was hit of each role."""
        found: dict[Role, Records] = {}
        for (owner, role), row in zip(self._rows, self._ranges(), strict=True):
            if owner == number and row["hits"]:
                found.setdefault(role, row)
        return found

    # -- what happened -------------------------------------------------------------------------

    def _accesses(self, watched: Watched) -> Iterator[MemoryAccess]:
        """Return the accesses that count."""
        number, frame, hits = watched.number, watched.frame, self._hits(watched.number)
        old, touched = self._seen[number], hits.get("object")
        if frame is not None and self._begun() <= frame.entered:
            self._seen[number] = self._evaluate(
                watched
            )  # no statement of the function has started yet
            return
        header = hits.get("frame")
        if header is not None and int(header["hits"]) & RETURN:
            # What it has written is gone, but what it has read is what was there before.
            if touched is not None and int(touched["hits"]) == READ:
                yield MemoryAccess(watched, "read", old.content, old.content, *self._place(touched))
            yield MemoryAccess(watched, "return", old.content, old.content, *self._place(header))
            return
        row = touched if touched is not None else hits.get("read")
        if row is None:
            return
        is_all = frame is None and "read" not in hits
        new = self._seen[number] = (self._same_object(old) if is_all else None) or self._evaluate(
            watched
        )
        if (old.content == new.content) if watched.kind == "change" else (touched is None):
            return
        what: Literal["write", "read", "change"] = "change"
        if touched is not None and old.place == new.place:
            what = "write" if int(touched["hits"]) & WRITE else "read"
        yield MemoryAccess(watched, what, old.content, new.content, *self._place(row))

    def _place(self, row: Records) -> tuple[Location | None, str, str]:
        """Return where an access was made: location, function, and library function."""
        detail = self._plain.detail()
        compiled, number = detail.compiled, int(row["place"])
        if number:
            if not self._places:
                sites = accesses(detail.program)
                self._places = [(each.location, each.function) for each in sites]
            return *self._places[number - 1], ""
        for call in row["callers"].tolist():
            site = compiled.call_sites[call - 1] if call else None
            if site is not None and not in_library(site.location):
                landing = compiled.call_landings[call - 1]
                callee = compiled.info(site.function).callees.get(landing, "")
                name = plain_name(callee) if isinstance(callee, str) else ""
                return site.location, site.function, name
        return None, "", ""

    # -- the program ---------------------------------------------------------------------------

    def _begun(self) -> int:
        return int(self._fleet.slots["statements"][self._robot])

    def _evaluate(self, watched: Watched) -> Observation:
        """Return the value now, and what it depends on."""
        if isinstance(watched, WatchedWorld):
            return Observation(watched.observe())
        if isinstance(watched, WatchedExpression):
            return watched.observe() or UNREADABLE
        part = slice(watched.address, watched.address + watched.size)
        states = plain_states(self._fleet.shadow(self._robot)[part].tobytes())
        content = self._fleet.memory(self._robot)[part].tobytes()
        return Observation((content, states), (watched.address, watched.size))

    def _same_object(self, seen: Observation) -> Observation | None:
        """Return the value now of an object that is always the same, without evaluating anything.

        None if that is not enough: its place depends on others, or it has had or has no value.
        """
        if seen.place is None or seen.reads or not seen.content[0] or seen.content[1]:
            return None
        part = slice(seen.place[0], sum(seen.place))
        states = plain_states(self._fleet.shadow(self._robot)[part].tobytes())
        if states.strip(_VALUED):
            return None
        content = self._fleet.memory(self._robot)[part].tobytes()
        return Observation((content, b""), seen.place)

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


def _moved(before: Observation, now: Observation) -> bool:
    """Return whether another set of objects is to be watched."""
    return (before.place, before.reads) != (now.place, now.reads)


def joined(spans: Iterable[Span], most: int) -> list[Span]:
    """Return a limited number of ranges that cover others, at least one on each side of the stack.

    >>> joined([(0x900000, 4), (0x900008, 4), (0x900004, 4), (0x900100, 1)], 6)
    [(9437184, 12), (9437440, 1)]
    >>> joined([(0x900000, 4), (0x900100, 4), (0x900110, 4)], 2)
    [(9437184, 4), (9437440, 20)]
    """
    found: list[tuple[int, int]] = []  # first address and end
    for first, size in sorted(spans):
        if found and first <= found[-1][1]:
            found[-1] = found[-1][0], max(found[-1][1], first + size)
        else:
            found.append((first, first + size))
    while len(found) > most:
        gaps = {
            after[0] - before[1]: number
            for number, (before, after) in reversed(list(enumerate(pairwise(found))))
            if (before[1] <= STACK_TOP) == (after[0] < STACK_TOP)
        }
        if not gaps:
            break
        at = gaps[min(gaps)]
        found[at : at + 2] = [(found[at][0], found[at + 1][1])]
    return [(first, end - first) for first, end in found]
