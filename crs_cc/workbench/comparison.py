"""How another run differs from this one, in what is known of both: at once, and roughly.

Robots are those of the same names. Compared are what they did and measured, what happened, and what
programs printed; variables are compared by `exact_comparison`, which has the programs run again.
"""

from __future__ import annotations

import math
from itertools import zip_longest
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.debug.errors import DebugError
from crs_cc.workbench.quantities import QUANTITIES
from crs_cc.workbench.trace import thinned
from crs_cc.workbench.trajectories import (
    Trajectories,
    common_times_s,
    distance_m,
    equal_or_absent,
    robots_of,
    trajectories,
    wrap_angles,
)

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from crs_cc.workbench.feed import Event, Feed
    from crs_cc.workbench.trace import Samples

MAX_DIFFERENCES: Final = 60
MAX_PATHS: Final = 50
MAX_POINTS: Final = 500

_MAX_TEXT: Final = 80
_STORED: Final = 1.6e-4  # of a pose [m, rad]: frames have four digits
_BETWEEN: Final = 5e-3  # for a pose between two frames

Difference = dict[str, Any]
"""When two runs first differ in something: time `t`, `robot`, `what`, the values `here` and
`there`, and, of numbers, `by` how much."""


def compare(own: Feed, other: Feed) -> dict[str, Any]:
    """Return where two runs first differ, and the paths of both from there on.

    Raises:
        DebugError: they have no robot in common.
    """
    names = common_robots(own, other)
    until_s = min(own.end_s, other.end_s)
    found = sorted(
        [
            *_quantities(own, other, names),
            *_firsts("event", names, (_events(own), _events(other)), until_s),
            *_firsts("print", names, (_lines(own), _lines(other)), until_s),
        ],
        key=lambda each: float(each["t"]),
    )
    begin_s = found[0]["t"] if found else math.inf
    return {
        "differences": found[:MAX_DIFFERENCES],
        "until": until_s,
        "end": other.end_s,
        "paths": _paths(other, names[:MAX_PATHS], begin_s),
        "own": _paths(own, names[:MAX_PATHS], begin_s),
    }


def common_robots(own: Feed, other: Feed) -> list[str]:
    """Return the robots that are in both runs, in the order of this one.

    Raises:
        DebugError: there are none.
    """
    there = set(robots_of(other))
    found = [name for name in robots_of(own) if name in there]
    if not found:
        raise DebugError("these runs have no robot of the same name: nothing can be compared")
    return found


def distance_to_run(
    own: Feed, other: Feed, robot: int, *, begin_s: float, end_s: float, most: int
) -> Samples:
    """Return the distance between the positions of a robot in two runs, over time [m]."""
    names = robots_of(own)[robot : robot + 1]
    if not names or names[0] not in robots_of(other):
        return [], []
    here, there = (trajectories(each, names, begin_s, end_s) for each in (own, other))
    times_s, _ = common_times_s(here, there)
    times_s = times_s[(times_s >= begin_s - 1e-9) & (times_s <= end_s + 1e-9)]
    found = distance_m(here.interpolate(times_s), there.interpolate(times_s))[:, 0]
    found[found < 2 * _STORED] = 0.0
    return thinned(times_s.tolist(), found, most)


def _quantities(own: Feed, other: Feed, names: Sequence[str]) -> Iterator[Difference]:
    """Yield the first differences of traced quantities, or else of poses."""
    if _is_traced(own) and _is_traced(other) and robots_of(own) == robots_of(other):
        for each in own.trace.first_differences(other.trace):
            if each.robot < len(names):
                values = each.here, each.there
                yield _difference(each.time_s, names[each.robot], each.name, values)
        return
    end_s = min(own.end_s, other.end_s)
    here, there = (trajectories(each, names, 0.0, end_s) for each in (own, other))
    yield from _poses(here, there, names)


def _is_traced(feed: Feed) -> bool:
    times_s, _ = feed.trace.motion(feed.end_s - 1.0, math.inf)
    return len(times_s) > 0 and times_s[-1] >= feed.end_s - 1e-6


