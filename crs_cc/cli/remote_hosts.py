"""A run of `crs serve` whose programs are on other hosts."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from crs_cc.cli.messages import say
from crs_cc.cli.typed_input import OwnInput
from crs_cc.core.errors import CrsError
from crs_cc.core.time_grid import ROUNDING_S
from crs_cc.debug.timeline.change import Change
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.world.run_edits import edit_run
from crs_cc.net.host_link import HOST_LOST, HostGoneError, HostLink
from crs_cc.net.remote_fleet import RemoteFleet
from crs_cc.requests import FAILED

if TYPE_CHECKING:
    from crs_cc.cli.own_hosts import OwnHosts
    from crs_cc.cli.resumption import Resumption
    from crs_cc.net.channel import Channel
    from crs_cc.net.cluster_hosts import ClusterHosts
    from crs_cc.net.host_registry import Assignment, HostRegistry
    from crs_cc.runtime.executable import Executable
    from crs_cc.session.session import Session
    from crs_cc.workbench.server import Front

NOBODY: Final[Mapping[str, float]] = MappingProxyType({})
_SHOWN: Final = 5


class RemoteHosts:
    """The hosts of a run.

    Attributes:
        fleet: the programs.
        front: where pages connect; None for nowhere.
        on_waiting: is called repeatedly with the names of the robots whose hosts the run waits for,
            as text, and with an empty text when it continues.
    """

    def __init__(
        self,
        registry: HostRegistry,
        assignments: Sequence[Assignment],
        robots: Sequence[str],
        executables: Sequence[Executable],
        *,
        waits: bool,
        own: OwnHosts | None = None,
        front: Front | None,
        resumption: Resumption | None = None,
        hosts: ClusterHosts | None = None,
        late: Mapping[str, float] = NOBODY,
    ) -> None:
        """Take the hosts that are ready.

        Args:
            registry: the assignment of robots to hosts.
            assignments: the hosts that are ready.
            robots: the robots' names.
            executables: the names of their programs.
            waits: whether the run waits for another host in place of one that is lost.
            own: runs the programs of lost hosts here; None if that is not wanted.
            front: where pages connect; None for nowhere.
            resumption: what is known of the first part of the run.
            hosts: what starts hosts again on a cluster, which have no streams of their own: these
                are ours; None for hosts that users start.
            late: robots that have no host, with their times to join at the earliest [s].
        """
        self._registry, self._waits, self.front = registry, waits, front
        self._resumption, self._hosts, self._own = resumption, hosts, own
        self._input: OwnInput | None = OwnInput() if hosts else None
        self._is_interrupted: Callable[[], bool] = lambda: False
        self.on_waiting: Callable[[str], None] = lambda _names: None
        self._assignments = {assignment.names: assignment for assignment in assignments}
        self._stopped: list[str] = []  # robots whose programs have just stopped with their host
        self._numbers = {name: number for number, name in enumerate(robots)}
        self._late = dict(late)
        self.fleet = RemoteFleet(
            executables, [self._link(assignment) for assignment in assignments]
        )
        self.fleet.outcome = self._outcome

    def _link(self, assignment: Assignment) -> HostLink:
        """Return the connection to a host that is ready."""
        import numpy as np

        numbers = np.array([self._numbers[name] for name in assignment.names], np.intp)
        channel = self._registry.wait_for_channel(assignment, lambda: False)
        assert channel is not None
        return HostLink(assignment.names, numbers, channel, self._replace)

    def begin(self, session: Session, is_interrupted: Callable[[], bool]) -> None:
        """Store the session that uses the fleet, and the interrupt check."""
        self._session, self._is_interrupted = session, is_interrupted

    @property
    def repeats_until_s(self) -> float:
        """Up to when the run is a recorded one again [s]."""
        return 0.0 if self._resumption is None else self._resumption.end_s

    @property
    def shows_output(self) -> bool:
        """Return whether hosts show what programs print, or did before the run was resumed."""
        return self._hosts is None or self._session.time_s < self.repeats_until_s

    def read(self, robot: int, wanted: int) -> bytes:
        """Return standard input of a robot's host, or of this process."""
        if self._resumption is not None and self._session.time_s < self._resumption.end_s:
            return self._resumption.given.read(robot, wanted)
        if self._input is not None:
            return self._input.read(robot, wanted)
        return self.fleet.link(robot).read(robot, wanted, 0.0)

    def waiting(self, robot: int, clock_s: float) -> tuple[int, float]:
        """Return the available amount, and when there will be more, see `session.host`."""
        if self._resumption is not None and self._session.time_s < self._resumption.end_s:
            return self._resumption.given.waiting(robot, clock_s)
        if self._input is not None:
            return self._input.waiting(robot, clock_s)
        size, wait_s = json.loads(self.fleet.link(robot).read(robot, -1, clock_s))
        return int(size), float("inf") if wait_s is None else float(wait_s)

    def timesteps_left(self) -> int | None:
        """Return the number of timesteps before the next `check_resumption`; None for no limit."""
        return None if self._resumption is None else self._resumption.timesteps_left(self._session)

    def check_resumption(self) -> None:
        """Compare a resumed run with its recording, between two timesteps.

        Raises:
            ReplayMismatch: it is resumed, and takes another course.
        """
        if self._resumption is not None:
            self._resumption.compare(self._session)

    def change(self, made: Callable[[Change], None]) -> None:
        """Repeat the recorded changes of a resumed run, and hold robots without a host.

        These are those whose programs have stopped with their host.

        Args:
            made: is called with each change of the run.

        Raises:
            ReplayMismatch: a recorded change is not possible now.
        """
        if self._resumption is not None:
            self._resumption.change(self._session, made)
        while self._stopped:
            self._apply_change(f"hold {self._stopped.pop(0)}", made)
        if self._late:
            self._admit_robots(made)

    def _admit_robots(self, made: Callable[[Change], None]) -> None:
        """Admit robots whose hosts are connected, and delay the others."""
        now_s = self._session.time_s
        if self._resumption is None and not self._session.timesteps:
            self._apply_change(f"delay {' '.join(self._late)}", made)
        if now_s < self.repeats_until_s:
            return
        for assignment in self._registry.new_assignments():
            self._assignments[assignment.names] = assignment
            self.fleet.add_link(self._link(assignment))
            say(f"crs: {shown_names(assignment.names)}: connected")
        ready = [
            name
            for names in self._assignments
            for name in names
            if self._late.get(name, math.inf) <= now_s + ROUNDING_S
        ]
        if ready:
            self._apply_change(f"join {' '.join(ready)}", made)
        for name in ready:
            del self._late[name]

    def _apply_change(self, text: str, made: Callable[[Change], None]) -> None:
        edit_run(self._session, text)
        made(Change(Position(self._session.timesteps, 0), text))

    def close(self) -> None:
        """Dismiss all hosts: the run has ended."""
        self._registry.end()
        self.fleet.dismiss(everyone=True)
        self.fleet.close()
        if self._own is not None:
            self._own.close()

    def _replace(self, link: HostLink, reason: str) -> Channel:
        """Return a connection to another host in place of a lost one, see `host_link`."""
        names, assignment = shown_names(link.names), self._assignments[link.names]
        self._registry.mark_lost(assignment)
        lost = f"crs: {names}: {HOST_LOST} ({reason})"
        if self._own is not None and assignment.host is not None:
            say(f"{lost}; its programs continue here")
            return self._restarted(self._own, link)
        if not self._waits:
            say(f"{lost}; its programs and robots stop")
            self._stopped += link.names
            raise HostGoneError(f"{HOST_LOST}: {reason}")
        say(f"{lost}; the run waits for another one")

        def is_ended() -> bool:
            self.on_waiting(names)
            return self._is_interrupted()

        source = self._hosts or self._registry
        channel = source.wait_for_channel(assignment, is_ended)
        self.on_waiting("")
        if channel is None:
            raise HostGoneError("the run was interrupted while its host was lost")
        say(f"crs: {names}: taken over")
        return channel

    def _restarted(self, own: OwnHosts, link: HostLink) -> Channel:
        """Return a connection to a local host in place of a lost one."""
        assignment = self._assignments[link.names]
        assert assignment.program is not None
        try:
            channel = own.start(assignment.program, link.robots)
        except (CrsError, ValueError, OSError) as error:
            say(f"crs: {shown_names(link.names)}: its programs cannot run here: {error}")
            self._stopped += link.names
            raise HostGoneError(f"a host was lost, and no other can be started: {error}") from None
        self._registry.assign_locally(assignment, channel)
        return channel

    def _outcome(self, robot: int) -> object:
        """Return the result of a robot's program, as JSON for its host."""
        status = self._session.state.host.exit_status[robot]
        failed = bool(self.fleet.slots["status"][robot] == FAILED)
        return {"exit_status": status, "failed": failed}


def shown_names(robots: Sequence[str]) -> str:
    """Return names of robots as text, the first few of many."""
    return ", ".join(robots[:_SHOWN]) + (", ..." if len(robots) > _SHOWN else "")
