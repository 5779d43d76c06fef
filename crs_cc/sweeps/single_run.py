"""One run of a sweep, up to its limits."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final, Literal, cast

import numpy as np

from crs_cc.api.program_choice import executables_of
from crs_cc.api.session import Session
from crs_cc.core.source import Location
from crs_cc.recording.description import RunDescription
from crs_cc.recording.recorder import Recorder, RecorderOptions
from crs_cc.recording.source_tree import INPUTS, SOURCES, SourceTree
from crs_cc.session.session import Session as InnerSession
from crs_cc.sim.state.goals import OPEN
from crs_cc.sweeps.experiment import Experiment, ExperimentError

if TYPE_CHECKING:
    from crs_cc.session.host import Client
    from crs_cc.session.result import RunResult
    from crs_cc.sweeps.variant import Variant

Status = Literal["ended", "run-time error", "limit", "time out", "crashed", "measure error"]

STATUSES: Final[dict[Status, str]] = {
    "ended": "the run ended normally",
    "run-time error": "a program was stopped by an error; the others continued",
    "limit": "a program computed or printed more than is allowed",
    "time out": "the run exceeded `wall_s`, a last resort that depends on the machine",
    "crashed": "the process of the run died at each attempt",
    "measure error": "a function of `measures` failed",
}
"""How a run can end."""

_LOOK_S: Final = 1.0
"""Simulated time between two looks at limits and goals."""


@dataclass(frozen=True, slots=True)
class Ending:
    """How a run ended.

    Attributes:
        status: the kind.
        text: what was wrong, with its place.
    """

    status: Status = "ended"
    text: str = ""


def end_s(experiment: Experiment, variant: Variant) -> float:
    """Return when a run ends [s].

    Raises:
        ExperimentError: nothing says so.
    """
    found = experiment.duration_s or variant.world.duration_s
    if not found:
        text, hint = "no end of the runs", "set 'duration', or the duration of the world"
        raise ExperimentError.at(Location(str(experiment.path)), text, hint)
    return found


def create(experiment: Experiment, variant: Variant, seed: int) -> Session:
    """Return the session of a variant with a seed."""
    return Session(
        variant.world,
        list(variant.executables),
        seed=seed,
        duration_s=end_s(experiment, variant),
        arguments=variant.arguments,
        files=_files(experiment),
        client=cast("Client", variant.client),
        threads=1,
    )


def run(experiment: Experiment, session: Session) -> Ending:
    """Run a session to its end."""
    return _run_on(experiment, session.inner, session.step, lambda: session.streams.written)


def record(experiment: Experiment, variant: Variant, seed: int, path: Path) -> Ending:
    """Run a variant with a seed as `run` does, and record it.

    Raises:
        OSError: the recording cannot be written.
    """
    recorder = _recorder(experiment, variant, seed, path)
    printed = 0

    def write(robot: int, stream: int, content: bytes) -> None:
        nonlocal printed
        printed += len(content)
        if printed <= experiment.limits.output:
            recorder.write(robot, stream, content)

    def read(robot: int, _wanted: int) -> bytes:
        recorder.read(robot, b"")
        return b""

    _, rows = executables_of(variant.world, list(variant.executables), variant.arguments)
    session = InnerSession(
        variant.world,
        variant.executables,
        seed,
        arguments=rows,
        output=write,
        read=read,
        files=_files(experiment),
        client=cast("Client", variant.client),
        threads=1,
        observer=recorder,
    )
    last = round(end_s(experiment, variant) / variant.world.timestep_s)

    def advance(timesteps: int) -> bool:
        until = min(session.timesteps + timesteps, last)
        while session.timesteps < until:
            most = round(recorder.seconds_left() / variant.world.timestep_s)
            most = max(1, min(until - session.timesteps, most))
            goes_on = session.advance(most, calmly=not recorder.needs_each)
            recorder.sample()
            if not goes_on:
                return False
        return until < last

    with closing(session):
        recorder.begin(session)
        ending = _run_on(experiment, session, advance, lambda: printed)
        recorder.finish(session.result())
    if recorder.failed is not None:
        raise recorder.failed
    return ending


def _run_on(
    experiment: Experiment,
    session: InnerSession,
    advance: Callable[[int], bool],
    printed: Callable[[], int],
) -> Ending:
    """Advance a session to its end, or to a limit.

    Looks are at fixed instants, so that they are the same however a run is advanced.
    """
    timesteps = max(1, round(_LOOK_S / session.environment.timestep_s))
    goes_on = True
    while goes_on:
        goes_on = advance(timesteps)
        if printed() > experiment.limits.output:
            return Ending("limit", f"printed more than {experiment.limits.output:,} bytes")
        if int(session.state.fuel.max()) > experiment.limits.fuel:
            return Ending("limit", f"computed more than {experiment.limits.fuel:,} instructions")
        goals = session.environment.last_state.goals
        if experiment.until_decided and goals is not None and not np.any(goals.status == OPEN):
            break
    return _ending(session.result())


def _ending(result: RunResult) -> Ending:
    for robot in result.robots:
        if robot.error is not None:
            place = robot.error.location
            return Ending(
                "run-time error", f"{robot.id}: {place.file}:{place.line}: {robot.error.text}"
            )
    return Ending()


def _files(experiment: Experiment) -> dict[str, bytes]:
    return {name: path.read_bytes() for name, path in experiment.files.items()}


def _recorder(experiment: Experiment, variant: Variant, seed: int, path: Path) -> Recorder:
    """Create the recording of a run, with all that it takes to run it again."""
    tree = SourceTree.of(variant.files, experiment.include_paths)
    files = _files(experiment)
    is_file = variant.robot.endswith(".xml")
    description = RunDescription(
        sources=tuple(map(tree.name, experiment.programs)),
        world=tree.name(experiment.world),
        arguments=variant.arguments,
        include_paths=tuple(map(tree.name, experiment.include_paths)),
        defines=variant.defines,
        seed=seed,
        client=variant.client,
        link=variant.link,
        robot=tree.name(Path(variant.robot)) if is_file else variant.robot,
        setup=variant.setup,
        files=tuple(files),
        max_time_s=end_s(experiment, variant),
        timestep_s=variant.world.timestep_s,
        frame_s=max(RecorderOptions().every_s, variant.world.timestep_s),
    )
    attachments = {f"{SOURCES}{name}": content for name, content in tree.contents.items()}
    attachments |= {f"{INPUTS}{name}": content for name, content in files.items()}
    return Recorder(path, RecorderOptions(), description.metadata(), attachments)
