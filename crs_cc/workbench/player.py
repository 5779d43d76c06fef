"""Play and pause, speed, and the loop of a span: when the run may continue, and how far.

Whoever runs it asks before each piece how many timesteps it may take; the player waits as long as
the user wants, and carries out what pages ask for meanwhile. All of that happens in the thread of
the run.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from queue import Empty, SimpleQueue
from typing import Final

PIECE_S: Final = 0.03
"""Real time that a piece takes at most, about: so soon does the run answer."""

MIN_SPEED, MAX_SPEED = 0.01, 1000.0
_LAG_S: Final = 0.25
_MAX_TIMESTEPS: Final = 1000
_RATE_S: Final = 0.5
_SLACK: Final = 1e-6
_LOOK_S: Final = 0.2

Job = Callable[[], None]


def _never() -> bool:
    return False


def _always() -> bool:
    return True


class Player:
    """Decides when a run advances.

    Attributes:
        is_playing: whether the run continues.
        speed: simulated by real time; infinite for as fast as possible.
        rate: what it has been lately.
        span: the times [s] between which it is repeated; None for no loop.
        has_ended: returns whether the run is to end.
    """

    def __init__(self, timestep_s: float, *, speed: float = 1.0) -> None:
        self.is_playing = False
        self.speed = speed
        self.rate = 0.0
        self.span: tuple[float, float] | None = None
        self.has_ended: Callable[[], bool] = _never
        self._timestep_s = timestep_s
        self._jobs: SimpleQueue[Job] = SimpleQueue()
        self._started: tuple[float, float] | None = None  # real and simulated time
        self._cost_s = 0.0  # real time of a timestep
        self._asked: tuple[float, float, int] | None = None
        self._measured = (0.0, 0.0)

    def submit(self, job: Job) -> None:
        """Schedule a job between two pieces; thread-safe."""
        self._jobs.put(job)

    @property
    def has_jobs(self) -> bool:
        """Whether something waits to be done between two pieces; thread-safe."""
        return not self._jobs.empty()

    def end(self) -> None:
        """End the run; thread-safe."""
        self.has_ended = _always
        self._jobs.put(lambda: None)

    def play(self) -> None:
        """Resume the run."""
        self.is_playing = True
        self.restart()

    def pause(self) -> None:
        """Pause the run."""
        self.is_playing = False
        self.rate = 0.0

    def set_speed(self, speed: float) -> None:
        """Change the speed; infinite for as fast as possible."""
        self.speed = speed
        self.restart()

    def restart(self) -> None:
        """Restart the measurement of time: the run has been moved."""
        self._started = self._asked = None

    def timesteps(self, now_s: Callable[[], float]) -> int:
        """Wait until the run may continue, and return the number of timesteps; 0 at its end.

        Args:
            now_s: returns the simulated time, which what is done meanwhile may change.
        """
        self._measure(now_s())
        while True:
            self._run_jobs(wait_s=0.0)
            if self.has_ended():
                return 0
            if not self.is_playing:
                self._run_jobs(wait_s=None if self.has_ended is _never else _LOOK_S)
                continue
            count = self._due(now_s())
            if count >= 1:
                self._asked = time.monotonic(), now_s(), count
                return count
            self._run_jobs(wait_s=min(0.02, self._timestep_s / self.speed))

    def _due(self, now_s: float) -> int:
        """Return the number of timesteps that may be run now."""
        most = min(_MAX_TIMESTEPS, max(1, int(PIECE_S / self._cost_s))) if self._cost_s else 1
        if math.isinf(self.speed):
            return most
        real_s = time.monotonic()
        if self._started is None:
            self._started = real_s, now_s
            return 1
        due_s = self._started[1] + (real_s - self._started[0]) * self.speed - now_s
        if due_s > _LAG_S * self.speed + self._timestep_s:  # it cannot keep up
            self._started = real_s - (_LAG_S / 2), now_s
        return min(most, int(due_s / self._timestep_s + _SLACK))

    def _measure(self, now_s: float) -> None:
        """Record the time of the last piece."""
        if self._asked is None:
            self._measured = time.monotonic(), now_s
            return
        begun_s, _, count = self._asked
        real_s = time.monotonic()
        self._asked = None
        cost_s = (real_s - begun_s) / count
        self._cost_s = cost_s if not self._cost_s else 0.7 * self._cost_s + 0.3 * cost_s
        before_s, simulated_s = self._measured
        if real_s - before_s >= _RATE_S:
            self.rate = max(0.0, now_s - simulated_s) / (real_s - before_s)
            self._measured = real_s, now_s

    def _run_jobs(self, wait_s: float | None) -> None:
        """Execute pending jobs; first wait for one, with or without a timeout."""
        try:
            job = self._jobs.get(timeout=wait_s) if wait_s != 0.0 else self._jobs.get_nowait()
            while True:
                job()
                job = self._jobs.get_nowait()
        except Empty:
            return
