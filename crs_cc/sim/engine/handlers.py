"""What a robot does for each request: one small function each, for all robots that posted it.

A handler changes the state and gives, for each robot, whether the request was good. Wheels have
been turned to the instant of the request before.

What a robot does not have it refuses: a request that is about one device, to read it or to tell it
something, changes nothing on a robot without it, and its result is 0. The same holds for parts that
it does not have: a sonar in an order, a mode. `State` comes with the reply all the same. Requests
about all of the robot, like GS, are answered by each.

The table and `requests.REQUESTS` must name the
same codes; a test holds them together.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray, Records
from crs_cc.requests import CODES, REQUESTS
from crs_cc.sim.comms import messenger
from crs_cc.sim.devices import (
    beacons,
    bumper,
    compass,
    drive,
    infrared,
    laser,
    odometry,
    pos_data,
    serial_link,
    sonar,
    tag,
)
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.devices.waits import Wait
from crs_cc.sim.engine.server import drawing, world
from crs_cc.sim.engine.server.motion import motion_check
from crs_cc.sim.engine.server.place import place_robot
from crs_cc.sim.engine.server.robot_poses import get_rpx
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.mask import NUM_MASK, POS_DATA

Handler: TypeAlias = Callable[[EnvState, RobotConstants, IndexArray, Records], BoolArray | None]
"""Gives whether each request was good; None when all were."""


def connect(
    state: EnvState, constants: RobotConstants, rows: IndexArray, messages: Records
) -> None:
    """Connects; whatever the number, a program's robot is the one that it runs in.

    That robot is there already, so that `create_robot` has nothing more to do.
    """
    state.connected[rows] = True
    serial_link.set_speed(state, rows, messages["i"][:, 1])
    messages["i"][:, 0] = constants.vendor_model[rows]


def disconnect(
    state: EnvState, _constants: RobotConstants, rows: IndexArray, _messages: Records
) -> None:
    """Ends the connection, or the simulator for this program.

    The wheels go on as they were told (vendor source `Ndirect.c` 2.7).
    """
    state.connected[rows] = False


def tell(
    _state: EnvState, _constants: RobotConstants, _rows: IndexArray, _messages: Records
) -> None:
    """Changes nothing: readings come with the reply, or the robot is as it is asked to be."""


def leave_to_device(
    _state: EnvState, _constants: RobotConstants, _rows: IndexArray, _messages: Records
) -> None:
    """Does nothing yet: the device does and tells what is asked, see `Devices.answers`."""


def refuse(
    _state: EnvState, _constants: RobotConstants, rows: IndexArray, _messages: Records
) -> BoolArray:
    """Refuses what this robot, or its simulator, cannot do.

    There is no real robot, no window to point at, and nobody who knows packets of the user's own.
    """
    return np.zeros(len(rows), dtype=np.bool_)


def ct(
    state: EnvState, _constants: RobotConstants, rows: IndexArray, messages: Records
) -> BoolArray:
    """Takes over which parts of `State` the program wants; refuses a mask that is not whole."""
    good: BoolArray = messages["size"] == NUM_MASK
    state.mask[rows[good]] = messages["data"][good, :NUM_MASK]
    state.pos_data.attach(rows[state.mask[rows, POS_DATA] != 0])
    return good


HANDLERS: Final[dict[int, Handler]] = {
    CODES[name]: handler
    for name, handler in (
        ("CONNECT", connect),
        ("DISCONNECT", disconnect),
        ("AC", drive.ac),
        ("SP", drive.sp),
        ("PR", drive.pr),
        ("VM", drive.vm),
        ("MV", drive.mv),
        ("ST", drive.st),
        ("LP", drive.lp),
        ("WS", drive.ws),
        ("DP", odometry.dp),
        ("DA", odometry.da),
        ("ZR", drive.zr),
        ("CONF_SN", sonar.conf_sn),
        ("CONF_TM", drive.conf_tm),
        ("GS", tell),
        ("GET_SN", sonar.get_sn),
        ("GET_BP", bumper.get_bp),
        ("GET_RC", tell),
        ("GET_RV", tell),
        ("CT", ct),
        ("GET_IR", infrared.get_ir),
        ("GET_RA", tell),
        ("GET_CP", compass.get_cp),
        ("GET_LS", laser.get_laser),
        ("GET_SG", laser.get_laser),
        ("CONF_IR", infrared.conf_ir),
        ("CONF_CP", compass.conf_cp),
        ("CONF_LS", laser.conf_ls),
        ("CONF_SG", laser.conf_sg),
        ("LASER_PAGE", laser.page),
        ("POS_DATA", pos_data.page),
        ("TK", tell),
        ("CONF_SER", serial_link.conf_ser),
        ("PLACE_ROBOT", place_robot),
        ("ADD_OBSTACLE", world.add_obstacle),
        ("DELETE_OBSTACLE", world.delete_obstacle),
        ("MOVE_OBSTACLE", world.move_obstacle),
        ("NEW_WORLD", world.new_world),
        ("GET_RPX", get_rpx),
        ("PREDICT", leave_to_device),
        ("MOTION_CHECK", motion_check),
        ("GET_CONF", refuse),
        ("REAL_ROBOT", refuse),
        ("SIMULATED_ROBOT", tell),
        ("DRAW", drawing.draw),
        ("REFRESH", drawing.refresh),
        ("QUIT_SERVER", disconnect),
        ("CREATE", connect),
        ("SPECIAL", refuse),
        ("SONAR", leave_to_device),
        ("HEAT", leave_to_device),
        ("TAG", tag.tag),
        ("GPS", leave_to_device),
        ("TILT", leave_to_device),
        ("CAMERA", leave_to_device),
        ("SEND", leave_to_device),
        ("RECEIVE", messenger.wait),
        ("MESSAGE_COUNT", leave_to_device),
        ("GROUP", leave_to_device),
        ("CHANNEL", leave_to_device),
        ("ROBOT", leave_to_device),
        ("READINGS", leave_to_device),
        ("SENSE_HEAT", leave_to_device),
        ("SONAR_MODE", sonar.set_mode),
        ("SONAR_RANGES", leave_to_device),
        ("LASER", leave_to_device),
        ("PERIOD", leave_to_device),
        ("AGE", leave_to_device),
        ("GRIPPER", leave_to_device),
        ("GET_GRIPPER", leave_to_device),
        ("ARM", leave_to_device),
        ("GET_ARM", leave_to_device),
        ("HAND", leave_to_device),
        ("LIGHT", beacons.light),
        ("SOUND", beacons.sound),
        ("GET_LIGHT", leave_to_device),
        ("GET_SOUND", leave_to_device),
        ("TAKE_HEAT", tag.tag),
    )
}
"""The handler of each request that a robot answers, or one of its devices."""

UNCONNECTED: Final = frozenset(
    code
    for code, request in REQUESTS.items()
    if request.server == "device" or request.name in {"CONNECT", "CREATE"}
)
"""Requests for which a program need not be connected."""

MOVES: Final = frozenset(CODES[name] for name in ("PR", "VM", "MV"))
"""Requests that can make a robot move."""

CHANGES_WORLD: Final = frozenset(
    CODES[name]
    for name in ("ADD_OBSTACLE", "DELETE_OBSTACLE", "MOVE_OBSTACLE", "NEW_WORLD", "PLACE_ROBOT")
)
"""Requests after which things may stand elsewhere; they take until the cycle's end."""

WAITS: Final[dict[int, Wait]] = {
    CODES["WS"]: Wait(drive.stands_s, tell),
    CODES["ZR"]: Wait(drive.stands_s, drive.zeroed),
    CODES["RECEIVE"]: Wait(messenger.heard_s, tell),
}
"""Requests that can make a robot wait."""
