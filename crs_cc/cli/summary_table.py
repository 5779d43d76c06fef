"""The results of a run, as a table on stderr."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final, Literal

from rich.console import Console
from rich.markup import escape
from rich.measure import Measurement
from rich.table import Table

from crs_cc.cli.messages import is_terminal, printable
from crs_cc.ir.names import plain_name
from crs_cc.runtime.diagnosis.object_text import count

if TYPE_CHECKING:
    from crs_cc.cli.summary import Run
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.session.result import Pose, RobotResult, RunResult
    from crs_cc.sim.engine.goals import GoalResult

MAX_ROWS: Final = 20
_WIDTH_ELSEWHERE: Final = 120
_UNBOUNDED: Final = 1000
_GOAL_COLUMNS: Final[tuple[tuple[str, Literal["left", "right"]], ...]] = (
    ("goal", "left"), ("", "left"), ("at", "right"), ("points", "right"), ("progress", "left"),
)  # fmt: skip
_DISPENSABLE: Final = ("fuel", "commands", "odometry", "collisions")
"""The columns dropped on a narrow terminal, in this order."""


def print_summary(run: Run) -> None:
    """Write the results to stderr as a table."""
    width = None if is_terminal(sys.stderr) else _WIDTH_ELSEWHERE
    console = Console(stderr=True, highlight=False, width=width)
    robots = run.result.robots
    with console.capture() as captured:  # rich would exit the process at a broken pipe
        console.print(_card(robots[0]) if len(robots) == 1 else _fitting_table(robots, console))
        if run.result.goals:
            console.print(_goal_table(run.result.goals))
        for line in _places(run.result):
            console.print(line, markup=False)
        for line in running_programs(run):
            console.print(line, markup=False)
        for line in lost_blocks(run):
            console.print(line, markup=False)
        console.print(_closing_line(run), style="dim")
    sys.stderr.write(captured.get())
    sys.stderr.flush()


def _goal_table(goals: Sequence[GoalResult]) -> Table:
    """Return a table of the goals, with their sum of points."""
    table = Table(box=None, pad_edge=False)
    for name, justify in _GOAL_COLUMNS:
        table.add_column(name, justify=justify)
    for goal in goals:
        at = "" if goal.at_s is None else f"{goal.at_s:.2f} s"
        row = goal.status, at, f"{goal.earned:g} of {goal.points:g}", goal.progress
        table.add_row(escape(printable(goal.title)), *row)
    earned, total = sum(goal.earned for goal in goals), sum(goal.points for goal in goals)
    table.add_row("in all", "", "", f"{earned:g} of {total:g}", "")
    return table


def _places(result: RunResult) -> Iterator[str]:
    """Yield a line for each source and each nest."""
    for source in result.sources:
        left = "" if source.left is None else f", {source.left:,} left"
        yield f"source {printable(source.id)}: {count(source.taken, 'item')} taken{left}"
    for nest in result.nests:
        yield f"nest {printable(nest.id)}: {count(nest.brought, 'item')} brought"


def _closing_line(run: Run) -> str:
    result = run.result
    return (
        f"{result.timesteps} timesteps, {result.simulated_s:.2f} s simulated in {run.wall_s:.2f} s "
        f"({run.real_time_factor:,.1f} x real time), seed {run.seed}, "
        f"state {result.state_hash[:12]}"
    )


def _card(robot: RobotResult) -> Table:
    """Return the table for one robot: a row for each figure."""
    card = Table.grid(padding=(0, 2))
    card.add_row("[bold]robot[/]", f"[bold]{escape(robot.id)}[/]  {escape(robot.program)}")
    for name, value in _figures(robot):
        card.add_row(f"[dim]{name}[/]", value)
    return card


def _fitting_table(robots: Sequence[RobotResult], console: Console) -> Table:
    """Return the table for several robots, with as many columns as fit."""
    unbounded = console.options.update(width=_UNBOUNDED)
    for number in range(len(_DISPENSABLE)):
        table = _table(robots, _DISPENSABLE[:number])
        if Measurement.get(console, unbounded, table).maximum <= console.width:
            return table
    return _table(robots, _DISPENSABLE)


def _table(robots: Sequence[RobotResult], without: Sequence[str]) -> Table:
    """Return the table for several robots: a row for each of the first `MAX_ROWS`."""
    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0))
    table.add_column("robot", style="bold")
    for name, _ in _figures(robots[0]):
        if name not in without:
            table.add_column(name)
    for robot in robots[:MAX_ROWS]:
        values = [value for name, value in _figures(robot) if name not in without]
        table.add_row(escape(robot.id), *values)
    if len(robots) > MAX_ROWS:
        outcomes = [robot.outcome for robot in robots]
        counts = [f"{outcomes.count(each)} {each}" for each in dict.fromkeys(outcomes)]
        table.add_row("...", f"in all {', '.join(counts)}")
    return table


def _figures(robot: RobotResult) -> Iterator[tuple[str, str]]:
    yield "outcome", _outcome(robot)
    yield "odometry", _pose(robot.odometry)
    yield "true pose", _pose(robot.pose)
    yield "driven", f"{robot.distance_m:.2f} m"
    yield "collisions", str(robot.collisions)
    yield "commands", str(robot.commands)
    yield "fuel", f"{robot.fuel:,}"


def _outcome(robot: RobotResult) -> str:
    at = f"at {robot.time_s:.2f} s"
    if robot.outcome == "failed":
        return f"[red]error[/] {at}"
    if robot.outcome == "exited":
        status = robot.exit_status or 0
        return f"exit {status} {at}" if status == 0 else f"[yellow]exit {status}[/] {at}"
    if robot.outcome == "absent":
        return "never joined"
    return f"{robot.outcome} {at}"


def _pose(pose: Pose) -> str:
    x_m, y_m, heading_rad = pose
    heading_deg = math.degrees(math.remainder(heading_rad, math.tau))
    return f"{x_m:.2f} {y_m:.2f} m {heading_deg:.0f}°"


LONG_S: Final = 5.0
"""A program that has not called its robot for longer than this may hang."""

MAX_NAMES: Final = 3
MAX_LINES: Final = 5


def running_programs(run: Run) -> Iterator[str]:
    """Yield a line for each of the first few locations of programs that have not ended."""
    alike: dict[tuple[str, str], list[RobotResult]] = {}
    for robot, call in zip(run.result.robots, run.calls, strict=True):
        if call is not None:
            last_call = _last_call(robot)
            alike.setdefault((_place(call, alone=len(run.calls) == 1), last_call), []).append(robot)
    for (place, last_call), robots in list(alike.items())[:MAX_LINES]:
        verb = "is" if len(robots) == 1 else "are"
        yield f"{_names(robots)} {verb} {place}{last_call}"
    if len(alike) > MAX_LINES:
        yield f"... and {len(alike) - MAX_LINES} more places"


def lost_blocks(run: Run) -> Iterator[str]:
    """Yield a line for each of the first few locations whose heap blocks were never freed."""
    alike: dict[tuple[str, int, int], list[RobotResult]] = {}
    for number, robot in enumerate(run.result.robots):
        for lost in run.lost_blocks_of(number):
            site = lost.allocated[0] if lost.allocated else None
            where = f", allocated at {site.location} in {plain_name(site.function)}" if site else ""
            key = where, len(lost.sizes), sum(lost.sizes)
            alike.setdefault(key, []).append(robot)
    for (where, number, size), robots in list(alike.items())[:MAX_LINES]:
        blocks = f"{count(number, 'heap block')} of {count(size, 'byte')}"
        yield printable(f"{_names(robots)}: lost {blocks}{where}: neither freed nor pointed to")
    if len(alike) > MAX_LINES:
        yield f"... and blocks from {len(alike) - MAX_LINES} more places"


def _place(call: ActiveCall, *, alone: bool) -> str:
    """Return the location of a program, with the call's arguments if it is the only one."""
    text = str(call) if alone else f"{call.function}()"
    return f"in {printable(text)} at {printable(str(call.location))}"


def _last_call(robot: RobotResult) -> str:
    if robot.robot_call_s is None:
        return ", no robot call so far" if robot.time_s > LONG_S else ""
    if robot.time_s - robot.robot_call_s > LONG_S:
        return f", no robot call since {robot.robot_call_s:.2f} s"
    return ""


def _names(robots: list[RobotResult]) -> str:
    names = [printable(robot.id) for robot in robots[:MAX_NAMES]]
    more = len(robots) - len(names)
    return ", ".join(names) + (f" and {more} more" if more else "")
