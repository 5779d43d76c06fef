"""Elements of sonars in a robot definition."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from crs_cc.core.quantity import ANGLE, LENGTH, TIME
from crs_cc.sim.devices.sonar.model import (
    MAX_SONARS,
    SONAR_TICK_S,
    Sonar,
    SonarBoard,
    SonarMode,
    Sonars,
)
from crs_cc.sim.files.body import body_radius_m, is_outside
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.sensor_elements import half_angle_rad
from crs_cc.sim.kernels import exact

_RATE: Final = 15  # times 4 ms: the usual argument of `conf_sn`
_MAX_RATE: Final = 255
_MIN_INTERVAL_S: Final = 0.04  # an echo from 255 in takes 37.7 ms, and the clock ticks in 4 ms
_MIN_PERIOD_S: Final = 0.001  # bounds the work that one robot's firing causes
_THINNEST_RAD: Final = math.radians(0.01)


def read(root: Element, reader: Reader) -> Sonars | None:
    """Return the sonars of a definition, None if it has none; errors go to the reader."""
    element, sonars = root.first("sonars"), _sonars(root, reader)
    board = _board(element, sonars, reader)
    modes = _modes(element, sonars, board, reader)
    return Sonars(sonars, board, modes) if sonars else None


def _sonars(root: Element, reader: Reader) -> tuple[Sonar, ...]:
    """Return the sonars of a definition, by rising number."""
    found: dict[int, Sonar] = {}
    for element in root.sensors("sonar"):
        sonar = _sonar(element, reader)
        if sonar.id in found:
            reader.error(element, f"duplicate sensor id {sonar.id}")
        if is_outside(root, sonar.x_m, sonar.y_m, reader):
            radius = f"radius: {body_radius_m(root, reader):g} m"
            reader.error(element, f"sensor {sonar.id} is outside of the body ({radius})")
        found[sonar.id] = sonar
    return tuple(found[number] for number in sorted(found))


def _sonar(element: Element, reader: Reader) -> Sonar:
    place = element.first("position")
    return Sonar(
        id=reader.whole(element, "id", 0, MAX_SONARS - 1),
        x_m=reader.quantity(place, "x-relative", LENGTH),
        y_m=reader.quantity(place, "y-relative", LENGTH),
        direction_rad=reader.quantity(place, "dir-relative", ANGLE, unit="rad"),
        range_m=reader.positive(place, "range", LENGTH),
        radius_m=reader.not_negative(place, "radius", LENGTH),
        z_m=reader.quantity(place, "z-relative", LENGTH),
    )


def _board(element: Element, of: tuple[Sonar, ...], reader: Reader) -> SonarBoard:
    """Return the properties common to the sonars of a definition."""
    least_s = reader.positive(element, "least-interval", TIME, _MIN_INTERVAL_S)
    if least_s < _MIN_PERIOD_S:
        reader.refuse(element, "least-interval: must be 1ms or more")
    rate = reader.whole(element, "rate", 0, _MAX_RATE, absent=_RATE)
    usual = SonarBoard(
        _order(element, of, reader),
        interval_s=max(rate * SONAR_TICK_S, least_s),
        least_interval_s=least_s,
    )
    return _heard(element, usual, reader)


def _modes(
    element: Element, of: tuple[Sonar, ...], usual: SonarBoard, reader: Reader
) -> tuple[SonarMode, ...]:
    """Return the sonar modes of a definition, empty if there is only one.

    element: the element with the modes.
    of: the sonars as they are without modes.
    usual: their common properties.
    reader: receives the errors.
    """
    found: dict[str, SonarMode] = {}
    for mode in element.all("mode"):
        name = mode.attributes["name"]
        if name in found:
            reader.error(mode, f"duplicate mode {name!r}")
        found[name] = SonarMode(name, beams(mode, of, reader), _heard(mode, usual, reader))
    return tuple(found.values())


def beams(mode: Element, of: tuple[Sonar, ...], reader: Reader) -> tuple[Sonar, ...]:
    """Return sonars with the range and the beam of a mode's element."""
    ranges_m = [reader.positive(mode, "range", LENGTH)] * len(of)
    if "range" not in mode.attributes:
        ranges_m = [sonar.range_m for sonar in of]
    halves_rad = [half_angle_rad(mode, reader)] * len(of)
    if "half-angle" not in mode.attributes:
        halves_rad = [sonar.half_angle_rad for sonar in of]
    beams = zip(of, ranges_m, halves_rad, strict=True)
    return tuple(
        replace(sonar, range_m=range_m, radius_m=range_m * exact.tan(half_rad))
        for sonar, range_m, half_rad in beams
    )


def _heard(element: Element, usual: SonarBoard, reader: Reader) -> SonarBoard:
    """Return a board, changed by an element's attributes."""
    lobe_rad = reader.not_negative(element, "lobe", ANGLE, usual.lobe_rad)
    if 0.0 < lobe_rad < _THINNEST_RAD:
        reader.refuse(element, "lobe: must be 0, or 0.01deg or more")
    return replace(
        usual,
        lobe_rad=lobe_rad,
        critical_rad=reader.not_negative(element, "critical-angle", ANGLE, usual.critical_rad),
        blind_m=reader.not_negative(element, "blind", LENGTH, usual.blind_m),
        minimum_m=reader.not_negative(element, "minimum", LENGTH, usual.minimum_m),
        noise_m=reader.not_negative(element, "noise", LENGTH, usual.noise_m),
        noise_share=reader.fraction(element, "noise-share", usual.noise_share),
        dropouts=reader.fraction(element, "dropouts", usual.dropouts),
        crosstalk=reader.fraction(element, "crosstalk", usual.crosstalk),
        resolution_m=reader.not_negative(element, "resolution", LENGTH, usual.resolution_m),
    )


def _order(element: Element, sonars: tuple[Sonar, ...], reader: Reader) -> tuple[int, ...]:
    order = tuple(int(number) for number in element.attributes.get("order", "").split())
    known = {sonar.id for sonar in sonars}
    for number in order:
        if number not in known:
            reader.error(element, f"order: unknown sonar {number}")
    return order
