"""Floor friction and moments of inertia of movable objects.

Friction resists sliding with the force mu m g (Coulomb), and turning with that force times the
mean distance of the contact area from the object's centre.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from crs_cc.sim.model.polygon import area_m2, second_moment_m4
from crs_cc.sim.model.world import Box, Cylinder, Thing

FLOOR_FRICTION: Final = 0.4
"""Friction coefficient of objects on the floor; our choice: cardboard on linoleum."""

GRAVITY_MPS2: Final = 9.80665
"""Standard gravity (3rd General Conference on Weights and Measures, 1901)."""


def friction_n(thing: Thing) -> float:
    """Return the friction force, below which an object does not slide."""
    return FLOOR_FRICTION * GRAVITY_MPS2 * thing.mass_kg


def floor_m2(thing: Thing) -> float:
    """Return the contact area of an object with the floor."""
    if isinstance(thing, Cylinder):
        return math.pi * (thing.radius_m * thing.radius_m)
    if isinstance(thing, Box):
        return thing.length_m * thing.width_m
    return area_m2(np.array(thing.corners_m))


def friction_nm(thing: Thing) -> float:
    """Return the friction torque, below which an object does not turn.

    The mean distance from the centre of a disc is two thirds of its radius; any other shape is
    approximated by a disc of the same area.
    """
    if isinstance(thing, Cylinder):
        return friction_n(thing) * 2 / 3 * thing.radius_m
    return friction_n(thing) * 2 / 3 * math.sqrt(floor_m2(thing) / math.pi)


def moment_kgm2(thing: Thing) -> float:
    """Return an object's moment of inertia about its centre: that of a disc or of a plate."""
    if isinstance(thing, Cylinder):
        return thing.mass_kg * (thing.radius_m * thing.radius_m) / 2
    if isinstance(thing, Box):
        square_m2 = thing.length_m * thing.length_m + thing.width_m * thing.width_m
        return thing.mass_kg * square_m2 / 12
    corners_m = np.array(thing.corners_m)
    return thing.mass_kg * second_moment_m4(corners_m) / area_m2(corners_m)
