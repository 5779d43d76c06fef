"""Attributes that several sensors have, and the sensor board, in a robot definition."""

from __future__ import annotations

import math
from typing import Final

from crs_cc.core.quantity import ANGLE, FREQUENCY, TIME
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.sensors import USUAL_BOARD, SensorBoard

_MIN_PERIOD_S: Final = 0.001  # bounds the work that one robot's measurements cause
_ROUNDING: Final = 1e-9


def half_angle_rad(element: Element, reader: Reader) -> float:
    """Return the angle between a beam's axis and its side [rad]."""
    value_rad = reader.not_negative(element, "half-angle", ANGLE)
    if value_rad < math.pi / 2:
        return value_rad
    reader.refuse(element, "half-angle: must be less than 90deg")
    return 0.0


def period_s(element: Element, reader: Reader) -> float:
    """Return a sensor's measuring period by timer, 0 for none [s]."""
    value_s = reader.not_negative(element, "period", TIME)
    if 0.0 < value_s < _MIN_PERIOD_S:
        reader.refuse(element, "period: must be 0, or 1ms or more")
    if "rate" in element.attributes and value_s > 0.0:
        least_s = 1.0 / reader.positive(element, "rate", FREQUENCY)
        if value_s < least_s * (1.0 - _ROUNDING):
            reader.refuse(element, "period: must not be shorter than 1 / rate")
    return value_s


def sensor_board(root: Element, reader: Reader) -> SensorBoard:
    """Return the computer that reads the sensors."""
    element = root.first("sensor-board")
    return SensorBoard(
        start_s=reader.not_negative(element, "clock", TIME, USUAL_BOARD.start_s),
        tick_s=reader.positive(element, "tick", TIME, USUAL_BOARD.tick_s),
    )
