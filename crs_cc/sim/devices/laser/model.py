"""The constants and the state of lasers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import Int32Array
from crs_cc.core.quantity import LENGTH
from crs_cc.sim.devices import range_scan
from crs_cc.sim.devices.sensor import Readings
from crs_cc.sim.files.body import is_outside
from crs_cc.sim.files.device_elements import read_attributes
from crs_cc.sim.model.attribute import Choice, Count, attribute, period, rate
from crs_cc.sim.state.last_measurement import CONFIGURATION, LastMeasurement
from crs_cc.sim.state.paged_reply import PagedReply

if TYPE_CHECKING:
    from crs_cc.sim.files.document import Element, Reader
    from crs_cc.sim.state.env_state import EnvState


NUM_LASER: Final = 482
"""Maximum number of points of a laser (vendor header `Nclient.h` 1.29)."""

_ROOM: Final = 2 * NUM_LASER  # numbers of the vendor's array `Laser`
_USUAL_SEGMENTS: Final = (50, 4, 30)
"""The vendor header's suggestion for `conf_sg`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Laser:
    """A laser that measures distances in its plane.

    Attributes:
        field_of_view_rad: the angle that they cover, half of it to each side.
        range_m: maximum range.
        forward_m: its distance ahead of the mount's centre.
    """

    points: int = attribute(
        "points", Count(1, NUM_LASER), "482", f"Maximum number of points, 1 to {NUM_LASER}."
    )
    field_of_view_rad: float = range_scan.field_of_view(None)
    range_m: float = attribute("range", LENGTH, None, "Maximum distance measured.", positive=True)
    forward_m: float = range_scan.forward()
    rate_hz: float = rate("30Hz")
    noise_m: float = attribute(
        "noise", LENGTH, "0m",
        "Standard deviation of a distance at 1 m; it grows with the square of the distance.",
    )  # fmt: skip
    mode: int = attribute(
        "mode", Choice(tuple((str(mode), mode) for mode in (0, 1, 19, 33, 51))), "0",
        "The vendor's mode until the program changes it with conf_ls(): 0 for off, 19 or 51 for"
        " points, 1 or 33 for segments.",
    )  # fmt: skip
    z_m: float = range_scan.height()
    period_s: float = period()


def read(root: Element, reader: Reader) -> Laser | None:
    """Return the laser of a robot definition, None for a robot without one."""
    element = root.find_child("laser")
    if element is None:
        return None
    laser: Laser = read_attributes(Laser, element, reader)
    if is_outside(root, laser.forward_m, 0.0, reader):
        reader.error(element, "the laser is outside of the body")
    return laser


@dataclass(slots=True)
class LaserState:
    """The lasers; arrays have a row for each robot with a laser, n of them.

    Attributes:
        mode: the mode set by `conf_ls`, (n,).
        wanted: number of points to measure, (n,).
        averaged: number of pixels that are averaged, (n,).
        segments: threshold, minimum number of points and gap, as set by `conf_sg`, (n, 3).
        readings: the ranges [m], from right to left, not finite for none; then their number, and
            the robot's configuration, as in `State`.
        reply: contents of the last reply.
        predicted: contents of the last reply to PREDICT.
    """

    mode: Int32Array
    wanted: Int32Array
    averaged: Int32Array
    segments: Int32Array
    readings: Readings
    reply: PagedReply
    predicted: PagedReply


def state_at_start(models: Sequence[Laser]) -> LaserState:
    """Return lasers with the settings of their definitions, without a scan."""
    count = len(models)
    return LaserState(
        mode=np.array([laser.mode for laser in models], dtype=np.int32),
        wanted=np.array([laser.points for laser in models], dtype=np.int32),
        averaged=np.ones(count, dtype=np.int32),
        segments=np.tile(np.array(_USUAL_SEGMENTS, dtype=np.int32), (count, 1)),
        readings=Readings.never(count, NUM_LASER + 1 + CONFIGURATION),
        reply=PagedReply.nothing(count, _ROOM),
        predicted=PagedReply.nothing(count, _ROOM),
    )


def laser_state(state: EnvState) -> LaserState:
    """Return the state of the lasers."""
    return state.device("laser", LaserState)


def last_scan(state: EnvState) -> LastMeasurement:
    """Return the time and the configuration of each laser's last scan."""
    readings = laser_state(state).readings
    return LastMeasurement(readings.at_s, readings.value[:, NUM_LASER + 1 :].astype(np.int32))
