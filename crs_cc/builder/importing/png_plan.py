"""Walls from a picture: dark pixels, merged into boxes by the reader of `<map>`."""

from __future__ import annotations

from crs_cc.builder.importing.drawn import MAX_ELEMENTS, PlanElements
from crs_cc.sim.files.image import grey_values
from crs_cc.sim.files.map_elements import rectangles


def read_png(data: bytes, scale_m: float | None, threshold: float = 0.5) -> PlanElements:
    """Return the walls that a picture shows.

    Args:
        data: the PNG file.
        scale_m: the size of a pixel.
        threshold: pixels darker than this share of white are wall.

    Raises:
        ValueError: it is not such a file, is too large, or has no scale.
    """
    if scale_m is None:
        raise ValueError("a picture has no physical size: give the scale, the size of a pixel")
    elements = PlanElements()
    rows, columns = grey_values(data).shape
    width_m, height_m = columns * scale_m, rows * scale_m
    for left, bottom, right, top in dark_boxes(data, threshold):
        centre = (left + right) / 2 * width_m, (bottom + top) / 2 * height_m
        elements.box(centre, ((right - left) * width_m, (top - bottom) * height_m))
    return elements


def dark_boxes(data: bytes, threshold: float) -> list[tuple[float, float, float, float]]:
    """Return left, bottom, right and top of the boxes that a picture shows, as shares of it.

    Raises:
        ValueError: it is not a PNG file, or shows too many.
    """
    dark = grey_values(data) < threshold
    found = rectangles(dark)
    if len(found) > MAX_ELEMENTS:
        raise ValueError(f"it shows {len(found)} boxes (maximum: {MAX_ELEMENTS})")
    rows, columns = dark.shape
    return [
        (left / columns, 1 - end / rows, right / columns, 1 - top / rows)
        for top, end, left, right in found.tolist()
    ]
