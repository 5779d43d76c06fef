"""Calm timesteps that have passed at once, for observers: see `engine/calm_time.py`.

In them nothing was touched, no message was sent, no robot joined or left, and no event was logged.
Programs asked for nothing but what kernels answer, each time with `State`.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crs_cc.core.arrays import FloatArray, Records
from crs_cc.sim.engine.step import Served
from crs_cc.sim.kernels.calm import ANSWER, FRAME


@dataclass(slots=True)  # not frozen: one is made in half the time
class Passage:
    """Calm timesteps, one after the other.

    Attributes:
        first: the number of the first one.
        count: how many.
        timestep_s: the length of each [s].
        moved: the bytes of `frames`.
        logged: the bytes of the answers that the kernel has logged, of dtype `kernels.calm.ANSWER`.
        earlier: what was answered in the first timestep before that, by other means.
    """

    first: int
    count: int
    timestep_s: float
    moved: bytes
    logged: bytes
    earlier: Sequence[Served]

    @property
    def cycles(self) -> range:
        """The numbers of the timesteps."""
        return range(self.first, self.first + self.count)

    @property
    def frames(self) -> FloatArray:
        """Where each robot is at the end of each timestep, (timesteps, robots, 7).

        x, y [m], heading, turret [rad]; then x, y [m], heading [rad] as its odometry has it.
        """
        return np.frombuffer(self.moved).reshape(self.count, -1, FRAME)

    @property
    def answers(self) -> Records:
        """What was answered in them, in order, of dtype `kernels.calm.ANSWER`."""
        logged = np.frombuffer(self.logged, ANSWER)
        return np.concatenate([_answers_of(self.earlier, self.first), logged])

    def served(self, cycle: int) -> tuple[Served, ...]:
        """Return the replies of a timestep, in the form of `Step.served`."""
        answers = self.answers
        return tuple(served_of(answers[answers["cycle"] == cycle]))


def served_of(answers: Records) -> list[Served]:
    """Return logged answers by requests that were answered together."""
    batches = answers["batch"]
    ends = (batches[1:] != batches[:-1]).nonzero()[0] + 1
    bounds = itertools.pairwise([0, *ends.tolist(), len(answers)])
    return [_served(answers[begin:end]) for begin, end in bounds if end]


def _answers_of(served: Sequence[Served], cycle: int) -> Records:
    """Return the replies of a timestep that the kernel did not give, each with `State`."""
    answers = np.zeros(sum(len(each.robots) for each in served), ANSWER)
    answers["cycle"], begin = cycle, 0
    for number, each in enumerate(served, -len(served)):
        rows = answers[begin : begin + len(each.robots)]
        rows["batch"], rows["code"], rows["robot"] = number, each.code, each.robots
        rows["clock_s"], rows["result"] = each.clock_s, each.results
        rows["arguments"], rows["state"] = each.arguments, each.states
        begin += len(rows)
    return answers


def _served(some: Records) -> Served:
    return Served(
        code=int(some["code"][0]),
        robots=some["robot"].astype(np.intp),
        clock_s=some["clock_s"].copy(),
        arguments=some["arguments"].copy(),
        results=some["result"].copy(),
        states=some["state"].copy(),
    )
