"""The table of `docs/robots.md`: the bundled robot definitions."""

from __future__ import annotations

import math

from crs_cc.sim.devices.bumper.element import switches_of
from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.files.known_robots import known_robots
from crs_cc.sim.files.world_xml import load_robot
from crs_cc.sim.model.robot import RobotModel
from docs.generate import Fillers, table
from docs.generate.schema import SIM


def robots() -> str:
    """Return the table of all bundled robots."""
    titles = ("name", "radius, mass", "drive", "top speed", "sonars", "other sensors")
    return table(titles, [_row(name) for name in known_robots()])


def _row(name: str) -> tuple[str, ...]:
    model = load_robot(SIM / "files" / "robots" / f"{name}.xml")
    return (
        f"`{name}`",
        f"{100 * model.radius_m:.1f} cm, {model.mass_kg:g} kg",
        _drive(model),
        f"{model.drive.wheels.speed_limit:.2f} m/s",
        _sonars(model),
        _others(model),
    )


def _drive(model: RobotModel) -> str:
    drive = model.drive
    if drive.steering is None:
        return f"two wheels, {100 * drive.wheel_base_m:.1f} cm apart"
    return "synchro drive with turret" if drive.turret is not None else "synchro drive"


def _sonars(model: RobotModel) -> str:
    sonars = sonars_of(model).sonars
    front = [each.id for each in sonars if abs(each.direction_rad) < math.radians(20)]
    numbers = ", ".join(map(str, front))
    return f"{len(sonars)}, range {sonars[0].range_m:.1f} m; front: {numbers}"


def _others(model: RobotModel) -> str:
    devices = {
        f"{len(switches_of(model))} bumpers": bool(switches_of(model)),
        "infrared": model.device("infrared") is not None,
        "compass": model.device("compass") is not None,
        "laser": model.device("laser") is not None,
        "heat": model.device("heat") is not None,
    }
    return ", ".join(name for name, has in devices.items() if has) or "none"


FILLERS: Fillers = {"robots": robots}
