"""Run C programs in worlds, for tests from the perspective of a user of the library.

>>> done = drive("connect_robot(1); pr(100, 100, 0); ws(1, 1, 0, 10);")
>>> round(done.x_in[-1], 3), done.status
(10.0, 0)
"""

from __future__ import annotations

import atexit
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.core.units import m_to_inch
from crs_cc.frontend.preprocess.options import Dialect
from crs_cc.session.build import build_executable
from crs_cc.session.host import Client
from crs_cc.session.session import Session
from crs_cc.sim.engine.step import Step
from crs_cc.sim.files.world_xml import SCOUT, parse_world

HEADERS = ("stdio", "stdlib", "string", "math", "unistd", "sys/time", "crs")

OPEN = '<robot x="0" y="0"/>'
"""A Scout with nothing around it."""


class Drive:
    """A run of C programs to its end.

    Attributes:
        session: the session as it was at the end.
        output: the standard output of each robot.
        errors: the standard error output of each robot.
        steps: the record of each timestep.
        x_in: true x of the first robot after each timestep [in], world frame.
        y_in: its y.
        heading_deg: its heading, 0 to 360.
    """

    session: Session

    def __init__(self, count: int) -> None:
        self.output = [""] * count
        self.errors = [""] * count
        self.steps: list[Step] = []
        self.x_in: list[float] = []
        self.y_in: list[float] = []
        self.heading_deg: list[float] = []

    def step(self, step: Step) -> None:
        state = self.session.environment.state
        self.steps.append(step)
        self.x_in.append(float(m_to_inch(state.x_m[0])))
        self.y_in.append(float(m_to_inch(state.y_m[0])))
        self.heading_deg.append(float(state.heading_rad[0]) * 57.29577951308232)

    def write(self, robot: int, stream: int, content: bytes) -> None:
        written = self.output if stream == 1 else self.errors
        written[robot] += content.decode()

    @property
    def status(self) -> int | None:
        """Return the exit status of the first robot's program."""
        return self.session.result().robots[0].exit_status

    @property
    def numbers(self) -> list[float]:
        """Return the numbers that the first robot printed, separated by white space."""
        return [float(word) for word in self.output[0].split()]


def drive(
    *programs: str,
    elements: str = OPEN,
    area: str = 'length="2000in" width="2000in" origin="centre" edge="0"',
    timestep: str = "50ms",
    seconds: float = 60.0,
    seed: int = 0,
    setup: str = "",
    robot: str = SCOUT,
    client: Client = "nclient",
    arguments: Sequence[Sequence[str]] = (),
    dialect: Dialect | None = None,
) -> Drive:
    """Run programs to their end, one in each robot, or the same in all.

    Args:
        programs: whole C programs, or just the body of `main`; in the report's dialect any.
        elements: the elements of the world.
        area: the attributes of its area.
        timestep: its timestep.
        seconds: maximum duration of the run.
        seed: the random seed.
        setup: the robots' setup.
        robot: the default model of robots, or the path of a definition.
        client: which of the vendor's client libraries to emulate.
        arguments: `argv` of each robot.
        dialect: the dialect of the programs; detected by default.
    """
    text = f'<world version="1" timestep="{timestep}"><area {area}/>{elements}</world>'
    world = parse_world(text.encode(), "test", setup, robot)
    built = [_build(source, dialect) for source in programs]
    executables = built if len(built) == len(world.robots) else built * len(world.robots)
    done = Drive(len(executables))
    done.session = Session(
        world,
        executables,
        seed,
        arguments=arguments,
        output=done.write,
        client=client,
        trace=done,
    )
    while done.session.step() and done.session.time_s < seconds - 1e-9:
        pass
    done.session.close()
    return done


@cache
def _build(source: str, dialect: Dialect | None):
    """Build a program, once for all worlds that it is run in."""
    if dialect != "report" and "main" not in source and "runcode" not in source:
        includes = "\n".join(f"#include <{name}.h>" for name in HEADERS)
        source = f'{includes}\n#include "Nclient.h"\nint main(void)\n{{\n{source}\nreturn 0;\n}}\n'
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "program.c"
        path.write_text(source)
        return build_executable([path], Diagnostics(), dialect=dialect)


atexit.register(_build.cache_clear)  # while wasmtime can still free what it made
