"""Objects held by robots: in a gripper, or in the hand of an arm.

>>> holds = Holds.nothing(robots=2)
>>> holds.take(np.array([1]), GRIPPER, np.array([5]), np.array([[0.3, 0.0, 0.0]]))
>>> holds.in_grippers()
(array([1]), array([5]))
>>> holds.drop(np.array([1]), GRIPPER)
>>> holds.any()
False
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array, any_of

GRIPPER: Final = 0
HAND: Final = 1
_KINDS: Final = 2


@dataclass(slots=True)
class Holds:
    """The objects that robots hold; arrays have a column for the gripper and one for the hand.

    Attributes:
        object: number of the object among the movable ones, -1 for none, (robots, 2).
        grasp: its pose: x, y [m] and direction [rad], for a gripper in the frame of the mount, for
            a hand in the frame of the hand, (robots, 2, 3).
        grip: of the gripper that holds it: distance [m] of the fingers' centre ahead of the mount's
            centre, and the force [N] that pulls out an object that others hold too, (robots, 2).
    """

    object: Int64Array
    grasp: FloatArray
    grip: FloatArray

    @classmethod
    def nothing(cls, robots: int) -> Self:
        """Return empty grippers and hands."""
        return cls(
            np.full((robots, _KINDS), -1, np.int64),
            np.zeros((robots, _KINDS, 3)),
            np.zeros((robots, 2)),
        )

    def with_another(self) -> Self:
        """Return a copy with one more robot, which holds nothing."""
        more = self.nothing(1)
        return type(self)(
            np.concatenate([self.object, more.object]),
            np.concatenate([self.grasp, more.grasp]),
            np.concatenate([self.grip, more.grip]),
        )

    def copy(self) -> Self:
        """Return a deep copy."""
        return type(self)(self.object.copy(), self.grasp.copy(), self.grip.copy())

    def any(self) -> bool:
        """Return whether any object is held."""
        return any_of(self.object >= 0)

    def take(self, rows: IndexArray, kind: int, objects: IndexArray, grasp: FloatArray) -> None:
        """Put objects into the grippers or hands of robots."""
        self.object[rows, kind] = objects
        self.grasp[rows, kind] = grasp

    def drop(self, rows: IndexArray, kind: int) -> None:
        """Remove objects from the grippers or hands of robots."""
        self.object[rows, kind] = -1
        self.grasp[rows, kind] = 0.0

    def in_grippers(self) -> tuple[IndexArray, IndexArray]:
        """Return the robots that hold an object in their gripper, rising, and the objects."""
        return self._held(GRIPPER)

    def in_hands(self) -> tuple[IndexArray, IndexArray]:
        """Return the robots that hold an object in their hand, rising, and the objects."""
        return self._held(HAND)

    def renumbered(self, kept: BoolArray) -> Self:
        """Return the holds after some objects were removed.

        Args:
            kept: which of the movable objects are left, (objects,).
        """
        numbers = np.append(np.where(kept, np.cumsum(kept) - 1, -1), -1)
        return type(self)(numbers[self.object], self.grasp.copy(), self.grip.copy())

    def _held(self, kind: int) -> tuple[IndexArray, IndexArray]:
        rows = np.flatnonzero(self.object[:, kind] >= 0)
        return rows, self.object[rows, kind].astype(np.intp)
