"""The `State` vectors sent to programs, as they are collected during a run."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.recording.columns import Columns, Part
from crs_cc.recording.mcap_records import ENDLESS_S, NS
from crs_cc.recording.readings import STATE, Readings
from crs_cc.sim.kernels import calm

if TYPE_CHECKING:
    from crs_cc.core.arrays import Records
    from crs_cc.sim.engine.step import Served

ANSWER: Final = np.dtype(
    [("clock_s", "<f8"), ("code", "<i4"), ("robot", "<i4"), ("state", "<i4", (STATE,))]
)
"""The stored part of an answer in a passage of timesteps: its first fields."""

_CODE: Final = 4  # bytes
_VECTOR: Final = 4 * STATE


class ReadingBuffer:
    """Answers with a `State` vector.

    Attributes:
        count: their number.
        single: code, robot, clock [s] and vector of the answers in single timesteps.
        passed: the answers in settled passages of timesteps.
    """

    def __init__(self) -> None:
        """Create an empty buffer."""
        self.count = 0
        self.single = Columns(_CODE, 8, 8, _VECTOR)
        self.passed = Columns(ANSWER.itemsize)
        self._logged: list[
            tuple[int, bytes]
        ] = []  # of later passages, each after a number of singles

    def add(self, answers: Iterable[Served]) -> None:
        """Add those answers that have vectors."""
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
        self.count += len(answers) // calm.ANSWER.itemsize
        self._logged.append((len(self.single), answers))

    def settle(self) -> None:
        """Move the answers in passages to `passed`."""
        logged = b"".join([answers for _, answers in self._logged])
        rows = np.frombuffer(logged, np.uint8).reshape(-1, calm.ANSWER.itemsize)
        self.passed.append(rows[:, : ANSWER.itemsize].tobytes())
        self._logged.clear()

    def rows(self) -> tuple[int, Readings]:
        """Return the answers, at least one, and a time not after any of them [ns].

        Their order does not depend on when passages were settled.

        Raises:
            ValueError: they are not valid.
        """
        if self._logged and not len(self.passed):
            rows = self._in_order()
            if (rows.clock_s[1:] > rows.clock_s[:-1]).all():  # as of one robot
                return _begin_ns(rows), rows
        self.settle()
        rows = self._singles()
        if not len(self.passed):
            return _begin_ns(rows), rows
        passed = _readings(np.frombuffer(self.passed.content()[0], ANSWER))
        columns: Iterator[Any] = zip(rows, passed, strict=True)
        rows = Readings(*(np.concatenate(each) for each in columns))
        return _begin_ns(rows), rows.of(np.argsort(rows.clock_s, kind="stable"))

    def _singles(self) -> Readings:
        codes, robots, clocks, vectors = self.single.content()
        return Readings(
            np.frombuffer(codes, "<i4"),
            np.frombuffer(robots, np.intp),
            np.frombuffer(clocks, "<f8"),
            np.frombuffer(vectors, "<i4").reshape(-1, STATE),
        )

    def _in_order(self) -> Readings:
        """Return all answers as they were added, none of which is settled."""
        single = self._singles()
        records = np.zeros(len(single.robots), calm.ANSWER)
        records["code"], records["robot"] = single.codes, single.robots
        records["clock_s"], records["state"] = single.clock_s, single.states
        content, done, parts = memoryview(records.tobytes()), 0, list[Part]()
        for count, answers in self._logged:
            end = count * calm.ANSWER.itemsize
            parts += (content[done:end], answers)
            done = end
        return _readings(np.frombuffer(b"".join([*parts, content[done:]]), calm.ANSWER))


def _readings(records: Records) -> Readings:
    robots, clock_s = records["robot"].astype(np.intp), records["clock_s"].copy()
    return Readings(records["code"], robots, clock_s, records["state"])


def _begin_ns(rows: Readings) -> int:
    """Return a time not after any reading [ns]; raise ValueError if one is not valid."""
    is_valid = (rows.clock_s >= 0.0) & (rows.clock_s < ENDLESS_S)
    if not is_valid.all() or rows.robots.min() < 0:
        raise ValueError("a reading is not valid")
    return int(rows.clock_s.min() * NS)
