"""The table of commands that pages can send; no other reaches the run.

The debugger's own commands go through `console`, as far as `allowed.ALLOWED` has them.
"""

from __future__ import annotations

import math
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Final

from crs_cc.debug.errors import DebugError
from crs_cc.workbench import console, questions, sources, stops
from crs_cc.workbench.command import Command
from crs_cc.workbench.comparing import COMPARING
from crs_cc.workbench.messages import block_message, page_message, recording_message
from crs_cc.workbench.page import feed_contents, page_of
from crs_cc.workbench.panel_commands import PANEL
from crs_cc.workbench.player import MAX_SPEED, MIN_SPEED
from crs_cc.workbench.values import values

if TYPE_CHECKING:
    from crs_cc.workbench.context import Context

MAX_RECORDING_BYTES: Final = 48 * 2**20
"""The maximum size of a recording that is sent to a page."""


def _play(screen: Context) -> None:
    screen.player.play()


def _pause(screen: Context) -> None:
    """Interrupt the run, and pause it."""
    screen.run.interrupt()

    def pause() -> None:
        screen.run.forget_interrupt()
        screen.player.pause()
        screen.publish()

    screen.player.submit(pause)


def _step(screen: Context, timesteps: int) -> None:
    screen.player.pause()
    if timesteps >= 0:
        screen.run.advance(min(timesteps, 10_000))
        screen.stopped()
    else:
        now = round(screen.run.time_s / screen.run.timestep_s)
        screen.run.seek(max(0, now + timesteps) * screen.run.timestep_s)


def _seek(screen: Context, time_s: float) -> None:
    screen.run.seek(max(0.0, time_s))
    screen.player.restart()


def _speed(screen: Context, speed: float) -> None:
    if speed != 0.0 and not MIN_SPEED <= speed <= MAX_SPEED:
        raise ValueError(f"the speed must be {MIN_SPEED:g} to {MAX_SPEED:g}, or 0 for no limit")
    screen.player.set_speed(speed or math.inf)


def _span(screen: Context, begin_s: float, end_s: float) -> None:
    if begin_s < 0.0 or end_s < begin_s:
        raise ValueError("the span must begin at 0 or later, and end after that")
    is_one = end_s - begin_s > screen.run.timestep_s / 2
    screen.player.span = (begin_s, end_s) if is_one else None


def _select(screen: Context, robot: int) -> None:
    screen.run.select(robot)
    screen.robot = robot


def _point(screen: Context, robot: int, x_m: float, y_m: float, heading_deg: float) -> None:
    screen.pointing.point(robot, x_m, y_m, heading_deg)


def _frames(screen: Context, block: int) -> bytes:
    content = screen.feed.frames.content(block) or screen.others.block(block)
    if content is None:
        raise ValueError(f"no block {block}: the run has changed since")
    return block_message(block, content)


def _page(screen: Context) -> bytes:
    return page_message(page_of(feed_contents(screen.feed)))


def _recording(screen: Context) -> bytes:
    """Record the run up to the time that is shown: it is run again, from the start."""
    debugger = screen.run.debugger()
    if debugger.save is None:
        raise DebugError("this run cannot be recorded here: start it with crs view, or --record")
    screen.player.pause()
    with screen.working(), tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "run.mcap")
        try:
            debugger.save(debugger, path)
            content = path.read_bytes()
        except OSError as error:
            raise DebugError(f"the run cannot be recorded: {error.strerror}") from None
    if len(content) > MAX_RECORDING_BYTES:
        raise DebugError("the recording is too large for a page: use crs debug, or --record")
    return recording_message(content)


RUNNING: Final = (
    Command("play", "Continue the run.", _play, needs="play"),
    Command("pause", "Let the run wait.", _pause, needs="play", at_once=True),
    Command("step", "Advance by timesteps, or go back by them if negative.", _step,
            {"timesteps": int}, needs="seek"),
    Command("seek", "Go to a time.", _seek, {"time_s": float}, needs="seek"),
    Command("speed", "Set the speed, simulated by real time; 0 for no limit.", _speed,
            {"speed": float}, needs="play"),
    Command("span", "Repeat the time between two instants; end it if they are equal.", _span,
            {"begin_s": float, "end_s": float}, needs="seek"),
    Command("select", "Select a robot, by number.", _select, {"robot": int}),
    Command("point", "Answer a program that has asked the user for a pose.", _point,
            {"robot": int, "x_m": float, "y_m": float, "heading_deg": float}),
    Command("page", "Send the run, as far as it is known, as one HTML page.", _page, asks=True),
    Command("recording", "Send the run, up to the time that is shown, as a recording.", _recording,
            needs="debug", asks=True),
    Command("frames", "Send a block of frames.", _frames, {"block": int}, controls=False,
            at_once=True),
)  # fmt: skip


def _sync_programs(screen: Context) -> None:
    with screen.working():
        screen.run.sync_programs()


DEBUGGING: Final = (
    Command("sync", "Run the programs to the displayed time.", _sync_programs, needs="debug"),
    Command("console", "Execute a command of the debugger.", console.execute, {"line": str},
            needs="debug"),
    Command("complete", "Return the completions of a line for the console.", console.completions,
            {"line": str}, needs="debug", asks=True),
    Command("break", "Set a breakpoint at a line, or remove the one that is there.",
            stops.toggle, {"file": str, "line": int}, needs="debug"),
    Command("breakpoint", "Change the breakpoint at a line, or set one.", stops.change,
            {"file": str, "line": int, "condition": str, "log": str, "robot": int, "ignore": int,
             "commands": str, "enabled": bool}, needs="debug"),
    Command("catchable", "Return the kinds of events that can be caught.", stops.events,
            controls=False, at_once=True),
    Command("values", "Return the variables of the selected frame, and what is watched.", values,
            {"unfolded": str}, controls=False, needs="debug", asks=True),
    Command("source", "Return the lines of a C file.", sources.source, {"file": str},
            controls=False, needs="debug", asks=True),
)  # fmt: skip

QUESTIONS: Final = (
    Command("go", "Go to a position in the run from another answer, and select a robot.",
            questions.go_to, {"place": str, "robot": int}, needs="debug"),
    Command("why", "Return where the value of an expression came from.", questions.why,
            {"expression": str}, needs="debug"),
    Command("changes", "Return the past values of an expression.", questions.changes,
            {"robot": int, "expression": str, "begin_s": float, "end_s": float}, needs="debug"),
    Command("when", "Return when a condition became true.", questions.when,
            {"condition": str}, needs="debug"),
    Command("log_messages", "Return what a log point would have printed.", questions.log_messages,
            {"file": str, "line": int, "text": str}, needs="debug"),
    Command("hits", "Return when a breakpoint was hit, or would have been.", questions.hits,
            {"number": int}, needs="debug"),
)  # fmt: skip

TABLE: Final = {row.name: row for row in (*RUNNING, *DEBUGGING, *QUESTIONS, *PANEL, *COMPARING)}
"""All commands by name."""
