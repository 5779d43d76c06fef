"""The connection between requests of outside clients and the relays of their robots.

Clients are served in a thread of their own, programs run in that of the session. A client asks for
an exchange; the relay of its robot finds the exchange's requests on its standard input, one by one,
and each reply continues it. What the relay is told of its input is recorded as for any program, so
neither the thread nor the clock here is part of the results.

Time goes by the wall clock, or by requests: then it stands still until every client has asked for
something, and no robot is waited for that has no client.
"""

from __future__ import annotations

import math
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any, Final, Protocol, TypeAlias

from crs_cc.net.vendor.exchange import AskUser, Exchange, ReplyReader, posted

LOOK_S: Final = 0.05
"""Real time between two looks at the wall clock and at interrupts."""

PATIENCE_S: Final = 0.5
"""How long time stands still for a client that asks for nothing, while others do; chosen by us."""

LAG_S: Final = 0.25
"""A run that is so far behind real time does not catch up: its time begins anew; chosen by us."""

_LEAST_S: Final = 1e-3
"""The shortest time that a relay sleeps; chosen by us."""

_ROUNDING: Final = 1e-6  # [timesteps]

Done: TypeAlias = Callable[[Any, float], None]
"""Is told what an exchange has come to, and at what simulated time [s]; in the run's thread."""


class WallClock(Protocol):
    """The simulated time that real time has come to."""

    def simulated_s(self) -> float:
        """Return it [s]."""

    def restart(self, simulated_s: float = 0.0) -> None:
        """Let it be this now [s]."""


Configuration: TypeAlias = tuple[int, int, int, int]
"""x and y [0.1 in], heading and turret [0.1 deg]."""


class Window(Protocol):
    """What a user looks at."""

    def ask(self, robot: int, answer: Callable[[Configuration], None]) -> None:
        """Ask him for a configuration of a robot."""

    def forget(self, robot: int) -> None:
        """Ask no more."""


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
    is_left: bool = False
    has_ended: bool = False
    idle_since_s: float = 0.0

    has_cable: bool = False

    @property
    def is_busy(self) -> bool:
        return (self.call is not None and not self.is_asking) or bool(self.calls)

    def is_free(self, *, cable: bool) -> bool:
        return self.has_cable == cable and not (self.has_client or self.has_ended)

    def take(self) -> None:
        self.has_client = True
        self.idle_since_s = time.monotonic()


