"""The friction of the floor under things that can be pushed.

A thing rubs with the force mu m g (Coulomb), and against turning with that force times the mean
distance of the floor under it from its middle.
"""

from __future__ import annotations

import math
from typing import Final

from crs_cc.sim.model import Box, Cylinder

FLOOR_FRICTION: Final = 0.4
"""Friction of things on the floor; chosen by us, about that of cardboard on linoleum."""

GRAVITY_MPS2: Final = 9.80665
"""Standard gravity (3rd General Conference on Weights and Measures, 1901)."""


def friction_n(thing: Box | Cylinder) -> float:
    """Gives the force below which a thing does not move."""
    return FLOOR_FRICTION * GRAVITY_MPS2 * thing.mass_kg


def friction_nm(thing: Box | Cylinder) -> float:
    """Gives the torque below which a thing does not turn.

    The mean distance from the middle of a disc is two thirds of its radius; a box is taken for a
    disc of the same area.
    """
    if isinstance(thing, Cylinder):
        return friction_n(thing) * 2 / 3 * thing.radius_m
    return friction_n(thing) * 2 / 3 * math.sqrt(thing.length_m * thing.width_m / math.pi)


def moment_kgm2(thing: Box | Cylinder) -> float:
    """Gives a thing's moment of inertia about its middle: that of a disc or of a plate."""
    if isinstance(thing, Cylinder):
        return thing.mass_kg * thing.radius_m**2 / 2
    return thing.mass_kg * (thing.length_m**2 + thing.width_m**2) / 12
