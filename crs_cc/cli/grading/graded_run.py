"""Compile a submission in the current directory, run it in a world, and report its goals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Final

import numpy as np

from crs_cc.cli.grading.fingerprint import fingerprint
from crs_cc.cli.grading.job import DEFAULT_TIME_S, GradedRun, Job, Result
from crs_cc.cli.grading.refused_calls import refused_call, refused_codes
from crs_cc.cli.grading.source_tokens import tokens_of
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.load import Loaded, load
from crs_cc.cli.messages import printable
from crs_cc.cli.run_options import RunOptions
from crs_cc.cli.run_plot import RunPlot
from crs_cc.cli.start_recording import start_recording
from crs_cc.cli.summary import Run
from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics, Location
from crs_cc.core.time_grid import ROUNDING_S
from crs_cc.session.host import never_waits
from crs_cc.session.session import Session
from crs_cc.sim.engine.passage import Passage
from crs_cc.sim.engine.step import Step
from crs_cc.sim.state.goals import OPEN

_LOOK_S: Final = 0.5
_SHOWN: Final = 2000  # bytes


def graded_run(job: Job, compiled: Callable[[], None]) -> GradedRun:
    """Return the outcome of a run; call `compiled` when its program has been compiled.

    Raises:
        WorldError: the world cannot be read.
    """
    sources = tuple(map(Path, job.sources))
    options = RunOptions(
        Inputs(sources, Path(job.world)),
        seed=job.seed,
        quiet=True,
        threads=1,
        record=Path(job.record) if job.record else None,
        inputs_on_disk={name: Path(path) for name, path in job.inputs.items()},
        **asdict(job.robots),
    )
    files = [tokens_of(path) for path in sources]
    mark = fingerprint(files)
    try:
        loaded = load(options, Diagnostics())
    except CompileError as error:
        return _compile_error(error, mark)
    mine = [number for number, each in enumerate(loaded.sources) if each == sources]
    refused = refused_call(files, loaded.executables[mine[0]], job.allowed)
    if refused is not None:
        name, place = refused
        text = f"{name}() is not allowed: no robot can do that"
        return GradedRun("refused", text, place.file, place.line, fingerprint=mark)
    compiled()
    return _ProgramRun(job, options, loaded, mine).run(mark)


def _roots(job: Job) -> dict[Path, str]:
    """Return the folders of the run's files, with their names in a recording."""
    roots = {Path(job.folder).resolve(): "", Path(job.world).parent: "world"}
    if job.robots.robot.endswith(".xml"):
        roots.setdefault(Path(job.robots.robot).parent, "robot")
    return roots


def _readable(content: bytes) -> str:
    """Return lines that were printed without control characters."""
    return "\n".join(map(printable, content.decode("utf-8", "replace").split("\n")))


def _compile_error(error: CompileError, mark: str) -> GradedRun:
    """Return the grade of a program with errors: the first of them."""
    first = next(each for each in error.diagnostics if each.severity == "error")
    place = first.location
    return GradedRun("compile error", first.text, place.file, place.line, fingerprint=mark)


class _RunStopped(Exception):  # noqa: N818 - the run is over, for a reason
    """The run is over before its time.

    Attributes:
        result: how it ended.
        text: why.
    """

    def __init__(self, result: Result, text: str) -> None:
        self.result, self.text = result, text
        super().__init__(text)


