"""From the elements of a robot definition file to a `RobotModel`."""

from __future__ import annotations

from typing import Final

from crs_cc.requests import REQUESTS
from crs_cc.sim import sensor_elements
from crs_cc.sim.document import Element, Reader
from crs_cc.sim.quantity import (
    ACCELERATION,
    ANGLE,
    FORCE,
    FREQUENCY,
    LENGTH,
    MASS,
    SPEED,
    TIME,
    TURN_ACCELERATION,
    TURN_RATE,
    Kind,
)
from crs_cc.sim.robot_model import Axis, Drive, Heat, RobotModel, Sonar

MAX_SONARS: Final = 16
"""The vendor's `State` array has 16 places for sonars (vendor header `Nclient.h` 1.29)."""

VENDOR_MODELS: Final = ("nomad200", "nomad150", "scout")
"""The vendor's models by their numbers (vendor header `Nclient.h` 1.29: MODEL_N200, ...)."""

_BITS_PER_BYTE: Final = 10  # one start bit, eight data bits, one stop bit
_MOST_BYTES: Final = 65_535
_MOST_BAUD: Final = 100_000_000
_ROBOT_COMMANDS: Final = frozenset(
    request.name for request in REQUESTS.values() if request.server == "robot"
)


def robot_model(root: Element, reader: Reader) -> RobotModel:
    """Gives the model that a robot definition describes; mistakes go to the reader."""
    body = root.first("body")
    vendor = root.attributes.get("model", "scout")
    sonars = _sonars(root, reader)
    return RobotModel(
        root.attributes["name"],
        radius_m=reader.positive(body, "radius", LENGTH),
        drive=_drive(root.first("drive"), reader),
        mass_kg=reader.positive(body, "mass", MASS),
        sonars=sonars,
        sonar_order=_sonar_order(root.first("sonars"), sonars, reader),
        sonar_noise_m=reader.not_negative(root.first("sonars"), "noise", LENGTH),
        heat=_heat(root.first("heat"), reader),
        bumpers=sensor_elements.bumpers(root, reader),
        computer_battery=sensor_elements.computer_battery(root, reader),
        motor_battery=sensor_elements.motor_battery(root, reader),
        board=sensor_elements.sensor_board(root, reader),
        link_s=_link(root.first("link"), reader),
        host_speed_hz=reader.positive(root.first("host"), "speed", FREQUENCY, 5e7),
        vendor_model=VENDOR_MODELS.index(vendor),
    )


def _drive(element: Element, reader: Reader) -> Drive:
    synchro = element.attributes.get("type") == "synchro"
    if synchro != any(element.all("steering")):
        reader.error(element, "a synchro drive, and no other, has <steering>")
    if not synchro and any(element.all("turret")):
        reader.error(element, "a differential drive has no <turret>")
    if not synchro and "wheel-base" not in element.attributes:
        reader.error(element, "a differential drive has the attribute 'wheel-base'")
    return Drive(
        wheel_base_m=0.0 if synchro else reader.positive(element, "wheel-base", LENGTH),
        wheels=_axis(element, reader, SPEED, ACCELERATION),
        steering=_turning(element, "steering", reader),
        turret=_turning(element, "turret", reader),
        timeout_s=reader.not_negative(element, "timeout", TIME),
        push_n=reader.positive(element, "push", FORCE),
    )


def _turning(drive: Element, name: str, reader: Reader) -> Axis | None:
    for element in drive.all(name):
        return _axis(element, reader, TURN_RATE, TURN_ACCELERATION)
    return None


def _axis(element: Element, reader: Reader, speed: Kind, acceleration: Kind) -> Axis:
    return Axis(
        speed_limit=reader.positive(element, "speed-limit", speed),
        acceleration_limit=reader.positive(element, "acceleration-limit", acceleration),
        speed=reader.positive(element, "speed", speed),
        acceleration=reader.positive(element, "acceleration", acceleration),
    )


def _sonars(root: Element, reader: Reader) -> tuple[Sonar, ...]:
    sonars: dict[int, Sonar] = {}
    for element in root.all("sensor"):
        sonar = _sonar(element, reader)
        if sonar.id in sonars:
            reader.error(element, f"a second sensor with the id {sonar.id}")
        sonars[sonar.id] = sonar
    return tuple(sonars[number] for number in sorted(sonars))


def _sonar(element: Element, reader: Reader) -> Sonar:
    place = element.first("position")
    return Sonar(
        id=reader.whole(element, "id", 0, MAX_SONARS - 1),
        x_m=reader.quantity(place, "x-relative", LENGTH),
        y_m=reader.quantity(place, "y-relative", LENGTH),
        direction_rad=reader.quantity(place, "dir-relative", ANGLE, unit="rad"),
        range_m=reader.positive(place, "range", LENGTH),
        radius_m=reader.not_negative(place, "radius", LENGTH),
        z_m=reader.quantity(place, "z-relative", LENGTH),
    )


def _sonar_order(element: Element, sonars: tuple[Sonar, ...], reader: Reader) -> tuple[int, ...]:
    order = tuple(int(number) for number in element.attributes.get("order", "").split())
    known = {sonar.id for sonar in sonars}
    for number in order:
        if number not in known:
            reader.error(element, f"order names sonar {number}, which the robot does not have")
    return order


def _heat(element: Element, reader: Reader) -> Heat:
    range_m = reader.not_negative(element, "range", LENGTH)
    return Heat(range_m, reader.not_negative(element, "tag-range", LENGTH, range_m))


def _link(element: Element, reader: Reader) -> tuple[tuple[str, float], ...]:
    baud = reader.whole(element, "baud", 1, _MOST_BAUD, absent=1)
    times: dict[str, float] = {}
    for command in element.all("command"):
        name = command.attributes["name"]
        if name not in _ROBOT_COMMANDS:
            reader.error(command, f"{name!r} is no command of a robot")
        count = reader.whole(command, "sends", 0, _MOST_BYTES)
        count += reader.whole(command, "receives", 0, _MOST_BYTES)
        times[name] = count * _BITS_PER_BYTE / baud
    return tuple(sorted(times.items()))
