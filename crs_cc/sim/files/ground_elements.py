"""The element `<surface>` of a world file."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.image import picture
from crs_cc.sim.model.ground import Ground, HeightMap, Patch
from crs_cc.sim.model.world import Area

MAX_HEIGHT_M: Final = 100.0
MAX_PIXELS: Final = 128
"""On each side of an image of heights."""

_MIN_PIXELS: Final = 2
_MIN_M: Final = 0.01
_SHOWN: Final = 80


def ground(element: Element, area: Area, folder: Path | None, reader: Reader) -> Ground:
    """Return the ground that an element describes; errors go to the reader.

    Args:
        element: the element.
        area: the world's area; the default of the image's lower left corner is its own.
        folder: the folder of images; None if the world was not read from a file.
        reader: reads the values.
    """
    patches = [_patch(each, reader) for each in element.children if each.tag != "heightmap"]
    maps = [_heightmap(child, area, folder, reader) for child in element.all("heightmap")]
    return Ground(tuple(patches), maps[0] if maps else None)


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


def _heightmap(
    element: Element, area: Area, folder: Path | None, reader: Reader
) -> HeightMap | None:
    pixel_m = _size(element, "resolution", reader)
    if "heights" in element.attributes:
        return _table(element, area, pixel_m, reader)
    height_m = _height(element, "height", reader)
    for name in ("image", "height"):
        if name not in element.attributes:
            reader.error(element, f"missing attribute {name!r} in <heightmap> (or give heights)")
            return None
    x_m = reader.quantity(element, "x", LENGTH, area.x_min_m)
    y_m = reader.quantity(element, "y", LENGTH, area.y_min_m)
    try:
        grey = _grey(element.attributes["image"], folder)
    except ValueError as wrong:
        reader.refuse(element, f"image {element.attributes['image'][:_SHOWN]!r}: {wrong}")
        return None
    if element.broken:
        return None
    heights_m = (grey[::-1] * height_m).ravel().tolist()
    return HeightMap(x_m, y_m, pixel_m, grey.shape[1], tuple(heights_m))


def _table(element: Element, area: Area, pixel_m: float, reader: Reader) -> HeightMap | None:
    """Return the ground whose heights are given as numbers."""
    columns = reader.whole(element, "columns", _MIN_PIXELS, MAX_PIXELS, _MIN_PIXELS)
    words = element.attributes["heights"].split()[: MAX_PIXELS * MAX_PIXELS + 1]
    rows, rest = divmod(len(words), columns)
    if rest or not _MIN_PIXELS <= rows <= MAX_PIXELS:
        form = f"{_MIN_PIXELS} to {MAX_PIXELS} rows of {columns}"
        reader.refuse(element, f"heights: {len(words)} numbers (expected {form})")
        return None
    x_m = reader.quantity(element, "x", LENGTH, area.x_min_m)
    y_m = reader.quantity(element, "y", LENGTH, area.y_min_m)
    try:
        heights_m = np.array([LENGTH.parse(word) for word in words]).reshape(rows, columns)
    except ValueError as wrong:
        reader.refuse(element, f"heights: {wrong}")
        return None
    if not 0.0 <= heights_m.min() <= heights_m.max() <= MAX_HEIGHT_M:
        reader.refuse(element, f"heights: must be 0 to {MAX_HEIGHT_M:g}m")
    return HeightMap(x_m, y_m, pixel_m, columns, tuple(heights_m[::-1].ravel().tolist()))


def _grey(image: str, folder: Path | None) -> FloatArray:
    grey = picture(folder, image)
    if min(grey.shape) < _MIN_PIXELS or max(grey.shape) > MAX_PIXELS:
        size = f"{grey.shape[1]} x {grey.shape[0]}"
        raise ValueError(f"must have {_MIN_PIXELS} to {MAX_PIXELS} pixels per side, not {size}")
    return grey


def _height(element: Element, name: str, reader: Reader) -> float:
    value_m = reader.not_negative(element, name, LENGTH)
    if value_m > MAX_HEIGHT_M:
        reader.refuse(element, f"{name}: must be {MAX_HEIGHT_M:g}m or less")
    return value_m


def _size(element: Element, name: str, reader: Reader) -> float:
    value_m = reader.positive(element, name, LENGTH)
    if value_m < _MIN_M:
        reader.refuse(element, f"{name}: must be 1cm or more")
        return _MIN_M
    return value_m