class _ProgramRun:
    """A run of a compiled submission, up to its limits."""

    def __init__(self, job: Job, options: RunOptions, loaded: Loaded, mine: Sequence[int]) -> None:
        self._job, self._loaded = job, loaded
        self._mine = np.array(mine)
        self._codes = refused_codes(job.allowed)
        self._seed = job.seed if job.seed is not None else loaded.world.seed or 0
        self._end_s = job.limits.max_time_s or loaded.world.duration_s or DEFAULT_TIME_S
        self._look = max(1, round(_LOOK_S / loaded.world.timestep_s))
        self._printed = 0
        self._shown = bytearray()
        self._refused = ""
        self._plot = RunPlot()
        self._recorder = (
            start_recording(loaded, options, self._seed, self._end_s, _roots(job))
            if job.record
            else None
        )
        self._session = Session(
            loaded.world,
            loaded.executables,
            self._seed,
            arguments=loaded.arguments,
            output=self._write,
            read=self._read,
            waiting=self._waiting,
            files=loaded.files,
            client=options.client,
            observer=self,
            threads=1,
        )

    def run(self, mark: str) -> GradedRun:
        """Run to the end; return the outcome."""
        session, text, place = self._session, "", Location("")
        result: Result = "ended"
        if self._recorder is not None:
            self._recorder.begin(session)
        try:
            self._step_to_end()
        except _RunStopped as over:
            result, text = over.result, over.text
        finally:
            session.close()
        done = session.result()
        if self._recorder is not None:
            self._recorder.finish(done)
        failed = [done.robots[n].error for n in self._mine if done.robots[n].error is not None]
        if result == "ended" and failed and failed[0] is not None:
            result, text, place = "run-time error", failed[0].text, failed[0].location
        programs = [Path(each[0]).name for each in self._loaded.sources]
        for number in self._mine:
            programs[number] = self._job.name
        finished = Run(done, self._job.world, self._seed, 0.0, interrupted=False, calls=())
        picture = self._plot.picture(session, finished, programs, sensors=False)
        return GradedRun(
            result, text, place.file, place.line, done.goals, round(done.simulated_s, 9),
            picture.decode(), mark, _readable(bytes(self._shown)),
        )  # fmt: skip

    def _step_to_end(self) -> None:
        session = self._session
        self._sample()
        goes_on = True
        while goes_on and session.time_s < self._end_s - ROUNDING_S:
            goes_on = session.advance(self._most_timesteps(), calmly=True)
            self._sample()
            self._check_limits(is_last=not goes_on)
            goals = session.environment.last_state.goals
            if goals is not None and not (goals.status == OPEN).any():
                return

    def _most_timesteps(self) -> int:
        """Return the number of timesteps to run until the limits are checked again."""
        session, timestep_s = self._session, self._loaded.world.timestep_s
        most = self._look - session.timesteps % self._look
        left_s = self._end_s - session.time_s
        if self._recorder is not None:
            left_s = min(left_s, self._recorder.seconds_left())
        return max(1, min(most, int(left_s / timestep_s + ROUNDING_S)))

    def _check_limits(self, *, is_last: bool) -> None:
        """Stop a run that has exceeded a limit, or done something forbidden.

        What it has used up counts at fixed instants, however many timesteps run at once, and when
        its program has ended.

        Raises:
            _RunStopped: it must be stopped.
        """
        limits = self._job.limits
        if self._refused:
            raise _RunStopped("refused", f"{self._refused}() is not allowed: no robot can do that")
        if self._session.timesteps % self._look and not is_last:
            return
        if self._printed > limits.max_output:
            raise _RunStopped("limit", f"printed more than {limits.max_output:,} bytes")
        if int(self._session.state.fuel[self._mine].max()) > limits.max_fuel:
            raise _RunStopped("limit", f"computed more than {limits.max_fuel:,} instructions")

    def _sample(self) -> None:
        if self._recorder is not None:
            self._recorder.sample()
        self._plot.sample(self._session)

    def step(self, step: Step) -> None:
        """Record the contacts and the requests of a timestep."""
        if self._recorder is not None:
            self._recorder.step(step)
        self._plot.add_contacts(step, len(self._session.fleet))
        for served in step.served:
            if served.code in self._codes and np.isin(served.robots, self._mine).any():
                self._refused = self._codes[served.code]

    def passed(self, passage: Passage) -> None:
        """Record a passage of timesteps without contacts."""
        if self._recorder is not None:
            self._recorder.passed(passage)
        self._plot.add_passage(self._session, passage)

    def _write(self, robot: int, stream: int, content: bytes) -> None:
        if robot in self._mine:
            self._printed += len(content)
            self._shown += content[: _SHOWN - len(self._shown)]
        if self._recorder is not None and self._printed <= self._job.limits.max_output:
            self._recorder.write(robot, stream, content)

    def _read(self, robot: int, _size: int) -> bytes:
        if self._recorder is not None:
            self._recorder.read(robot, b"")
        return b""

    def _waiting(self, robot: int, clock_s: float) -> tuple[int, float]:
        answer = never_waits(robot, clock_s)
        if self._recorder is not None:
            self._recorder.waiting(robot, clock_s, answer)
        return answer
