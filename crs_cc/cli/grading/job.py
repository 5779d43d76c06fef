"""One run of a submission, as plain data that is sent to a process and back.

>>> job = Job("anna", "/tmp/s", ("main.c",), "/tmp/room.xml", 3, Limits(), ())
>>> Job.from_data(job.as_data()) == job
True
>>> run = GradedRun("refused", "place_robot() is not allowed", file="main.c", line=4)
>>> GradedRun.from_data(run.as_data()) == run
True
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from typing import TYPE_CHECKING, Any, Final, Literal, Self

from crs_cc.cli.messages import printable
from crs_cc.core.file_names import displayed
from crs_cc.sim.engine.goals import GoalResult, Status

if TYPE_CHECKING:
    from crs_cc.session.host import Client, Link

Result = Literal[
    "ended",
    "compile error",
    "run-time error",
    "refused",
    "limit",
    "time out",
    "crashed",
    "invalid",
]

RESULTS: Final[dict[Result, str]] = {
    "ended": "the program ended, the time of the run was over, or all goals were decided",
    "compile error": "the source is not a valid program; no points",
    "run-time error": "the program was stopped by an error; goals that were met until then count",
    "refused": "the program calls what only the vendor's simulator has; no points",
    "limit": "the program used more than is allowed; no points",
    "time out": "the last resort, by real time, and so dependent on the machine; no points",
    "crashed": "the process of the run came to an end; no points",
    "invalid": "what was handed in is not a program; no points",
}
"""How a run can end."""

_COUNTED: Final[dict[Result, tuple[Status, ...]]] = {
    "ended": ("met", "holds"),
    "run-time error": ("met",),
}
"""The goals that count, by how a run ended; none for all others."""


@dataclass(frozen=True, slots=True)
class Limits:
    """What one run may take; all but the last three are the same on every machine.

    Attributes:
        max_time_s: simulated time; None for the world's duration, else `DEFAULT_TIME_S`.
        max_fuel: instructions of each of the submission's programs.
        max_output: bytes that the submission's programs print, together.
        max_memory: memory to compile [bytes]; that of programs is limited anyway.
        compile_s: real time to compile.
        wall_s: real time for the rest of the run.
    """

    max_time_s: float | None = None
    max_fuel: int = 2_000_000_000
    max_output: int = 1_000_000
    max_memory: int = 2**30
    compile_s: float = 60.0
    wall_s: float = 300.0


@dataclass(frozen=True, slots=True)
class Robots:
    """The robots of graded runs, as of `crs run`.

    Attributes:
        robot: the default robot model: a name, or the absolute path of a definition file.
        setup: the setup of all robots; empty for the world's.
        link: `serial` to simulate the serial link's delay, `ideal` for none.
        client: which of the vendor's client libraries to emulate.
    """

    robot: str = "scout"
    setup: str = ""
    link: Link = "serial"
    client: Client = "nclient"


_MAX_TEXT: Final = 300
DEFAULT_TIME_S: Final = 120.0


@dataclass(frozen=True, slots=True)
class Job:
    """A run to be graded.

    Attributes:
        name: the name of the submission for people.
        folder: the copy of the submission, in which it is compiled.
        sources: its C files, relative to the folder.
        world: the world file, an absolute path.
        seed: the random seed; None for the world's, else 0.
        limits: what it may take.
        allowed: the functions of the vendor's simulator that may be called.
        record: the file of the recording, an absolute path; empty for none.
        inputs: files that the program can read, absolute paths, by the names that it uses.
        robots: the robots, see `Robots`.
    """

    name: str
    folder: str
    sources: tuple[str, ...]
    world: str
    seed: int | None
    limits: Limits
    allowed: tuple[str, ...]
    record: str = ""
    inputs: Mapping[str, str] = field(default_factory=dict)
    robots: Robots = field(default_factory=Robots)

    def as_data(self) -> dict[str, Any]:
        """Return it as plain data for JSON."""
        return asdict(self)

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> Self:
        """Return the job that `as_data` described."""
        parts = {"limits": Limits(**data["limits"]), "robots": Robots(**data["robots"])}
        job = cls(**{**data, **parts})
        return replace(job, sources=tuple(job.sources), allowed=tuple(job.allowed))


@dataclass(frozen=True, slots=True)
class GradedRun:
    """The outcome of a run.

    Attributes:
        result: how it ended.
        message: why, if it did not just end.
        file: the submission's file that the message is about; empty for none.
        line: the line in it; 0 for none.
        goals: the status of the world's goals; empty if it has not been run.
        simulated_s: how long it ran [s].
        picture: the plot, SVG; empty if it has not been run.
        fingerprint: equal for equal programs; empty if it could not be found out.
        printed: the first lines that its programs printed.
    """

    result: Result
    message: str = ""
    file: str = ""
    line: int = 0
    goals: tuple[GoalResult, ...] = ()
    simulated_s: float = 0.0
    picture: str = ""
    fingerprint: str = ""
    printed: str = ""

    @property
    def text(self) -> str:
        """The message with its place, as one line of valid Unicode that is not too long."""
        place = f"{self.file}:{self.line}: " if self.file and self.line else ""
        text = printable(displayed(f"{place}{self.message}"))
        return text if len(text) <= _MAX_TEXT else f"{text[:_MAX_TEXT]}..."

    @property
    def earned(self) -> float:
        """The points of the goals that were met.

        A goal that lasts until the end of the run counts only if the run was completed.
        """
        return sum(goal.points for goal in self.goals if self.counts(goal))

    def counts(self, goal: GoalResult) -> bool:
        """Return whether the points of a goal count."""
        return goal.status in _COUNTED.get(self.result, ())

    def as_data(self) -> dict[str, Any]:
        """Return it as plain data for JSON."""
        return asdict(self)

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> Self:
        """Return the run that `as_data` described."""
        return cls(**{**data, "goals": tuple(GoalResult(**goal) for goal in data["goals"])})
