"""Renders a picture of `svg.Page` to pixels: the shapes and attributes that our plots use.

Everything is drawn twice as large and made smaller, so edges are smooth. Colours with an opacity
are mixed with white, which is what plots have below them.

>>> page = Page(40, 20, "a square")
>>> page.rectangle((10, 5), (10, 10), fill="#ff0000")
>>> image = blank(page)
>>> draw(page, image)
>>> image.size, image.getpixel((30, 20)), smaller(image).getpixel((2, 2))
((80, 40), (255, 0, 0), (255, 255, 255))
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Final

import numpy as np
from PIL import Image, ImageColor, ImageDraw, ImageFont

from crs_cc.plot.svg import Element, Page, Point

Style = Mapping[str, str]
Raster = Image.Image

_SCALE: Final = 2
_INHERITED: Final = {"fill": "black", "stroke": "none", "stroke-width": "1", "font-size": "12"}
_ANCHORS: Final = {"start": "ls", "middle": "ms", "end": "rs"}
_PAPER: Final = (255, 255, 255)
_COLOURS: Final = 255  # of a palette
_PLAIN: Final = 48
_APART: Final = 8


def blank(page: Page) -> Raster:
    """Return a white image for a page."""
    width, height = (math.ceil(float(page.root.get(side, "1"))) for side in ("width", "height"))
    return Image.new("RGB", (_SCALE * width, _SCALE * height), _PAPER)


def smaller(image: Raster) -> Raster:
    """Return a finished image in its proper size."""
    return image.reduce(_SCALE)


def draw(page: Page, image: Raster) -> None:
    """Draw a page on an image."""
    _draw_all(page.root, ImageDraw.Draw(image), _INHERITED)


def palette(image: Raster) -> Raster:
    """Return a palette: the most frequent colours of an image as they are, the others about.

    As Pillow looks for a colour's neighbours roughly, those that are nearly the same are left out.
    """
    pixels = np.asarray(image).reshape(-1, 3)
    found, counts = np.unique(pixels, axis=0, return_counts=True)
    plain = found[np.argsort(-counts, kind="stable")[:_PLAIN]]
    others = image.quantize(_COLOURS - _PLAIN, Image.Quantize.MEDIANCUT).getpalette() or []
    kept = np.zeros((0, 3), np.int64)
    for paint in np.concatenate([plain.astype(np.int64), np.reshape(others, (-1, 3))]):
        if (np.abs(kept - paint).max(axis=1, initial=0) >= _APART).all():
            kept = np.vstack([kept, paint])
    made = Image.new("P", (1, 1))
    made.putpalette(kept.ravel().tolist())
    return made


def flat(image: Raster, colours: Raster) -> Raster:
    """Return an image in the colours of a palette."""
    return image.quantize(palette=colours, dither=Image.Dither.NONE)


def save_film(path: Path, pictures: Sequence[Raster], durations_ms: Sequence[int]) -> None:
    """Write images as an animation, GIF or APNG by the file's name, that starts again at its end.

    Raises:
        OSError: it cannot be written.
    """
    first, *others = pictures
    form = "GIF" if path.suffix.lower() == ".gif" else "PNG"
    first.save(path, form, save_all=True, append_images=others, duration=list(durations_ms), loop=0)


def _draw_all(parent: Element, pen: ImageDraw.ImageDraw, inherited: Style) -> None:
    for element in parent:
        style = {**inherited, **element.attrib}
        tag = str(element.tag).rpartition("}")[2]
        if tag == "g":
            _draw_all(element, pen, style)
        elif tag in _SHAPES:
            _SHAPES[tag](element, pen, style)


def _line(element: Element, pen: ImageDraw.ImageDraw, style: Style) -> None:
    x1, y1, x2, y2 = (_pixels(element.get(name)) for name in ("x1", "y1", "x2", "y2"))
    _stroke(pen, [(x1, y1), (x2, y2)], style)


def _polyline(element: Element, pen: ImageDraw.ImageDraw, style: Style) -> None:
    _stroke(pen, _points(element), style)


def _polygon(element: Element, pen: ImageDraw.ImageDraw, style: Style) -> None:
    points = _points(element)
    fill = _colour(style, "fill")
    if fill is not None and len(points) > 1:
        pen.polygon(points, fill)
    _stroke(pen, [*points, points[0]], style)


def _rectangle(element: Element, pen: ImageDraw.ImageDraw, style: Style) -> None:
    x, y, width, height = (_pixels(element.get(name)) for name in ("x", "y", "width", "height"))
    corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
    fill = _colour(style, "fill")
    if fill is not None:
        pen.rectangle((x, y, x + width - 1, y + height - 1), fill)
    _stroke(pen, [*corners, corners[0]], style)


def _circle(element: Element, pen: ImageDraw.ImageDraw, style: Style) -> None:
    x, y, radius = (_pixels(element.get(name)) for name in ("cx", "cy", "r"))
    stroke, width = _colour(style, "stroke"), _width(style)
    if stroke is not None:
        radius += width / 2
    box = (x - radius, y - radius, x + radius, y + radius)
    pen.ellipse(box, _colour(style, "fill"), stroke, width if stroke is not None else 0)


def _text(element: Element, pen: ImageDraw.ImageDraw, style: Style) -> None:
    place = _pixels(element.get("x")), _pixels(element.get("y"))
    font = _font(round(_SCALE * float(style["font-size"])))
    bold = _SCALE / 2 if style.get("font-weight") == "bold" else 0
    anchor = _ANCHORS[style.get("text-anchor", "start")]
    fill = _colour(style, "fill")
    pen.text(place, element.text or "", fill, font, anchor, stroke_width=bold)


_SHAPES: Final = {
    "line": _line, "polyline": _polyline, "polygon": _polygon, "rect": _rectangle,
    "circle": _circle, "text": _text,
}  # fmt: skip


def _stroke(pen: ImageDraw.ImageDraw, points: list[Point], style: Style) -> None:
    paint = _colour(style, "stroke")
    if paint is None or not points:
        return
    width = _width(style)
    for part in _dashes(points, style.get("stroke-dasharray", "")):
        pen.line(part, paint, width, joint="curve")
        if style.get("stroke-linecap") == "round" and width > _SCALE:
            for x, y in (part[0], part[-1]):
                half = width / 2
                pen.ellipse((x - half, y - half, x + half, y + half), paint)


def _dashes(points: list[Point], pattern: str) -> Iterator[list[Point]]:
    """Yield the parts of a line that are drawn, by a pattern `dash gap`."""
    if not pattern:
        yield points
        return
    dash, gap = (_pixels(each) for each in pattern.split())
    at = 0.0
    for (x1, y1), (x2, y2) in itertools.pairwise(points):
        length = math.hypot(x2 - x1, y2 - y1)
        along = -(at % (dash + gap))
        while along < length:
            begin, end = max(0.0, along), min(length, along + dash)
            if end > begin:
                yield [
                    (x1 + (x2 - x1) * each / length, y1 + (y2 - y1) * each / length)
                    for each in (begin, end)
                ]
            along += dash + gap
        at += length


def _points(element: Element) -> list[Point]:
    pairs = (pair.partition(",") for pair in element.get("points", "").split())
    return [(_pixels(x), _pixels(y)) for x, _, y in pairs]


def _pixels(text: str | None) -> float:
    return _SCALE * float(text or "0")


def _width(style: Style) -> int:
    return max(1, round(_pixels(style["stroke-width"])))


def _colour(style: Style, kind: str) -> tuple[int, ...] | None:
    paint = style[kind]
    if paint == "none":
        return None
    share = float(style.get(f"{kind}-opacity", "1"))
    known = ImageColor.getrgb(paint)
    return tuple(round(a * share + b * (1 - share)) for a, b in zip(known, _PAPER, strict=False))


@functools.cache
def _font(size_px: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(size_px)
