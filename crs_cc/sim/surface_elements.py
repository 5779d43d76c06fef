"""From the element `<surface>` of a world file to a `Surface`."""

from __future__ import annotations

from typing import Final

from crs_cc.sim.document import Element, Reader
from crs_cc.sim.quantity import ANGLE, LENGTH
from crs_cc.sim.surface import Patch, Surface

HIGHEST_M: Final = 100.0
_LEAST_M: Final = 0.01


def surface(element: Element, reader: Reader) -> Surface:
    """Gives the ground that an element describes; mistakes go to the reader."""
    return Surface(tuple(_patch(child, reader) for child in element.children))


def _patch(element: Element, reader: Reader) -> Patch:
    is_ramp = element.tag == "ramp"
    to_m = _height(element, "to" if is_ramp else "height", reader)
    return Patch(
        reader.quantity(element, "x", LENGTH),
        reader.quantity(element, "y", LENGTH),
        reader.quantity(element, "heading", ANGLE),
        _size(element, "length", reader),
        _size(element, "width", reader),
        _height(element, "from", reader) if is_ramp else to_m,
        to_m,
    )


def _height(element: Element, name: str, reader: Reader) -> float:
    value_m = reader.not_negative(element, name, LENGTH)
    if value_m > HIGHEST_M:
        reader.refuse(element, f"{name}: must be {HIGHEST_M:g}m or less")
    return value_m


def _size(element: Element, name: str, reader: Reader) -> float:
    value_m = reader.positive(element, name, LENGTH)
    if value_m < _LEAST_M:
        reader.refuse(element, f"{name}: must be 1cm or more")
        return _LEAST_M
    return value_m