class Switchboard:
    """Joins relays with clients.

    Attributes:
        robots: the numbers of the robots that run a relay.
        pointing: asks the user for configurations; None if nobody looks.
        clock: what time goes by; None if it goes by requests.
    """

    pointing: Window | None = None

    def __init__(
        self,
        robots: Iterable[int],
        timestep_s: float,
        clock: WallClock | None = None,
    ) -> None:
        """Join no relay with any client yet.

        Args:
            robots: the numbers of the robots that run a relay.
            timestep_s: the length of a timestep [s].
            clock: what time goes by; None if it goes by requests.
        """
        self._lines = {robot: _Line(robot) for robot in robots}
        self.robots = frozenset(self._lines)
        self._timestep_s = timestep_s
        self.clock = clock
        self._changed = threading.Condition()
        self._run_s: Callable[[int], float] = lambda _robot: 0.0
        self._is_in_a_hurry: Callable[[], bool] = lambda: False

    # -- the run's side --------------------------------------------------------------------------

    def begin(self, clock_s: Callable[[int], float], is_in_a_hurry: Callable[[], bool]) -> None:
        """Store the functions of the run.

        Args:
            clock_s: returns the clock of a robot's program [s].
            is_in_a_hurry: returns whether the timestep is to end, and nobody is waited for.
        """
        self._run_s, self._is_in_a_hurry = clock_s, is_in_a_hurry

    def waiting(self, robot: int, clock_s: float) -> tuple[int, float]:
        """Return what a relay can read, and for how long it is to sleep, see `session.host`.

        Wait for clients as far as time may not go on.
        """
        line = self._lines[robot]
        with self._changed:
            while True:
                self._begin_call(line)
                if line.inbox:
                    late_s = line.call.asked_s - clock_s if line.call else 0.0
                    # A run that is behind the clock answers as soon as it can.
                    is_early = _LEAST_S <= late_s <= self._timestep_s
                    return (0, late_s) if is_early else (len(line.inbox), 0.0)
                if line.has_ended:
                    return 0, 0.0
                pause_s = self._pause_s(line, clock_s)
                if pause_s > 0.0:
                    return 0, max(pause_s, _LEAST_S)
                self._changed.wait(min(-pause_s, LOOK_S))

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
        """Let an exchange post its next request, or end."""
        call = line.call
        assert call is not None
        try:
            posted = go(call)
            while isinstance(posted, AskUser) and (self.pointing is None or line.is_left):
                posted = call.exchange.send(None)
            line.is_asking = isinstance(posted, AskUser)
            if isinstance(posted, AskUser):
                self._ask_user(line)
            else:
                line.inbox += posted.encoded()
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
        """Return for how long a relay without input sleeps [s].

        If it is negative, the relay waits so long in real time and asks again.
        """
        cycle = math.floor(clock_s / self._timestep_s + _ROUNDING)
        end_s = (cycle + 1) * self._timestep_s
        if self._is_in_a_hurry():
            return end_s - clock_s
        lines = self._lines.values()
        others = any(each.is_busy for each in lines)
        if self.clock is not None:
            now_s = self.clock.simulated_s()
            if now_s > end_s + LAG_S:  # the run was paused, or is too much for this machine
                self.clock.restart(clock_s)
                now_s = clock_s
            if now_s >= end_s:
                return end_s - clock_s
            return max(now_s - clock_s, _LEAST_S) if others else now_s - end_s
        held_s = line.idle_since_s + PATIENCE_S - time.monotonic() if line.has_client else 0.0
        others |= any(each.is_asking for each in lines)  # pages are heard between timesteps
        if others and held_s <= 0.0:
            return end_s - clock_s
        return -held_s if others else -LOOK_S

    # -- the clients' side -----------------------------------------------------------------------

    def take(self, wanted: int) -> int | None:
        """Reserve a robot for a client, and return its number.

        Args:
            wanted: the number of the robot in the order of the world, 1 for the first.

        Returns:
            that robot; if it is not free the first that is; or None.
        """
        with self._changed:
            free = [robot for robot, line in self._lines.items() if line.is_free(cable=False)]
            if not free:
                return None
            robot = wanted - 1 if wanted - 1 in free else free[0]
            self._lines[robot].take()
            return robot

    def take_cabled(self, robot: int) -> bool:
        """Reserve this robot for who is at its cable; return False if it is not free."""
        with self._changed:
            line = self._lines[robot]
            if not line.is_free(cable=True):
                return False
            line.take()
            return True

    def cable(self, robot: int) -> None:
        """Set a robot aside for a cable of its own."""
        self._lines[robot].has_cable = True

    @property
    def is_one_left(self) -> bool:
        """Return whether a client has gone whose robot will be free."""
        return any(line.is_left for line in self._lines.values())

    def ask(self, robot: int, exchange: Exchange[Any], done: Done) -> None:
        """Start an exchange with a robot; `done` is called with its result."""
        clock = self.clock  # which the run's thread may change
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
            line.has_client = line.is_left = False
            line.has_ended |= ends

        line = self._lines[robot]
        line.is_left = True
        if line.is_asking and self.pointing is not None:
            self.pointing.forget(robot)
            with self._changed:
                self._advance(line, lambda call: call.exchange.send(None), 0.0)
        self.ask(robot, _leave() if connected else _nothing(), free)

    def close(self) -> None:
        """End all relays."""
        with self._changed:
            for line in self._lines.values():
                line.has_ended = True
            self._changed.notify_all()


def _leave() -> Exchange[None]:
    yield posted("DISCONNECT", 1)


def _nothing() -> Exchange[None]:
    yield from ()
