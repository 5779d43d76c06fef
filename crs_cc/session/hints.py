"""Hints about probable mistakes: moves that are cut off, speeds beyond the robot's, and others.

Each kind is noted once for each program. What is noted is not part of the state of a run.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Records, any_of
from crs_cc.requests import CODES

if TYPE_CHECKING:
    from crs_cc.core.source import Location
    from crs_cc.runtime.fleet import Fleet
    from crs_cc.sim.devices.drive.constants import Drives
    from crs_cc.sim.engine.environment import Environment

_MOVE: Final = CODES["PR"]
_SPEED: Final = CODES["VM"]
_SETTINGS: Final = frozenset({CODES["SP"], CODES["AC"], CODES["CONF_TM"], _SPEED})
"""Requests that do not show that a program follows its move; a new speed is meant to end it."""

_ROUNDING: Final = 1e-6


@dataclass(frozen=True, slots=True)
class Hint:
    """A doubtful call of the robot, or a doubtful comparison.

    Attributes:
        robot: the robot's number.
        flag: the name of its warning, see `core.warning_names`.
        text: the message.
        advice: what to do about it.
        location: where it is, if that is known.
    """

    robot: int
    flag: str
    text: str
    advice: str
    location: Location | None


class Hints:
    """Watches the requests of all programs.

    Attributes:
        found: the hints so far, in order.
    """

    def __init__(self, environment: Environment, fleet: Fleet) -> None:
        self.found: list[Hint] = []
        self._environment = environment
        self._fleet = fleet
        self._known: set[tuple[str, str]] = set()
        self._moves = np.zeros(len(fleet), np.bool_)
        self._most: FloatArray | None = None
        self._most_of: Drives | None = None

    def note_requests(
        self, code: int, robots: IndexArray, messages: Records, at_s: FloatArray
    ) -> None:
        """Check requests of one kind before they are served.

        Args:
            code: the request.
            robots: the robots, k of them.
            messages: their messages.
            at_s: when they arrive, shape (k,).
        """
        if len(self._moves) < len(self._fleet):  # robots have joined
            self._moves = np.append(
                self._moves, np.zeros(len(self._fleet) - len(self._moves), np.bool_)
            )
        if code == _MOVE:
            self._note_moves(robots, at_s)
        elif code == _SPEED:
            self._note_speeds(robots, messages)
        if code not in _SETTINGS and (code == _MOVE or any_of(self._moves)):
            self._moves[robots] = code == _MOVE

    @property
    def follows_moves(self) -> bool:
        """Whether any program has asked for nothing since it began a move."""
        return any_of(self._moves)

    def most_units(self) -> FloatArray:
        """Return the speeds above which `vm` is noted, (robots, 3), infinite if it was before.

        It is the same array while that holds.
        """
        drives = self._environment.drives
        if self._most is None or self._most_of is not drives:
            most, robots = drives.most_units.copy(), range(len(self._fleet))
            programs = [self._fleet.executable(robot).name for robot in robots]
            most[[(name, "speed-limit") in self._known for name in programs]] = np.inf
            self._most, self._most_of = most, drives
        return self._most

    def comparisons(self) -> list[Hint]:
        """Return the first comparison of pointers to different objects of each program."""
        found: dict[str, Hint] = {}
        for robot in np.flatnonzero(self._fleet.timing["compared_site"]).tolist():
            program = self._fleet.executable(robot).name
            pair = self._fleet.compared_pointers(robot) if program not in found else None
            if pair is not None:
                advice = "C leaves their order open; to compare addresses, convert to 'uintptr_t'"
                found[program] = Hint(robot, "pointer-order", pair.text, advice, pair.location)
        return list(found.values())

    def note_exit(self, robot: int, at_s: float) -> None:
        """Record that a program ends by itself."""
        if robot < len(self._moves) and self._moves[robot]:
            left_s = float(self._left_s(np.array([robot]), np.array([at_s]))[0])
            if left_s > 0.0:
                text = f"the program ends {left_s:.1f} s before its last 'pr' is done"
                self._add(robot, "unfinished-move", text, "call ws after pr to wait for its end")

    def _note_moves(self, robots: IndexArray, at_s: FloatArray) -> None:
        """Record moves that replace another one, after which there was no request."""
        again = self._moves[robots]
        if not again.any():
            return
        left_s = self._left_s(robots[again], at_s[again])
        for index in np.flatnonzero(left_s > 0.0)[:1].tolist():
            text = f"'pr' replaces another 'pr' that would run for {left_s[index]:.1f} s more"
            advice = "call ws between them to wait for the end of the first"
            self._add(int(robots[again][index]), "unfinished-move", text, advice)

    def _left_s(self, robots: IndexArray, at_s: FloatArray) -> FloatArray:
        """Return the remaining times of robots' moves [s], 0 for those that have ended."""
        axes = self._environment.state.drive.axes
        moving = axes.limit[robots] > 0.0
        end_s = np.where(moving, axes.end_s(robots), 0.0).max(axis=1)
        return np.asarray(np.maximum(end_s - at_s - _ROUNDING, 0.0))

    def _note_speeds(self, robots: IndexArray, messages: Records) -> None:
        asked, drives = messages["i"][:, :3], self._environment.drives
        if not any_of(np.abs(asked) > drives.most_units.take(robots, axis=0)):
            return
        unit, limit = drives.unit[robots], drives.speed_limit[robots]
        above = np.abs(asked * unit) > limit * (1.0 + _ROUNDING)
        if not any_of(above):
            return
        for index, axis in np.argwhere(above)[:1].tolist():
            robot = int(robots[index])
            most = round(float(limit[index, axis] / unit[index, axis]))
            text = (
                f"'vm' asks for a speed of {asked[index, axis]}, but this robot's limit is {most}"
            )
            self._add(robot, "speed-limit", text, "the robot moves at its limit")

    def _add(self, robot: int, flag: str, text: str, advice: str) -> None:
        program = self._fleet.executable(robot).name
        if (program, flag) not in self._known:
            self._known.add((program, flag))
            self._most = None
            call = self._fleet.library_call(robot)
            location = call.location if call else None
            self.found.append(Hint(robot, flag, text, advice, location))
