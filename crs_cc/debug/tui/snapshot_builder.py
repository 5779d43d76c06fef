"""Collection of the data that the screen shows of a stopped run."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from pathlib import PurePath
from typing import Final

from rich.text import Text

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.commands.stop_text import frame_text, selection
from crs_cc.debug.engine import Debugger
from crs_cc.debug.tui.backend import BackendRequest
from crs_cc.debug.tui.program_streams import Piece
from crs_cc.debug.tui.screen_data import (
    Badge,
    BreakpointMark,
    ListEntry,
    OutputLine,
    ScreenData,
    SourceData,
)
from crs_cc.debug.tui.value_rows import variables
from crs_cc.debug.world.robot_rows import activity
from crs_cc.debug.world.run_map import run_map
from crs_cc.session.session import Session

_BLOCK: Final = 1000
"""Pieces of output that leave the screen at once; the last one to two thousand are shown."""
_STDERR: Final = 2
_MAX_ROBOTS: Final = 200
_MAX_FRAMES: Final = 200  # a runaway recursion has ten thousand
_MIN_COLUMNS, _MIN_ROWS = 10, 4


def build_snapshot(shell: Shell, request: BackendRequest) -> ScreenData:
    """Return the data to show.

    Args:
        shell: the command line of the run.
        request: which values are expanded, and the size of the map.
    """
    debugger = shell.debugger
    position, event_history = debugger.position, debugger.run.event_history
    happened = tuple(event_history.world_events())
    timestep_s = _timestep_s(debugger)
    last_s = max((each.time_s for each in happened), default=0.0)
    return ScreenData(
        state=_state(debugger),
        badge=_badge(debugger),
        time_s=debugger.view.time_s,
        now_s=debugger.session.time_s,
        end_s=max(event_history.timesteps * timestep_s, debugger.session.time_s, last_s),
        timestep_s=timestep_s,
        place=f"timestep {position.timestep}" + _statement(debugger),
        source=_source(debugger, request.file),
        frames=tuple(_frames(debugger)),
        robots=tuple(_robots(debugger)),
        variables=variables(shell, request.unfolded),
        world_map=_world_map(debugger, *request.map_size),
        output=tuple(_output(debugger)),
        events=happened,
    )


def _badge(debugger: Debugger) -> Badge:
    if debugger.stop.reason == "error":
        return "error"
    return "over" if debugger.view.is_over else "stopped"


def _state(debugger: Debugger) -> str:
    stop = debugger.stop
    selected = selection(debugger)
    where = "" if stop.reason == "end" else selected.head(debugger)
    if selected.frame is not None:
        file = selected.frame.location.file
        where = where.replace(file, PurePath(file).name)
    return ": ".join(filter(None, [stop.why, where]))


def _statement(debugger: Debugger) -> str:
    return f", before stmt {debugger.run.sites_passed(debugger.view.robot) + 1}"


def _timestep_s(debugger: Debugger) -> float:
    return debugger.session.environment.world.timestep_s


def _world_map(debugger: Debugger, columns: int, rows: int) -> Text:
    """Draw the map with the echoes of the selected robot; empty if there is no room."""
    if columns < _MIN_COLUMNS or rows < _MIN_ROWS:
        return Text()
    return run_map(debugger.view, columns, rows, robot=debugger.view.robot).text


def _source(debugger: Debugger, wanted: str) -> SourceData:
    """Return the requested file, or else the one of the selected frame."""
    program = debugger.run.programs[debugger.view.robot]
    files = tuple(program.executable.detail().lines)
    place, own = (
        debugger.view.location(),
        [each for each in debugger.view.frames() if not each.is_library],
    )
    file = place.file if place else own[0].location.file if own else next(iter(program.files))
    if wanted in files:
        file = wanted
    innermost = not own or own[0].number == debugger.view.frame
    line = place.line if place and place.file == file else 0
    marks = _breakpoints(debugger, file)
    return SourceData(file, debugger.view.source(file), line, innermost, marks, files)


def _breakpoints(debugger: Debugger, file: str) -> dict[int, BreakpointMark]:
    marks = {}
    for each in debugger.stop_points.breakpoints:
        place = each.location.location if each.location else None
        if place is not None and place.file == file:
            marks[place.line] = BreakpointMark(each.number, each.enabled)
    return marks


def _frames(debugger: Debugger) -> Iterator[ListEntry]:
    """Return the stack; of library frames only those called by the user's code."""
    frames = debugger.view.frames()
    for each in frames[:_MAX_FRAMES]:
        caller = frames[each.number + 1] if each.number + 1 < len(frames) else None
        if each.is_library and caller is not None and caller.is_library:
            continue
        _, _, arguments = frame_text(debugger, each).partition(" at ")[0].partition(" ")
        place = f"{PurePath(each.location.file).name}:{each.location.line}  {arguments}"
        is_current = each.number == debugger.view.frame
        place = "C library" if each.is_library else place
        yield ListEntry(each.number, each.function, place, is_current)


def _robots(debugger: Debugger) -> Iterator[ListEntry]:
    """Return the robots; of very many those around the selected one."""
    session, names = debugger.session, debugger.names
    first = max(0, min(debugger.view.robot - _MAX_ROBOTS // 2, len(names) - _MAX_ROBOTS))
    for number in range(first, min(first + _MAX_ROBOTS, len(names))):
        text = " ".join(filter(None, [names[number], _pose(session, number)]))
        yield ListEntry(number, text, activity(session, number), number == debugger.view.robot)


def _pose(session: Session, robot: int) -> str:
    """Return x and y [m] and the heading; empty for an absent robot."""
    state = session.environment.state
    if not state.presence.present[robot]:
        return ""
    heading_deg = round(math.degrees(state.heading_rad[robot])) % 360
    return f"{state.x_m[robot]:.2f}, {state.y_m[robot]:.2f}, {heading_deg}°"


def _output(debugger: Debugger) -> Iterator[OutputLine]:
    console = debugger.run.console
    since = max(0, console.piece_count // _BLOCK - 1) * _BLOCK
    return written(debugger.names, console.pieces(since), console.lines_before(since) + 1)


def written(
    names: tuple[str, ...], pieces: Iterable[Piece], first: int = 0
) -> Iterator[OutputLine]:
    """Return output as lines; a line ends, too, where another program writes.

    Args:
        names: the names of the robots.
        pieces: the output.
        first: the number of the first line; 0 if it is not known.
    """
    writer, begun, number = (-1, -1), "", first
    for robot, stream, piece in pieces:
        if (robot, stream) != writer and begun:
            yield OutputLine(_writer_name(names, writer[0]), begun, writer[1] == _STDERR, number)
            begun = ""
        writer = robot, stream
        *lines, begun = (begun + piece.decode("utf-8", "replace")).split("\n")
        for line in lines:
            yield OutputLine(_writer_name(names, robot), line, stream == _STDERR, number)
            number += bool(first)
    if begun:
        yield OutputLine(_writer_name(names, writer[0]), begun, writer[1] == _STDERR, number)


def _writer_name(names: tuple[str, ...], robot: int) -> str:
    return names[robot] if len(names) > 1 else ""
