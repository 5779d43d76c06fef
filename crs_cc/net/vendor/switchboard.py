"""The connection between requests of outside clients and the relays of their robots.

Clients are served in a thread of their own, programs run in that of the session. A client asks for
an exchange; the relay of its robot finds the exchange's requests on its standard input, one by one,
and each reply continues it. The relay's input is recorded like that of any program, so the results
do not depend on the thread or the clock here.

Time advances by the wall clock, or by requests: then it advances only when every client has made a
request; robots without a client are not waited for.
"""

from __future__ import annotations

import math
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any, Final, Protocol, TypeAlias

from crs_cc.net.vendor.exchange import AskUser, Exchange, ReplyReader, make_request

POLL_S: Final = 0.05
"""Interval at which the wall clock and interrupts are checked, in real time [s]."""

CLIENT_TIMEOUT_S: Final = 0.5
"""How long simulated time waits for a client without requests while others have some [s]. Chosen by
us."""

MAX_LAG_S: Final = 0.25
"""A run that lags further behind real time does not catch up: its clock is restarted [s]. Chosen by
us."""

_MIN_SLEEP_S: Final = 1e-3
"""The minimum time that a relay sleeps [s]. Chosen by us."""

_ROUNDING: Final = 1e-6  # [timesteps]

Done: TypeAlias = Callable[[Any, float], None]
"""Receives the result of an exchange and its simulated time [s], in the run's thread."""


class WallClock(Protocol):
    """A clock that maps real time to simulated time."""

    def simulated_s(self) -> float:
        """Return it [s]."""

    def restart(self, simulated_s: float = 0.0) -> None:
        """Set the current simulated time [s]."""


Configuration: TypeAlias = tuple[int, int, int, int]
"""x and y [0.1 in], heading and turret [0.1 deg]."""


class Window(Protocol):
    """A view in which the user can be asked for a configuration."""

    def ask(self, robot: int, answer: Callable[[Configuration], None]) -> None:
        """Ask the user for a configuration of a robot."""

    def forget(self, robot: int) -> None:
        """Cancel the question about a robot."""


@dataclass(frozen=True, slots=True)
class _Call:
    exchange: Exchange[Any]
    done: Done
    asked_s: float


@dataclass(slots=True)
class _Line:
    """A robot's end of the switchboard."""

    robot: int
    inbox: bytearray = field(default_factory=bytearray)
    calls: deque[_Call] = field(default_factory=deque)
    call: _Call | None = None
    replies: ReplyReader = field(default_factory=ReplyReader)
    has_client: bool = False
    is_asking: bool = False
    is_leaving: bool = False
    has_ended: bool = False
    idle_since_s: float = 0.0

    is_cabled: bool = False

    @property
    def is_busy(self) -> bool:
        return (self.call is not None and not self.is_asking) or bool(self.calls)

    def is_free(self, *, set_cabled: bool) -> bool:
        return self.is_cabled == set_cabled and not (self.has_client or self.has_ended)

    def reserve(self) -> None:
        self.has_client = True
        self.idle_since_s = time.monotonic()


