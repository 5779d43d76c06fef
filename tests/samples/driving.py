"""A run of a sample program to its end, and what there is to say of it."""

from __future__ import annotations

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
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import WorldModel

ROOT = Path(__file__).parents[2]
SAMPLES = ROOT / "samples" / "scout_c"
WORLDS = ROOT / "worlds"
INCH_M = 0.0254

FloatArray = npt.NDArray[np.float64]


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
        things: x, y [m] and heading [rad] of what can be pushed, at the end, by name.
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
        """
        self._outputs = [bytearray() for _ in world.robots]
        own = [SAMPLES / name for name in program]
        programs = [[Path(robot.program)] if robot.program else own for robot in world.robots]
        session = Session(
            world,
            [
                build_executable(paths, Diagnostics(), standard=standard, dialect=dialect)
                for paths in programs
            ],
            arguments=[
                [paths[0].stem, *(robot.arguments or (() if robot.program else arguments))]
                for robot, paths in zip(world.robots, programs, strict=True)
            ],
            output=self._write,
            files=files,
        )
        paths = []
        running = True
        while running and session.time_s < longest_s:
            running = session.step()
            state = session.environment.state
            paths.append(np.column_stack([state.x_m, state.y_m]))
        self.paths = np.array(paths)
        self.state_hash = session.state_hash()
        self.hints = session.hints
        self.robots: tuple[RobotResult, ...] = session.result().robots
        self.goals = session.goals
        self.output = b"".join(self._outputs)
        bodies, pushables = session.environment.state.bodies, Scene(world).pushables
        poses = np.column_stack([bodies.position_m, bodies.angle_rad])[len(world.robots) :]
        names = [thing.id for thing in pushables]
        self.things = dict(zip(names, poses.tolist(), strict=True))
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
