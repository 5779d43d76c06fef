"""A run of a sample program to its end, and what there is to say of it."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Dialect
from crs_cc.session.build import build_executable
from crs_cc.session.result import RobotResult
from crs_cc.session.session import Session
from crs_cc.sim.engine.passage import Passage
from crs_cc.sim.engine.step import Step
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import WorldModel

ROOT = Path(__file__).parents[2]
SAMPLES = ROOT / "samples" / "scout_c"
WORLDS = ROOT / "worlds"
INCH_M = 0.0254

FloatArray = npt.NDArray[np.float64]


class Places:
    """Observes where the robots are after each timestep, also of those that pass at once."""

    def __init__(self) -> None:
        self._pieces: list[FloatArray] = []
        self._seen = 0  # timesteps

    def follow(self, session: Session) -> None:
        """Set the session that is observed, before it runs."""
        self._session = session
        self._last = self._now()

    def step(self, step: Step) -> None:
        """Note the places after a timestep."""
        self._rest_until(step.cycle)
        self._add(self._now())

    def passed(self, passage: Passage) -> None:
        """Note the places after each timestep of a passage."""
        self._rest_until(passage.first)
        self._add(passage.frames[:, :, :2])

    def until(self, timestep: int) -> FloatArray:
        """Return the places after all timesteps, shape (timesteps, robots, 2)."""
        self._rest_until(timestep)
        return np.concatenate(self._pieces)

    def _rest_until(self, timestep: int) -> None:
        """Add the timesteps in which nothing has happened, of which no observer is told."""
        if timestep > self._seen:
            self._add(np.repeat(self._last, timestep - self._seen, axis=0))

    def _add(self, places: FloatArray) -> None:
        self._pieces.append(places)
        self._seen, self._last = self._seen + len(places), places[-1:]

    def _now(self) -> FloatArray:
        state = self._session.environment.state
        return np.column_stack([state.x_m, state.y_m])[None]


class Drive:
    """A run of one sample to its end.

    Attributes:
        output: what the programs printed, robot after robot.
        files: what it wrote, by name.
        paths: x and y of the robots after each timestep [m], shape (timesteps, robots, 2).
        robots: the results.
        goals: what has become of the world's goals.
        state_hash: of the state in which it ends.
        hints: what is doubtful about its robot calls.
        objects: x, y [m] and heading [rad] of what can be pushed, at the end, by name.
    """

    def __init__(
        self,
        program: Sequence[str],
        world: WorldModel,
        *,
        arguments: Sequence[str] = (),
        files: Mapping[str, bytes] | None = None,
        standard: str = "gnu17",
        dialect: Dialect | None = None,
        longest_s: float = 300.0,
        calmly: bool = True,
    ) -> None:
        """Run it.

        Args:
            program: its C files, below `samples/scout_c`; robots for which the world names a
                program run that.
            world: where.
            arguments: what `main` finds behind its name, where the world names neither arguments
                nor a program.
            files: what it can read, by name.
            standard: the C that it is written in.
            dialect: whose functions it calls; by default what it looks like.
            longest_s: when to stop it [s].
            calmly: run timesteps at once where that can be done, as `crs run` does.
        """
        self._outputs = [bytearray() for _ in world.robots]
        own = tuple(SAMPLES / name for name in program)
        programs = [(Path(robot.program),) if robot.program else own for robot in world.robots]
        built = {
            paths: build_executable(paths, Diagnostics(), standard=standard, dialect=dialect)
            for paths in dict.fromkeys(programs)
        }
        seen = Places()
        session = Session(
            world,
            [built[paths] for paths in programs],
            arguments=[
                [paths[0].stem, *(robot.arguments or (() if robot.program else arguments))]
                for robot, paths in zip(world.robots, programs, strict=True)
            ],
            output=self._write,
            files=files,
            observer=seen,
        )
        seen.follow(session)
        last = math.ceil(longest_s / world.timestep_s)
        running = True
        while running and session.timesteps < last:
            most = last - session.timesteps if calmly else 1
            running = session.advance(most, calmly=calmly)
        session.close()
        self.paths = seen.until(session.timesteps)
        self.state_hash = session.state_hash()
        self.hints = session.hints
        self.robots: tuple[RobotResult, ...] = session.result().robots
        self.goals = session.goals
        self.output = b"".join(self._outputs)
        bodies, pushables = session.environment.state.bodies, Scene(world).pushables
        poses = np.column_stack([bodies.position_m, bodies.angle_rad])[len(world.robots) :]
        names = [obj.id for obj in pushables]
        self.objects = dict(zip(names, poses.tolist(), strict=True))
        self.files = {name.decode(): content for name, content in session.files(0).items()}

    def _write(self, robot: int, stream: int, content: bytes) -> None:
        if stream == 1:
            self._outputs[robot] += content

    @property
    def text(self) -> str:
        """Return what the program printed."""
        return self.output.decode()

    @property
    def robot(self) -> RobotResult:
        """Return the result of the first robot."""
        return self.robots[0]

    @property
    def places(self) -> FloatArray:
        """Return where the first robot was after each timestep [m], shape (timesteps, 2)."""
        return np.asarray(self.paths[:, 0])

    def numbers(self, pattern: str) -> list[float]:
        """Return the groups of the only place in the output that looks like a pattern."""
        (found,) = re.finditer(pattern, self.text)
        return [float(group) for group in found.groups()]

    def squares(self, side_m: float) -> int:
        """Return how many squares of the floor the robot has been in."""
        return len({tuple(place) for place in (self.places // side_m).tolist()})
