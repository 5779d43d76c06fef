"""Raising the ground with a brush: a height map is created, or changed number by number."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import Final

import numpy as np

from crs_cc.builder import changes, markup
from crs_cc.builder.changes import Plan
from crs_cc.builder.document import Document, Splice
from crs_cc.builder.spans import Node
from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.core.quantity import LENGTH
from crs_cc.sim.files.ground_elements import MAX_HEIGHT_M
from crs_cc.sim.model.ground import HeightMap
from crs_cc.sim.model.world import WorldModel

MAX_POINTS: Final = 2000
"""Points of one stroke."""

_NEW_CELLS: Final = 64
"""Pixels along the longer side of a new map, at most."""

_DIGITS: Final = 3
"""Heights are written in millimetres."""


_NUMBER: Final = re.compile(r"(?:&#\w+;|\s)*([^\s&]+)")
"""A number after white space, which may be written as character references."""


def stroke(text: str) -> list[tuple[float, float]]:
    """Return the points of a stroke [m].

    >>> stroke("1m,50cm 2,3")
    [(1.0, 0.5), (2.0, 3.0)]

    Raises:
        ValueError: it has none, too many, or one is not a point.
    """
    words = text.split()
    if not 1 <= len(words) <= MAX_POINTS:
        raise ValueError(f"a stroke has 1 to {MAX_POINTS} points, not {len(words)}")
    points = []
    for word in words:
        x, comma, y = word.partition(",")
        if not comma:
            raise ValueError(f"{word[:40]!r} is not a point (expected x,y)")
        points.append((LENGTH.parse(x), LENGTH.parse(y)))
    return points


def raised(
    document: Document,
    world: WorldModel,
    path: Sequence[tuple[float, float]],
    radius_m: float,
    rise_m: float,
) -> Plan:
    """Raise the ground along a path, in its middle by `rise_m`, and less towards the brush's rim.

    Each pixel is raised once, as far as the brush came nearest to it. Numbers of the file that stay
    are not rewritten; a map that came from a picture gets numbers.

    Args:
        document: the document.
        world: what it describes.
        path: the points that the brush passes [m].
        radius_m: what the brush reaches.
        rise_m: the rise; negative to lower the ground.

    Raises:
        ValueError: the brush has no size, or the document has no ground.
    """
    if not radius_m > 0:
        raise ValueError("the radius of a brush must be more than 0")
    node = next((each for each in document.root.all() if each.tag == "heightmap"), None)
    chart = _flat(world) if node is None else world.surface.heightmap
    if chart is None:
        raise ValueError("the map of heights is invalid")
    before = np.array(chart.heights_m).reshape(-1, chart.columns)
    share = _share(chart, before.shape, path, radius_m)
    after = np.clip(before + rise_m * share, 0.0, MAX_HEIGHT_M)
    is_new = share > 0.0
    if node is not None and "heights" in node.attributes:
        return Plan(_replaced(document, node, after[::-1], is_new[::-1]), ["surface/heightmap"])
    values = {"columns": str(chart.columns), "heights": " ".join(map(_word, after[::-1].flat))}
    if node is None:
        size = {name: f"{value:.9g}m" for name, value in
                (("resolution", chart.pixel_m), ("x", chart.x_m), ("y", chart.y_m))}  # fmt: skip
        return changes.add(document, document.root, "heightmap", {**size, **values})
    gone = {"image": None, "height": None}
    return Plan(markup.set_attributes(document, node, {**values, **gone}), ["surface/heightmap"])


def _share(
    chart: HeightMap,
    shape: tuple[int, ...],
    path: Sequence[tuple[float, float]],
    radius_m: float,
) -> FloatArray:
    """Return the share of the rise that each pixel gets: 1 under the middle of the brush."""
    x_m = chart.x_m + (np.arange(shape[1]) + 0.5) * chart.pixel_m
    y_m = (chart.y_m + (np.arange(shape[0]) + 0.5) * chart.pixel_m)[:, None]
    found = np.zeros(shape)
    for to_x, to_y in path:
        square = (x_m - to_x) ** 2 + (y_m - to_y) ** 2
        np.maximum(found, 1.0 - square / radius_m**2, out=found)
    return found


def _flat(world: WorldModel) -> HeightMap:
    """Return a map without heights on all of the area."""
    area = world.area
    pixel_m = _round_step(max(area.length_m, area.width_m) / _NEW_CELLS)
    columns, rows = (
        max(2, math.ceil(side_m / pixel_m - 1e-9)) for side_m in (area.length_m, area.width_m)
    )
    return HeightMap(area.x_min_m, area.y_min_m, pixel_m, columns, (0.0,) * (columns * rows))


def _round_step(least: float) -> float:
    """Return the least of 1, 2, 5 times a power of ten that is as large.

    >>> _round_step(0.125)
    0.2
    """
    power = 10.0 ** math.floor(math.log10(least))
    return next(each * power for each in (1, 2, 5, 10) if each * power >= least * 0.999)


def _word(height_m: float) -> str:
    return f"{height_m:.{_DIGITS}f}".rstrip("0").rstrip(".") or "0"


def _replaced(
    document: Document, node: Node, heights_m: FloatArray, is_new: BoolArray
) -> list[Splice]:
    """Return the splice of the heights, in which only the numbers that change are other ones."""
    span = node.value_at["heights"]
    text = document.text[span.begin : span.end].decode(document.codec)
    words = [(found.start(1), found.end(1)) for found in _NUMBER.finditer(text)]
    if len(words) != heights_m.size:  # numbers whose digits are character references
        joined = " ".join(map(_word, heights_m.flat))
        return markup.set_attributes(document, node, {"heights": joined})
    parts, place = [], 0
    for (begin, end), height_m, changes_it in zip(words, heights_m.flat, is_new.flat, strict=True):
        if changes_it:
            parts += [text[place:begin], _word(height_m)]
            place = end
    return [Splice(span.begin, span.end, "".join([*parts, text[place:]]).encode(document.codec))]
