"""Microphones: the level of each of eight tones, and the direction of the loudest.

    level of a tone = round(sqrt(sum over all its sources of (level / d * w)^2))
    w = 1 for a source in the line of sight, 1/4 for one behind an obstacle

d is the distance of a source from the robot's centre [m]: the pressure is inversely proportional to
the distance, as for a pulsating sphere, and the powers of incoherent sources add. A quarter of the
pressure is 12 dB less: ISO 9613-2, 7.4, gives about 5 to 20 dB for diffraction at one edge, and we
use the middle of that range for all obstacles. The direction is that of the vector sum over all
sources of the loudest tone, each weighted by its power; sources behind obstacles count as if there
were no obstacles. Smaller values of d count as 10 cm. Sources are declared in the world file, or
are speakers of other robots (`crs_sound`).

Microphones measure on request, or on their timer, with objects at their positions at the start of
the timestep; a normal deviate is added, whose standard deviation is the level times the `noise` of
the definition.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.core.quantity import LENGTH, LOUDNESS
from crs_cc.core.units import rad_to_tenths_deg
from crs_cc.requests import LARGEST, device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices import speaker
from crs_cc.sim.devices.emitters import Sources, line_of_sight, sense
from crs_cc.sim.devices.sensor import Measurement, Readings, Sensor, listed
from crs_cc.sim.geometry.frames import wrapped
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.attribute import FRACTION, attribute, period
from crs_cc.sim.model.beacons import TONES
from crs_cc.sim.model.degradable import Degradable, elements_of, numbered
from crs_cc.sim.model.device import Device

if TYPE_CHECKING:
    from crs_cc.sim.devices.installed import Installed
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.model.world import WorldModel


AROUND: Final = 0.25
"""The share of a sound's pressure that remains behind an obstruction."""


@dataclass(frozen=True, slots=True)
class Microphones:
    """Microphones that measure the level and direction of each tone."""

    range_m: float = attribute(
        "range", LENGTH, "10m", "Maximum distance at which a sound is detected.", positive=True
    )
    noise: float = attribute(
        "noise", FRACTION, "0", "Standard deviation of a level, as a fraction of the level."
    )
    period_s: float = period()


class _Ears:
    """The microphones of all robots that have any, and the sounds of the world."""

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        sounds = world.sounds
        self._sounds = Sources.fixed(
            [(sound.x_m, sound.y_m) for sound in sounds], [sound.level for sound in sounds]
        )
        self._tone = np.array([sound.tone for sound in sounds], dtype=np.int64)
        self._sensor = Sensor(row, world, seed, self.measure, TONES, missing=0.0)
        self.fans = line_of_sight(float(self._sensor.settings["range_m"].max(initial=0.0)))

    def installed(self) -> Installed:
        """Return the microphones with the handler of their request."""
        return self._sensor.installed({"GET_SOUND": self.get_sound}, self.fans)

    def measure(self, now: Measurement) -> FloatArray:
        """Return the levels of all tones, then their directions [rad], (k, 16)."""
        level, tone = speaker.sounds(now.state, now.constants)
        sounds = self._sounds.with_robots(now.state.bodies.position_m[: len(level)], level)
        carried = sounds.owner[len(self._tone) :]
        tones = np.concatenate([self._tone, tone[carried]])
        heard = sense(
            now.state, now.constants, now.rays, now.rows,
            sources=sounds, range_m=now.settings["range_m"], fan=self.fans[0],
        )  # fmt: skip
        pressure = sounds.strength[heard.source] / heard.distance_m
        power = np.square(pressure * np.where(heard.in_sight, 1.0, AROUND))
        sums = np.zeros((3, len(now.rows), TONES))
        places = heard.robot, tones[heard.source]
        np.add.at(sums[0], places, power)
        np.add.at(sums[1], places, power * exact.cos(heard.bearing_rad))
        np.add.at(sums[2], places, power * exact.sin(heard.bearing_rad))
        return np.hstack([np.sqrt(sums[0]), wrapped(exact.arctan2(sums[2], sums[1]))])

    def get_sound(self, context: RequestContext) -> BoolArray:
        """Answer GET_SOUND with the levels of all tones, and the direction of the loudest."""
        has, mine = self._sensor.measure_on_request(context)
        value = self._sensor.readings(context.state).value[mine]
        level, bearing_rad = value[:, :TONES], value[:, TONES:]
        bearing_rad = bearing_rad[np.arange(len(mine)), level.argmax(axis=1)]
        context.put("direction", np.rint(rad_to_tenths_deg(bearing_rad)), has)
        context.put_data(np.clip(np.rint(level), 0, LARGEST), has)
        return has


DEVICE = Device(
    name="sound",
    title="Microphones",
    element="microphones",
    summary="Measures the levels of eight tones, and the direction of the loudest; programs read"
    " them with crs_get_sound() (crs.h).",
    model=Microphones,
    state=lambda models: Readings.never(len(models), 2 * TONES),
    install=lambda row, world, seed, _log: _Ears(row, world, seed).installed(),
    requests=(
        device_request(
            "GET_SOUND", 228, "int crs_get_sound(int *levels, int most, int *direction)",
            "reads the level of each tone, and the direction of the loudest",
            results=fields(
                ("direction", "i[0]", "0.1 deg", "direction of the loudest, from ahead"),
                ("levels", "data", "1", "levels of the eight tones", "int32"),
            ),
        ),
    ),
    functions=(
        Function(
            "int crs_get_sound(int *levels, int most, int *direction)",
            "copies the level of each tone, and returns the direction of the loudest, relative to"
            " the front, in `direction`, which may be NULL; returns the number of tones copied, at"
            " most `most`", units="-, -, 0.1 deg",
            posts=("GET_SOUND",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "sound", "level of a tone", LOUDNESS,
            elements_of("sound", lambda _model: numbered(TONES)), TONES,
            "the reading is 0",
        ),
    ),
    inspect=listed("sound", TONES),
    reading=lambda state, _model, number: state.device("sound", Readings).last(number, TONES),
    number=8,
    stream=23,
    source=__file__,
)  # fmt: skip
