"""The colours that distinguish robots in pictures.

>>> colour(0), colour(7)
('#0072b2', '#2f2b8c')
"""

from __future__ import annotations

import colorsys
from typing import Final

_PALETTE: Final = (  # Okabe and Ito's colours for the colour-blind, 2008, without yellow and black
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
)  # fmt: skip


def colour(number: int) -> str:
    """Return a robot's colour as #rrggbb; after the palette, hues a golden angle apart."""
    if number < len(_PALETTE):
        return _PALETTE[number]
    hue = number * 0.381966 % 1.0  # the golden angle's share of a turn
    lightness = (0.46, 0.36, 0.56)[number % 3]
    rgb = colorsys.hls_to_rgb(hue, lightness, 0.53)
    return "#" + "".join(f"{round(part * 255):02x}" for part in rgb)
