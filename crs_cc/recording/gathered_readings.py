"""The `State` vectors sent to programs, as they are collected during a run."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.recording.columns import Columns
from crs_cc.recording.mcap_records import ENDLESS_S, NS
from crs_cc.recording.readings import STATE, Readings
from crs_cc.sim.kernels import calm

if TYPE_CHECKING:
    from crs_cc.sim.engine.step import Served

ANSWER: Final = np.dtype(
    [("clock_s", "<f8"), ("code", "<i4"), ("robot", "<i4"), ("state", "<i4", (STATE,))]
)
"""What is kept of an answer in a passage of timesteps: the first fields of it."""

_CODE: Final = 4  # bytes


class GatheredReadings:
    """Answers with a `State` vector.

    Attributes:
        count: how many.
        single: code, robot, clock [s] and vector of the answers of single timesteps.
        passed: those of passages of timesteps.
    """

    def __init__(self) -> None:
        """Create one without readings."""
        self.count = 0
        self.single = Columns(_CODE, 8, 8, 4 * STATE)
        self.passed = Columns(ANSWER.itemsize)

    def add(self, answers: Iterable[Served]) -> None:
        """Add answers, of which those without vectors are left out."""
        codes, robots, clocks, vectors = self.single.content()
        for each in answers:
            states = each.states
            if states is not None:
                self.count += len(states)
                codes += each.code.to_bytes(_CODE, "little") * len(states)
                robots += each.robots.tobytes()
                clocks += each.clock_s.tobytes()
                vectors += states.tobytes()

    def add_passage(self, answers: bytes) -> None:
        """Add the answers in a passage: records of calm time, which begin with `ANSWER`."""
        rows = np.frombuffer(answers, np.uint8).reshape(-1, calm.ANSWER.itemsize)
        self.count += len(rows)
        self.passed.append(rows[:, : ANSWER.itemsize].tobytes())

    def rows(self) -> tuple[int, Readings]:
        """Return the answers, at least one, and a time not after any of them [ns].

        Raises:
            ValueError: they are not valid.
        """
        passed = np.frombuffer(self.passed.content()[0], ANSWER)
        if not len(self.single):
            rows = Readings(
                passed["code"].astype(np.int64),
                passed["robot"].astype(np.intp),
                passed["clock_s"],
                passed["state"],
            )
            return _begin_ns(rows), rows
        codes, robots, clocks, states = self.single.content()
        vectors = np.frombuffer(states, "<i4").reshape(-1, STATE)
        rows = Readings(
            np.concatenate([np.frombuffer(codes, "<i4"), passed["code"]], dtype=np.int64),
            np.concatenate([np.frombuffer(robots, np.intp), passed["robot"]], dtype=np.intp),
            np.concatenate([np.frombuffer(clocks, "<f8"), passed["clock_s"]]),
            np.concatenate([vectors, passed["state"]]),
        )
        begin_ns = _begin_ns(rows)
        if len(passed):
            rows = rows.of(np.argsort(rows.clock_s, kind="stable"))
        return begin_ns, rows


def _begin_ns(rows: Readings) -> int:
    """Return a time not after any reading [ns]; raise ValueError if one is not valid."""
    is_valid = (rows.clock_s >= 0.0) & (rows.clock_s < ENDLESS_S)
    if not is_valid.all() or rows.robots.min() < 0:
        raise ValueError("a reading is not valid")
    return int(rows.clock_s.min() * NS)