def _poses(own: Trajectories, other: Trajectories, names: Sequence[str]) -> Iterator[Difference]:
    times_s, are_alike = common_times_s(own, other)
    here, there = own.interpolate(times_s), other.interpolate(times_s)
    displacements = here - there
    displacements[:, 2] = wrap_angles(displacements[:, 2])
    tolerance = _STORED if are_alike else _BETWEEN
    differs = ~equal_or_absent(displacements, np.zeros_like(displacements), tolerance)
    differs &= ~(np.isnan(here) & np.isnan(there))
    here[:, 2], there[:, 2] = (np.degrees(each[:, 2]) % 360.0 for each in (here, there))
    for column, what in enumerate(("pose.x", "pose.y", "pose.heading")):
        for robot, name in enumerate(names):
            rows = np.flatnonzero(differs[:, column, robot])
            if len(rows):
                at = rows[0]
                values = float(here[at, column, robot]), float(there[at, column, robot])
                yield _difference(float(times_s[at]), name, what, values)


def _difference(time_s: float, robot: str, what: str, values: tuple[float, float]) -> Difference:
    here, there = values
    unit = QUANTITIES[what].unit if what in QUANTITIES else "m"
    step = abs(here - there)
    if what == "pose.heading":
        step = min(step, 360.0 - step)
    return {
        "t": time_s,
        "robot": robot,
        "what": what,
        "here": _shown(here),
        "there": _shown(there),
        "by": "" if math.isnan(step) else f"{step:.3g} {unit}".strip(),
    }


def _shown(value: float) -> str:
    return "nothing" if math.isnan(value) else f"{value:.4g}"


Happening = tuple[float, str, str]
"""Time [s], robot, text."""


def _events(feed: Feed) -> list[Happening]:
    """Return the events of the world in order."""
    return [
        (round(time_s, 3), _name(feed, robot), text)
        for time_s, kind, robot, text, *_ in _of_the_world(feed.events())
    ]


def _of_the_world(events: Sequence[Event]) -> Iterator[Event]:
    for event in events:
        if event[1] not in {"note", "change", "warning"} and not event[1].startswith("message"):
            yield event


def _lines(feed: Feed) -> list[Happening]:
    """Return the lines that programs printed, in the order in which they ended."""
    begun: dict[tuple[str, int], str] = {}
    found: list[Happening] = []
    for time_s, robot, stream, text in feed.output():
        name = _name(feed, robot)
        *lines, rest = (begun.get((name, stream), "") + text).split("\n")
        found += [(round(time_s, 3), name, line) for line in lines]
        begun[name, stream] = rest
    return found


def _name(feed: Feed, robot: int | str) -> str:
    if isinstance(robot, str):  # a recording names it
        return robot
    names = robots_of(feed)
    return names[robot] if 0 <= robot < len(names) else ""


def _firsts(
    what: str, names: Sequence[str], both: tuple[list[Happening], list[Happening]], until_s: float
) -> Iterator[Difference]:
    """Yield of each robot the first happening that is not in both runs."""
    for name in names:
        own, other = ([each for each in run if each[1] == name] for run in both)
        yield from _first(what, own, other, until_s)


def _first(
    what: str, own: Sequence[Happening], other: Sequence[Happening], until_s: float
) -> Iterator[Difference]:
    """Yield the first happening of a robot that is not in both runs, which are the same before.

    One of a time up to which a run is not known is no difference.
    """
    for mine, theirs in zip_longest(own, other):
        if mine == theirs:
            continue
        there = [each for each in (mine, theirs) if each is not None and each[0] < until_s]
        if there:
            first = min(there)
            yield {
                "t": first[0],
                "robot": first[1],
                "what": what,
                "here": _text(mine, first),
                "there": _text(theirs, first),
                "by": "",
            }
        return


def _text(happening: Happening | None, first: Happening) -> str:
    if happening is None or happening[:2] != first[:2]:
        return "not then"
    return happening[2][:_MAX_TEXT].strip()


def _paths(feed: Feed, names: Sequence[str], begin_s: float) -> dict[str, list[list[float]]]:
    """Return the paths of robots from a time on, thinned: x, y [m] and time [s]."""
    if math.isinf(begin_s):
        return {}
    known = trajectories(feed, names, begin_s, math.inf)
    chosen = np.flatnonzero(known.times_s >= begin_s - 1e-9)
    chosen = chosen[:: max(1, -(-len(chosen) // MAX_POINTS))]
    times_s, poses = known.times_s[chosen], known.poses[chosen]
    return {
        name: [
            [round(float(x), 3), round(float(y), 3), round(float(time_s), 3)]
            for time_s, (x, y) in zip(times_s, poses[:, :2, row], strict=True)
            if not math.isnan(x)
        ]
        for row, name in enumerate(names)
    }
