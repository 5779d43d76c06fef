"""Changes to a run: those of its world, its programs and its participants."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING, Final

from crs_cc.core.quantity import TIME
from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.edit import Edit, Words, find_robot, pose_of
from crs_cc.debug.world.edits import EDITS, edit, words_of
from crs_cc.debug.world.network_edits import NETWORK_HELP, change_network
from crs_cc.debug.world.rows import instant, pose_text
from crs_cc.sim.model.world import Robot

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable
    from crs_cc.session.session import Session

MAX_ROBOTS: Final = 10_000
"""Robots of a run to which more may be added by hand; chosen by us."""

_JOIN: Final = "NAME like ROBOT to X Y [HEADING] [running PROGRAM]"
_SLEEP: Final = "ROBOT TIME"
_NAME: Final = re.compile(r"[\w.-]{1,60}")


@dataclass(frozen=True, slots=True)
class RunEdit:
    """A kind of change; its fields are those of `Edit`.

    Attributes:
        syntax: its arguments, optional ones in brackets.
        summary: what it does, in a line.
        text: further help.
        do: makes it, given the session, the programs by name, and the arguments.
    """

    syntax: str
    summary: str
    text: str
    do: Callable[[Session, Sequence[Executable], Words], str]


def edit_run(session: Session, text: str, programs: Sequence[Executable] = ()) -> str:
    """Change a run or its world; return a description of the change.

    Args:
        session: the run, anywhere in a timestep.
        text: a change, as `RUN_EDITS` and `EDITS` have them.
        programs: what robots may be added with: the robots' programs, then others. By default
            those of the session.

    Raises:
        DebugError: it is invalid or impossible; nothing has changed.
    """
    words = words_of(text)
    wanted = RUN_EDITS.get(words[0]) if words else None
    if wanted is None:
        return edit(session.environment, text)
    known = programs or [session.fleet.executable(each) for each in range(len(session.fleet))]
    try:
        return wanted.do(session, known, words[1:])
    except (ValueError, OSError) as wrong:
        raise DebugError(str(wrong)) from None


def _sleep(session: Session, _programs: Sequence[Executable], words: Words) -> str:
    if len(words) != 2:
        raise ValueError(f"expected: sleep {_SLEEP}")
    number = _running(session, words[0])
    for_s = TIME.parse(words[1])
    if for_s <= 0.0:
        raise ValueError("the time to sleep must be greater than 0")
    state, until_s = session.state, session.time_s + for_s
    if math.isinf(state.clock_s[number]) and math.isinf(state.due_s[number]):
        raise ValueError(f"{words[0]}'s program is waiting for its robot: try again later")
    on_link = state.due_s if math.isfinite(state.due_s[number]) else state.clock_s
    on_link[number] = max(float(on_link[number]), until_s)
    return f"{words[0]}'s program sleeps until {instant(until_s)}"


def _wake(session: Session, _programs: Sequence[Executable], words: Words) -> str:
    if len(words) != 1:
        raise ValueError("expected: wake ROBOT")
    number, state = _running(session, words[0]), session.state
    for clocks in (state.due_s, state.clock_s):
        if math.isfinite(clocks[number]):
            clocks[number] = min(float(clocks[number]), session.time_s)
    return f"{words[0]}'s program continues"


def _running(session: Session, name: str) -> int:
    """Return the number of a robot whose program runs."""
    robots = session.environment.world.robots
    number = robots.index(find_robot(session.environment, name))
    if not session.state.alive[number]:
        raise ValueError(f"{name}'s program is not running")
    return number


def _join(session: Session, programs: Sequence[Executable], words: Words) -> str:
    if words and words[1:2] != ["like"]:
        return _admit(session, words)
    if len(words) < 6 or words[1] != "like" or words[3] != "to":
        raise ValueError(f"expected: join {_JOIN}")
    name, place = words[0], list(words[4:])
    if not _NAME.fullmatch(name):
        raise ValueError(f"{name[:60]!r} is not a name for a robot")
    model = find_robot(session.environment, words[2])
    executable = programs[session.environment.world.robots.index(model)]
    if "running" in place:
        at = place.index("running")
        executable = _program(programs, place[at + 1 :])
        del place[at:]
    if len(place) not in (2, 3):
        raise ValueError(f"expected: join {_JOIN}")
    _require_between_timesteps(session)
    if len(session.fleet) >= MAX_ROBOTS:
        raise ValueError(f"too many robots (maximum: {MAX_ROBOTS:,})")
    start = pose_of(place)
    session.add_robot(Robot(name, model.model, start, join_s=session.time_s), executable)
    return f"{name} joins at {pose_text(start.x_m, start.y_m, start.heading_rad)}"


def _admit(session: Session, names: Words) -> str:
    """Make robots that are to join later join now."""
    _require_between_timesteps(session)
    numbers = _numbers(session, names)
    session.state.admit_robots(numbers)
    joined_s = session.environment.state.presence.joined_s
    joins = f"{', '.join(names)} join{'s' * (len(names) == 1)}"
    joined_s = session.environment.state.presence.joined_s[numbers]
    waits = [name for name, at_s in zip(names, joined_s, strict=True) if math.isinf(at_s)]
    return f"{joins}; not before there is room: {', '.join(waits)}" if waits else joins


def _delay(session: Session, _programs: Sequence[Executable], words: Words) -> str:
    if not words:
        raise ValueError("expected: delay ROBOT [ROBOT ...]")
    if session.timesteps or session.state.rounds or session.state.halted is not None:
        raise ValueError("robots can be delayed only at the start of a run: 'goto start'")
    session.state.delay_robots(_numbers(session, words))
    return f"not in the world until 'join': {', '.join(words)}"


def _numbers(session: Session, names: Words) -> list[int]:
    """Return the numbers of robots."""
    known = {robot.id: number for number, robot in enumerate(session.environment.world.robots)}
    for name in names:
        if name not in known:
            raise ValueError(unknown("robot", name, tuple(known)))
    return [known[name] for name in names]


def _require_between_timesteps(session: Session) -> None:
    if session.state.rounds or session.state.halted is not None:
        raise ValueError("robots join between two timesteps: 'tick' goes to the end of this one")


def _program(programs: Sequence[Executable], words: Words) -> Executable:
    """Return the program of a name."""
    known = {PurePath(each.name).name: each for each in reversed(programs)}
    if len(words) != 1:
        raise ValueError(f"expected: join {_JOIN}")
    if words[0] not in known:
        raise ValueError(unknown("program", words[0], tuple(known)))
    return known[words[0]]


RUN_EDITS: Final = {
    "sleep": RunEdit(
        _SLEEP,
        "Put a robot's program to sleep for a time.",
        "Its motors continue to follow their last command; its processor is idle.",
        _sleep,
    ),
    "network": RunEdit(*NETWORK_HELP, change_network),
    "wake": RunEdit("ROBOT", "Wake a robot's program from any kind of sleep.", "", _wake),
    "delay": RunEdit(
        "ROBOT [ROBOT ...]",
        "Keep robots out of the world until 'join ROBOT'.",
        "Only at the start of a run. It has the effect of a join time in the world file.",
        _delay,
    ),
    "join": RunEdit(
        f"{_JOIN}, or ROBOT [ROBOT ...]",
        "Add a robot of the same kind as another: join two like robot0 to 1 2.",
        "It runs the same program as that robot, or PROGRAM, the name of another program in the "
        "run. With names alone, robots of the world that have yet to join do so now, or as soon "
        "as their place is free.",
        _join,
    ),
}
"""Changes by name, besides `EDITS`."""

ALL_EDITS: Final[dict[str, Edit | RunEdit]] = {**EDITS, **RUN_EDITS}
"""All changes by name."""
