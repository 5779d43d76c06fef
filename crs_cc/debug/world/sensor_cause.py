"""Causes of readings in `State[]`: the beam, the object that it met, and faults."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.debug.world.rows import instant, length, pose_text
from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.model.degradation import described

if TYPE_CHECKING:
    from crs_cc.debug.world.state_fields import StateField
    from crs_cc.sim.engine.environment import Environment
    from crs_cc.sim.geometry.scene import Outlines

_DEVICES: Final = {
    "SONAR": "sonar", "IR": "infrared", "BUMPER": "bumper", "COMPASS": "compass",
    "CONF": "drive", "VEL": "drive",
}  # fmt: skip
"""The device that a field of `State[]` comes from, by a word in its name."""

_RAYS: Final = 31
_SAME_M: Final = 0.1
"""How far the outline may be from the echo to have returned it; chosen by us: the robot's motion
during a timestep, and the error of the sensor."""


@dataclass(frozen=True, slots=True)
class Firing:
    """The last firing of a sonar that a robot has reported.

    Attributes:
        fired_s: when it fired.
        echo_m: the distance of the echo as the robot has it, infinite for none.
    """

    number: int
    fired_s: float
    echo_m: float

    def text(self, met: str) -> str:
        """Return it in words, given the object in its beam at that distance, or ""."""
        at = f"sonar {self.number} fired at t = {instant(self.fired_s)}"
        if not math.isfinite(self.echo_m):
            return f"{at}: no echo"
        return f"{at}: echo at {length(self.echo_m)} from {met or 'nothing that was there'}"


def firing(environment: Environment, robot: int, field: StateField) -> Firing | None:
    """Return the firing that a field of `State[]` is from; None if it is of no sonar."""
    number = _number(field)
    if _device(field) != "sonar" or number is None:
        return None
    found = firing_of(environment, robot, number)
    has_fired = found.fired_s >= 0.0 and not math.isnan(found.echo_m)  # all do at the start
    return found if has_fired else None


def firing_of(environment: Environment, robot: int, number: int) -> Firing:
    """Return the last firing of a sonar."""
    sonar = sonar_state(environment.state)
    return Firing(number, float(sonar.fired_s[robot, number]), float(sonar.echo_m[robot, number]))


def sensor_texts(environment: Environment, robot: int, field: StateField) -> Iterator[str]:
    """Return additional facts about a reading that a robot has just reported."""
    device, number = _device(field), _number(field)
    if device == "bumper":
        robots, objects = np.divmod(environment.state.contacts_before, len(environment.names))
        touched = [environment.names[obj] for obj in objects[robots == robot].tolist()]
        yield f"the robot touched {', '.join(touched) or 'nothing'}"
    if "CONF" in field.name:
        state = environment.state
        pose = (float(each[robot]) for each in (state.x_m, state.y_m, state.heading_rad))
        yield f"estimated by odometry; the true pose was {pose_text(*pose)}"
    control, model = environment.degradations, environment.world.robots[robot].model
    for each in control.all():
        is_of = each.robot == environment.world.robots[robot].id and each.device == device
        is_element = number is None or each.element in {None, number}
        if is_of and is_element and control.phase(each.id) == "acts":
            yield f"bent by the degradation {each.id}: {described(each, model)}"


def _device(field: StateField) -> str:
    """Return the name of the device that measured a field; "" if it is none of these."""
    return next((name for word, name in _DEVICES.items() if f"_{word}" in field.name), "")


def _number(field: StateField) -> int | None:
    """Return the number of the sensor that measured a field; None if it has none."""
    last = field.name.rpartition("_")[2]
    return int(last) if last.isdigit() else None


def echoing_object(environment: Environment, robot: int, number: int, echo_m: float) -> str:
    """Return the object at the distance of an echo in the beam of a sonar; "" for none.

    The beam is that of the robot's present pose.
    """
    model, state = environment.world.robots[robot].model, environment.state
    mode = sonars_of(model).modes[int(sonar_state(state).mode[robot])]
    sonar = next(each for each in mode.sonars if each.id == number)
    turn = cmath.rect(1.0, float(state.mount_rad[robot]))
    start = complex(*state.bodies.position_m[robot].tolist())
    start += complex(sonar.x_m, sonar.y_m) * turn
    axis_rad = float(state.mount_rad[robot]) + sonar.direction_rad
    best, name = _SAME_M, ""
    for angle_rad in np.linspace(-sonar.half_angle_rad, sonar.half_angle_rad, _RAYS).tolist():
        ray = cmath.rect(1.0, axis_rad + angle_rad)
        hits = [
            each
            for outlines in environment.outlines()
            for each in _hits(outlines, start, ray, robot)
        ]
        distance_m, owner = min(hits, default=(math.inf, -1))
        if abs(distance_m - echo_m) < best:
            best, name = abs(distance_m - echo_m), environment.names[owner]
    return name


def _hits(
    outlines: Outlines, start: complex, ray: complex, own: int
) -> Iterator[tuple[float, int]]:
    """Return the distance and the owner of each outline that a ray of length 1 meets."""
    rows = zip(outlines.segments[:, :4].tolist(), outlines.segment_owners.tolist(), strict=True)
    for (x1, y1, x2, y2), owner in rows:
        one, other = ((complex(x, y) - start) / ray for x, y in ((x1, y1), (x2, y2)))
        if (one.imag > 0) != (other.imag > 0):
            share = one.imag / (one.imag - other.imag)
            distance_m = one.real + share * (other.real - one.real)
            if distance_m > 0.0:
                yield distance_m, owner
    for (x, y, radius_m), owner in zip(
        outlines.circles.tolist(), outlines.owners.tolist(), strict=True
    ):
        middle = (complex(x, y) - start) / ray
        inside = radius_m * radius_m - middle.imag * middle.imag
        if owner != own and inside >= 0.0 and (near := middle.real - math.sqrt(inside)) > 0.0:
            yield near, owner
