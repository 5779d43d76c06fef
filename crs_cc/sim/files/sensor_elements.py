"""Elements of sensors and batteries in a robot definition."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from crs_cc.core.quantity import ANGLE, FREQUENCY, LENGTH, TIME
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.colours import rgb
from crs_cc.sim.model.sensors import (
    MAX_COLUMNS,
    NUM_LASER,
    USUAL_BOARD,
    Camera,
    Laser,
    SensorBoard,
)

_TURN: Final = 2 * math.pi
_SHORTEST_S: Final = 0.001  # bounds the work that one robot's measurements cause
_ROUNDING: Final = 1e-9


def half_angle_rad(element: Element, reader: Reader) -> float:
    """Return the angle between a beam's axis and its side [rad]."""
    value_rad = reader.not_negative(element, "half-angle", ANGLE)
    if value_rad < math.pi / 2:
        return value_rad
    reader.refuse(element, "half-angle: must be less than 90deg")
    return 0.0


def _field_of_view(element: Element, reader: Reader) -> float:
    value_rad = reader.positive(element, "field-of-view", ANGLE)
    if value_rad > _TURN:
        reader.refuse(element, "field-of-view: must be 360deg or less")
    return value_rad


def laser(root: Element, reader: Reader) -> Laser | None:
    """Return the laser, None for a robot without one."""
    element = root.maybe("laser")
    if element is None:
        return None
    return Laser(
        points=reader.whole(element, "points", 1, NUM_LASER),
        field_of_view_rad=_field_of_view(element, reader),
        range_m=reader.positive(element, "range", LENGTH),
        forward_m=reader.quantity(element, "forward", LENGTH),
        rate_hz=reader.positive(element, "rate", FREQUENCY),
        noise_m=reader.not_negative(element, "noise", LENGTH),
        mode=int(element.attributes["mode"]),
        z_m=reader.not_negative(element, "height", LENGTH),
        period_s=period_s(element, reader),
    )


def camera(root: Element, reader: Reader) -> Camera | None:
    """Return the camera, None for a robot without one.

    The report's `<sensor>` of this type, if there is one, sets its pose, field of view and range.
    """
    places = list(root.sensors("camera"))
    for place in places[1:]:
        reader.error(place, "duplicate camera: a robot has at most one")
    for element in root.all("camera"):
        if places:
            return _placed(_camera(element, reader), places[0].first("position"), reader)
        return _camera(element, reader)
    for place in places[:1]:
        hint = "add <camera/> before <computer-battery>"
        reader.error(place, "missing <camera>, which sets the camera's columns and rate", hint)
    return None


def _placed(camera: Camera, place: Element, reader: Reader) -> Camera:
    """Return a camera with the pose, field of view and range of the report's `<sensor>`."""
    range_m = reader.positive(place, "range", LENGTH)
    radius_m = reader.positive(place, "radius", LENGTH)
    return replace(
        camera,
        field_of_view_rad=2 * math.atan2(radius_m, range_m),
        range_m=range_m,
        x_m=reader.quantity(place, "x-relative", LENGTH),
        y_m=reader.quantity(place, "y-relative", LENGTH),
        direction_rad=reader.quantity(place, "dir-relative", ANGLE, unit="rad"),
        z_m=reader.not_negative(place, "z-relative", LENGTH),
    )


def _camera(element: Element, reader: Reader) -> Camera:
    return Camera(
        columns=reader.whole(element, "columns", 1, MAX_COLUMNS, absent=1),
        field_of_view_rad=_field_of_view(element, reader),
        range_m=reader.positive(element, "range", LENGTH),
        x_m=reader.quantity(element, "forward", LENGTH),
        y_m=reader.quantity(element, "left", LENGTH),
        direction_rad=reader.quantity(element, "direction", ANGLE),
        rate_hz=reader.positive(element, "rate", FREQUENCY),
        noise_m=reader.not_negative(element, "noise", LENGTH),
        background=_colour(element, "background", reader),
        z_m=reader.not_negative(element, "height", LENGTH),
        period_s=period_s(element, reader),
    )


def period_s(element: Element, reader: Reader) -> float:
    """Return a sensor's measuring period by timer, 0 for none [s]."""
    value_s = reader.not_negative(element, "period", TIME)
    if 0.0 < value_s < _SHORTEST_S:
        reader.refuse(element, "period: must be 0, or 1ms or more")
    if "rate" in element.attributes and value_s > 0.0:
        least_s = 1.0 / reader.positive(element, "rate", FREQUENCY)
        if value_s < least_s * (1.0 - _ROUNDING):
            reader.refuse(element, "period: must not be shorter than 1 / rate")
    return value_s


def _colour(element: Element, name: str, reader: Reader) -> tuple[int, int, int]:
    try:
        return rgb(element.attributes[name])
    except ValueError as wrong:
        reader.refuse(element, f"{name}: {wrong}")
        return 0, 0, 0


def sensor_board(root: Element, reader: Reader) -> SensorBoard:
    """Return the computer that reads the sensors."""
    element = root.first("sensor-board")
    return SensorBoard(
        start_s=reader.not_negative(element, "clock", TIME, USUAL_BOARD.start_s),
        tick_s=reader.positive(element, "tick", TIME, USUAL_BOARD.tick_s),
    )
