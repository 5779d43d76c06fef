"""The speed of a run relative to real time, and its part of the progress line.

>>> Pace(math.inf).behind_s(5.0, 0.1)
0.0
>>> Pace(2.0).behind_s(5.0, 0.1)
2.4
>>> progress_text(3.0, 12.0, 1.5, "1 of 1 running")
'3.0 of 12.0 s simulated (25%), 2.0 x real time, 5 s left, 1 of 1 running'
>>> progress_text(3.0, None, 1.5, "1 of 1 running")
'3.0 s simulated, 2.0 x real time, 1 of 1 running'
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Final

LOOK_S: Final = 0.05
"""Real time between two looks at interrupts while a run waits."""


class Pace:
    """Keeps a run from going faster than some multiple of real time.

    Attributes:
        speed: the multiple; infinite for as fast as possible.
    """

    def __init__(self, speed: float) -> None:
        self.speed = speed
        self._started_s = time.monotonic()

    def behind_s(self, simulated_s: float, real_s: float) -> float:
        """Return by how much real time lags behind simulated time [s]."""
        return max(0.0, simulated_s / self.speed - real_s)

    def wait(self, simulated_s: float, is_interrupted: Callable[[], bool]) -> None:
        """Wait until real time has caught up with simulated time."""
        while not is_interrupted():
            left_s = self.behind_s(simulated_s, time.monotonic() - self._started_s)
            if left_s <= 0.0:
                return
            time.sleep(min(left_s, LOOK_S))

    def restart(self, simulated_s: float = 0.0) -> None:
        """Set the current simulated time [s]."""
        self._started_s = time.monotonic() - simulated_s / self.speed

    def simulated_s(self) -> float:
        """Return the simulated time that corresponds to the real time [s]."""
        return (time.monotonic() - self._started_s) * self.speed

    def left_s(self, simulated_s: float) -> float:
        """Return the real time until a simulated time [s]."""
        return self.behind_s(simulated_s, time.monotonic() - self._started_s)

    @property
    def is_limited(self) -> bool:
        """Return whether there is a limit."""
        return not math.isinf(self.speed)


def progress_text(simulated_s: float, end_s: float | None, real_s: float, running: str) -> str:
    """Return the progress line.

    Args:
        simulated_s: simulated time so far.
        end_s: when the run ends; None for no end.
        real_s: real time so far.
        running: how many programs run.
    """
    rate = simulated_s / max(real_s, 1e-9)
    speed = f"{rate:.1f} x real time"
    if end_s is None:
        return f"{simulated_s:.1f} s simulated, {speed}, {running}"
    percent = 100.0 * min(1.0, simulated_s / end_s)
    left_s = (end_s - simulated_s) / rate if rate > 0.0 else 0.0
    done = f"{simulated_s:.1f} of {end_s:.1f} s simulated ({percent:.0f}%)"
    return f"{done}, {speed}, {_duration_text(left_s)} left, {running}"


def _duration_text(time_s: float) -> str:
    """Return a rounded duration in words.

    >>> _duration_text(4.2), _duration_text(119.0), _duration_text(121.0), _duration_text(7300.0)
    ('5 s', '119 s', '3 min', '3 h')
    """
    if time_s < 120.0:
        return f"{math.ceil(time_s)} s"
    return f"{math.ceil(time_s / 60)} min" if time_s < 7200.0 else f"{math.ceil(time_s / 3600)} h"
