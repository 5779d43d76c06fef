"""Evaluation of a cycle's contacts: touched objects, and loads that are lost."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.physics.carrying import Load
from crs_cc.sim.state.bodies import NO_CONTACTS, Bodies, Contacts

SLOP_M: Final = 0.0005
"""Overlap that is not corrected, so that resting objects stay in contact."""

TORN_M: Final = 0.02
"""Penetration depth at which a load is torn from the fingers; our choice."""

STRETCH_M: Final = 0.05
"""Slip of a shared load at which a gripper loses it; our choice."""


def first_contacts(scene: Scene, found: list[tuple[IndexArray, FloatArray]]) -> Contacts:
    """Return the first contact point of each robot with each object.

    Args:
        scene: its names number the objects.
        found: for each substep the pairs in contact, and x, y, distance [m] of each.
    """
    pairs = np.concatenate([pairs for pairs, _ in found])
    if not len(pairs):
        return NO_CONTACTS
    places = np.concatenate([places for _, places in found])
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    places = np.concatenate([places, places])
    names = len(scene.names)
    keys, first = np.unique(pairs[:, 0] * names + pairs[:, 1], return_index=True)
    mine = first[keys // names < scene.robots]
    x_m, y_m = places[mine, 0], places[mine, 1]
    return Contacts(pairs[mine, 0], pairs[mine, 1], x_m, y_m, NO_CONTACTS.torn)


def separate_loads(
    load: Load, pairs: IndexArray, places: FloatArray, position_m: FloatArray
) -> tuple[IndexArray, IndexArray]:
    """Separate contacts of loads from those of their carriers.

    Args:
        load: the robots' loads.
        pairs: the bodies in contact, (k, 2).
        places: x, y, distance [m] of each contact, (k, 3).
        position_m: the positions of the bodies, (bodies, 2).

    Returns:
        the pairs, with loads in place of their carriers; and the carriers of loads that penetrate
        an object so deeply that they are torn out.
    """
    owned, rows = load.owned(pairs, places, position_m)
    rows = rows[places[rows, 2] < -TORN_M]
    deep = pairs[rows][pairs[rows] != owned[rows]]
    return owned, np.unique(deep)


def with_slipped(contacts: Contacts, load: Load, bodies: Bodies) -> Contacts:
    """Add the robots whose shared loads have slipped from their fingers."""
    slipped = load.sharers[load.slip_m(bodies) > STRETCH_M]
    return replace(contacts, torn=np.union1d(contacts.torn, slipped))


def is_settled(scene: Scene, pairs: IndexArray, places: FloatArray) -> bool:
    """Return whether no object presses on another; arguments as for `separate_loads`."""
    objects = ((pairs >= scene.robots) & (pairs < len(scene.start))).any(axis=1)
    return bool((places[objects, 2] >= -2 * SLOP_M).all())
