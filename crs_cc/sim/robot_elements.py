"""From the elements of a robot definition file to a `RobotModel`."""

from __future__ import annotations

from typing import Final

from crs_cc.requests import REQUESTS
from crs_cc.sim import sensor_elements
from crs_cc.sim.document import Element, Reader
from crs_cc.sim.quantity import ACCELERATION, ANGLE, FORCE, FREQUENCY, LENGTH, MASS, SPEED, TIME
from crs_cc.sim.robot_model import Drive, Heat, RobotModel, Sonar

MAX_SONARS: Final = 16
"""The vendor's `State` array has 16 places for sonars (vendor header `Nclient.h` 1.29)."""

_BITS_PER_BYTE: Final = 10  # one start bit, eight data bits, one stop bit
_MOST_BYTES: Final = 65_535
_MOST_BAUD: Final = 100_000_000
_ROBOT_COMMANDS: Final = frozenset(
    request.name for request in REQUESTS.values() if request.server == "robot"
)


def robot_model(root: Element, reader: Reader) -> RobotModel:
    """Gives the model that a robot definition describes; mistakes go to the reader."""
    body = root.first("body")
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
        link_s=_link(root.first("link"), reader),
        host_speed_hz=reader.positive(root.first("host"), "speed", FREQUENCY, 5e7),
    )


def _drive(element: Element, reader: Reader) -> Drive:
    return Drive(
        wheel_base_m=reader.positive(element, "wheel-base", LENGTH),
        speed_limit_mps=reader.positive(element, "speed-limit", SPEED),
        acceleration_limit_mps2=reader.positive(element, "acceleration-limit", ACCELERATION),
        speed_mps=reader.positive(element, "speed", SPEED),
        acceleration_mps2=reader.positive(element, "acceleration", ACCELERATION),
        timeout_s=reader.not_negative(element, "timeout", TIME),
        push_n=reader.positive(element, "push", FORCE),
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
