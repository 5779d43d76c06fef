"""The beams of sonars, and crosstalk: another robot's ping that is mistaken for an echo.

The ping of another robot's sonar reaches a listening sonar directly. The sonar cannot distinguish
it from an echo, and reports half of the distance that sound travels in the time since its own
firing:

    distance = (sent + apart / (speed of sound) - fired) * (speed of sound) / 2

where `sent` is the time of the other robot's firing and `apart` the distance between the sonars.
Each must be in the other's beam and range, with nothing in between, and the sound must arrive
before the true echo. Sound that is reflected by walls is ignored. Other robots are at their
positions at the start of the cycle, and fire in the order that they have then.

The probability of this mistake is a parameter of the robot definition (`crosstalk`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray
from crs_cc.core.units import SOUND_MPS
from crs_cc.sim.devices.sonar.model import MAX_SONARS, sonars_of
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.geometry.cell_list import CellList
from crs_cc.sim.geometry.pings import ANY_ANGLE, Pings, Points
from crs_cc.sim.kernels import exact

if TYPE_CHECKING:
    from crs_cc.sim.model.robot import RobotModel
    from crs_cc.sim.state.env_state import EnvState


_THIN_RAD: Final = 1e-9  # a cone must have an inside
_NEAR_M: Final = 1e-3  # cells must have a size


class Beams:
    """The beams of all robots by the sonar's number; a missing sonar has no echo.

    Attributes:
        boards: the board of each mode of each kind of robot.
        first: the first mode of each robot, (robots,).
        start_m: largest distance of a sonar from its robot's centre.
        reach_m: largest distance from the centre at which a ping can be heard.
    """

    def __init__(self, models: Sequence[RobotModel]) -> None:
        """Create the beams of robots of these models."""
        different = list(dict.fromkeys(models))
        kinds = [mode for model in different for mode in sonars_of(model).modes]
        counts = [len(sonars_of(model).modes) for model in different]
        first = np.cumsum([0, *counts])[[different.index(model) for model in models]]
        self.first = first.astype(np.intp)
        shape = (len(kinds), MAX_SONARS)
        self._mounts = np.ones((2, *shape), dtype=np.complex128)  # places, and directions
        self._mounts[0] = 0.0
        self._half_rad = np.full(shape, _THIN_RAD)
        self._range_m = np.zeros(shape)
        self._z_m = np.zeros(shape)
        for kind, mode in enumerate(kinds):
            for sonar in mode.sonars:
                place = kind, sonar.id
                self._mounts[:, kind, sonar.id] = (
                    complex(sonar.x_m, sonar.y_m),
                    exact.turn(sonar.direction_rad),
                )
                self._half_rad[place] = max(sonar.half_angle_rad, _THIN_RAD)
                self._range_m[place] = sonar.range_m
                self._z_m[place] = sonar.z_m
        self.start_m = float(exact.magnitude(self._mounts[0]).max(initial=0.0))
        boards = self.boards = [mode.board for mode in kinds]
        self.reach_m = self.start_m + float(self._range_m.max(initial=0.0))
        lobes = [board.lobe_rad for board in boards]
        self._falloff = np.array([1 / (lobe * lobe) if lobe else 0.0 for lobe in lobes])
        self._critical_rad = np.array([min(board.critical_rad, ANY_ANGLE) for board in boards])

    def table(self, limits: FloatArray) -> FloatArray:
        """Return the row of each sonar of each mode, see `kernels/sonars.c`, (modes, 16, 14).

        Args:
            limits: the errors of each mode, (modes, 6).
        """
        table = np.empty((len(self.boards), MAX_SONARS, 14))
        for place, points in zip((0, 2), self._mounts, strict=True):
            table[:, :, place], table[:, :, place + 1] = points.real, points.imag
        table[:, :, 4], table[:, :, 5] = self._half_rad, self._range_m
        table[:, :, 6] = self._falloff[:, None]
        table[:, :, 7] = self._critical_rad[:, None]
        table[:, :, 8:] = limits[:, None]
        return table

    def z_m(self, rows: IndexArray, number: IndexArray) -> FloatArray:
        """Return the height above the ground of a sonar of each of some robots."""
        return np.asarray(self._z_m[self.first[rows], number])

    def pings(
        self,
        rows: IndexArray,
        number: IndexArray,
        place: ComplexArray,
        turn: ComplexArray,
        mode: IndexArray,
    ) -> Pings:
        """Return a ping from one sonar of each of some robots.

        Args:
            rows: the robots.
            number: the number of the sonar.
            mode: its mode.
            place: the position of each robot.
            turn: the direction of the front of its ring, of length 1.
        """
        kind = self.first[rows] + mode
        beam = kind, number
        offset, axis = exact.product(self._mounts[:, kind, number], turn)
        return Pings(
            place,
            place + offset,
            axis,
            self._half_rad[beam],
            self._range_m[beam],
            self._falloff[kind],
            self._critical_rad[kind],
            rows,
        )


def crosstalk_pings(
    state: EnvState,
    beams: Beams,
    pings: Pings,
    listeners: IndexArray,
    *,
    from_s: FloatArray,
    to_s: FloatArray,
) -> Points:
    """Return the pings of other robots that reach listeners.

    Args:
        state: has the other robots' poses and firing times.
        beams: the beams of all robots.
        pings: the listeners' own pings.
        listeners: indices of the pings whose robots may hear others, k of them.
        from_s: the time at which these are sent.
        to_s: the time at which the robots stop listening.
    """
    sonar, start = sonar_state(state), pings.start[listeners]
    cells = CellList(state.x_m, state.y_m, max(beams.reach_m, _NEAR_M))
    listener, other = cells.near(start.real, start.imag)
    fires = (sonar.length[other] > 0) & (pings.own[listeners[listener]] != other)
    fires &= state.presence.present[other]
    listener, other = listener[fires], other[fires]
    distance_m = exact.magnitude(state.x_m[other] + 1j * state.y_m[other] - start[listener])
    near = np.flatnonzero(distance_m <= beams.reach_m)
    listener, other, distance_m = listener[near], other[near], distance_m[near]
    # At most one ping of another robot arrives: its board fires again only later than sound from
    # the end of the range takes to arrive.
    round_s = sonar.interval_s[other]
    since_s = from_s[listener] - distance_m / SOUND_MPS - sonar.start_s[other]
    turn = np.maximum(np.ceil(since_s / round_s), 0).astype(np.int64)
    number = sonar.order[other, turn % sonar.length[other]]
    place = state.x_m[other] + 1j * state.y_m[other]
    turn_there = exact.turn(state.mount_rad)[other]
    theirs = beams.pings(other, number, place, turn_there, sonar.mode[other])
    seen = theirs.local(np.arange(len(other)), start[listener])
    distance_m = exact.magnitude(seen)
    come_s = sonar.start_s[other] + turn * round_s + distance_m / SOUND_MPS
    told_m = (come_s - from_s[listener]) * SOUND_MPS / 2
    likely = (seen.real > 0.0) & (distance_m <= theirs.range_m)  # few are
    heard = np.flatnonzero(likely & (told_m >= 0.0) & (come_s <= to_s[listener]))
    angle_rad = exact.angle(seen[heard])
    in_beam = np.abs(angle_rad) <= theirs.half_rad[heard]
    heard = heard[in_beam & (distance_m[heard] <= theirs.reach_m(heard, angle_rad))]
    ping = listeners[listener[heard]]
    return Points(ping, pings.local(ping, theirs.start[heard]), told_m[heard], np.ones(len(ping)))
