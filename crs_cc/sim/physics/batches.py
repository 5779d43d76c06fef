"""Batched transfer of body states to and from a pymunk space.

The buffers are created once for a world: pymunk never frees the memory of a buffer.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from pymunk import batch

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.physics.rigid import Rigid
from crs_cc.sim.physics.space import Space
from crs_cc.sim.state.bodies import Bodies

_MOTION: Final = (
    batch.BodyFields.POSITION | batch.BodyFields.ANGLE
    | batch.BodyFields.VELOCITY | batch.BodyFields.ANGULAR_VELOCITY
)  # fmt: skip
_CONTACT: Final = (
    batch.ArbiterFields.BODY_A_ID | batch.ArbiterFields.BODY_B_ID
    | batch.ArbiterFields.CONTACT_COUNT
    | batch.ArbiterFields.POINT_A_1 | batch.ArbiterFields.DISTANCE_1
)  # fmt: skip
_NO_PAIRS: Final = (np.zeros((0, 2), dtype=np.intp), np.zeros((0, 3)))


class Batches:
    """Writes and reads the bodies of a sequence of spaces.

    Bodies are numbered as in `Bodies`; those that move in a space may be some of them.

    Attributes:
        force_n: the forces on the bodies in the next substep, (bodies, 2); see `push`.
    """

    def __init__(self, names: int) -> None:
        """Create the buffers.

        Args:
            names: number of objects: robots and the solids between which they move.
        """
        self._read, self._touch = batch.Buffer(), batch.Buffer()
        self._write_motion, self._write_force = batch.Buffer(), batch.Buffer()
        # Batches also write the static bodies, among them the floor; their rows stay 0.
        self._motion = np.zeros((names + 1, 6))
        self.force_n = np.zeros((names + 1, 2))
        self._forces_n = self.force_n.copy()
        self._filled = 0  # rows of these that may not be 0
        self._write_motion.set_float_buf(self._motion)
        self._write_force.set_float_buf(self._forces_n)

    def map_bodies(self, space: Space) -> None:
        """Find out in which order pymunk lists a space's bodies, and which ids it gave them."""
        ids = np.array([body.id for body in space.bodies], dtype=np.uintp)
        numbers = np.array(space.numbers, dtype=np.intp)
        self._read.clear()
        batch.get_space_bodies(space.inner, batch.BodyFields.BODY_ID, self._read)
        listed = np.frombuffer(self._read.int_buf(), dtype=np.uintp)
        by_id = np.argsort(ids)
        self._ids, self._by_id = ids[by_id], numbers[by_id]
        # The bodies that move come first; a removed one has left its place to the last of them.
        moving = by_id[np.searchsorted(self._ids, listed[: space.moving])]
        order = np.argsort(np.argsort(numbers[: space.moving]))[moving]
        is_rising = np.array_equal(order, np.arange(space.moving))
        self._order: IndexArray | slice = slice(None) if is_rising else order

    def write(self, space: Space, bodies: Bodies, rigid: Rigid) -> None:
        """Set the poses and velocities of the bodies that move in a space."""
        motion = np.empty((len(bodies.position_m), 6))
        motion[:, 0:2], motion[:, 2] = bodies.position_m, bodies.angle_rad
        motion[:, 3:5], motion[:, 5] = bodies.velocity_mps, bodies.spin_radps
        rigid.load(motion[len(bodies.slipping) :])
        self._motion[: len(motion)] = motion[self._order]
        most, self._filled = max(len(motion), self._filled), len(motion)
        self._motion[len(motion) : most] = 0.0
        self._forces_n[len(motion) : most] = self.force_n[:most] = 0.0
        batch.set_space_bodies(space.inner, _MOTION, self._write_motion)

    def push(self, space: Space) -> None:
        """Apply `force_n` to the bodies in the next substep."""
        self._forces_n[: space.moving] = self.force_n[: space.moving][self._order]
        batch.set_space_bodies(space.inner, batch.BodyFields.FORCE, self._write_force)

    def read(self, space: Space, bodies: Bodies, rigid: Rigid) -> None:
        """Read the poses and velocities of the bodies that move in a space."""
        motion = self._body_fields(space, _MOTION, 6)[: space.moving]
        bodies.position_m[:], bodies.angle_rad[:] = motion[:, 0:2], motion[:, 2]
        bodies.velocity_mps[:], bodies.spin_radps[:] = motion[:, 3:5], motion[:, 5]
        rigid.place(bodies)

    def velocity_mps(self, space: Space) -> FloatArray:
        """Return the velocities of the bodies, (bodies, 2)."""
        return self._body_fields(space, batch.BodyFields.VELOCITY, 2)

    def position_m(self, space: Space) -> FloatArray:
        """Return the positions of the bodies, (bodies, 2)."""
        return self._body_fields(space, batch.BodyFields.POSITION, 2)

    def touching(self, space: Space) -> tuple[IndexArray, FloatArray]:
        """Return the pairs of bodies in contact, and x, y, distance [m] of each."""
        self._touch.clear()
        batch.get_space_arbiters(space.inner, _CONTACT, self._touch)
        numbers = np.frombuffer(self._touch.int_buf(), dtype=np.uintp).reshape(-1, 3)
        touch = numbers[:, 2] > 0  # no points: a body above a patch that does not block it
        if not touch.any():
            return _NO_PAIRS
        pairs = self._by_id[np.searchsorted(self._ids, numbers[touch, :2])]
        places = np.frombuffer(self._touch.float_buf()).reshape(-1, 3)[touch]
        # pymunk orders the contacts of one body's shapes by their addresses in memory.
        order = np.lexsort((places[:, 1], places[:, 0], pairs[:, 1], pairs[:, 0]))
        return pairs[order], places[order]

    def _body_fields(self, space: Space, what: batch.BodyFields, columns: int) -> FloatArray:
        self._read.clear()
        batch.get_space_bodies(space.inner, what, self._read)
        listed = np.frombuffer(self._read.float_buf()).reshape(-1, columns)
        found = listed.copy()
        found[: space.moving][self._order] = listed[: space.moving]
        return found
