"""Elements of a robot definition file."""

from __future__ import annotations

import math
from typing import Final

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
from crs_cc.core.suggest import unknown
from crs_cc.requests import REQUESTS
from crs_cc.sim.files import (
    device_elements,
    sensor_elements,
)
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.axis import Axis
from crs_cc.sim.model.robot import Drive, Link, Odometry, RobotModel

VENDOR_MODELS: Final = ("nomad200", "nomad150", "scout")
"""The vendor's models by their numbers (vendor header `Nclient.h` 1.29: MODEL_N200, ...)."""

MAX_BYTES: Final = 65_535
_MAX_BAUD: Final = 100_000_000
_NETWORK_S: Final = 1e-3  # default of `robot.xsd`
_SEVERAL: Final = frozenset({"sensor", "setup"})
_ROBOT_COMMANDS: Final = frozenset(
    request.name for request in REQUESTS.values() if request.server == "robot"
)


def robot_model(root: Element, reader: Reader) -> RobotModel:
    """Return the model that a robot definition describes; errors go to the reader."""
    body = root.first("body")
    vendor = root.attributes.get("model", "scout")
    radius_m = reader.positive(body, "radius", LENGTH)
    _check_duplicates(root, reader)
    return RobotModel(
        root.attributes["name"],
        radius_m=radius_m,
        drive=_drive(root.first("drive"), reader),
        odometry=_odometry(root.first("odometry"), reader),
        mass_kg=reader.positive(body, "mass", MASS),
        board=sensor_elements.sensor_board(root, reader),
        link=_link(root.first("link"), reader),
        host_speed_hz=reader.positive(root.first("host"), "speed", FREQUENCY, 5e7),
        vendor_model=VENDOR_MODELS.index(vendor),
        height_m=reader.positive(body, "height", LENGTH, math.inf),
        devices=device_elements.models(root, reader),
    )


def _check_duplicates(root: Element, reader: Reader) -> None:
    """Report duplicate elements: the schema allows those of devices in any order."""
    seen: set[str] = set()
    for element in root.children:
        if element.tag in seen and element.tag not in _SEVERAL:
            reader.error(element, f"duplicate <{element.tag}>")
        seen.add(element.tag)


def _drive(element: Element, reader: Reader) -> Drive:
    synchro = element.attributes.get("type") == "synchro"
    if synchro != any(element.all("steering")):
        reader.error(element, "<steering> must be given for a synchro drive, and only for it")
    if not synchro and any(element.all("turret")):
        reader.error(element, "<turret> is only allowed for a synchro drive")
    if not synchro and "wheel-base" not in element.attributes:
        reader.error(element, "missing attribute 'wheel-base' of a differential drive")
    return Drive(
        wheel_base_m=0.0 if synchro else reader.positive(element, "wheel-base", LENGTH),
        wheels=_axis(element, reader, SPEED, ACCELERATION),
        steering=_turning(element, "steering", reader),
        turret=_turning(element, "turret", reader),
        timeout_s=reader.not_negative(element, "timeout", TIME),
        force_n=reader.positive(element, "force", FORCE),
        grip_n=reader.positive(element, "grip", FORCE),
        roll_out_mps2=reader.positive(element, "roll-out", ACCELERATION),
        climb_rad=_climb(element, reader),
        step_m=reader.not_negative(element, "step", LENGTH),
        give_up_s=reader.not_negative(element, "give-up", TIME) or math.inf,
        waits_forever=element.attributes.get("ws-timeout-zero") == "forever",
    )


def _climb(element: Element, reader: Reader) -> float:
    climb_rad = reader.not_negative(element, "climb", ANGLE)
    if climb_rad < math.pi / 2:
        return climb_rad
    reader.refuse(element, "climb: must be less than 90deg")
    return 0.0


def _odometry(element: Element, reader: Reader) -> Odometry:
    return Odometry(
        resolution_m=reader.not_negative(element, "resolution", LENGTH),
        resolution_rad=reader.not_negative(element, "turn-resolution", ANGLE),
        scale=reader.positive(element, "scale", RATIO),
        diameters=reader.positive(element, "diameters", RATIO),
        wheel_base=reader.positive(element, "wheel-base", RATIO),
        drift_radpm=reader.quantity(element, "drift", ANGLE),
        way_noise_m=reader.not_negative(element, "way-noise", LENGTH),
        turn_noise_rad=reader.not_negative(element, "turn-noise", ANGLE),
        spin_noise_rad=reader.not_negative(element, "spin-noise", ANGLE),
    )


def _turning(drive: Element, name: str, reader: Reader) -> Axis | None:
    element = drive.find_child(name)
    return None if element is None else _axis(element, reader, TURN_RATE, TURN_ACCELERATION)


def _axis(element: Element, reader: Reader, speed: Kind, acceleration: Kind) -> Axis:
    return Axis(
        speed_limit=reader.positive(element, "speed-limit", speed),
        acceleration_limit=reader.positive(element, "acceleration-limit", acceleration),
        speed=reader.positive(element, "speed", speed),
        acceleration=reader.positive(element, "acceleration", acceleration),
    )


def _link(element: Element, reader: Reader) -> Link:
    counts: dict[str, int] = {}
    for command in element.all("command"):
        name = command.attributes["name"]
        if name not in _ROBOT_COMMANDS:
            reader.refuse(command, f"name: {unknown('command', name, sorted(_ROBOT_COMMANDS))}")
        count = reader.whole(command, "sends", 0, MAX_BYTES)
        count += reader.whole(command, "receives", 0, MAX_BYTES)
        counts[name] = count
    baud = reader.whole(element, "baud", 1, _MAX_BAUD, absent=1)
    network_s = reader.not_negative(element, "network", TIME, absent=_NETWORK_S)
    return Link(baud, tuple(sorted(counts.items())), network_s)
