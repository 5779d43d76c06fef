"""Writes the elements of sonars in a robot definition, which `element` reads."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from crs_cc.core.quantity import ANGLE, LENGTH, TIME
from crs_cc.core.source import Diagnostics
from crs_cc.sim.devices.sonar.element import beams
from crs_cc.sim.devices.sonar.model import (
    SONAR_TICK_S,
    Sonar,
    SonarBoard,
    SonarMode,
    Sonars,
    sonars_of,
)
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.attribute import FRACTION

if TYPE_CHECKING:
    from crs_cc.sim.model.robot import RobotModel

_STEPS: Final = 8
"""How many neighbouring numbers are tried for a half-angle that gives the same radius."""


def write(model: RobotModel) -> list[Element]:
    """Return the elements that describe the sonars of a robot, none without sonars.

    Raises:
        ValueError: the beams of a mode cannot be described.
    """
    found = sonars_of(model)
    if not found.sonars:
        return []
    board = found.board
    is_shortest = board.interval_s == board.least_interval_s
    attributes = {
        "order": " ".join(map(str, board.order)),
        "rate": "0" if is_shortest else str(round(board.interval_s / SONAR_TICK_S)),
        "least-interval": TIME.exact(board.least_interval_s),
        **_heard(board),
    }
    modes = [_mode(mode, found) for mode in found.own_modes]
    return [Element("sonars", 0, attributes, children=modes), *map(_sensor, found.sonars)]


def _heard(board: SonarBoard) -> dict[str, str]:
    return {
        "lobe": ANGLE.exact(board.lobe_rad),
        "critical-angle": ANGLE.exact(board.critical_rad),
        "blind": LENGTH.exact(board.blind_m),
        "minimum": LENGTH.exact(board.minimum_m),
        "noise": LENGTH.exact(board.noise_m),
        "noise-share": FRACTION.exact(board.noise_share),
        "dropouts": FRACTION.exact(board.dropouts),
        "crosstalk": FRACTION.exact(board.crosstalk),
        "resolution": LENGTH.exact(board.resolution_m),
    }


def _sensor(sonar: Sonar) -> Element:
    place = {
        "x-relative": LENGTH.exact(sonar.x_m),
        "y-relative": LENGTH.exact(sonar.y_m),
        "z-relative": LENGTH.exact(sonar.z_m),
        "range": LENGTH.exact(sonar.range_m),
        "radius": LENGTH.exact(sonar.radius_m),
        "dir-relative": ANGLE.exact(sonar.direction_rad),
    }
    position = [Element(name, 0, text=text) for name, text in place.items()]
    children = [
        Element("id", 0, text=str(sonar.id)),
        Element("type", 0, text="sonar"),
        Element("position", 0, children=position),
    ]
    return Element("sensor", 0, children=children)


def _mode(mode: SonarMode, of: Sonars) -> Element:
    """Return the element of a mode, with the range and the beam that are read as they are."""
    for beam in _beams(mode):
        element = Element("mode", 0, {"name": mode.name, **beam, **_heard(mode.board)})
        if beams(element, of.sonars, Reader("", Diagnostics())) == mode.sonars:
            return element
    raise ValueError(f"sonar mode {mode.name!r}: its beams have no common range and half-angle")


def _beams(mode: SonarMode) -> Iterator[dict[str, str]]:
    """Yield attributes that may describe the beams of a mode, the shortest first."""
    first = mode.sonars[0]
    for ranges in ({}, {"range": LENGTH.exact(first.range_m)}):
        yield ranges
        below_rad = above_rad = first.half_angle_rad
        for _ in range(_STEPS):
            yield {**ranges, "half-angle": ANGLE.exact(below_rad)}
            yield {**ranges, "half-angle": ANGLE.exact(above_rad)}
            below_rad, above_rad = math.nextafter(below_rad, 0), math.nextafter(above_rad, 2)
