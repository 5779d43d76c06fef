"""Unit conversions of lengths and angles, which are in SI units and radians everywhere else.

The Nomadic interface counts in tenths of an inch and tenths of a degree (vendor header
`Nclient.h` 1.29); its sonar readings are whole inches.

>>> round(tenths_inch_to_m(100), 3)
0.254
>>> round(m_to_tenths_inch(0.254), 9)
100.0
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray  # numpy: the help of crs does without

Number = TypeVar("Number", float, "FloatArray")

INCH_M = 0.0254  # by definition, international yard and pound agreement of 1959
SOUND_MPS = 343.2  # in dry air at 20 degrees Celsius (CRC Handbook of Chemistry and Physics)


def inch_to_m(value_inch: Number) -> Number:
    """Convert inches to metres."""
    return value_inch * INCH_M


def m_to_inch(value_m: Number) -> Number:
    """Convert metres to inches."""
    return value_m / INCH_M


def tenths_inch_to_m(value: Number) -> Number:
    """Convert tenths of an inch (also per second, per second squared) to metres."""
    return value * (INCH_M / 10)


def m_to_tenths_inch(value_m: Number) -> Number:
    """Convert metres (also per second, per second squared) to tenths of an inch."""
    return value_m / (INCH_M / 10)


def tenths_deg_to_rad(value: Number) -> Number:
    """Convert tenths of a degree to radians."""
    return value * (math.pi / 1800)


def rad_to_tenths_deg(value_rad: Number) -> Number:
    """Convert radians to tenths of a degree."""
    return value_rad / (math.pi / 1800)
