"""Sensors of a kind of robot.

Sonars are in `model.sonar`, light sensors and microphones in `model.beacons`. Units: metres,
seconds, radians; directions are counter-clockwise from ahead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class SensorBoard:
    """The computer on the robot that reads the sensors.

    Attributes:
        start_s: its clock at the start.
        tick_s: the resolution of its clock.
    """

    start_s: float = 0.0
    tick_s: float = 0.0164


USUAL_BOARD: Final = SensorBoard()
"""Defaults of a robot definition."""
