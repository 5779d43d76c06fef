"""The terrain in the plot of a run: the higher, the darker; arrows point up ramps."""

from __future__ import annotations

import math
from itertools import groupby

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.plot.svg import Page, View
from crs_cc.sim.geometry.terrain import Terrain
from crs_cc.sim.model.ground import Ground, HeightMap, Patch

PAPER = "#fbfaf7"
"""The background colour."""

_EARTH = "#a67c52"
_EDGE = "#8a6a48"
_STRIPES = 12
_LEVELS = 20
_SEAM_PX = 0.3  # overlap, so that rows leave no gap
_LIGHTEST, _DARKEST = 0.06, 0.5


def draw_terrain(page: Page, view: View, ground: Ground) -> None:
    """Draw the ramps and plateaus of the terrain, the lowest first."""
    patches = sorted(ground.patches, key=lambda patch: max(patch.from_m, patch.to_m))
    tops_m = [max(patch.from_m, patch.to_m) for patch in patches]
    tops_m += ground.heightmap.heights_m if ground.heightmap else ()
    highest_m = max(tops_m, default=0.0)
    if ground.heightmap is not None and highest_m:
        _draw_pixels(page, view, ground.heightmap, highest_m)
    for patch in patches:
        for stripe, height_m in _stripes(patch):
            share = height_m / highest_m if highest_m else 0.0
            paint = _mixed(_LIGHTEST + (_DARKEST - _LIGHTEST) * share)
            page.polygon(_points(view, stripe), fill=paint, stroke=paint, stroke_width=0.4)
        page.polygon(_points(view, _corners_m(patch)), fill="none", stroke=_EDGE, stroke_width=1.0)
        if patch.slope:
            _arrow(page, view, patch)
        else:
            place = view.point(patch.x_m, patch.y_m)
            text = f"{patch.to_m:.2f} m"
            page.text(place, text, fill=_EDGE, font_size=10.0, text_anchor="middle")


def terrain_corners_m(ground: Ground) -> list[FloatArray]:
    """Return the corners of all patches and of the height map [m], (n, 2) each."""
    found = [_corners_m(patch) for patch in ground.patches]
    if (heightmap := ground.heightmap) is not None:
        rows = len(heightmap.heights_m) // heightmap.columns
        size_m = np.array([heightmap.columns, rows]) * heightmap.pixel_m
        corner = np.array([heightmap.x_m, heightmap.y_m])
        found.append(np.array([corner, corner + size_m]))
    return found


def _draw_pixels(page: Page, view: View, heightmap: HeightMap, highest_m: float) -> None:
    """Draw each run of pixels of similar height in a row as one rectangle."""
    pixel_m, heights = heightmap.pixel_m, np.array(heightmap.heights_m)
    levels = np.ceil(heights.reshape(-1, heightmap.columns) / highest_m * _LEVELS).astype(np.int64)
    for row, level in enumerate(levels.tolist()):
        column = 0
        for shade, run in groupby(level):
            width = len(list(run))
            if shade:
                x_m, y_m = heightmap.x_m + column * pixel_m, heightmap.y_m + (row + 1) * pixel_m
                size = view.length(width * pixel_m), view.length(pixel_m) + _SEAM_PX
                paint = _mixed(_DARKEST * shade / _LEVELS)
                page.rectangle(view.point(x_m, y_m), size, fill=paint)
            column += width


def _stripes(patch: Patch) -> list[tuple[FloatArray, float]]:
    """Return the stripes of a patch across its heading, and the heights of their centres."""
    count = _STRIPES if patch.slope else 1
    length_m = patch.length_m / count
    stripes = []
    for number in range(count):
        ahead_m = (number + 0.5) * length_m - patch.length_m / 2
        x_m = patch.x_m + ahead_m * math.cos(patch.heading_rad)
        y_m = patch.y_m + ahead_m * math.sin(patch.heading_rad)
        height_m = (patch.from_m + patch.to_m) / 2 + patch.slope * ahead_m
        part = Patch(x_m, y_m, patch.heading_rad, length_m, patch.width_m, height_m, height_m)
        stripes.append((_corners_m(part), height_m))
    return stripes


def _arrow(page: Page, view: View, patch: Patch) -> None:
    """Draw an arrow up a ramp, labelled with its slope."""
    up_rad = patch.heading_rad if patch.slope > 0.0 else patch.heading_rad + math.pi
    half_m = 0.3 * patch.length_m
    along = np.array([math.cos(up_rad), math.sin(up_rad)]) * half_m
    middle = np.array([patch.x_m, patch.y_m])
    foot, tip = (view.point(*(middle + side * along).tolist()) for side in (-1, 1))
    head_px = min(9.0, view.length(half_m))
    sides = [
        (tip[0] - head_px * math.cos(up_rad + turn), tip[1] + head_px * math.sin(up_rad + turn))
        for turn in (-0.45, 0.45)
    ]
    with page.group(stroke=_EDGE, stroke_width=1.3, fill="none", stroke_linejoin="round"):
        page.line(foot, tip)
        page.polyline([sides[0], tip, sides[1]])
    place = (view.point(*middle.tolist())[0] + 5, view.point(*middle.tolist())[1] - 5)
    slope_deg = math.degrees(math.atan(abs(patch.slope)))
    page.text(place, f"{slope_deg:.1f}°", fill=_EDGE, font_size=10.0)


def _corners_m(patch: Patch) -> FloatArray:
    return np.asarray(Terrain(Ground((patch,))).corners_m()[0])


def _points(view: View, corners_m: FloatArray) -> list[tuple[float, float]]:
    return [view.point(*corner) for corner in corners_m.tolist()]


def _mixed(share: float) -> str:
    """Return a blend of the earth colour, by its share, and the background."""
    pairs = zip(*(_parts(colour) for colour in (PAPER, _EARTH)), strict=True)
    return "#" + "".join(f"{round(paper + (earth - paper) * share):02x}" for paper, earth in pairs)


def _parts(colour: str) -> list[int]:
    return [int(colour[place : place + 2], 16) for place in (1, 3, 5)]
