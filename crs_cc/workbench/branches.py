"""The branches of a run as pages know them: what happened in each, and how two of them differ.

The engine makes a branch when something is changed in the past; what pages knew of the run that is
left is kept here beside it.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.debug.engine import Debugger
    from crs_cc.workbench.feed import Feed
    from crs_cc.workbench.watcher import Watcher

MAX_DIFFERENCES: Final = 60
MAX_PATHS: Final = 50
MAX_POINTS: Final = 500

_LONGEST: Final = 80


class KnownBranches:
    """What is known of each branch of a run."""

    def __init__(self, debugger: Debugger, watcher: Watcher) -> None:
        """Have the engine keep what is left by changes in the past."""
        self._debugger, self._watcher = debugger, watcher
        self._name = debugger.branches.current.name
        self._left: dict[str, Feed] = {}
        self._since_s = {self._name: 0.0}
        debugger.branches.keeps_past = True

    def notice(self) -> None:
        """Keep what is known of the branch that the engine has left by a change."""
        name = self._debugger.branches.current.name
        if name == self._name:
            return
        self._left[self._name] = self._watcher.feed.fork()
        self._name = name
        self._since_s[name] = self._debugger.session.time_s
        for gone in set(self._left) - set(self._debugger.branches.names()):
            del self._left[gone]

    def switch(self, name: str) -> None:
        """Go to another branch, at the same time if it is known there.

        Raises:
            DebugError: it does not exist.
        """
        known = self._known(name)
        debugger, now_s = self._debugger, self._debugger.session.time_s
        timestep_s = debugger.session.environment.timestep_s
        self._left[self._name] = self._watcher.feed.fork()
        self._watcher.stop()
        debugger.switch(name)
        debugger.goto_time(min(now_s, max(0.0, known.end_s)))
        self._name = name
        self._watcher.resume(round(known.end_s / timestep_s))
        self._watcher.feed.become(self._left.pop(name))

    def listing(self) -> list[dict[str, Any]]:
        """Return the branches, in the order in which they were made."""
        return [
            {
                "name": name,
                "current": name == self._name,
                "since": self._since_s.get(name, 0.0),
                "end": (self._left.get(name) or self._watcher.feed).end_s,
            }
            for name in self._debugger.branches.names()
        ]

    def compare(self, name: str) -> dict[str, Any]:
        """Return where this branch and another one first differ, and the paths of the other.

        Raises:
            DebugError: it does not exist.
        """
        other, own = self._known(name), self._watcher.feed
        found = sorted(
            [
                *_quantities(own, other, self._debugger.names),
                *_first("event", own.events(), other.events(), self._debugger.names),
                *_first("print", own.output(), other.output(), self._debugger.names),
            ],
            key=lambda each: float(each["t"]),
        )
        begin_s = found[0]["t"] if found else math.inf
        return {
            "name": name,
            "differences": found[:MAX_DIFFERENCES],
            "paths": _paths(other, begin_s, len(self._debugger.names)),
        }

    def _known(self, name: str) -> Feed:
        found = self._left.get(name)
        if found is None:
            raise DebugError(f"no other run '{name[:_LONGEST]}' is kept")
        return found


def _quantities(own: Feed, other: Feed, names: Sequence[str]) -> list[dict[str, Any]]:
    return [
        {
            "t": each.time_s,
            "robot": names[each.robot],
            "what": each.name,
            "here": _shown(each.here),
            "there": _shown(each.there),
        }
        for each in own.trace.first_differences(other.trace)
        if each.robot < len(names)
    ]


def _shown(value: float) -> str:
    return "nothing" if math.isnan(value) else f"{value:.4g}"


def _first(
    what: str, own: Sequence[Any], other: Sequence[Any], names: Sequence[str]
) -> list[dict[str, Any]]:
    """Return the first of some happenings that is not in both, which are equal before.

    One that has not happened yet in a run that is not known so far is no difference.
    """
    for mine, theirs in zip(own, other, strict=False):
        if mine != theirs:
            first = min(mine, theirs, key=lambda each: float(each[0]))
            robot = first[1] if what == "print" else first[2]
            return [
                {
                    "t": first[0],
                    "robot": names[robot] if 0 <= robot < len(names) else "",
                    "what": what,
                    "here": mine[3][:_LONGEST].strip() if mine is first else "not then",
                    "there": theirs[3][:_LONGEST].strip() if theirs is first else "not then",
                }
            ]
    return []


def _paths(feed: Feed, begin_s: float, robots: int) -> list[list[list[float]]]:
    """Return the paths of the first robots from a time on, thinned: x, y [m] and time [s]."""
    frames = list(feed.frames.between(begin_s, math.inf))
    frames = frames[:: max(1, -(-len(frames) // MAX_POINTS))]
    return [
        [
            [round(float(frame[0, robot]), 3), round(float(frame[1, robot]), 3), round(time_s, 3)]
            for time_s, frame in frames
            if robot < frame.shape[1] and not math.isnan(frame[0, robot])
        ]
        for robot in range(min(robots, MAX_PATHS))
    ]
