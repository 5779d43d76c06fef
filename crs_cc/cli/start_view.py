"""Start the screen in the browser: load what it shows, serve it, and run it until Ctrl-C."""

from __future__ import annotations

import functools
import os
import sys
import webbrowser
from pathlib import Path
from typing import TYPE_CHECKING, Any

from crs_cc.cli.compare_recordings import rerun
from crs_cc.cli.load import Loaded, load
from crs_cc.cli.make_debugger import end_at, make_debugger
from crs_cc.cli.messages import say, show_before_run
from crs_cc.cli.start_debugger import fixed_input, record, record_at_end
from crs_cc.cli.view_address import announced
from crs_cc.core.source import Diagnostics
from crs_cc.session.host import no_input
from crs_cc.workbench.debugged_run import DebuggedRun
from crs_cc.workbench.feed import Feed
from crs_cc.workbench.player import Player
from crs_cc.workbench.screen import Screen
from crs_cc.workbench.watcher import Watcher
from crs_cc.workbench.world_data import world_data

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.cli.debug_options import DebugOptions
    from crs_cc.debug.timeline.console import WaitingAfter
    from crs_cc.sim.model.world import WorldModel

FRAME_S = 0.05
"""Simulated time between two frames that the page gets, at least a timestep."""


def view_programs(
    options: DebugOptions, compared: Sequence[Path], port: int, *, opens: bool, plays: bool
) -> int:
    """Run programs in the world under the eyes of a browser; return the exit status.

    Raises:
        CrsError: the programs cannot be loaded.
        OSError: the port is in use, or the input cannot be read.
    """
    screen, loaded, waiting = _opened(options, port)
    open_others(screen, compared)
    if plays:
        screen.player.play()
    status = serve(screen, opens=opens)
    record_at_end(screen.run.debugger(), loaded, options, waiting)
    return status


def open_others(screen: Screen, paths: Sequence[Path]) -> None:
    """Open recordings that pages compare the run with.

    Raises:
        CrsError: one is damaged.
    """
    names = [path.name for path in paths]
    for path in paths:
        is_only = names.count(path.name) == 1
        screen.others.open(path, path.name if is_only else str(path))


def screen_of(options: DebugOptions, port: int) -> Screen:
    """Return the screen of programs that are loaded, at their start.

    Raises:
        CrsError: the programs cannot be loaded.
        OSError: the port is in use, or the input cannot be read.
    """
    return _opened(options, port)[0]


def _opened(options: DebugOptions, port: int) -> tuple[Screen, Loaded, WaitingAfter]:
    """Return the screen, the loaded programs, and the known part of their input."""
    diagnostics = Diagnostics()
    loaded = load(options, diagnostics, debug=True)
    if not options.quiet:
        show_before_run(diagnostics.messages)
    world = loaded.world
    feed = Feed(
        describe("live", world, _title(loaded, options), options.seed or world.seed or 0),
        max(FRAME_S, world.timestep_s),
    )
    watcher = Watcher(feed)
    read, waiting = fixed_input(options)
    debugger = make_debugger(
        loaded, options, watcher.write, read or no_input, observer=watcher, waiting=waiting
    )
    end_at(debugger, options.max_time_s or world.duration_s)
    watcher.begin(debugger.session)
    debugger.start()
    debugger.save = functools.partial(record, loaded, options, waiting)
    run = DebuggedRun(debugger, watcher)
    screen = Screen(run, feed, Player(world.timestep_s), port)
    screen.others.runs_again = rerun
    return screen, loaded, waiting


def describe(
    kind: str,
    world: WorldModel,
    title: tuple[str, str],
    seed: int,
    names: Sequence[str] | None = None,
) -> dict[str, Any]:
    """Return the constant data of a run, as JSON.

    Args:
        kind: `live` or `recorded`.
        world: its world.
        title: the names of its programs and of its world.
        seed: its seed.
        names: its robots; by default those of the world.
    """
    names = [robot.id for robot in world.robots] if names is None else names
    return {
        "kind": kind,
        "programs": title[0],
        "world_name": title[1],
        "seed": seed,
        "timestep_s": world.timestep_s,
        "channels": [channel.name for channel in world.communication.channels],
        "world": world_data(world, names),
    }


def serve(screen: Screen, *, opens: bool) -> int:
    """Serve a screen until Ctrl-C; return the exit status."""
    address = screen.server.address()
    say(f"crs: open {address}")
    say(f"crs: view only: {screen.server.address('view')}  (Ctrl-C ends the run)")
    if opens:
        open_browser(address)
    try:
        with announced(screen.server.port, address):
            screen.play()
    except KeyboardInterrupt:
        say("crs: the run has ended")
    finally:
        screen.server.close()
    return 0


def open_browser(address: str) -> None:
    """Open a page if there is a display; else a browser for terminals might open."""
    is_shown = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    if is_shown or sys.platform in {"win32", "darwin"}:
        webbrowser.open(address)


def _title(loaded: Loaded, options: DebugOptions) -> tuple[str, str]:
    names = dict.fromkeys(path.name for row in loaded.sources for path in row)
    where = options.inputs.world
    return ", ".join(names), "an empty world" if where is None else Path(where).name
