"""Reports of stops: reason and location."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.debug.breakpoints import Breakpoint
from crs_cc.debug.commands.answer import Answer, Line, SourceLine
from crs_cc.debug.commands.breakpoint_text import name_of
from crs_cc.debug.stop import WORDS, Stop
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.world.robot_rows import activity

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger
    from crs_cc.debug.view import BacktraceFrame

_SAID: Final = frozenset({"start", "beginning", "interrupt"})
"""Reasons that are reported if a stop has no text of its own."""

_MAX_ENDS: Final = 5
_MAX_ARGUMENT_LENGTH: Final = 40  # characters

_QUIET: Final = frozenset({"step", "goto"})
"""Reasons that are not reported, because the user requested the stop."""


@dataclass(frozen=True, slots=True)
class Selection:
    """The selected robot and frame, and the depth of the stack."""

    robot: int
    function: str
    depth: int
    frame: BacktraceFrame | None

    def head(self, debugger: Debugger) -> str:
        """Return the location: `robot0 in turn (left=3) at wander.c:40`."""
        name = f"{debugger.names[self.robot]} in " if len(debugger.names) > 1 else ""
        return name + frame_text(debugger, self.frame) if self.frame else ""

    def lines(self, debugger: Debugger, *, with_head: bool = True) -> Answer:
        """Answer with the location and its source line."""
        if self.frame is None:
            return
        if with_head:
            yield Line(f"#{self.frame.number}  {self.head(debugger)}", "place")
        yield from current_line(debugger, self.frame)


def selection(debugger: Debugger) -> Selection:
    """Return the current selection."""
    frames = debugger.view.frames()
    frame = next((each for each in frames if each.number == debugger.view.frame), None)
    return Selection(debugger.view.robot, frame.function if frame else "", len(frames), frame)


def stop_lines(
    debugger: Debugger,
    stop: Stop,
    known: Mapping[int, Breakpoint],
    before: Selection | None,
) -> Answer:
    """Answer with the reason and the location of a stop.

    Args:
        debugger: the debugger.
        stop: the stop.
        known: the breakpoints before the move, by number.
        before: the selection before.
    """
    now = selection(debugger)
    hit = ", ".join(name_of(known[number]) for number in stop.breakpoints if number in known)
    text = stop.text
    if not text and not hit and stop.reason in _SAID:
        text = f"{WORDS[stop.reason].capitalize()}."
    if stop.reason == "end" and not text:
        text = f"All programs have ended: {_ends(debugger)}. Step back, or quit."
    elif stop.reason == "exit" and not text:
        text = f"{debugger.names[stop.robot]} {activity(debugger.session, stop.robot)}."
    if text:
        yield Line(f"{hit}: {text}" if hit else text, "stop")
        hit = ""
    if stop.reason == "error":
        yield from debugger.session.fleet.report(stop.robot).notes
    if now.frame is None or stop.reason == "end":
        if not text:
            yield Line(when_text(debugger), "place")
        elif stop.breakpoints:  # it has no location to say when
            yield Line(f"t = {stop.time_s:.3f} s", "place")
        return
    is_same = before is not None and _call(before) == _call(now)
    if hit or text or stop.reason not in _QUIET or not is_same:
        at = f", t = {stop.time_s:.3f} s"
        yield Line(f"{hit}{', ' * bool(hit)}{now.head(debugger)}{at}", "place")
    yield from now.lines(debugger, with_head=False)


def program_lines(debugger: Debugger) -> Answer:
    """Answer with the files of the selected robot's program, its location, and why it stopped."""
    robot, frames = debugger.view.robot, debugger.view.frames()
    name, files = debugger.names[robot], ", ".join(debugger.run.programs[robot].files)
    stop = debugger.stop
    if not debugger.session.state.alive[robot]:
        yield f"{name}'s program ({files}) does not run: {activity(debugger.session, robot)}."
        return
    own = next((each for each in frames if not each.is_library), None)
    at = f" in {frame_text(debugger, own)}" if own else ""
    yield f"{name}'s program ({files}) has stopped{at}, t = {debugger.view.time_s:.3f} s."
    known = {each.number: each for each in debugger.stop_points.breakpoints}
    hit = [
        name_of(known[number]).lower() if number in known else f"a deleted breakpoint ({number})"
        for number in stop.breakpoints
    ]
    if hit:
        yield f"The run stopped at {', '.join(hit)}."
    elif stop.reason == "step":
        yield "The run stopped after being stepped."
    elif stop.why:
        yield f"The run stopped: {stop.why}."


def _ends(debugger: Debugger) -> str:
    """Return the outcome of the programs."""
    ends = [
        f"{name} {activity(debugger.session, robot)}"
        for robot, name in enumerate(debugger.names[:_MAX_ENDS])
    ]
    more = len(debugger.names) - len(ends)
    return ", ".join(ends) + (f", and {more} more" if more else "")


def _call(place: Selection) -> tuple[int, str, int]:
    return place.robot, place.function, place.depth


def frame_text(debugger: Debugger, frame: BacktraceFrame, robot: int | None = None) -> str:
    """Return a frame's function, arguments and location."""
    if frame.is_library:
        return f"{frame.function} (), in the C library"
    place, variables = frame.location, debugger.view.variables(robot=robot, frame=frame.number)
    arguments = [
        f"{each.name}={_brief(each.value.text)}"
        for each in variables
        if each.scope == "parameter" and not each.is_hidden
    ]
    return f"{frame.function} ({', '.join(arguments)}) at {place.file}:{place.line}"


def _brief(value: str) -> str:
    """Return a value shortened, and of a pointer only the address."""
    if value.startswith("0x"):
        value = value.split(maxsplit=1)[0]
    return value if len(value) <= _MAX_ARGUMENT_LENGTH else f"{value[:_MAX_ARGUMENT_LENGTH]}..."


def current_line(debugger: Debugger, frame: BacktraceFrame) -> Answer:
    """Answer with the current line of a frame."""
    lines, number = debugger.view.source(frame.location.file), frame.location.line
    if 0 < number <= len(lines):
        yield SourceLine(number, lines[number - 1], is_current=True)


def when_text(debugger: Debugger) -> str:
    """Return the current time of a run."""
    begun = debugger.run.sites_passed(debugger.view.robot)
    stmt = f"{debugger.names[debugger.view.robot]} before stmt {begun + 1}"
    return f"t = {debugger.view.time_s:.3f} s, {position_text(debugger.position)}, {stmt}"


def position_text(position: Position) -> str:
    """Return a position without the statement."""
    return f"tick {position.timestep}, round {position.round}"
