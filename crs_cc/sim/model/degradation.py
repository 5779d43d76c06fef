"""Degradations of sensors and actuators, and the table of all devices that can be degraded.

A degradation names a robot, one of its devices, and one element of it or all. It describes how
the values that the device reports (or, for an actuator, receives) are distorted, its onset, its
duration, and the time for which the effect then fades. `degradation` has the formula. Values are
in the device's unit: metres, radians, seconds, volts.

>>> from crs_cc.sim.files.world_xml import empty_world
>>> scout = empty_world().robots[0].model
>>> validation_error(Degradation("robot0", "sonar", element=3, bias=0.5, onset_s=10.0), scout)
''
>>> validation_error(Degradation("robot0", "sonar", element=16, dead=True), scout)
'unknown element 16 of sonar (known: 0 to 15)'
>>> validation_error(Degradation("robot0", "compass", dead=True), scout)
'the robot has no compass'
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Final, Literal

from crs_cc.core.quantity import (
    LENGTH,
    RATIO,
    SPEED,
    Kind,
)
from crs_cc.core.suggest import unknown
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.model.degradable import Degradable, numbered
from crs_cc.sim.model.registry import devices
from crs_cc.sim.model.robot import RobotModel

MAX_DELAY_S: Final = 60.0
MAX_DURATION_S: Final = 1e7
"""Upper limits of times."""

HOLD: Final = "hold"
"""Stuck at the last reported value."""

MAX_MEMORY: Final = 2**23
"""Maximum number of values that all degradations of a world may store (64 MiB)."""

_DEEPEST: Final = 64  # values that a delay stores for one element
_LARGEST: Final = 4096  # and for all elements
_SHALLOWEST: Final = 8


@dataclass(frozen=True, slots=True)
class Degradation:
    """A fault of a device.

    Attributes:
        robot: the robot's id.
        device: the device's name in `degradables()`.
        element: the element's number; None for all.
        bias: offset that is added, in the device's unit.
        gain: factor.
        noise: standard deviation of additive noise.
        step: values are rounded to multiples of this; 0 for no rounding.
        stuck: the value that is always reported; `HOLD` for the last one before the onset; None for
            none.
        delay_s: age of the reported values.
        dropouts: probability that a value is missing.
        dead: whether all values are missing.
        onset_s: start, in simulated time.
        duration_s: time for which it has its full effect; None for ever.
        recovery_s: time for which the effect then fades.
        id: its name; empty if it was set through the environment.
    """

    robot: str
    device: str
    element: int | None = None
    bias: float = 0.0
    gain: float = 1.0
    noise: float = 0.0
    step: float = 0.0
    stuck: float | Literal["hold"] | None = None
    delay_s: float = 0.0
    dropouts: float = 0.0
    dead: bool = False
    onset_s: float = 0.0
    duration_s: float | None = None
    recovery_s: float = 0.0
    id: str = ""

    def faults(self, kind: Kind) -> str:
        """Describe the fault for values of a kind: `bias 5deg, delay 1s`."""
        words = [
            f"{name} {unit.show(value)}"
            for name, value, usual, unit in (
                ("gain", self.gain, 1.0, RATIO), ("bias", self.bias, 0.0, kind),
                ("noise", self.noise, 0.0, kind), ("step", self.step, 0.0, kind),
                ("dropouts", self.dropouts, 0.0, RATIO),
            )
            if value != usual
        ]  # fmt: skip
        if isinstance(self.stuck, float | int):
            words.append(f"stuck at {kind.show(self.stuck)}")
        elif self.stuck is not None:
            words.append("stuck")
        if self.delay_s:
            words.append(f"delay {self.delay_s:g}s")
        if self.dead:
            words.append("dead")
        return ", ".join(words)


def _axes(model: RobotModel) -> tuple[str, ...]:
    return model.drive.axis_names


_OTHERS: Final = {
    device.name: device
    for device in (
        Degradable(
            "odometry", "speed of an axis as counted by its encoder", SPEED, _axes, AXES,
            "the encoder does not count",
        ),
        Degradable(
            "drive", "speed at which a motor turns its axis", SPEED, _axes, AXES,
            "the axis stops",
            acts=True,
        ),
        Degradable(
            "wheels", "speed at which an axis moves the robot", SPEED, _axes, AXES,
            "the axis slips: it turns, but does not move the robot", acts=True,
        ),
    )
}  # fmt: skip
"""Devices that can be degraded, by name, except those of the registry."""


@cache
def degradables() -> Mapping[str, Degradable]:
    """Return every device that can be degraded, by name, in alphabetical order."""
    ours = {row.name: row for device in devices() for row in device.degradables}
    return dict(sorted({**_OTHERS, **ours}.items()))


def validation_error(degradation: Degradation, model: RobotModel) -> str:
    """Return an error message for a degradation of a robot; empty if it is valid."""
    texts = (degradation.robot, degradation.device, degradation.id)
    if not all(isinstance(text, str) for text in texts):
        return "robot, device and id must be strings"
    device = degradables().get(degradation.device)
    if device is None:
        return unknown("device", degradation.device, tuple(degradables()))
    names = device.elements(model)
    if not names:
        return f"the robot has no {device.name}"
    element = degradation.element
    if element is not None and not _names_one(element, names):
        return f"unknown element {element!r} of {device.name} (known: {shown(names)})"
    if wrong := next(out_of_range(degradation), ""):
        return wrong
    if not degradation.faults(RATIO):
        return "no fault given: set gain, bias, noise, step, stuck, delay, dropouts or dead"
    return _ambiguous(degradation, device, names)


def part(degradation: Degradation, model: RobotModel) -> str:
    """Return the degraded device and element, such as `drive left`."""
    names = degradables()[degradation.device].elements(model)
    which = "" if degradation.element is None else f" {names[degradation.element]}"
    return f"{degradation.device}{which}"


def described(degradation: Degradation, model: RobotModel) -> str:
    """Describe a degradation: the device, its element and the fault.

    >>> from crs_cc.sim.files.world_xml import empty_world
    >>> scout = empty_world().robots[0].model
    >>> described(Degradation("robot0", "drive", element=1, gain=0.5, delay_s=1.0), scout)
    'drive left, gain 0.5, delay 1s'
    >>> described(Degradation("robot0", "sonar", bias=0.3), scout)
    'sonar, bias 0.3m'
    """
    device, element = degradables()[degradation.device], degradation.element
    kind = device.kind_of(device.elements(model)[element or 0])
    return f"{part(degradation, model)}, {degradation.faults(kind)}"


def element_of(device: Degradable, model: RobotModel, text: str) -> int | None:
    """Return the number of the element with a name or number; None if there is none.

    >>> from crs_cc.sim.files.world_xml import empty_world
    >>> scout = empty_world().robots[0].model
    >>> [element_of(degradables()["drive"], scout, text) for text in ("left", "1", "2", "", "up")]
    [1, 1, None, None, None]
    """
    for number, name in enumerate(device.elements(model)):
        if name and text in {name, str(number)}:
            return number
    return None


def shown(names: tuple[str, ...]) -> str:
    """List the elements of a device: `0 to 15`, or `0 (right), 1 (left)`."""
    used = [number for number, name in enumerate(names) if name]
    whole = used == list(range(len(names))) and names == numbered(len(names))
    if whole and len(names) > 1:
        return f"0 to {len(names) - 1}"
    return ", ".join(
        n if n == str(number) else f"{number} ({n})" for number, n in enumerate(names) if n
    )


def _names_one(element: object, names: tuple[str, ...]) -> bool:
    return type(element) is int and 0 <= element < len(names) and bool(names[element])


def out_of_range(degradation: Degradation) -> Iterator[str]:
    """Yield errors in the values of a degradation, each with its field."""
    stuck, duration_s = degradation.stuck, degradation.duration_s
    fixed = 0.0 if stuck is None or stuck == HOLD else stuck
    limits = (
        ("bias", degradation.bias, -LENGTH.limit, LENGTH.limit),
        ("gain", degradation.gain, -RATIO.limit, RATIO.limit),
        ("noise", degradation.noise, 0.0, LENGTH.limit),
        ("step", degradation.step, 0.0, LENGTH.limit),
        (f"stuck must be {HOLD!r}, or it", fixed, -LENGTH.limit, LENGTH.limit),
        ("delay", degradation.delay_s, 0.0, MAX_DELAY_S),
        ("dropouts", degradation.dropouts, 0.0, 1.0),
        ("onset", degradation.onset_s, 0.0, MAX_DURATION_S),
        ("duration", 1.0 if duration_s is None else duration_s, 0.0, MAX_DURATION_S),
        ("recovery", degradation.recovery_s, 0.0, MAX_DURATION_S),
    )
    for name, value, least, most in limits:
        if not _is_between(value, least, most):
            yield f"{name} must be a number from {least:g} to {most:g}, not {value!r}"
    if type(degradation.dead) is not bool:
        yield f"dead must be True or False, not {degradation.dead!r}"


def _is_between(value: object, least: float, most: float) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and least <= value <= most  # type: ignore[operator]  # a number


def _ambiguous(degradation: Degradation, device: Degradable, names: tuple[str, ...]) -> str:
    """Reject a value for elements with different units, metres and radians."""
    several = len({device.kind_of(name) for name in names}) > 1
    values = (degradation.bias, degradation.noise, degradation.step)
    given = any(values) or isinstance(degradation.stuck, int | float)
    if degradation.element is None and several and given:
        return f"element is missing: those of {device.name} differ in unit (known: {shown(names)})"
    return ""


def delay_depth(width: int) -> int:
    """Return the number of values of each of `width` elements that a delay stores."""
    return min(max(_LARGEST // width, _SHALLOWEST), _DEEPEST)


def memory_size(degradation: Degradation) -> int:
    """Return the number of values that a degradation stores: held and delayed ones."""
    width = degradables()[degradation.device].width if degradation.element is None else 1
    return width * (3 + 2 * delay_depth(width)) if degradation.delay_s else width
