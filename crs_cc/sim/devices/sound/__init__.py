"""Microphones: the level of each of eight tones, and the direction of the loudest.

    level of a tone = round(sqrt(sum over all its sources of (level / d * w)^2))
    w = 1 for a source in the line of sight, 1/4 for one behind an obstacle

d is the distance of a source from the robot's centre [m]: the pressure is inversely proportional to
the distance, as for a pulsating sphere, and the powers of incoherent sources add. A quarter of the
pressure is 12 dB less: ISO 9613-2, 7.4, has about 5 to 20 dB for diffraction at one edge, and we
use the middle for all obstacles. The direction is that of the vector sum over all sources of the
loudest tone, each weighted by its power, including sources behind obstacles, as if there were none.
d is at least 10 cm. Sources are declared in the world file, or are speakers of other robots
(`crs_sound`).

Microphones measure on request, or on their timer, with objects at their positions at the start of
the timestep; a normal deviate proportional to the level, with the definition's noise, is added.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core import random_streams
from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.units import rad_to_tenths_deg
from crs_cc.requests import LARGEST
from crs_cc.sim.devices.emitters import Sources, line_of_sight, sense
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.geometry.frames import wrapped
from crs_cc.sim.model.beacons import TONES
from crs_cc.sim.state.timers import SOUND

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


AROUND: Final = 0.25
"""The share of a sound's pressure that remains behind an obstruction."""


class Microphones:
    """The microphones of all robots that have any.

    Attributes:
        fans: the beams that test for obstructions.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        models = [robot.model.microphones for robot in world.robots]
        sounds = world.sounds
        self._sounds = Sources(
            np.array([(sound.x_m, sound.y_m) for sound in sounds]).reshape(-1, 2),
            np.array([sound.level for sound in sounds], dtype=np.float64),
            np.full(len(sounds), -1, dtype=np.intp),
        )
        self._tone = np.array([sound.tone for sound in sounds], dtype=np.int64)
        self._range_m = np.array([model.range_m if model else 0.0 for model in models])
        self._share = np.array([model.noise if model else 0.0 for model in models])
        self.fans = line_of_sight(float(self._range_m.max(initial=0.0)))
        robots = len(models) if self._share.any() else 0
        self._noise = random_streams.Noise(seed, random_streams.SOUND, TONES, robots)

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Measure with microphones.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: robots with microphones, k of them, whose axes were turned to `at_s`.
            at_s: the time of each, shape (k,).
        """
        if not len(rows):
            return
        ears, mine = state.sound, constants.sound[rows]
        levels, bearing_rad = self._sound(state, constants, rays, rows)
        if self._share.any():
            deviates = self._noise.rows(rows, ears.count[mine])
            levels = levels * (1.0 + deviates * self._share[rows, None])
        levels = constants.degradations.alter(state, "sound", rows, levels, at_s)
        levels = np.nan_to_num(levels, nan=0.0)
        ears.level[mine], ears.at_s[mine] = levels, at_s
        ears.bearing_rad[mine] = bearing_rad[np.arange(len(rows)), levels.argmax(axis=1)]
        ears.count[mine] += 1

    def get_sound(self, context: RequestContext) -> BoolArray:
        """Answer GET_SOUND with the levels of all tones, and the direction of the loudest."""
        sound, mine = context.state.sound, context.constants.sound[context.rows]
        has = np.asarray(mine >= 0)
        read_on_request(context, self.read, SOUND, has)
        mine = mine[has]
        context.put("direction", np.rint(rad_to_tenths_deg(sound.bearing_rad[mine])), has)
        context.put_data(np.clip(np.rint(sound.level[mine]), 0, LARGEST), has)
        return has

    def _sound(
        self, state: EnvState, constants: RobotConstants, rays: RayCaster, rows: IndexArray
    ) -> tuple[FloatArray, FloatArray]:
        """Return the levels of all tones and their directions, both (k, 8)."""
        beacons, robots = state.beacons, len(state.heading_rad)
        sounds = self._sounds.with_robots(state.bodies.position_m[:robots], beacons.level)
        carried = sounds.owner[len(self._tone) :]
        tones = np.concatenate([self._tone, beacons.tone[carried]])
        heard = sense(
            state, constants, rays, rows,
            sources=sounds, range_m=self._range_m[rows], fan=self.fans[0],
        )  # fmt: skip
        pressure = sounds.strength[heard.source] / heard.distance_m
        power = (pressure * np.where(heard.in_sight, 1.0, AROUND)) ** 2
        sums = np.zeros((3, len(rows), TONES))
        places = heard.robot, tones[heard.source]
        np.add.at(sums[0], places, power)
        np.add.at(sums[1], places, power * np.cos(heard.bearing_rad))
        np.add.at(sums[2], places, power * np.sin(heard.bearing_rad))
        return np.sqrt(sums[0]), wrapped(np.arctan2(sums[2], sums[1]))
