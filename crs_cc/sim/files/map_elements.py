"""Walls from an image: `<map image="office.png" resolution="5cm"/>`.

Every dark pixel is a square of wall. Squares that fill a rectangle are merged into one box, so that
a straight wall is one object. The boxes of a map with the id `plan` are called `plan.0` and so on,
from the upper left.

>>> rectangles(np.array([[1, 1, 1, 1], [1, 0, 0, 1], [1, 0, 0, 0]], dtype=bool)).tolist()
[[0, 1, 0, 4], [1, 3, 0, 1], [1, 2, 3, 4]]
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, Int64Array
from crs_cc.core.quantity import ANGLE, LENGTH, RATIO
from crs_cc.sim.files.document import Element
from crs_cc.sim.files.image import picture
from crs_cc.sim.files.solid_elements import SolidElements
from crs_cc.sim.model.world import Area, Box, Pose

MAX_RECTANGLES: Final = 10_000
"""Maximum number of boxes of a map."""

_SHOWN: Final = 80


def map_boxes(
    element: Element, folder: Path | None, area: Area, solids: SolidElements
) -> tuple[Box, ...]:
    """Return the boxes of a `<map>`; empty after an error, which goes to the reader.

    Args:
        element: the element.
        folder: the folder of the world file; None if it was not read from a file.
        area: the world's area; the default of the image's lower left corner is its own.
        solids: reads the material.
    """
    reader = solids.reader
    pixel_m = solids.size(element, "resolution")
    threshold = reader.quantity(element, "threshold", RATIO)
    if not 0.0 < threshold <= 1.0:
        reader.refuse(element, "threshold: must be greater than 0 and at most 1")
    x_m = reader.quantity(element, "x", LENGTH, area.x_min_m)
    y_m = reader.quantity(element, "y", LENGTH, area.y_min_m)
    corner = Pose(x_m, y_m, reader.quantity(element, "heading", ANGLE))
    common = solids.common(element)
    rows, found = 0, np.zeros((0, 4), dtype=np.int64)
    try:
        dark = picture(folder, element.attributes["image"]) < threshold
        rows, found = len(dark), _few_rectangles(dark)
    except ValueError as wrong:
        reader.refuse(element, f"image {element.attributes['image'][:_SHOWN]!r}: {wrong}")
    else:
        if max(dark.shape) * pixel_m > LENGTH.limit:
            reader.refuse(element, "resolution: the map would be too large")
    if element.broken:
        return ()
    name = element.attributes["id"]
    return tuple(
        Box(
            f"{name}.{number}",
            Pose((left + right) / 2 * pixel_m, (rows - (top + end) / 2) * pixel_m).within(corner),
            (right - left) * pixel_m,
            (end - top) * pixel_m,
            **common,
        )
        for number, (top, end, left, right) in enumerate(found.tolist())
    )


def rectangles(dark: BoolArray) -> Int64Array:
    """Return rectangles that cover all dark pixels without overlap.

    Runs of dark pixels below each other with the same ends are merged into one rectangle. This is
    done for runs along rows and for runs along columns, and the smaller number of rectangles wins.

    Args:
        dark: which pixels are dark, (rows, columns).

    Returns:
        first row, row after the last, first column, column after the last; (n, 4), sorted.
    """
    by_rows, by_columns = _stacked_runs(dark), _stacked_runs(dark.T)[:, [2, 3, 0, 1]]
    fewer = by_rows if len(by_rows) <= len(by_columns) else by_columns
    return np.asarray(fewer[np.lexsort((fewer[:, 2], fewer[:, 0]))])


def _few_rectangles(dark: BoolArray) -> Int64Array:
    found = rectangles(dark)
    if len(found) > MAX_RECTANGLES:
        raise ValueError(
            f"the dark pixels form {len(found)} rectangles (maximum: {MAX_RECTANGLES}); "
            "use another threshold or an image with fewer and straighter walls"
        )
    return found


def _stacked_runs(dark: BoolArray) -> Int64Array:
    edges = np.zeros((dark.shape[0], dark.shape[1] + 2), dtype=np.int8)
    edges[:, 1:-1] = dark
    steps = np.diff(edges, axis=1)
    row, start = np.nonzero(steps == 1)
    end = np.nonzero(steps == -1)[1]
    order = np.lexsort((row, end, start))
    row, start, end = row[order], start[order], end[order]
    goes_on = np.zeros(len(row), dtype=np.bool_)
    goes_on[1:] = (start[1:] == start[:-1]) & (end[1:] == end[:-1]) & (row[1:] == row[:-1] + 1)
    first = np.flatnonzero(~goes_on)
    last = np.append(first[1:], len(row))[: len(first)] - 1
    return np.column_stack([row[first], row[last] + 1, start[first], end[first]])
