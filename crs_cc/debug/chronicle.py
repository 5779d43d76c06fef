"""What has happened in a run, and where its robots have been: for time lines and maps.

It is known of every timestep that has ever been run, also of those ahead once the run has gone
back: they come again as they were, unless the user changes something.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.debug.happenings import KINDS, Happening, happenings

if TYPE_CHECKING:
    from crs_cc.sim.environment import Environment
    from crs_cc.sim.step import Step

FloatArray = npt.NDArray[np.float64]

_KINDS: Final = tuple(kind for kind in KINDS if kind != "tick" and "-" not in kind)
_MOST_HAPPENINGS: Final = 20_000
"""More are not kept: the older half goes. Chosen by us, some megabytes."""
_MOST_POSES: Final = 2_000
"""Points of a path; when there are more, every second one goes. Chosen by us: a map has less."""


class Chronicle:
    """What happened in each timestep of a branch of a run.

    Attributes:
        timesteps: how many timesteps are known.
    """

    def __init__(self) -> None:
        """Knows nothing yet."""
        self.timesteps = 0
        self._happened: list[tuple[int, Happening]] = []
        self._stride = 1
        self._poses: list[tuple[int, FloatArray]] = []  # at the end of every `stride`th timestep

    def hear(self, step: Step, environment: Environment) -> None:
        """Takes what happened in a timestep that has just ended, unless it is known."""
        if step.cycle < self.timesteps:
            return
        self.timesteps = step.cycle + 1
        if _is_eventful(step):
            for each in happenings(step, environment.world, _KINDS):
                self._add(step.cycle, each)
        if step.cycle % self._stride == 0:
            self._take_poses(step.cycle, environment)

    def note(self, timestep: int, happening: Happening) -> None:
        """Takes something else that happened in a timestep, once."""
        if (timestep, happening) not in self._happened:
            self._add(timestep, happening)

    def _add(self, timestep: int, happening: Happening) -> None:
        self._happened.append((timestep, happening))
        if len(self._happened) > _MOST_HAPPENINGS:
            del self._happened[: _MOST_HAPPENINGS // 2]

    def _take_poses(self, timestep: int, environment: Environment) -> None:
        state = environment.state
        places = np.column_stack([state.x_m, state.y_m])
        places[~state.presence.present] = np.nan
        self._poses.append((timestep, places))
        if len(self._poses) > _MOST_POSES:
            self._stride *= 2
            self._poses = [each for each in self._poses if each[0] % self._stride == 0]

    def happenings(self) -> Sequence[Happening]:
        """Gives what has happened, by time; also ahead of where the run is."""
        return sorted((each for _, each in self._happened), key=lambda each: each.time_s)

    def paths(self, timestep: int) -> list[FloatArray]:
        """Gives where each robot has been [m] before a timestep, (n, 2) each."""
        known = [places for at, places in self._poses if at < timestep]
        if not known:
            return []
        robots = max(map(len, known))
        return [_path(known, robot) for robot in range(robots)]

    def forget(self, timestep: int) -> None:
        """Forgets a timestep and all behind it, as they will be others."""
        self.timesteps = min(self.timesteps, timestep)
        self._happened = [each for each in self._happened if each[0] < timestep]
        self._poses = [each for each in self._poses if each[0] < timestep]

    def fork(self, timestep: int) -> Chronicle:
        """Gives one of its own that knows the timesteps before this one."""
        other = copy.copy(self)
        other.forget(timestep)
        return other


def _is_eventful(step: Step) -> bool:
    return bool(
        step.events
        or len(step.contacts.robot)
        or len(step.traffic)
        or step.pressed.any()
        or step.released.any()
    )


def _path(places: Sequence[FloatArray], robot: int) -> FloatArray:
    path = np.array([each[robot] for each in places if robot < len(each)])
    return np.asarray(path[~np.isnan(path[:, 0])])
