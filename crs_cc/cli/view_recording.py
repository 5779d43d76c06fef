"""`crs view run.mcap`: a recorded run in the browser, with the debugger inside it."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Final

from crs_cc.cli.compare_recordings import rerun
from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.load import load
from crs_cc.cli.make_debugger import make_debugger
from crs_cc.cli.recorded_run import RecordedRunCheck
from crs_cc.cli.recording_plot import world_of
from crs_cc.cli.rerun import extracted_run
from crs_cc.cli.start_view import describe, open_others, serve
from crs_cc.core.errors import CrsError
from crs_cc.core.source import Diagnostics
from crs_cc.debug.errors import DebugError
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.recording import Recording
from crs_cc.workbench.debugged_recording import DebuggedRecording
from crs_cc.workbench.debugged_run import DebuggedRun
from crs_cc.workbench.feed import Feed
from crs_cc.workbench.playback import Playback
from crs_cc.workbench.player import Player
from crs_cc.workbench.screen import Screen
from crs_cc.workbench.watcher import Watcher

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.sim.engine.step import Step

_QUICK: Final = 20_000
"""Timesteps of all robots that are run again without being asked for: some seconds of real time."""


def view_recording(
    path: Path, compared: Sequence[Path], port: int, *, opens: bool, plays: bool
) -> int:
    """Show a recorded run in a browser; return the exit status.

    Raises:
        CrsError: the recording is damaged.
        OSError: it cannot be read, or the port is in use.
    """
    with ExitStack() as stack:
        recording = Recording(path)
        stack.callback(recording.close)
        screen = recording_screen(recording, port, stack)
        open_others(screen, compared)
        if plays:
            screen.player.play()
        return serve(screen, opens=opens)


def recording_screen(recording: Recording, port: int, stack: ExitStack) -> Screen:
    """Return the screen of a recorded run.

    Args:
        recording: the recording.
        port: where to serve it.
        stack: cleans up when it is over.

    Raises:
        CrsError: the recording is damaged.
        OSError: the port is in use.
    """
    run, world = recording.description, world_of(recording)
    names = ", ".join(dict.fromkeys(Path(source).name for source in run.sources))
    title = names or "programs", Path(run.world).name or "an empty world"
    known = recording.rosters[-1].robots
    feed = Feed(describe("recorded", world, title, run.seed, known), run.frame_s)
    timesteps = len(known) * recording.end_ns / NS / run.timestep_s
    feed.description["follows"] = timesteps <= _QUICK
    playback = Playback(recording, world, feed)
    shown = DebuggedRecording(playback, lambda: _debugged(recording, feed, stack))
    screen = Screen(shown, feed, Player(run.frame_s), port)
    screen.others.own, screen.others.runs_again = recording, rerun
    return screen


def _debugged(recording: Recording, feed: Feed, stack: ExitStack) -> DebuggedRun:
    """Return the recorded run in the debugger, at its start.

    Raises:
        DebugError: it cannot be run again.
    """
    try:
        options = stack.enter_context(extracted_run(recording, DebugOptions))
        loaded = load(options, Diagnostics(), debug=True)
        check = RecordedRunCheck(recording)
        check.warned = lambda text: feed.event(check.time_s, "warning", -1, text)
    except CrsError as error:
        first = error.diagnostics[0]
        raise DebugError(f"the recorded programs cannot be run again: {first.text}") from None
    watcher = Watcher(feed)
    both = _ComparingWatcher(check, watcher)
    debugger = make_debugger(
        loaded, options, watcher.write, check.read, observer=both, waiting=check.waiting
    )
    timestep_s = debugger.session.environment.world.timestep_s
    watcher.begin(debugger.session, round(recording.end_ns / NS / timestep_s))
    check.begin(debugger)
    made = both.run = DebuggedRun(debugger, watcher)
    return made


class _ComparingWatcher:
    """Watches a run, and compares it with its recording until the user changes it.

    Attributes:
        run: the run.
    """

    def __init__(self, check: RecordedRunCheck, watcher: Watcher) -> None:
        self.run: DebuggedRun | None = None
        self._check, self._watcher = check, watcher

    def step(self, step: Step) -> None:
        """Notice what happened in a timestep."""
        if self.run is None or not self.run.has_changed:
            self._check.step(step)
        self._watcher.step(step)