class Switchboard:
    """Connects relays to clients.

    Attributes:
        robots: the numbers of the robots that run a relay.
        pointing: asks the user for configurations; None without a view.
        clock: the clock; None if time advances by requests.
    """

    pointing: Window | None = None

    def __init__(
        self,
        robots: Iterable[int],
        timestep_s: float,
        clock: WallClock | None = None,
    ) -> None:
        """Create a line for each robot, without a client.

        Args:
            robots: the numbers of the robots that run a relay.
            timestep_s: the length of a timestep [s].
            clock: the clock; None if time advances by requests.
        """
        self._lines = {robot: _Line(robot) for robot in robots}
        self.robots = frozenset(self._lines)
        self._timestep_s = timestep_s
        self.clock = clock
        self._changed = threading.Condition()
        self._run_s: Callable[[int], float] = lambda _robot: 0.0
        self._must_not_wait: Callable[[], bool] = lambda: False

    # -- the run's side --------------------------------------------------------------------------

    def begin(self, clock_s: Callable[[int], float], must_not_wait: Callable[[], bool]) -> None:
        """Store the functions of the run.

        Args:
            clock_s: returns the clock of a robot's program [s].
            must_not_wait: returns whether the timestep must end without waiting for clients.
        """
        self._run_s, self._must_not_wait = clock_s, must_not_wait

    def waiting(self, robot: int, clock_s: float) -> tuple[int, float]:
        """Return how much a relay can read, and how long it sleeps, see `session.host`.

        Wait for clients while simulated time must not advance.
        """
        line = self._lines[robot]
        with self._changed:
            while True:
                self._begin_call(line)
                if line.inbox:
                    late_s = line.call.asked_s - clock_s if line.call else 0.0
                    # A run that is behind the clock answers as soon as it can.
                    is_early = _MIN_SLEEP_S <= late_s <= self._timestep_s
                    return (0, late_s) if is_early else (len(line.inbox), 0.0)
                if line.has_ended:
                    return 0, 0.0
                pause_s = self._pause_s(line, clock_s)
                if pause_s > 0.0:
                    return 0, max(pause_s, _MIN_SLEEP_S)
                self._changed.wait(min(-pause_s, POLL_S))

    def read(self, robot: int, size: int) -> bytes:
        """Return a relay's input: requests that `waiting` has announced."""
        line = self._lines[robot]
        content = bytes(line.inbox[:size])
        del line.inbox[:size]
        return content

    def reply(self, robot: int, _stream: int, content: bytes) -> None:
        """Continue the exchange of a robot with a piece of a reply that its relay has written."""
        line = self._lines.get(robot)
        if line is None or line.call is None:
            return
        reply = line.replies.add(content)
        if reply is not None:
            with self._changed:
                self._advance(line, lambda call: call.exchange.send(reply), self._run_s(robot))

    def _begin_call(self, line: _Line) -> None:
        """Begin the next exchange if there is none."""
        while line.call is None and line.calls:
            line.call = line.calls.popleft()
            self._advance(line, lambda call: next(call.exchange), line.call.asked_s)

    def _advance(self, line: _Line, go: Callable[[_Call], Any], at_s: float) -> None:
        """Advance an exchange to its next request, or to its end."""
        call = line.call
        assert call is not None
        try:
            step = go(call)
            while isinstance(step, AskUser) and (self.pointing is None or line.is_leaving):
                step = call.exchange.send(None)
            line.is_asking = isinstance(step, AskUser)
            if isinstance(step, AskUser):
                self._ask_user(line)
            else:
                line.inbox += step.encoded()
        except StopIteration as end:
            line.is_asking = False
            line.call = None
            line.idle_since_s = time.monotonic()
            call.done(end.value, at_s)

    def _ask_user(self, line: _Line) -> None:
        """Ask the user for the result of a call."""
        call = line.call

        def answer(found: Configuration) -> None:
            with self._changed:
                if line.call is call and line.is_asking:
                    at_s = self._run_s(line.robot)
                    self._advance(line, lambda call: call.exchange.send(found), at_s)

        assert self.pointing is not None
        self.pointing.ask(line.robot, answer)

    def _pause_s(self, line: _Line, clock_s: float) -> float:
        """Return how long a relay without input sleeps [s].

        If it is negative, the relay waits that long in real time and then checks again.
        """
        cycle = math.floor(clock_s / self._timestep_s + _ROUNDING)
        end_s = (cycle + 1) * self._timestep_s
        if self._must_not_wait():
            return end_s - clock_s
        lines = self._lines.values()
        others = any(each.is_busy for each in lines)
        if self.clock is not None:
            now_s = self.clock.simulated_s()
            if now_s > end_s + MAX_LAG_S:  # the run was paused, or this machine is too slow
                self.clock.restart(clock_s)
                now_s = clock_s
            if now_s >= end_s:
                return end_s - clock_s
            return max(now_s - clock_s, _MIN_SLEEP_S) if others else now_s - end_s
        held_s = line.idle_since_s + CLIENT_TIMEOUT_S - time.monotonic() if line.has_client else 0.0
        # Messages of pages are handled between timesteps.
        others |= any(each.is_asking for each in lines)
        if others and held_s <= 0.0:
            return end_s - clock_s
        return -held_s if others else -POLL_S

    # -- the clients' side -----------------------------------------------------------------------

    def reserve(self, wanted: int) -> int | None:
        """Reserve a robot for a client, and return its number.

        Args:
            wanted: the number of the robot in the order of the world, 1 for the first.

        Returns:
            that robot; if it is not free the first that is; or None.
        """
        with self._changed:
            free = [robot for robot, line in self._lines.items() if line.is_free(set_cabled=False)]
            if not free:
                return None
            robot = wanted - 1 if wanted - 1 in free else free[0]
            self._lines[robot].reserve()
            return robot

    def reserve_cabled(self, robot: int) -> bool:
        """Reserve a cabled robot for the client at its cable; return False if it is not free."""
        with self._changed:
            line = self._lines[robot]
            if not line.is_free(set_cabled=True):
                return False
            line.reserve()
            return True

    def set_cabled(self, robot: int) -> None:
        """Reserve a robot for a serial cable of its own."""
        self._lines[robot].is_cabled = True

    @property
    def has_leaving_client(self) -> bool:
        """Whether a client has disconnected whose robot will be free."""
        return any(line.is_leaving for line in self._lines.values())

    def ask(self, robot: int, exchange: Exchange[Any], done: Done) -> None:
        """Start an exchange with a robot; `done` is called with its result."""
        clock = self.clock  # the run's thread may change it
        asked_s = -math.inf if clock is None else clock.simulated_s()
        with self._changed:
            self._lines[robot].calls.append(_Call(exchange, done, asked_s))
            self._changed.notify_all()

    def release(self, robot: int, *, connected: bool = True, ends: bool = False) -> None:
        """Release a disconnected client; its robot is free once its relay has been notified.

        Args:
            robot: the robot.
            connected: whether the robot still is connected to it.
            ends: whether the robot's program ends.
        """

        def free(_value: object, _at_s: float) -> None:
            line.has_client = line.is_leaving = False
            line.has_ended |= ends

        line = self._lines[robot]
        line.is_leaving = True
        if line.is_asking and self.pointing is not None:
            self.pointing.forget(robot)
            with self._changed:
                self._advance(line, lambda call: call.exchange.send(None), 0.0)
        self.ask(robot, _disconnect() if connected else _no_request(), free)

    def close(self) -> None:
        """End all relays."""
        with self._changed:
            for line in self._lines.values():
                line.has_ended = True
            self._changed.notify_all()


def _disconnect() -> Exchange[None]:
    yield make_request("DISCONNECT", 1)


def _no_request() -> Exchange[None]:
    yield from ()
