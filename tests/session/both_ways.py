"""Runs with and without calm time, which are to be the same in all that anybody could notice."""

from __future__ import annotations

import random
from dataclasses import dataclass, field

import numpy as np

from crs_cc.runtime.executable import Executable
from crs_cc.session.result import RunResult
from crs_cc.session.session import Session
from crs_cc.sim.engine.passage import Passage
from crs_cc.sim.engine.step import Served, Step
from crs_cc.sim.kernels.calm import FRAME
from crs_cc.sim.model.world import WorldModel

FIRST_ARGUMENT = 1000  # seeds, or how long to wander


@dataclass
class Observer:
    """Keeps what it hears of: each answer, where robots are."""

    told: list[tuple[object, ...]] = field(default_factory=list)
    passed_over: int = 0

    def step(self, step: Step) -> None:
        self.hear(step.cycle, step.served)

    def hear(self, cycle: int, answers: tuple[Served, ...]) -> None:
        for each in answers:
            states = None if each.states is None else each.states.tolist()
            told = each.robots, each.clock_s, each.arguments, each.results
            types = [array.dtype for array in told]
            self.told.append((cycle, each.code, states, types, *(one.tolist() for one in told)))


class CalmObserver(Observer):
    """The same, of calm timesteps at once."""

    def __init__(self) -> None:
        super().__init__()
        self.frames: dict[int, np.ndarray] = {}

    def passed(self, passage: Passage) -> None:
        self.passed_over += len(passage.frames)
        assert passage.frames.shape[2] == FRAME
        for cycle, frame in zip(passage.cycles, passage.frames, strict=True):
            self.hear(cycle, passage.served(cycle))
            self.frames[cycle + 1] = frame


def start(
    world: WorldModel, programs: list[Executable], observer: Observer
) -> tuple[Session, list[tuple[int, int, bytes]]]:
    written: list[tuple[int, int, bytes]] = []
    arguments = [["program", str(robot + FIRST_ARGUMENT)] for robot in range(len(programs))]
    session = Session(
        world, programs, 5, arguments=arguments, output=lambda *piece: written.append(piece),
        threads=1, observer=observer,
    )  # fmt: skip
    return session, written


def frame_of(session: Session) -> np.ndarray:
    """Return a frame as a passage has it."""
    state = session.environment.last_state
    odometry, bodies = state.odometry, state.bodies.position_m[: len(state.heading_rad)]
    believed = odometry.x_m, odometry.y_m, odometry.heading_rad
    return np.column_stack([bodies, state.heading_rad, state.drive.turret_rad, *believed])


def looks(steps: int) -> list[int]:
    """Return timesteps at random distances, and the last."""
    dice, found = random.Random(steps), [0]
    while found[-1] < steps:
        found.append(min(steps, found[-1] + dice.randint(1, 40)))
    return found[1:]


def compare(world: WorldModel, programs: list[Executable], steps: int) -> int:
    """Compare runs; return the number of timesteps that have passed calmly."""
    return compare_results(world, programs, steps)[0]


def compare_results(
    world: WorldModel, programs: list[Executable], steps: int
) -> tuple[int, RunResult]:
    """Compare runs; return the number of timesteps that have passed calmly, and the result."""
    session, written = start(world, programs, Observer())
    session.calm.is_allowed = False
    hashes, frames, goes_on = {}, [frame_of(session)], True
    places = looks(steps)
    while goes_on and session.timesteps < steps:
        goes_on = session.step()
        frames.append(frame_of(session))
        if session.timesteps in places or not goes_on:
            hashes[session.timesteps] = session.state_hash()
    plain, calm = session, CalmObserver()
    for observer in (Observer(), calm):
        dice = random.Random(steps)
        session, again = start(world, programs, observer)
        for look, state_hash in hashes.items():
            while session.timesteps < look:
                session.advance(look - session.timesteps, calmly=dice.random() < 0.8)
            assert session.state_hash() == state_hash, look
            assert session.state.rounds == 0
            if dice.random() < 0.2:
                session.restore(session.snapshot())
        assert again == written
        assert session.result() == plain.result()
        assert session.hints == plain.hints
        assert observer.told == plain._observer.told
    assert all((frames[at] == frame).all() for at, frame in calm.frames.items())
    return calm.passed_over, plain.result()
