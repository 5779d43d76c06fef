"""The events of a run and the paths of its robots, for timelines and maps.

Every timestep that has ever been run is recorded, also those ahead of a run that has gone
back: they repeat unless the user changes something.
"""

from __future__ import annotations

import copy
from bisect import bisect_left
from collections.abc import Sequence
from operator import itemgetter
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.debug.world.events import KINDS, WorldEvent, world_events
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.engine.step import Step

_KINDS: Final = tuple(kind for kind in KINDS if kind != "tick" and "-" not in kind)
_MAX_EVENTS: Final = 20_000
"""More are not kept: the older half goes. Chosen by us, some megabytes."""
_MAX_POSES: Final = 2_000
"""Points of a path; when there are more, every second one goes. Chosen by us: a map has less."""
_PUSHED: Final = 2.0
_PUSHED_M: Final = 0.1
"""How much farther than it can drive a robot may be pushed; what gets farther was carried. Chosen
by us."""


class EventHistory:
    """The events of each timestep of a branch.

    Attributes:
        timesteps: how many timesteps are recorded.
    """

    def __init__(self) -> None:
        """Create an empty history."""
        self.timesteps = 0
        self._happened: list[tuple[int, WorldEvent]] = []
        self._stride = 1
        self._poses: list[tuple[int, FloatArray]] = []  # at the end of every `stride`th timestep
        self._farthest_m: FloatArray = np.zeros(0)  # that each robot drives in a timestep

    def record_step(self, step: Step, environment: Environment) -> None:
        """Record the events of a timestep that has just ended, unless recorded before."""
        if step.cycle < self.timesteps:
            return
        self.timesteps = step.cycle + 1
        if _is_eventful(step):
            for each in world_events(step, environment.world, _KINDS):
                self._add(step.cycle, each)
        if step.cycle % self._stride == 0:
            self._record_poses(step.cycle, environment)

    def note(self, timestep: int, event: WorldEvent) -> None:
        """Record another event of a timestep, once."""
        if (timestep, event) not in self._happened:
            self._add(timestep, event)

    def _add(self, timestep: int, event: WorldEvent) -> None:
        self._happened.append((timestep, event))
        if len(self._happened) > _MAX_EVENTS:
            del self._happened[: _MAX_EVENTS // 2]

    def _record_poses(self, timestep: int, environment: Environment) -> None:
        state, robots = environment.state, environment.world.robots
        if len(self._farthest_m) != len(robots):
            limits_mps = [robot.model.drive.wheels.speed_limit for robot in robots]
            self._farthest_m = np.array(limits_mps) * environment.timestep_s
        places = np.column_stack([state.x_m, state.y_m])
        places[~state.presence.present] = np.nan
        self._poses.append((timestep, places))
        if len(self._poses) > _MAX_POSES:
            self._stride *= 2
            self._poses = [each for each in self._poses if each[0] % self._stride == 0]

    def world_events(self) -> Sequence[WorldEvent]:
        """Return all events by time, also those ahead of the current position."""
        return sorted((each for _, each in self._happened), key=lambda each: each.time_s)

    def by_timestep(self) -> list[tuple[int, WorldEvent]]:
        """Return all events by time, each with the timestep in which it happened."""
        return sorted(self._happened, key=lambda each: each[1].time_s)

    def contacts(self, timestep: int) -> list[tuple[int, float, float]]:
        """Return the robot and the position [m] of contacts before a timestep."""
        return [
            (each.robot, *each.place)
            for at, each in self._happened
            if at < timestep and each.place is not None
        ]

    def paths(self, timestep: int) -> list[FloatArray]:
        """Return the path of each robot [m] before a timestep, (n, 2) each.

        A row of NaN separates positions between which it was moved by hand.
        """
        known = [(at, places) for at, places in self._poses if at < timestep]
        if not known:
            return []
        robots = max(len(places) for _, places in known)
        return [self._path(known, robot) for robot in range(robots)]

    def _path(self, known: Sequence[tuple[int, FloatArray]], robot: int) -> FloatArray:
        rows = [(at, *places[robot]) for at, places in known if robot < len(places)]
        path = np.array(rows).reshape(-1, 3)
        path = path[~np.isnan(path[:, 1])]
        timesteps, ways = np.diff(path[:, 0]), np.diff(path[:, 1:], axis=0)
        farthest_m = _PUSHED * self._farthest_m[robot] * timesteps + _PUSHED_M
        jumps = np.flatnonzero(np.hypot(ways[:, 0], ways[:, 1]) > farthest_m)
        return np.insert(path[:, 1:], jumps + 1, np.nan, axis=0)

    def truncate(self, timestep: int) -> None:
        """Discard a timestep and all later ones."""
        self.timesteps = min(self.timesteps, timestep)
        self._happened = [each for each in self._happened if each[0] < timestep]
        self._poses = self._poses[: bisect_left(self._poses, timestep, key=itemgetter(0))]

    def fork(self, timestep: int) -> EventHistory:
        """Return an independent copy of the timesteps before this one."""
        other = copy.copy(self)
        other.truncate(timestep)
        return other


def _is_eventful(step: Step) -> bool:
    return bool(
        step.events
        or len(step.contacts.robot)
        or len(step.traffic)
        or step.pressed.any()
        or step.released.any()
    )
