"""The branches of a run as pages know them: what happened in each.

The engine makes a branch when something is changed in the past; what pages knew of the run that is
left is kept here beside it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.branch_facts import branch_facts
from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.debug.branch_comparison import Facts
    from crs_cc.debug.engine import Debugger
    from crs_cc.workbench.feed import Feed
    from crs_cc.workbench.watcher import Watcher

_MAX_NAME: Final = 80


class BranchFeeds:
    """The feeds of all branches of a run."""

    def __init__(self, debugger: Debugger, watcher: Watcher) -> None:
        """Let the engine keep runs that changes in the past leave."""
        self._debugger, self._watcher = debugger, watcher
        self._name = debugger.branches.current.name
        self._left: dict[str, Feed] = {}
        self._since_s = {self._name: 0.0}
        debugger.branches.keeps_past = True

    def store_left_branch(self) -> None:
        """Store the feed of the branch that the engine has left by a change."""
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
        self._watcher.feed.replace_with(self._left.pop(name))

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

    def feed(self, name: str) -> Feed:
        """Return the known data of another branch.

        Raises:
            DebugError: it does not exist.
        """
        return self._known(name)

    def common_until_s(self, name: str) -> float:
        """Return the time up to which another branch and this one are certainly equal [s]."""
        names = list(self._debugger.branches.names())
        first = min(names.index(name), names.index(self._name))
        return min((self._since_s.get(each, 0.0) for each in names[first + 1 :]), default=0.0)

    @property
    def current(self) -> str:
        """The name of this branch."""
        return self._name

    def facts(self, name: str, timesteps: Sequence[int]) -> list[Facts]:
        """Return the comparable state of a branch at the starts of timesteps, silently.

        Raises:
            DebugError: it does not exist.
        """
        known_s, timestep_s = (
            self._watcher.feed.end_s,
            self._debugger.session.environment.timestep_s,
        )
        self._watcher.stop()
        try:
            return branch_facts(self._debugger, name, timesteps)
        finally:
            self._watcher.resume(round(known_s / timestep_s))

    def _known(self, name: str) -> Feed:
        found = self._left.get(name)
        if found is None:
            raise DebugError(f"unknown run '{name[:_MAX_NAME]}'")
        return found
