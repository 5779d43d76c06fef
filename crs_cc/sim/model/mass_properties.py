"""Floor friction and moments of inertia of movable objects.

Friction resists sliding with the force mu m g (Coulomb), and turning with that force times the
mean distance of the contact area from the object's centre.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from crs_cc.sim.model.polygon import area_m2, second_moment_m4
from crs_cc.sim.model.world import Box, Cylinder, WorldObject

FLOOR_FRICTION: Final = 0.4
"""Friction coefficient of objects on the floor; our choice: cardboard on linoleum."""

GRAVITY_MPS2: Final = 9.80665
"""Standard gravity (3rd General Conference on Weights and Measures, 1901)."""


def friction_n(obj: WorldObject) -> float:
    """Return the friction force, below which an object does not slide."""
    return FLOOR_FRICTION * GRAVITY_MPS2 * obj.mass_kg


def floor_m2(obj: WorldObject) -> float:
    """Return the contact area of an object with the floor."""
    if isinstance(obj, Cylinder):
        return math.pi * (obj.radius_m * obj.radius_m)
    if isinstance(obj, Box):
        return obj.length_m * obj.width_m
    return area_m2(np.array(obj.corners_m))


def friction_nm(obj: WorldObject) -> float:
    """Return the friction torque, below which an object does not turn.

    The mean distance from the centre of a disc is two thirds of its radius; any other shape is
    approximated by a disc of the same area.
    """
    if isinstance(obj, Cylinder):
        return friction_n(obj) * 2 / 3 * obj.radius_m
    return friction_n(obj) * 2 / 3 * math.sqrt(floor_m2(obj) / math.pi)


def moment_kgm2(obj: WorldObject) -> float:
    """Return an object's moment of inertia about its centre: that of a disc or of a plate."""
    if isinstance(obj, Cylinder):
        return obj.mass_kg * (obj.radius_m * obj.radius_m) / 2
    if isinstance(obj, Box):
        square_m2 = obj.length_m * obj.length_m + obj.width_m * obj.width_m
        return obj.mass_kg * square_m2 / 12
    corners_m = np.array(obj.corners_m)
    return obj.mass_kg * second_moment_m4(corners_m) / area_m2(corners_m)
