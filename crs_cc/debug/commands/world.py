"""Commands about robots and their world, and those that change it (`world.edits`)."""

from __future__ import annotations

from functools import partial
from typing import Final

from crs_cc.core.quantity import LENGTH
from crs_cc.core.suggest import unknown
from crs_cc.debug.commands.answer import Answer, NestedCommand
from crs_cc.debug.commands.arguments import (
    parse_count,
    parse_numbers,
    parse_robot,
    require_argument,
)
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.errors import DebugError
from crs_cc.debug.interventions import interventions, revert
from crs_cc.debug.world.goal_rows import goal_rows
from crs_cc.debug.world.robot_rows import HEADINGS, robot_rows, summary
from crs_cc.debug.world.rows import lines
from crs_cc.debug.world.run_edits import ALL_EDITS
from crs_cc.debug.world.run_map import run_map
from crs_cc.debug.world.state_rows import vendor_state_rows
from crs_cc.debug.world.world_rows import world_rows

_COLUMNS: Final = 78
_ROWS: Final = 24
_AROUND_M: Final = 6.0
_MIN_M, _MAX_M = 0.01, 100_000.0
"""The size of a map, which is the same on every terminal, as scripts have it; chosen by us."""


def _robots(context: CommandContext, _text: str) -> Answer:
    session = context.debugger.session
    rows = [HEADINGS, *(summary(session, each) for each in range(len(context.debugger.names)))]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for number, row in enumerate(rows, -1):
        mark = "=>" if number == context.debugger.view.robot else "  "
        cells = (cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        yield f"{mark} {'  '.join(cells)}".rstrip()


def _robot(context: CommandContext, text: str) -> Answer:
    names, view = context.debugger.names, context.debugger.view
    word, _, rest = text.partition(" ")
    if word == "apply":
        yield from _apply(context, rest.strip())
        return
    if text:
        view.select_robot(parse_robot(text, names))
    yield f"{names[view.robot]} (robot {view.robot})"
    yield from context.show_selection()


def _apply(context: CommandContext, text: str) -> Answer:
    """Execute a command for each of some robots, and select the one that was selected again."""
    debugger = context.debugger
    names, before = debugger.names, (debugger.view.robot, debugger.view.frame)
    words = require_argument(text, "robot apply (all|NAME...) COMMAND").split()
    chosen: list[int] = []
    if words[0] == "all":
        chosen, words = list(range(len(names))), words[1:]
    while words and (words[0] in names or words[0].isdigit()):
        chosen.append(parse_robot(words.pop(0), names))
    command = require_argument(" ".join(words), "a command: robot apply all COMMAND")
    if not chosen:
        raise DebugError(f"which robots? {unknown('robot', words[0], names)}")
    try:
        for robot in chosen:
            debugger.view.select_robot(robot)
            yield f"{names[robot]}:"
            yield NestedCommand(command)
    finally:
        debugger.view.robot, debugger.view.frame = before


def _info_robot(context: CommandContext, text: str) -> Answer:
    debugger = context.debugger
    robot = parse_robot(text, debugger.names) if text else debugger.view.robot
    yield from lines(robot_rows(debugger.session, robot))


def _info_world(context: CommandContext, _text: str) -> Answer:
    yield from lines(world_rows(context.debugger.session.environment))


def _info_goals(context: CommandContext, _text: str) -> Answer:
    rows = goal_rows(context.debugger.session.goals)
    if not rows:
        raise DebugError("the world has no goals")
    yield from lines(rows)


def _info_state(context: CommandContext, text: str) -> Answer:
    debugger = context.debugger
    robot = parse_robot(text, debugger.names) if text else debugger.view.robot
    rows = vendor_state_rows(debugger.view, robot)
    if not rows:
        raise DebugError(f"{debugger.names[robot]}'s program has no State[]")
    yield from lines(rows)


def _map(context: CommandContext, text: str) -> Answer:
    debugger, words = context.debugger, text.split()
    across_m = _across_m(words.pop()) if len(words) > 1 else _AROUND_M
    if words:
        robot = parse_robot(" ".join(words), debugger.names)
        chart = run_map(debugger.view, _COLUMNS, _ROWS, robot=robot, across_m=across_m)
    else:
        chart = run_map(debugger.view, _COLUMNS, _ROWS)
    rows = ["".join(piece for piece, _ in row).rstrip() for row in chart.pieces]
    drawn = [number for number, row in enumerate(rows) if row]
    yield from rows[drawn[0] : drawn[-1] + 1] if drawn else ()


def _across_m(text: str) -> float:
    """Return the height of a map; raise DebugError if it is not a valid length."""
    try:
        across_m = LENGTH.parse(text)
    except ValueError as wrong:
        raise DebugError(str(wrong)) from None
    if not _MIN_M <= across_m <= _MAX_M:
        raise DebugError(f"the map's height must be {_MIN_M:g} to {_MAX_M:g} m")
    return across_m


def _output(context: CommandContext, text: str) -> Answer:
    debugger = context.debugger
    is_numbered = text.split()[:1] == ["/n"]
    words = text.split()[is_numbered:]
    most = parse_count(words.pop()) if words and words[-1].isdigit() else 0
    robot = parse_robot(" ".join(words), debugger.names) if words else None
    written = debugger.run.console.text(robot).decode(errors="replace").splitlines()
    if is_numbered and robot is not None:
        raise DebugError("/n numbers the output of all robots")
    rows = [f"{n:5}  {each}" for n, each in enumerate(written, 1)] if is_numbered else written
    yield from rows[-most:] if most else rows


WORLD: Final = Group(
    "world",
    "Robots and their world.",
    (
        Command(
            "robots", "", "List the robots with their activity and position.", _robots,
            ("info robots", "info threads"),
        ),
        Command(
            "robot", "[NAME|apply (all|NAME...) COMMAND]",
            "Select a robot, or show the selected one.",
            _robot, ("thread", "t"),
            text="NAME is the robot's name in the world, or its number. With apply all, or apply"
            " and names, execute a command for each: robot apply all backtrace.",
            completes="robot",
        ),
        Command(
            "info robot", "[NAME]", "Describe a robot: pose, sensors, command.",
            _info_robot, completes="robot",
        ),
        Command(
            "info state", "[NAME]",
            "Show State[] of a robot's program with names and units.",
            _info_state, ("info State",), completes="robot",
        ),
        Command("info world", "", "Describe the world: its time and its objects.",
                _info_world),
        Command(
            "info goals", "", "Show the goals of the world, and when each was met.", _info_goals,
            text="A goal that holds would be met if the run ended now. catch goal stops when one"
            " is met or fails.",
        ),
        Command(
            "map", "[NAME [METRES]]", "Draw a map of the world, or of the surroundings of a robot.",
            _map,
            text="Around a robot, its last sonar echoes are also drawn; METRES is the height of"
            " the map.",
            completes="robot",
        ),
        Command(
            "output", "[/n] [ROBOT] [LINES]", "Show the output of the programs up to here.",
            _output, text="With /n, number its lines, for goto output N.", completes="robot",
        ),
    ),
)  # fmt: skip


def _change(context: CommandContext, text: str, *, name: str) -> Answer:
    yield f"{context.debugger.edit_world(f'{name} {text}')}."


def _info_edits(context: CommandContext, _text: str) -> Answer:
    debugger = context.debugger
    timestep_s = debugger.session.environment.world.timestep_s
    done = interventions(debugger)
    if not done:
        yield "No edits."
    for number, each in enumerate(done, 1):
        whose = f"{debugger.names[each.robot]}: " if each.robot >= 0 else ""
        yield f"{number:<3} t = {each.place.timestep * timestep_s:.3f} s  {whose}{each.text}"


def _undo(context: CommandContext, text: str) -> Answer:
    made = len(interventions(context.debugger))
    numbers = parse_numbers(text) or [made]
    if len(numbers) > 1:
        raise DebugError("expected the number of one edit; later ones are undone with it")
    if not made:
        raise DebugError("there is nothing to undo")
    if not 1 <= numbers[0] <= made:
        raise DebugError(f'no edit {numbers[0]}; see "info edits"')
    return context.move(partial(revert, context.debugger, numbers[0] - 1))


CHANGES: Final = Group(
    "changes",
    "Changes to the world, which start a new history.",
    (
        *(
            Command(
                name, each.syntax, each.summary, partial(_change, name=name),
                text=each.text, completes="edit",
            )
            for name, each in ALL_EDITS.items()
        ),
        Command(
            "info edits", "",
            "List the changes to the run, and the lines typed for programs.",
            _info_edits, ("info changes",),
        ),
        Command(
            "undo", "[N]", "Undo a change, and go to where it was made.", _undo,
            text="N is its number (see \"info edits\"); all later changes are undone with it. "
            "Default is the last change. If the change was a line typed for a program, the "
            "program waits for the line again.",
        ),
    ),
)  # fmt: skip
