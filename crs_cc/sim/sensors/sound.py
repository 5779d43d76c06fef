"""Microphones: how loud each of eight tones is, and where the loudest comes from.

    level of a tone = round(sqrt(sum over all its sounds of (level / d * w)^2))
    w = 1 for a sound in sight, 1/4 for one that goes around something

d is the distance of a sound from the middle of the robot [m]: its pressure falls with the distance,
as that of a ball that breathes, and sounds that have nothing to do with each other add their power.
A quarter of the pressure is 12 dB less: ISO 9613-2, 7.4, has about 5 to 20 dB for one edge in the
way, and we take the middle for everything. The direction is that of the sum of all sounds of the
loudest tone, each an arrow as long as its power; also of those that come around something, as if
there were nothing. A sound nearer than 10 cm sounds as from there. Sounds stand in the world file,
or are those of other robots (`crs_sound`).

Microphones measure whenever the program asks, with things as they are at the start of the cycle; a
normal deviate with the definition's share of a level is added to it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.requests import LARGEST
from crs_cc.sim.beacon_model import TONES
from crs_cc.sim.geometry.frames import wrapped
from crs_cc.sim.noise import SOUND, Noise
from crs_cc.sim.sources import Sources, line_of_sight, sense
from crs_cc.units import rad_to_tenths_deg

if TYPE_CHECKING:
    from crs_cc.sim.asked import Asked
    from crs_cc.sim.model import WorldModel

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
IndexArray = npt.NDArray[np.intp]

AROUND: Final = 0.25
"""The share of a sound's pressure that is left behind something."""


class Microphones:
    """The microphones of all robots that have some.

    Attributes:
        fans: the beam by which they look whether a sound is in sight.
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
        self._has = np.array([model is not None for model in models], dtype=np.bool_)
        self._range_m = np.array([model.range_m if model else 0.0 for model in models])
        self._share = np.array([model.noise if model else 0.0 for model in models])
        self.fans = line_of_sight(float(self._range_m.max(initial=0.0)))
        self._noise = Noise(seed, SOUND, TONES, len(models) if self._share.any() else 0)

    def tell(self, asked: Asked) -> BoolArray:
        """Answers GET_SOUND: the levels of all tones, and where the loudest comes from."""
        has = self._has[asked.rows]
        rows, replies = asked.rows[has], asked.messages[has]
        if len(rows):
            levels, bearing_rad = self._hear(asked, rows)
            altered = asked.equipment.degradations.alter(
                asked.state, "sound", rows, levels, asked.at_s[has]
            )
            levels = np.nan_to_num(altered, nan=0.0)
            loudest = bearing_rad[np.arange(len(rows)), levels.argmax(axis=1)]
            replies["i"][:, 0] = np.rint(rad_to_tenths_deg(loudest))
            whole = np.clip(np.rint(levels), 0, LARGEST).astype("<i4")
            replies["data"][:, : 4 * TONES] = whole.view(np.uint8)
            replies["size"] = 4 * TONES
            asked.messages[has] = replies
        return np.asarray(has)

    def _hear(self, asked: Asked, rows: IndexArray) -> tuple[FloatArray, FloatArray]:
        """Gives the levels of all tones, and where they come from, both (k, 8)."""
        beacons, robots = asked.state.beacons, len(asked.state.heading_rad)
        sounds = self._sounds.with_robots(asked.state.bodies.position_m[:robots], beacons.level)
        carried = sounds.owner[len(self._tone) :]
        tones = np.concatenate([self._tone, beacons.tone[carried]])
        heard = sense(asked, rows, sounds, self._range_m[rows], self.fans[0])
        pressure = sounds.strength[heard.source] / heard.distance_m
        power = (pressure * np.where(heard.in_sight, 1.0, AROUND)) ** 2
        sums = np.zeros((3, len(rows), TONES))
        places = heard.robot, tones[heard.source]
        np.add.at(sums[0], places, power)
        np.add.at(sums[1], places, power * np.cos(heard.bearing_rad))
        np.add.at(sums[2], places, power * np.sin(heard.bearing_rad))
        levels, bearing_rad = np.sqrt(sums[0]), wrapped(np.arctan2(sums[2], sums[1]))
        if self._share.any():
            deviates = self._noise.rows(rows, beacons.heard[rows])
            levels = levels * (1.0 + deviates * self._share[rows, None])
        beacons.heard[rows] += 1
        return levels, bearing_rad
