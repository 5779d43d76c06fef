"""The handlers of requests: one small function each, for all robots that posted it.

A handler changes the state, writes the results, and returns for each robot whether the request was
good. Before, wheels have been turned and timers have fired up to the time of the request. If the
reply is all of `State`, the sensor board writes it afterwards.

A robot refuses requests for devices that it does not have: a request that reads or commands one
device changes nothing on a robot without it, and its result is 0. The same holds for missing parts:
a sonar in an order, a mode. The reply contains `State` nevertheless. Every robot answers requests
about the whole robot, like GS.

The table has the same codes as `requests.REQUESTS`, except those of the host; a test keeps them in
step.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray
from crs_cc.requests import CODES, REQUESTS
from crs_cc.sim.comms import messenger
from crs_cc.sim.devices import (
    drive,
    odometry,
    pages,
    pos_data,
    serial_link,
)
from crs_cc.sim.devices.waits import Wait
from crs_cc.sim.engine.server import drawing, world
from crs_cc.sim.engine.server.motion import motion_check
from crs_cc.sim.engine.server.place import place_robot
from crs_cc.sim.engine.server.prediction import predict
from crs_cc.sim.engine.server.robot_poses import get_rpx
from crs_cc.sim.state.mask import NUM_MASK, POS_DATA

if TYPE_CHECKING:
    from collections.abc import Mapping

    from crs_cc.sim.devices.request_context import Handler, RequestContext
    from crs_cc.sim.engine.device_board import DeviceBoard


_READS: Final = {
    "GET_SN": "sonar",
    "GET_BP": "bumper",
    "GET_IR": "infrared",
    "GET_CP": "compass",
}
"""Requests for `State` that robots without a device refuse."""


def connect(context: RequestContext) -> None:
    """Connect; a program's robot is the one that it runs in, for any number."""
    serial_link.set_speed(context.state, context.rows, context["baud"])
    create(context)


def create(context: RequestContext) -> None:
    """Connect to the robot, which exists already."""
    context.state.connected[context.rows] = True
    context["model"] = context.constants.vendor_model[context.rows]


def disconnect(context: RequestContext) -> None:
    """End the connection, or the simulator for this program.

    The wheels continue their motion (vendor source `Ndirect.c` 2.7).
    """
    context.state.connected[context.rows] = False


def acknowledge(_context: RequestContext) -> None:
    """Change nothing: the reply's `State` is the answer, or there is nothing to change."""


def refuse(context: RequestContext) -> BoolArray:
    """Refuse requests that this robot, or its simulator, cannot execute.

    There is no real robot, no window to point at, and no interpreter of user-defined packets.
    """
    return np.zeros(len(context), dtype=np.bool_)


def ct(context: RequestContext) -> BoolArray:
    """Set which parts of `State` the program requests; refuse an incomplete mask."""
    state = context.state
    good: BoolArray = context["count"] == NUM_MASK
    rows = context.rows[good]
    state.mask[rows] = context["mask"][good, :NUM_MASK]
    state.pos_data.attach(context.rows[state.mask[context.rows, POS_DATA] != 0])
    return good


def handlers_of(devices: DeviceBoard) -> Mapping[int, Handler]:
    """Return the handler of each request that a robot answers, or one of these devices."""
    board, messages = devices.sensor_board, devices.messenger
    handlers: dict[str, Handler] = {
        "CONNECT": connect,
        "DISCONNECT": disconnect,
        "AC": drive.ac,
        "SP": drive.sp,
        "PR": drive.pr,
        "VM": drive.vm,
        "MV": drive.mv,
        "ST": drive.st,
        "LP": drive.lp,
        "WS": drive.ws,
        "DP": odometry.dp,
        "DA": odometry.da,
        "ZR": drive.zr,
        "CONF_TM": drive.conf_tm,
        "GS": acknowledge,
        "GET_RC": acknowledge,
        "GET_RV": acknowledge,
        "CT": ct,
        "GET_RA": drive.get_ra,
        "POS_DATA": pos_data.page,
        "TK": acknowledge,
        "CONF_SER": serial_link.conf_ser,
        "PLACE_ROBOT": place_robot,
        "ADD_OBSTACLE": world.add_obstacle,
        "DELETE_OBSTACLE": world.delete_obstacle,
        "MOVE_OBSTACLE": world.move_obstacle,
        "NEW_WORLD": world.new_world,
        "GET_RPX": get_rpx,
        "PREDICT": partial(predict, sonars=devices.sonars, sensor_board=board),
        "MOTION_CHECK": motion_check,
        "GET_CONF": refuse,
        "REAL_ROBOT": refuse,
        "SIMULATED_ROBOT": acknowledge,
        "DRAW": drawing.draw,
        "REFRESH": drawing.refresh,
        "QUIT_SERVER": disconnect,
        "CREATE": create,
        "SPECIAL": refuse,
        "READINGS": partial(pages.page, installed=devices.installed),
        "PERIOD": devices.timers.set_period,
        "AGE": devices.timers.get_age,
        "SEND": messages.send,
        "RECEIVE": messenger.wait,
        "MESSAGE_COUNT": messages.count,
        "GROUP": messages.group,
        "CHANNEL": messages.find_channel,
        "FIELD": devices.fields.find,
        "ROBOT": messages.find_robot,
    }
    for installed in devices.installed.values():
        handlers |= installed.handlers
    return {CODES[name]: handler for name, handler in handlers.items()}


def simple_commands(devices: DeviceBoard, numbers: Mapping[str, IndexArray]) -> dict[int, int]:
    """Return the requests that kernels can answer, with the command that they run, 0 for none.

    Args:
        devices: the robots' devices.
        numbers: the number of each robot's device, -1 for none, by the devices' names.
    """
    if not devices.sensor_board.is_simple:
        return {}
    handlers = handlers_of(devices)
    reads = [code for code, handler in handlers.items() if handler is acknowledge]
    simple = dict.fromkeys((code for code in reads if REQUESTS[code].replies_state), 0)
    for name, device in _READS.items():
        if (numbers[device] >= 0).all():
            simple[CODES[name]] = 0
    return simple | {code: code for code in (CODES["VM"], CODES["ST"])}


def waits_of(devices: DeviceBoard) -> Mapping[int, Wait]:
    """Return the wait of each request that waits according to `REQUESTS`."""
    return {
        CODES["WS"]: Wait(drive.rest_s, acknowledge),
        CODES["ZR"]: Wait(drive.rest_s, drive.zeroed),
        CODES["RECEIVE"]: Wait(devices.messenger.receive_ends_s, devices.messenger.receive),
    }
