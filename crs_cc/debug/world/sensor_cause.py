"""What a reading in `State[]` was measured from: the beam, the object that it met, and faults."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.debug.world.rows import instant, length
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
"""How far the outline may be from the echo to have returned it; chosen by us: a robot's motion
while the sound is on its way, and the roundness of a beam's front."""


def sensor_texts(environment: Environment, robot: int, field: StateField) -> Iterator[str]:
    """Return what is known of a reading that a robot has just reported, in the present world."""
    device = next((name for word, name in _DEVICES.items() if word in field.name), "")
    number = int(found) if (found := field.name.rpartition("_")[2]).isdigit() else None
    if device == "sonar" and number is not None:
        yield sonar_text(environment, robot, number)
    control, model = environment.degradations, environment.world.robots[robot].model
    for each in control.all():
        is_of = each.robot == environment.world.robots[robot].id and each.device == device
        if is_of and each.element in {None, number} and control.phase(each.id) == "acts":
            yield f"bent by the degradation {each.id}: {described(each, model)}"


def sonar_text(environment: Environment, robot: int, number: int) -> str:
    """Return when a sonar fired last, what it heard, and which object that was."""
    sonar = sonar_state(environment.state)
    fired_s, echo_m = float(sonar.fired_s[robot, number]), float(sonar.echo_m[robot, number])
    if fired_s <= 0.0:
        return f"sonar {number} has not fired yet"
    at = f"sonar {number} fired at t = {instant(fired_s)}"
    if not math.isfinite(echo_m):
        return f"{at}: no echo"
    met = object_met(environment, robot, number, echo_m)
    return f"{at}: echo at {length(echo_m)} from {met or 'nothing that is there now'}"


def object_met(environment: Environment, robot: int, number: int, echo_m: float) -> str:
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
