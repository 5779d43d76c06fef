"""The sonar ring.

    reading = round(distance / 1 in), at most 255

with the distance from the sensor, which sits on the shell, to the nearest thing inside its beam
(`rays`), 0 where the sensor lies in or on a thing (`covered`). 255 stands for no echo within range:
the reading is a byte on the line (vendor source `Ndirect.c` 2.7). Degradation: a normal deviate
with the definition's `sonar_noise_m` is added to each distance that has an echo.

A sonar that is not in the firing order (`conf_sn`) keeps 255. The robot fires when it is asked,
from where it was at the start of the cycle, and once in a cycle at most. The time between firings
is not modelled yet, nor are echoes that glance off (a wall is heard from every angle).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.sim.noise import SONAR, Noise
from crs_cc.sim.rays import Fan
from crs_cc.sim.robot_elements import MAX_SONARS
from crs_cc.sim.states.sonar import NO_ECHO
from crs_cc.sim.surroundings import Surroundings
from crs_cc.units import m_to_inch, m_to_tenths_inch

if TYPE_CHECKING:
    from crs_cc.sim.equipment import Equipment
    from crs_cc.sim.model import WorldModel
    from crs_cc.sim.robot_model import RobotModel
    from crs_cc.sim.state import EnvState

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
IndexArray = npt.NDArray[np.intp]
Messages = npt.NDArray[np.void]

_END: Final = 255  # ends a firing order


class SonarRing:
    """The sonars of all robots of a world.

    Attributes:
        fans: the beams of each kind of robot.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        models = [robot.model for robot in world.robots]
        kinds = list(dict.fromkeys(models))
        self._kind = np.array([kinds.index(model) for model in models], dtype=np.intp)
        self.fans = [_fan(model) for model in kinds]
        self._numbers = [
            np.array([sonar.id for sonar in model.sonars], dtype=np.intp) for model in kinds
        ]
        self._noise_m = np.array([model.sonar_noise_m for model in models])
        noisy = len(models) if self._noise_m.any() else 0
        self._noise = Noise(seed, SONAR, MAX_SONARS, noisy)

    def read(self, state: EnvState, around: Surroundings, rows: IndexArray) -> None:
        """Lets the sonars of robots measure, those that did not yet in this cycle."""
        rows = rows[state.sonar.cycle[rows] != state.cycle]
        if not len(rows):
            return
        distance_m = np.full((len(rows), MAX_SONARS), np.inf)
        poses = np.column_stack([state.x_m[rows], state.y_m[rows], state.turret_rad[rows]])
        kinds = self._kind[rows]
        for kind, (fan, numbers) in enumerate(zip(self.fans, self._numbers, strict=True)):
            mine = np.flatnonzero(kinds == kind)
            if len(numbers) and len(mine):
                echoes = around.distances_m(state, fan, poses[mine], own=rows[mine])
                distance_m[np.ix_(mine, numbers)] = echoes
        distance_m += self._errors_m(state, rows)
        inches = np.clip(np.rint(m_to_inch(distance_m)), 0, NO_ECHO)
        state.sonar.reading_in[rows] = inches.astype(np.int32)
        state.sonar.echo_m[rows] = distance_m
        state.sonar.cycle[rows] = state.cycle
        state.sonar.count[rows] += 1

    def _errors_m(self, state: EnvState, rows: IndexArray) -> FloatArray:
        if not self._noise_m.any():
            return np.zeros(1)
        deviates = self._noise.rows(rows, state.sonar.count[rows])
        return np.asarray(deviates * self._noise_m[rows, None])


def conf_sn(
    state: EnvState, _equipment: Equipment, rows: IndexArray, messages: Messages
) -> BoolArray:
    """Sets which sonars fire; refuses an order that names a sonar there cannot be.

    The order ends with its last element, or before the first 255.
    """
    order = messages["data"][:, :MAX_SONARS].astype(np.intp)
    place = np.arange(MAX_SONARS)
    given = place < np.clip(messages["size"], 0, MAX_SONARS)[:, None]
    given &= np.cumsum(order == _END, axis=1) == 0
    good: BoolArray = ((order < MAX_SONARS) | ~given).all(axis=1)
    fires = np.zeros((len(rows), MAX_SONARS), dtype=np.bool_)
    robot, element = np.nonzero(given & good[:, None])
    fires[robot, order[robot, element]] = True
    state.sonar.on[rows[good]] = fires[good]
    return good


def tell_tenths(state: EnvState, rows: IndexArray, messages: Messages) -> None:
    """Puts readings as the CRS report has them into replies: 0.1 in, -1 for no echo.

    Those of all sonars, or with `i[0]` = 0 of those in the firing order alone.
    """
    echo_m = np.maximum(state.sonar.echo_m[rows], 0.0)
    heard = np.isfinite(echo_m) & (state.sonar.on[rows] | (messages["i"][:, :1] != 0))
    tenths = np.rint(m_to_tenths_inch(np.where(heard, echo_m, 0.0)))
    told = np.where(heard, tenths, -1).astype("<i4")
    messages["size"] = told.itemsize * MAX_SONARS
    messages["data"][:, : told.itemsize * MAX_SONARS] = told.view(np.uint8)


def _fan(model: RobotModel) -> Fan:
    return Fan.of(
        (sonar.x_m, sonar.y_m, sonar.direction_rad, sonar.half_angle_rad, sonar.range_m)
        for sonar in model.sonars
    )
