"""What the view draws of devices and fields: arms, what is carried, degraded or hot, readings."""

from __future__ import annotations

import base64
import math
from itertools import islice
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.units import tenths_inch_to_m
from crs_cc.recording.field_sketches import field_sketch
from crs_cc.sim.devices.arm.state import arm_of
from crs_cc.sim.devices.camera import camera_state, picture
from crs_cc.sim.devices.gripper.state import gripper_of
from crs_cc.sim.devices.laser.model import NUM_LASER, laser_state
from crs_cc.sim.model.degradation import part
from crs_cc.workbench.feed import rounded

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from crs_cc.recording.field_sketches import FieldSketch
    from crs_cc.sim.engine.environment import Environment
    from crs_cc.sim.model.degradation import Degradation

MAX_DEGRADED: Final = 500
MAX_HEATED: Final = 500


def devices_in_view(environment: Environment, rows: Sequence[int], selected: int) -> dict[str, Any]:
    """Return the drawn state of some robots' devices, and the readings of the selected one's."""
    fields = range(len(environment.world.fields))
    return {
        "fingers": dict(_fingers(environment, rows)),
        "joints": dict(_joints(environment, rows)),
        "holds": dict(_holds(environment, rows)),
        "degraded": list(_degraded(environment)),
        "heats": dict(islice(_heats(environment), MAX_HEATED)),
        "laser": _laser(environment, selected),
        "camera": _camera(environment, selected),
        "infrared": _readings(environment, "infrared", selected),
        "fields": [_field(environment, each) for each in fields],
        "heat": next(iter(_readings(environment, "heat", selected)), None),
    }


def _fingers(environment: Environment, rows: Sequence[int]) -> Iterator[tuple[int, float]]:
    """Yield the distance between the fingers [m]."""
    apart_m = gripper_of(environment.state).before_m
    if len(apart_m):
        for robot in rows:
            number = environment.device_number("gripper", robot)
            if number >= 0:
                yield robot, round(float(apart_m[number]), 4)


def _joints(environment: Environment, rows: Sequence[int]) -> Iterator[tuple[int, list[float]]]:
    """Yield the angles of shoulder and elbow [rad], which turn at constant speed."""
    arms = arm_of(environment.state)
    for robot in rows if len(arms.since_s) else ():
        number = environment.device_number("arm", robot)
        if number < 0:
            continue
        model = environment.world.robots[robot].model.device("arm")
        assert model is not None  # it has a number
        speed_radps = np.array([model.shoulder_radps, model.elbow_radps])
        most_rad = speed_radps * max(0.0, environment.time_s - float(arms.since_s[number]))
        way_rad = arms.to_rad[number] - arms.from_rad[number]
        yield robot, rounded(arms.from_rad[number] + np.clip(way_rad, -most_rad, most_rad))


def _holds(environment: Environment, rows: Sequence[int]) -> Iterator[tuple[int, list[str]]]:
    """Yield the names of what robots hold."""
    objects = environment.state.bodies.holds.object
    for robot in rows:
        held = [environment.pushables[each] for each in objects[robot].tolist() if each >= 0]
        if held:
            yield robot, held


def _degraded(environment: Environment) -> Iterator[tuple[int, str, int, str, str]]:
    """Yield robot, device, element (-1 for all), phase and name of degradations."""
    if not len(environment.state.degradation.table):
        return
    robots = {robot.id: row for row, robot in enumerate(environment.world.robots)}
    for each in environment.degradations.all()[:MAX_DEGRADED]:
        phase = phase_now(environment, each)
        if phase in {"acts", "fades"}:
            element = -1 if each.element is None else each.element
            robot = robots[each.robot]
            name = part(each, environment.world.robots[robot].model)
            yield robot, each.device, element, phase, name


def _heats(environment: Environment) -> Iterator[tuple[str, float]]:
    """Yield the heat of what no longer has that of the world file."""
    left = environment.state.heat.left.tolist()
    for obj, heat in zip(environment.objects, left, strict=False):  # the ground has none
        if heat != obj.heat:
            yield obj.id, heat


def field_map(sketch: FieldSketch) -> dict[str, Any]:
    """Return a field as the page draws it, without its amounts."""
    rows, columns = sketch.shares.shape
    return {
        "name": sketch.name,
        "x": sketch.x_m,
        "y": sketch.y_m,
        "cell": sketch.square_m,
        "rows": rows,
        "columns": columns,
        "most": sketch.most,
    }


def _field(environment: Environment, field: int) -> dict[str, Any]:
    """Return a field as shares of its largest amount, a byte for each square."""
    sketch, _ = field_sketch(environment, field)
    return field_map(sketch) | {"data": base64.b64encode(sketch.shares.tobytes()).decode()}


def _camera(environment: Environment, robot: int) -> list[tuple[str, float | None]]:
    """Return colour and range [m] of each column of the last picture; null without an object."""
    number = environment.device_number("camera", robot)
    state, camera = environment.state, environment.world.robots[robot].model.device("camera")
    if camera is None or camera_state(state).readings.at_s[number] < 0.0:
        return []
    columns = picture(state, camera, number)
    return [
        (f"#{colour:06x}", None if range_ < 0 else round(tenths_inch_to_m(range_), 3))
        for colour, range_ in columns.tolist()
    ]


def _readings(environment: Environment, device: str, robot: int) -> list[float | None]:
    """Return the last readings of a device, null for no value; nothing without the device."""
    found = environment.reading(device, robot)
    numbers = [] if found is None else rounded(found.astype(np.float64))
    return [None if math.isnan(each) else each for each in numbers]


def phase_now(environment: Environment, degradation: Degradation) -> str:
    """Return the phase of a degradation; one that begins with this timestep acts already."""
    phase = environment.degradations.phase(degradation.id)
    return "acts" if phase == "waits" and degradation.onset_s <= environment.time_s else phase


def _laser(environment: Environment, robot: int) -> list[float | None]:
    """Return the last scan of a robot's laser [m], from right to left; null without an echo."""
    number = environment.device_number("laser", robot)
    if number < 0:
        return []
    laser = laser_state(environment.state)
    if laser.readings.at_s[number] < 0.0:
        return []
    scan = laser.readings.value[number]
    count = min(int(laser.wanted[number]), int(np.nan_to_num(scan[NUM_LASER])))
    return [round(each, 3) if np.isfinite(each) else None for each in scan[:count].tolist()]
