"""Whatever way leads to an instant of a run, forward or backward, it is the same to the byte.

Every sample is led to and fro by chance: all kinds of steps, breakpoints, watchpoints, jumps.
Wherever it comes by for a second time, state and output are what they were. In the end it is run
on, and it has all come out as in a run that nobody looked at.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from random import Random
from typing import Any

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.stop import Stop
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.run_event import RunEvent
from crs_cc.session.build import build_executable
from crs_cc.session.host import Output
from crs_cc.session.library import library_options
from crs_cc.session.session import Session
from crs_cc.sim.engine.step import Step
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import WorldModel
from tests.samples.driving import ROOT, SAMPLES
from tests.samples.test_samples import RUNS
from tests.samples.test_samples import Run as Sample

Bytes = tuple[str, bytes]
"""A hash of all state, and all output."""

TIMESTEPS = 30
"""How far the run goes: behind that, the user interrupts it."""

INSTANTS = 2000
"""As many are looked at on the way back: then the user interrupts that, too."""

MOVES = 10


@dataclass
class Trial:
    """A sample that is debugged, and what it was like at the instants where it has stopped."""

    debugger: Debugger
    chance: Random
    seen: dict[Position, Bytes] = field(default_factory=dict)

    def jump(self) -> None:
        """Go to a timestep, and on from there in the ways of a user."""
        debugger = self.debugger
        debugger.goto_timestep(self.chance.randrange(TIMESTEPS))
        self.compare()
        debugger.view.select_robot(self.chance.randrange(len(debugger.names)))
        self.watch()
        for _ in range(MOVES):
            self.move(backward=False)
        for _ in range(MOVES):
            self.move(backward=self.chance.random() < 0.7)

    def watch(self) -> None:
        """Watch something that is to be seen here, and what was watched before no longer."""
        debugger = self.debugger
        for each in debugger.stop_points.breakpoints:
            if each.watch:
                debugger.stop_points.remove(each.number)
        names = [each.name for each in (*debugger.view.variables(), *debugger.view.globals_())]
        with contextlib.suppress(DebugError, IndexError):  # nothing is to be seen
            debugger.stop_points.add_watchpoint(self.chance.choice(names), "access")

    def move(self, *, backward: bool) -> None:
        """Execute one of all moves."""
        debugger = self.debugger
        moves: list[Callable[..., Stop]] = [
            debugger.step, debugger.next, debugger.step_statement, debugger.finish,
            debugger.tick, debugger.resume,
        ]  # fmt: skip
        with contextlib.suppress(DebugError):  # nobody has called
            self.chance.choice(moves)(backward=backward)
        self.compare()

    def revisit(self) -> None:
        """Go to all instants once more, in any order."""
        positions = sorted(self.seen)
        self.chance.shuffle(positions)
        for position in positions:
            self.debugger.goto(position)
            assert self.debugger.position == position
            self.compare()

    def compare(self) -> None:
        """Compare with what was here before."""
        debugger = self.debugger
        own = (debugger.session.state_hash(), debugger.run.console.text())
        assert own == self.seen.setdefault(debugger.position, own), debugger.stop


@contextmanager
def impatient(debugger: Debugger) -> Iterator[None]:
    """Interrupt what is still running at a certain timestep, and what takes long to go back."""
    run = debugger.run
    hear, again = run._latest.step, run.replay

    def step(step: Step) -> None:
        hear(step)
        if run.session.timesteps >= TIMESTEPS:
            debugger.interrupt()

    def again_but_not_for_long(*piece: Any, **options: Any) -> Iterator[RunEvent]:
        for number, instant in enumerate(again(*piece, **options)):
            if number == INSTANTS:
                debugger.interrupt()
            yield instant

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(run._latest, "step", step)
        patch.setattr(run, "replay", again_but_not_for_long)
        yield


def place_breakpoints(debugger: Debugger, chance: Random) -> None:
    """Put breakpoints into the first program, by chance."""
    sites = debugger.run.programs[0].executable.detail().compiled.statements
    for site in chance.sample(sites, 2):
        debugger.stop_points.add_breakpoint(f"{site.location.file}:{site.location.line}")


def programs_of(sample: Sample, world: WorldModel) -> list[DebugProgram]:
    """Return each robot's program."""
    front_end = {"standard": sample.standard, "dialect": sample.dialect}
    made: dict[str, DebugProgram] = {}
    for name in {robot.program: None for robot in world.robots}:
        paths = [Path(name)] if name else [SAMPLES / each for each in sample.program()]
        executable = build_executable(paths, Diagnostics(), debug=True, **front_end)
        made[name] = DebugProgram(executable, paths, replace(library_options(), **front_end))
    return [made[robot.program] for robot in world.robots]


def run_up_to(timestep: int, write: Output, *made_of: Any, **options: Any) -> Session:
    """Return a session that nobody has debugged."""
    session = Session(*made_of, output=write, **options)
    while session.timesteps < timestep and session.step():
        pass
    return session


@pytest.mark.parametrize(
    "sample",
    [pytest.param(each, id=each.name) for each in RUNS],
)
def test_backward_and_forward_again_gives_the_same_bytes(sample: Sample) -> None:
    world = load_world(sample.world_file())
    programs = programs_of(sample, world)
    options = {
        "arguments": [
            [each.paths[0].stem, *(robot.arguments or (() if robot.program else sample.arguments))]
            for each, robot in zip(programs, world.robots, strict=True)
        ],
        "files": {name: (ROOT / name).read_bytes() for name in sample.reads},
    }
    debugger = Debugger(world, programs, **options)
    trial = Trial(debugger, Random(sample.name))
    place_breakpoints(debugger, trial.chance)
    with impatient(debugger):
        trial.jump()
        trial.revisit()
    last = max(TIMESTEPS, *(each.timestep + 1 for each in trial.seen))
    debugger.goto_timestep(last)

    outputs = [b""] * len(programs)

    def write(robot: int, stream: int, content: bytes) -> None:
        outputs[robot] += content

    whole = run_up_to(last, write, world, [each.executable for each in programs], **options)
    assert [debugger.run.console.text(robot) for robot in range(len(programs))] == outputs
    assert debugger.session.state.fuel.tolist() == whole.state.fuel.tolist()
    assert debugger.session.result() == whole.result()
