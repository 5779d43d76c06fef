"""The assignment of robots to hosts: made when hosts connect, used by the run.

Each connection is handled in a thread of its own; the run waits in its own thread.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.core.errors import WorldError
from crs_cc.core.source import Location
from crs_cc.core.suggest import unknown
from crs_cc.net.channel import TIMEOUT_S
from crs_cc.net.handshake import Hello, RefusedError, definition_of, devices_digest, require_same
from crs_cc.net.word_kernel import ROWS

if TYPE_CHECKING:
    from crs_cc.net.channel import Channel
    from crs_cc.net.handshake import Program
    from crs_cc.sim.model.world import Robot

POLL_S: Final = 0.1
"""Interval at which a run that waits for hosts checks for interrupts [s]."""

_SHOWN: Final = 5
"""Limit of the robots listed to a host that is rejected."""

LIVENESS_POLL_S: Final = 0.02
"""Interval at which a host is checked for signs of life [s]."""


@dataclass(slots=True, eq=False)
class Assignment:
    """The robots that one host runs, and the host that has them now.

    Attributes:
        names: the robots.
        host: the name of the host; None for the environment itself.
        digest: the digest of its program.
        program: the program; None until it has been sent.
        channel: the connection; None until it is ready.
        is_offered: whether the connection waits for the run to take it.
        is_in_run: whether the run uses it, so that its robots no longer change.
    """

    names: tuple[str, ...]
    host: str | None
    digest: str
    program: Program | None = None
    channel: Channel | None = None
    is_offered: bool = False
    is_in_run: bool = False


class HostRegistry:
    """The hosts of a run, and the robots assigned to each.

    Attributes:
        has_begun: whether the run has begun, so that further hosts must have the same program.
        has_ended: whether it has ended, so that all hosts are rejected.
    """

    def __init__(self, robots: Sequence[Robot], awaited: Sequence[str] = ()) -> None:
        """Create assignments for robots.

        Args:
            robots: the robots.
            awaited: the robots whose hosts must be ready before the run begins.

        Raises:
            WorldError: there are more robots than can have programs on hosts.
        """
        if len(robots) > ROWS:
            text = f"{len(robots)} robots, but {ROWS} at most can have programs on hosts"
            raise WorldError.at(Location("<world>"), text)
        self.has_begun = self.has_ended = False
        self._awaited = tuple(awaited)
        self._definitions = {robot.id: definition_of(robot.model) for robot in robots}
        self._devices = devices_digest()
        self._assignments: list[Assignment] = []
        self._changed = threading.Condition()

    # -- for hosts, in their threads -------------------------------------------------------------

    def claim(self, hello: Hello) -> Assignment:
        """Return the assignment of a host that connects, or reconnects.

        Raises:
            RefusedError: it is rejected.
        """
        require_same("device libraries", self._devices, hello.devices)
        self._close_lost(hello)
        with self._changed:
            if self.has_ended:
                raise RefusedError("the run has ended")
            names = hello.robots or self._robots_of(hello.host) or self._free()
            for name in names:
                if name not in self._definitions:
                    raise RefusedError(unknown("robot", name[:40], list(self._definitions)))
                if hello.definition:
                    require_same(f"{name} as", self._definitions[name], hello.definition)
            if not names or len(set(names)) < len(names):
                raise RefusedError(
                    "every robot has a host already" if not names else "a robot is named twice"
                )
            return self._claim(names, hello)

    def _close_lost(self, hello: Hello) -> None:
        """Close lost connections of other hosts that have robots that a host wants.

        Nobody receives from a host that has nothing to run, as in a paused run. So this waits until
        each has sent a keep-alive message, or nothing for `TIMEOUT_S`.
        """
        with self._changed:
            others = [
                assignment.channel
                for assignment in self._assignments
                if assignment.channel is not None
                and assignment.host != hello.host
                and (not hello.robots or set(hello.robots) & set(assignment.names))
            ]
        for channel in others:
            channel.poll()  # data received from now on shows that it is alive
        silent = [(channel, channel.receive_count) for channel in others]
        end_s = time.monotonic() + TIMEOUT_S
        while silent and time.monotonic() < end_s:
            time.sleep(LIVENESS_POLL_S)
            for channel, _ in silent:
                channel.poll()
            silent = [
                each
                for each in silent
                if not each[0].is_closed and each[0].receive_count == each[1]
            ]
        for channel, _ in silent:
            channel.close()

    def _robots_of(self, host: str) -> tuple[str, ...]:
        """Return the robots of a host that reconnects; the loss may not have been noticed here."""
        return next(
            (assignment.names for assignment in self._assignments if assignment.host == host), ()
        )

    def _free(self) -> tuple[str, ...]:
        """Return the robots without a host, or those of a lost host if there are none."""
        lost = next((assignment for assignment in self._assignments if _is_lost(assignment)), None)
        taken = {name for assignment in self._assignments for name in assignment.names}
        free = tuple(name for name in self._definitions if name not in taken)
        return free or (lost.names if lost else ())

    def _claim(self, names: tuple[str, ...], hello: Hello) -> Assignment:
        order = list(self._definitions)
        names = tuple(sorted(names, key=order.index))
        for assignment in tuple(self._assignments):
            common = set(names) & set(assignment.names)
            if not common:
                continue
            if assignment.host != hello.host and not _is_lost(assignment):
                free = [name for name in self._free() if name not in common]
                hint = f" (without one: {' '.join(free[:_SHOWN])})" if free else ""
                name = min(common, key=order.index)
                raise RefusedError(f"{name} has a host already{hint}")
            if not assignment.is_in_run:
                self._assignments.remove(assignment)
                continue
            if assignment.names != names:
                text = f"{' and '.join(assignment.names)} were lost together: join them together"
                raise RefusedError(text)
            _require_program(assignment, hello)
            assignment.host = hello.host
            return assignment
        if self.has_begun:  # a recording has begun with the program that was there
            first = next(assignment for assignment in self._assignments if assignment.is_in_run)
            _require_program(first, hello)
        assignment = Assignment(names, hello.host, hello.program)
        self._assignments.append(assignment)
        return assignment

    def offer(self, assignment: Assignment, channel: Channel, program: Program | None) -> None:
        """Offer a connection to a host that is ready."""
        with self._changed:
            old, assignment.channel = assignment.channel, channel
            assignment.program = assignment.program or program
            assignment.is_offered = True
            self._changed.notify_all()
        if old is not None:
            old.close()  # the run notices, if it has not

    def awaited(self, assignment: Assignment) -> list[str]:
        """Return the robots of other hosts for which the run waits before it begins."""
        if self.has_begun:
            return []
        missing = set(self.missing()) - set(assignment.names)
        return [name for name in self._awaited if name in missing]

    def withdraw(self, assignment: Assignment, channel: Channel) -> None:
        """Remove the assignment of a host that did not become ready."""
        with self._changed:
            if (
                not assignment.is_in_run
                and assignment.channel in (None, channel)
                and assignment in self._assignments
            ):
                self._assignments.remove(assignment)

    # -- for the run, in its thread --------------------------------------------------------------

    def missing(self) -> list[str]:
        """Return the robots whose hosts are not ready."""
        with self._changed:
            ready = {
                name
                for assignment in self._assignments
                if assignment.is_offered
                for name in assignment.names
            }
            return [name for name in self._definitions if name not in ready]

    def unassigned(self, assignments: Sequence[Assignment]) -> list[str]:
        """Return the robots that none of some hosts has."""
        taken = {name for assignment in assignments for name in assignment.names}
        return [name for name in self._definitions if name not in taken]

    def wait(self) -> None:
        """Wait for a change, `POLL_S` at most."""
        with self._changed:
            self._changed.wait(POLL_S)

    def begin(self) -> list[Assignment]:
        """Begin the run; return the assignments of the hosts that are ready."""
        with self._changed:
            self.has_begun = True
            return self._offered()

    def new_assignments(self) -> list[Assignment]:
        """Return the assignments that have become ready since the last call, or `begin`."""
        with self._changed:
            return self._offered()

    def _offered(self) -> list[Assignment]:
        """Add the assignments that are ready to the run, and return them."""
        found = [
            assignment
            for assignment in self._assignments
            if assignment.is_offered and not assignment.is_in_run
        ]
        for assignment in found:
            assignment.is_in_run = True
        return found

    def wait_for_channel(
        self, assignment: Assignment, is_ended: Callable[[], bool]
    ) -> Channel | None:
        """Wait for the connection to a host; return None if the run ends first."""
        with self._changed:
            while not assignment.is_offered:
                if is_ended():
                    return None
                self._changed.wait(POLL_S)
            assignment.is_offered = False
            assert assignment.channel is not None
            return assignment.channel

    def mark_lost(self, assignment: Assignment) -> None:
        """Note that the host of an assignment is lost, so that another one may claim it."""
        with self._changed:
            if not assignment.is_offered:
                assignment.channel = None

    def assign_locally(self, assignment: Assignment, channel: Channel) -> None:
        """Transfer an assignment to the environment itself for the rest of the run."""
        with self._changed:
            old, assignment.channel = assignment.channel, channel
            assignment.host, assignment.is_offered = None, False
        if old is not None:
            old.close()

    def end(self) -> None:
        """Reject all hosts from now on."""
        with self._changed:
            self.has_ended = True


def _require_program(assignment: Assignment, hello: Hello) -> None:
    """Check that a host has the program of an assignment.

    Raises:
        RefusedError: it has another.
    """
    if assignment.digest != hello.program:
        assert assignment.program is not None
        names, program = " and ".join(assignment.names), assignment.program.name
        ours = f"the program of {names} is {program} ({_short(assignment.digest)})"
        theirs = f"the host has another one, or other arguments ({_short(hello.program)})"
        raise RefusedError(f"{ours}; {theirs}")


def _short(digest: str) -> str:
    """Return the beginning of a digest, which distinguishes programs in practice."""
    return digest[:12]


def _is_lost(assignment: Assignment) -> bool:
    """Return whether an assignment has had a host that is gone."""
    return assignment.program is not None and (
        assignment.channel is None or assignment.channel.is_closed
    )
