"""A fleet whose programs run on hosts, with the interface of a local fleet.

Each host runs rounds of its own programs until one of them makes a request, so some hosts are ahead
of others by a number of rounds. Requests are passed on in the order of rounds, as in a local fleet.
Hence output and recordings are the same, too.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.core.host_system import available_cores
from crs_cc.core.source import Location
from crs_cc.net.changed_words import Table
from crs_cc.net.host_link import HostGoneError, HostLink
from crs_cc.net.shared_rows import SharedRows
from crs_cc.requests import FAILED
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import STOP_FIELDS, Fleet
from crs_cc.runtime.snapshot import Snapshot
from crs_cc.runtime.turns import RECORD

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.diagnosis.compared_pointers import ComparedPointers
    from crs_cc.runtime.diagnosis.lost_blocks import LostBlocks
    from crs_cc.runtime.diagnosis.report import ErrorReport

_NOT_YET: Final = -1.0


class RemoteFleet(Fleet):
    """Programs on hosts, and their slots.

    Attributes:
        links: the hosts, by their numbers.
        outcome: returns the result of a robot's program, as JSON for its host.
    """

    def __init__(
        self,
        executables: Sequence[Executable],
        links: Sequence[HostLink],
    ) -> None:
        """Create the slots.

        Args:
            executables: each robot's program, for its names.
            links: the hosts, with each robot once at most; a robot without a host must not join
                before it has one.

        Raises:
            ValueError: there are too many robots.
        """
        self._programs = list(executables)
        self._rows = SharedRows(len(executables))
        self._shards = []
        self.has_marks = False
        self.links = list(links)
        self.outcome: Callable[[int], object] = lambda _robot: None
        self._lost: dict[int, str] = {}
        self._use(self._rows.table.reshape(-1).view(RECORD))
        for link in links:
            link.attach(self._rows)
        self._end_s = _NOT_YET
        self._round = 0
        self._last_alive = b""  # the running programs at the last check, once all hosts ran
        self._processors = available_cores()
        self._keeps_processor = False  # whether hosts here leave no processor to this thread

    def add(self, executable: Executable) -> int:
        """Raise ValueError: robots join before the run begins."""
        raise ValueError(f"{executable.name}: the programs of this run are on other hosts")

    def executable(self, robot: int) -> Executable:
        """Return a robot's program, for its names."""
        return self._programs[robot]

    def add_link(self, link: HostLink) -> None:
        """Add a host for robots that have had none, and have not joined."""
        link.attach(self._rows)
        self.links.append(link)
        self._last_alive = b""

    def table(self) -> Table:
        """Return slots and clocks, see `Fleet.table`."""
        return self._rows.table

    # -- rounds ----------------------------------------------------------------------------------

    @property
    def is_whole(self) -> bool:
        """Return True: `run_rounds` runs rounds until a program makes a request."""
        return True

    def run_rounds(self, end_s: float) -> int:
        """Run rounds of all hosts, see `Fleet.run_rounds`."""
        is_new = end_s != self._end_s
        if is_new:
            self._end_s, self._round = end_s, 0
            self.dismiss()
            self._keeps_processor = sum(link.is_local for link in self.links) >= self._processors
            for link in self.links:
                if link.is_log_long and not link.ended:
                    self._try(link, link.memories)
        reached, is_any = self._run_hosts(end_s, is_new=is_new)
        rounds, self._round = reached - self._round, reached
        return max(rounds, int(is_any or bool(self._requesting.any())))

    def _run_hosts(self, end_s: float, *, is_new: bool) -> tuple[int, bool]:
        """Send grants to the hosts whose programs can run, and receive their answers.

        Return the round up to which the table has all changes, and whether there are new ones.
        """
        rows = self._rows
        granted = [self.links[number] for number in rows.grant(end_s, is_new=is_new)]
        for link in granted:
            try:
                link.grant()
            except HostGoneError as error:
                self._stop(link, str(error))
        # First the one whose grant was sent last: usually the others have finished by then, so this
        # thread is woken once.
        keeps_processor = self._keeps_processor
        for link in reversed(granted):
            if link.ended:
                continue
            try:
                link.collect(keeps_processor=keeps_processor)
            except HostGoneError as error:
                self._stop(link, str(error))
            keeps_processor = False
        while (taken := rows.take(self._round)) is None:
            for link in granted:
                if reason := rows.error(link.number):
                    self._try(link, link.collect_again, reason)
        return taken

    def _try(self, link: HostLink, action: Callable[..., object], *arguments: object) -> None:
        """Perform an action of a host; stop its programs if it is lost and not replaced."""
        try:
            action(*arguments)
        except HostGoneError as error:
            self._stop(link, str(error))

    def _stop(self, link: HostLink, reason: str) -> None:
        """Stop the programs of a host that is lost and not replaced, in their last known state."""
        link.give_up()
        robots = link.robots[self.timing["alive"][link.robots]]
        self.slots["status"][robots] = FAILED
        self.timing["asks"][robots] = 1
        self._lost |= dict.fromkeys(robots.tolist(), reason)

    def dismiss(self, *, everyone: bool = False) -> None:
        """Dismiss the hosts whose programs have all ended, or all hosts at the end of the run."""
        alive = self.timing["alive"].tobytes()
        if alive == self._last_alive and not everyone:
            return  # no program has begun or ended since
        self._last_alive = alive if all(link.has_run for link in self.links) else b""
        for link in self.links:
            if link.ended:
                continue
            runs = bool(self.timing["alive"][link.selection].any())
            if everyone or (link.has_run and not runs):
                outcomes = [self.outcome(robot) for robot in link.robots.tolist()]
                self._try(link, link.end, outcomes)

    def close(self) -> None:
        """Close all connections."""
        for link in self.links:
            link.close()

    # -- the programs' state ---------------------------------------------------------------------

    def snapshot(self, robot: int) -> Snapshot:
        """Return the whole state of one robot's program; the memories of all are fetched at once.

        If its host is lost and not replaced, this has the memory that was last fetched.
        """
        unknown = [link for link in self.links if not link.is_saved]
        for ask in (HostLink.request_memories, HostLink.receive_memories):
            for link in unknown:
                self._try(link, ask, link)
        link = self.link(robot)
        slot = self.slots[robot : robot + 1].copy()
        for name in STOP_FIELDS:
            slot[name] = 0
        return Snapshot(slot, *link.memories()[link.position(robot)])

    def link(self, robot: int) -> HostLink:
        """Return the host of a robot."""
        return next(link for link in self.links if robot in link.robots)

    def restore(self, _robot: int, _snapshot: Snapshot) -> None:
        """Raise ValueError: a run on hosts goes forward only."""
        raise ValueError("a run whose programs are on other hosts cannot be rewound")

    def report(self, robot: int) -> ErrorReport:
        """Return the error report of a program, which its host has made."""
        from crs_cc.runtime.diagnosis.report import ErrorReport

        link = self.link(robot)
        found = link.reports.get(link.position(robot))
        if found is not None:
            return found
        reason = self._lost.get(robot, "its host has not reported why")
        return ErrorReport("host lost", Location(self.executable(robot).name), reason)

    def current_call(self, robot: int) -> ActiveCall | None:
        """Return None: only the host knows."""

    def library_call(self, robot: int) -> ActiveCall | None:
        """Return None: only the host knows."""

    def lost_blocks(self, _robot: int) -> tuple[LostBlocks, ...]:
        """Return nothing: the host reports them."""
        return ()

    def compared_pointers(self, robot: int) -> ComparedPointers | None:
        """Return None: the host reports them."""
