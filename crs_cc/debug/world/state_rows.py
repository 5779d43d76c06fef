"""The vendor's `State[]` as rows."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from crs_cc.debug.world.rows import Row
from crs_cc.sim.model.robot import RobotModel

if TYPE_CHECKING:
    from crs_cc.debug.data.values import Value
    from crs_cc.debug.view import View
    from crs_cc.debug.world.state_fields import StateField


def state_rows(elements: Iterable[tuple[StateField, Value]]) -> list[Row]:
    """Return the values of a `State[]` as rows."""
    return [
        Row(
            f"[{each.index}] {each.name}",
            each.text(value.number) if isinstance(value.number, int) else value.text,
        )
        for each, value in elements
    ]


def vendor_state_rows(view: View, robot: int) -> list[Row]:
    """Return the `State[]` of a robot's program; empty for a program without one.

    Fields of devices that the robot lacks are left out if they are 0.
    """
    model = view.session.environment.world.robots[robot].model
    missing = [name for name, device in _devices(model).items() if not device]
    elements = view.vendor_state(robot)
    return [
        row
        for row, (_, value) in zip(state_rows(elements), elements, strict=True)
        if value.number or not any(name in row.name for name in missing)
    ]


def _devices(model: RobotModel) -> dict[str, object]:
    """Return optional devices by a part of the names of their fields."""
    return {
        "STATE_IR_": model.device("infrared"),
        "_TURRET": model.drive.turret,
        "STATE_LASER": model.device("laser"),
        "STATE_COMPASS": model.device("compass"),
    }
