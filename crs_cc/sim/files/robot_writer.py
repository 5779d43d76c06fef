"""Writes robot models as robot definitions: what `robot_elements` reads, with equal values.

>>> from crs_cc.sim.files.known_robots import ROBOTS
>>> from crs_cc.sim.files.world_xml import load_robot, parse_robot
>>> scout = load_robot(ROBOTS / "scout.xml", "noisy")
>>> parse_robot(robot_text(scout), "scout") == scout
True
"""

from __future__ import annotations

import math
from dataclasses import fields

from crs_cc.core.quantity import (
    ACCELERATION,
    ANGLE,
    FORCE,
    FREQUENCY,
    LENGTH,
    MASS,
    RATIO,
    SPEED,
    TIME,
    TURN_ACCELERATION,
    TURN_RATE,
    Kind,
)
from crs_cc.sim.files.device_elements import device_elements
from crs_cc.sim.files.document import Element
from crs_cc.sim.files.robot_elements import MAX_BYTES, VENDOR_MODELS
from crs_cc.sim.files.world_xml import parse_robot
from crs_cc.sim.files.xml_document import document_of
from crs_cc.sim.model.axis import Axis
from crs_cc.sim.model.robot import Drive, Link, Odometry, RobotModel
from crs_cc.sim.model.sensors import SensorBoard


def robot_text(model: RobotModel) -> bytes:
    """Return a robot model as the text of a robot definition, without setups.

    Raises:
        ValueError: something in the model cannot be written.
        WorldError: the model is invalid; all errors are reported at once.
    """
    text = document_of(robot_element(model))
    again = parse_robot(text, model.name)
    if again != model:
        raise ValueError(f"the robot cannot be written: {_difference(model, again)}")
    return text


def robot_element(model: RobotModel) -> Element:
    """Return the element of a robot model, see `robot_text`; it is not checked.

    Raises:
        ValueError: something in the model cannot be written.
    """
    described = device_elements(model)
    children = [
        _body(model),
        _drive(model.drive),
        _odometry(model.odometry),
        *(each for each in described if each.tag != "sensor"),
        _board(model.board),
        _link(model.link),
        Element("host", 0, {"speed": FREQUENCY.exact(model.host_speed_hz)}),
        *(each for each in described if each.tag == "sensor"),
    ]
    vendor = dict(enumerate(VENDOR_MODELS)).get(model.vendor_model)
    if vendor is None:
        raise ValueError(f"unknown vendor_model {model.vendor_model} (expected 0, 1 or 2)")
    attributes = {"version": "1", "name": model.name, "model": vendor}
    return Element("robot-definition", 0, attributes, children=children)


def _difference(model: RobotModel, again: RobotModel) -> str:
    """Return the parts that would not be read back unchanged."""
    for name, device in model.devices:
        if again.device(name) != device:
            return f"its device {name!r} would be read differently"
    for field in fields(RobotModel):
        if field.compare and getattr(model, field.name) != getattr(again, field.name):
            return f"its {field.name} would be read differently"
    return ""


def _body(model: RobotModel) -> Element:
    sizes = {"radius": LENGTH.exact(model.radius_m), "mass": MASS.exact(model.mass_kg)}
    if math.isfinite(model.height_m):
        sizes["height"] = LENGTH.exact(model.height_m)
    return Element("body", 0, sizes)


def _drive(drive: Drive) -> Element:
    own = {"type": "differential", "wheel-base": LENGTH.exact(drive.wheel_base_m)}
    attributes = {
        **(own if drive.steering is None else {"type": "synchro"}),
        **_axis(drive.wheels, SPEED, ACCELERATION),
        "timeout": TIME.exact(drive.timeout_s),
        "force": FORCE.exact(drive.force_n),
        "grip": FORCE.exact(drive.grip_n),
        "roll-out": ACCELERATION.exact(drive.roll_out_mps2),
        "climb": ANGLE.exact(drive.climb_rad),
        "step": LENGTH.exact(drive.step_m),
        "give-up": TIME.exact(drive.give_up_s if math.isfinite(drive.give_up_s) else 0.0),
        "ws-timeout-zero": "forever" if drive.waits_forever else "return",
    }
    turning = {"steering": drive.steering, "turret": drive.turret}
    children = [
        Element(name, 0, _axis(axis, TURN_RATE, TURN_ACCELERATION))
        for name, axis in turning.items()
        if axis is not None
    ]
    return Element("drive", 0, attributes, children=children)


def _axis(axis: Axis, speed: Kind, acceleration: Kind) -> dict[str, str]:
    return {
        "speed-limit": speed.exact(axis.speed_limit),
        "acceleration-limit": acceleration.exact(axis.acceleration_limit),
        "speed": speed.exact(axis.speed),
        "acceleration": acceleration.exact(axis.acceleration),
    }


def _odometry(odometry: Odometry) -> Element:
    attributes = {
        "resolution": LENGTH.exact(odometry.resolution_m),
        "turn-resolution": ANGLE.exact(odometry.resolution_rad),
        "scale": RATIO.exact(odometry.scale),
        "diameters": RATIO.exact(odometry.diameters),
        "wheel-base": RATIO.exact(odometry.wheel_base),
        "drift": ANGLE.exact(odometry.drift_radpm),
        "way-noise": LENGTH.exact(odometry.way_noise_m),
        "turn-noise": ANGLE.exact(odometry.turn_noise_rad),
        "spin-noise": ANGLE.exact(odometry.spin_noise_rad),
    }
    return Element("odometry", 0, attributes)


def _board(board: SensorBoard) -> Element:
    times = {"clock": TIME.exact(board.start_s), "tick": TIME.exact(board.tick_s)}
    return Element("sensor-board", 0, times)


def _link(link: Link) -> Element:
    """Return the element of a link; only the sum of the bytes of both directions is known."""
    commands = [
        {"name": name, "sends": str(min(count, MAX_BYTES)), "receives": str(rest)}
        for name, count in link.byte_counts
        for rest in [max(0, count - MAX_BYTES)]
    ]
    children = [Element("command", 0, each) for each in commands]
    attributes = {"baud": str(link.baud), "network": TIME.exact(link.network_s)}
    return Element("link", 0, attributes, children=children)
