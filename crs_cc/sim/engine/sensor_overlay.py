"""The last readings of sensors, for pictures: echoes of sonars, and views of cameras.

For each sonar with an echo, the beam up to the echo; for each camera, a line to what each column
shows, in its colour. They are drawn from the robots' current poses, so camera pictures older than
`FRESH_S`, which were taken from other poses, are omitted.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.core.units import tenths_inch_to_m
from crs_cc.sim.devices.camera import Camera, camera_state, picture
from crs_cc.sim.devices.sonar.model import Sonar, sonars_of
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.env_state import EnvState

FRESH_S: Final = 0.25  # chosen by us
_ARC: Final = 9  # points of the arc at the end of a beam


@dataclass(frozen=True, slots=True)
class Beam:
    """The reading of one sensor in one direction.

    Attributes:
        outline: a polygon for a beam with a width, or both ends of a line [m], (points, 2); the
            first point is where the sensor is.
        colour: what a camera sees, #rrggbb; empty for an echo.
    """

    outline: FloatArray
    colour: str = ""


def sights(
    state: EnvState, world: WorldModel, time_s: float, only: int | None = None
) -> list[Beam]:
    """Return the last readings of sensors.

    Args:
        state: the world's state.
        world: the world.
        time_s: the time.
        only: the number of the robot whose sensors are included; None for all.
    """
    found: list[Beam] = []
    camera_row = 0
    for number, robot in enumerate(world.robots):
        if only not in {None, number}:
            camera_row += robot.model.device("camera") is not None
            continue
        place = np.array([state.x_m[number], state.y_m[number]])
        angle_rad = float(state.mount_rad[number])
        mode = sonars_of(robot.model).modes[int(sonar_state(state).mode[number])]
        for sonar in mode.sonars:
            echo_m = float(sonar_state(state).echo_m[number, sonar.id])
            if math.isfinite(echo_m):
                found.append(Beam(_turned(_cone(sonar, echo_m), angle_rad) + place))
        camera = robot.model.device("camera")
        if camera is not None:
            is_fresh = time_s - camera_state(state).readings.at_s[camera_row] <= FRESH_S
            colours, ranges = picture(state, camera, camera_row).T
            ranges_m = tenths_inch_to_m(ranges.astype(np.float64))
            for column, colour in enumerate(colours.tolist()):
                if is_fresh and ranges_m[column] >= 0.0:
                    line = _turned(_line(camera, column, float(ranges_m[column])), angle_rad)
                    found.append(Beam(line + place, f"#{colour:06x}"))
            camera_row += 1
    return found


def _cone(sonar: Sonar, echo_m: float) -> FloatArray:
    """Return a beam up to its echo, in the robot's frame."""
    half_rad = sonar.half_angle_rad
    angles = sonar.direction_rad + np.linspace(-half_rad, half_rad, _ARC)
    start = np.array([[sonar.x_m, sonar.y_m]])
    return np.concatenate(
        [start, start + echo_m * np.column_stack([exact.cos(angles), exact.sin(angles)])]
    )


def _line(camera: Camera, column: int, range_m: float) -> FloatArray:
    """Return the line from a camera to what a column shows, in the robot's frame."""
    step_rad = camera.field_of_view_rad / camera.columns
    angle = camera.direction_rad + ((camera.columns - 1) / 2 - column) * step_rad
    start = np.array([camera.x_m, camera.y_m])
    return np.array([start, start + range_m * np.array([exact.cos(angle), exact.sin(angle)])])


def _turned(points: FloatArray, angle_rad: float) -> FloatArray:
    cos, sin = exact.cos(angle_rad), exact.sin(angle_rad)
    x, y = points[..., 0], points[..., 1]
    return np.stack([cos * x - sin * y, sin * x + cos * y], axis=-1)
