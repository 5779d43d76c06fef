"""Record the run of a debugger: it is run once more, from the start to where it stands.

A run that went back and forth is at each instant what it would have been otherwise, so it is the
same run. What the user changed by hand is not repeated; such a run is not recorded.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from crs_cc.cli.messages import show
from crs_cc.cli.start_recording import start_recording
from crs_cc.core.source import Diagnostic, Location
from crs_cc.debug.timeline.position import BEGINNING
from crs_cc.session.session import Session

if TYPE_CHECKING:
    from crs_cc.cli.debug_options import DebugOptions
    from crs_cc.cli.load import Loaded
    from crs_cc.debug.engine import Debugger
    from crs_cc.session.host import Waiting


def record_debugged(
    debugger: Debugger, loaded: Loaded, options: DebugOptions, waiting: Waiting
) -> None:
    """Record a run up to the timestep that the debugger is in, or say why it cannot be.

    Raises:
        OSError: the recording cannot be written.
    """
    place = Location(str(options.record))
    run = debugger.run
    if run.history.next_edit(BEGINNING) is not None:
        text = "the run is not recorded: it was changed by hand"
        show([Diagnostic("warning", place, text, hint="only runs of programs are recorded")])
        return
    pieces = {robot: deque(given) for robot, given in run.console.given().items()}
    seed = options.seed if options.seed is not None else loaded.world.seed or 0
    recorder = start_recording(loaded, options, seed)

    def read(robot: int, _wanted: int) -> bytes:
        given = pieces.get(robot)
        content = given.popleft() if given else b""
        recorder.read(robot, content)
        return content

    def waits(robot: int, clock_s: float) -> tuple[int, float]:
        answer = waiting(robot, clock_s)
        recorder.waiting(robot, clock_s, answer)
        return answer

    session = Session(
        loaded.world,
        loaded.executables,
        seed,
        arguments=loaded.arguments,
        output=recorder.write,
        read=read,
        files=loaded.files,
        client=options.client,
        waiting=waits,
        observer=recorder,
    )
    recorder.begin(session)
    while session.timesteps < run.position.timestep and session.advance(1):
        recorder.sample()
    recorder.sample()
    recorder.finish(session.result())
    if recorder.failed is not None:
        text = f"the recording ends at {recorder.written_s:.2f} s: {recorder.failed.strerror}"
        show([Diagnostic("warning", place, text)])
