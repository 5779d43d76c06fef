"""Recording of a debugged run: it is repeated from the start to its current position.

A run that went back and forth is at each instant what it would have been otherwise, so it is the
same run. What the user changed by hand is done again, and recorded as input.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from crs_cc.cli.changed_run import ChangedRun
from crs_cc.cli.make_debugger import make_debugger
from crs_cc.cli.messages import show
from crs_cc.cli.start_recording import start_recording
from crs_cc.core.source import Diagnostic, Location
from crs_cc.debug.saved_breakpoints import saved_breakpoints

if TYPE_CHECKING:
    from crs_cc.cli.debug_options import DebugOptions
    from crs_cc.cli.load import Loaded
    from crs_cc.debug.engine import Debugger
    from crs_cc.debug.timeline.change import Change
    from crs_cc.debug.timeline.console import WaitingAfter


def record_debugged(
    debugger: Debugger, loaded: Loaded, options: DebugOptions, waiting: WaitingAfter
) -> None:
    """Record a run up to the timestep that the debugger is in, and up to the last change in it.

    Raises:
        OSError: the recording cannot be written.
    """
    run = debugger.run
    pieces = {robot: deque(given) for robot, given in run.console.consumed_input().items()}
    changes = run.history.changes_until(run.position)
    seed = options.seed if options.seed is not None else loaded.world.seed or 0
    recorder = start_recording(loaded, options, seed, for_debugger=bool(changes))

    def read(robot: int, _wanted: int) -> bytes:
        given = pieces.get(robot)
        content = given.popleft() if given else b""
        recorder.read(robot, content)
        return content

    def waits(robot: int, clock_s: float, read: int) -> tuple[int, float]:
        answer = waiting(robot, clock_s, read)
        recorder.waiting(robot, clock_s, answer)
        return answer

    def note(change: Change) -> None:
        recorder.change(change.as_data())

    again = make_debugger(loaded, options, recorder.write, read, observer=recorder, waiting=waits)
    again.run.console.shows_new = True
    recorder.begin(again.session)
    changed = ChangedRun(again, changes, note)
    end = max([run.position.timestep, *(each.position.timestep + 1 for each in changes)])
    while again.session.timesteps < end and again.run.can_advance:
        changed.advance_to(again.session.timesteps + 1)
        recorder.sample()
    for each in debugger.notes:
        recorder.change(each.as_data())
    for kept in saved_breakpoints(debugger.stop_points):
        recorder.change(kept)
    recorder.finish(again.session.result())
    if recorder.failed is not None:
        text = f"the recording ends at {recorder.written_s:.2f} s: {recorder.failed.strerror}"
        show([Diagnostic("warning", Location(str(options.record)), text)])
