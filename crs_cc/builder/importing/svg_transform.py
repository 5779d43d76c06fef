"""Transformations of SVG (SVG 1.1, 7.6) as 2 by 3 matrices.

>>> apply(matrix("translate(1,2) scale(2)"), (3.0, 4.0))
(7.0, 10.0)
"""

from __future__ import annotations

import math
import re
from typing import Final, TypeAlias

from crs_cc.builder.importing.drawn import Point

Matrix: TypeAlias = tuple[float, float, float, float, float, float]

IDENTITY: Final[Matrix] = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
_MAX_TEXT: Final = 2000
_CALL: Final = re.compile(r"[\s,]*(\w+)\s*\(([^()]*)\)")


def matrix(text: str) -> Matrix:
    """Return the matrix of an attribute `transform`.

    Raises:
        ValueError: it is not a transformation.
    """
    found, place = IDENTITY, 0
    text = text.strip()
    if len(text) > _MAX_TEXT:
        raise ValueError("the transformation is too long")
    while place < len(text):
        call = _CALL.match(text, place)
        if call is None:
            raise ValueError(f"{text[:40]!r} is not a transformation")
        numbers = [float(word) for word in call[2].replace(",", " ").split()]
        found = compose(found, _one(call[1], numbers))
        place = call.end()
    return found


def _one(name: str, numbers: list[float]) -> Matrix:
    match name, numbers:
        case "matrix", [a, b, c, d, e, f]:
            return a, b, c, d, e, f
        case "translate", [x, *rest]:
            return 1.0, 0.0, 0.0, 1.0, x, rest[0] if rest else 0.0
        case "scale", [x, *rest]:
            return x, 0.0, 0.0, rest[0] if rest else x, 0.0, 0.0
        case "rotate", [angle]:
            return _turn(angle)
        case "rotate", [angle, x, y]:
            there, back = (1.0, 0.0, 0.0, 1.0, x, y), (1.0, 0.0, 0.0, 1.0, -x, -y)
            return compose(compose(there, _turn(angle)), back)
    raise ValueError(f"{name[:20]!r} is not a supported transformation")


def _turn(angle_deg: float) -> Matrix:
    cos, sin = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
    return cos, sin, -sin, cos, 0.0, 0.0


def compose(left: Matrix, right: Matrix) -> Matrix:
    """Return the composition of two transformations; the right one is applied first."""
    a, b, c, d, e, f = left
    g, h, i, j, k, m = right
    return (
        a * g + c * h, b * g + d * h, a * i + c * j, b * i + d * j,
        a * k + c * m + e, b * k + d * m + f,
    )  # fmt: skip


def apply(by: Matrix, point: Point) -> Point:
    """Return where a point goes."""
    a, b, c, d, e, f = by
    return a * point[0] + c * point[1] + e, b * point[0] + d * point[1] + f
