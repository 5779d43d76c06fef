"""Lamps of robots, which light sensors of other robots detect (`crs_light`).

Brightness is the reading of a sensor that faces the lamp from a distance of 1 m. Larger values than
the maximum of the definition are clipped. Lamps are off at the start, and when the robot leaves.
Degradation (`lamp`) applies to the commanded brightness; if it is dropped the lamp goes off.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.core.quantity import BRIGHTNESS
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.emitters import commanded, of_all
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.model.attribute import attribute
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.robot import devices_of

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


@dataclass(frozen=True, slots=True)
class Lamp:
    """A lamp."""

    brightest: float = attribute(
        "brightest", BRIGHTNESS, "1000",
        "Maximum brightness: the reading of a light sensor that faces the lamp at 1 m.",
        positive=True,
    )  # fmt: skip


@dataclass(slots=True)
class LampState:
    """Lamps; arrays have a row for each robot with one, n of them.

    Attributes:
        brightness: its brightness, 0 for off, (n,).
    """

    brightness: FloatArray


def brightness(state: EnvState, constants: RobotConstants) -> FloatArray:
    """Return the brightness of all robots' lamps, 0 for none, (robots,)."""
    return of_all(state, constants, "lamp", state.device("lamp", LampState).brightness)


def install(row: Device, world: WorldModel, _seed: int, _log: EventLog) -> Installed:
    """Return the handler of LIGHT."""
    found = devices_of([robot.model for robot in world.robots], row.name)
    brightest = np.array([lamp.brightest for lamp in found if lamp is not None])

    def light(context: RequestContext) -> BoolArray:
        """Set the brightness of lamps; refuse robots without one."""
        numbers = context.constants.numbers[row.name][context.rows]
        has = np.asarray(numbers >= 0)
        mine = numbers[has]
        wanted = commanded(
            context, row.name, context.rows[has], context["brightness"][has], most=brightest[mine]
        )
        context.state.device(row.name, LampState).brightness[mine] = wanted
        return has

    return Installed(handlers={"LIGHT": light})


DEVICE = Device(
    name="lamp",
    title="Lamp",
    element="lamp",
    summary="A lamp that light sensors of other robots detect; programs control it with crs_light()"
    " (crs.h).",
    model=Lamp,
    state=lambda models: LampState(np.zeros(len(models))),
    install=install,
    requests=(
        device_request(
            "LIGHT", 225, "int crs_light(int brightness)", "sets the brightness of the lamp",
            fields(("brightness", "i[0]", "1", "brightness, as read at 1 m")),
        ),
    ),
    functions=(
        Function(
            "int crs_light(int brightness)",
            "sets the brightness of the robot's lamp, as read by a light sensor at 1 m; 0 for off",
            posts=("LIGHT",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "lamp", "commanded brightness", BRIGHTNESS, elements_of("lamp", lambda _model: ("0",)),
            1, "the lamp goes off", acts=True,
        ),
    ),
    inspect=lambda state, number: f"{state.device('lamp', LampState).brightness[number]:g}",
    source=__file__,
)  # fmt: skip
