"""Colours by name or as #rrggbb.

>>> rgb("red"), rgb("#80ff00"), rgb("Orange")
((255, 0, 0), (128, 255, 0), (255, 165, 0))
>>> rgb("reddish")
Traceback (most recent call last):
ValueError: unknown colour 'reddish' (use #rrggbb or one of aqua, black, blue, brown, fuchsia, \
gray, green, grey, lime, maroon, navy, olive, orange, pink, purple, red, silver, teal, white, \
yellow)
"""

from __future__ import annotations

import re
from typing import Final

Colour = tuple[int, int, int]
"""Red, green and blue, 0 to 255."""

NAMED: Final = {
    "aqua": 0x00FFFF, "black": 0x000000, "blue": 0x0000FF, "brown": 0xA52A2A,
    "fuchsia": 0xFF00FF, "gray": 0x808080, "green": 0x008000, "grey": 0x808080,
    "lime": 0x00FF00, "maroon": 0x800000, "navy": 0x000080, "olive": 0x808000,
    "orange": 0xFFA500, "pink": 0xFFC0CB, "purple": 0x800080, "red": 0xFF0000,
    "silver": 0xC0C0C0, "teal": 0x008080, "white": 0xFFFFFF, "yellow": 0xFFFF00,
}  # fmt: skip
"""The 16 names of HTML 4.01 (section 6.5) and four common ones of CSS, as 0xrrggbb."""

_NUMBER: Final = re.compile(r"#[0-9A-Fa-f]{6}")
_MAX_TEXT: Final = 40


def rgb(text: str) -> Colour:
    """Parse a colour; raise ValueError if the text is neither #rrggbb nor a known name."""
    name = text.strip()
    number = int(name[1:], 16) if _NUMBER.fullmatch(name) else NAMED.get(name.lower())
    if number is None:
        raise ValueError(
            f"unknown colour {name[:_MAX_TEXT]!r} (use #rrggbb or one of {', '.join(NAMED)})"
        )
    return number >> 16, number >> 8 & 0xFF, number & 0xFF


def hexadecimal(colour: Colour) -> str:
    """Format a colour as #rrggbb.

    >>> hexadecimal((255, 165, 0))
    '#ffa500'
    """
    return "#{:02x}{:02x}{:02x}".format(*colour)
