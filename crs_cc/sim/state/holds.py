"""What robots hold: in the fingers of a gripper, or in the hand of an arm.

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

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array

GRIPPER: Final = 0
HAND: Final = 1
_KINDS: Final = 2


@dataclass(slots=True)
class Holds:
    """Which things robots hold; arrays have a column for the gripper and one for the hand.

    Attributes:
        thing: number of the thing among those that can be pushed, -1 for nothing, (robots, 2).
        grasp: where it is held: x, y [m] and direction [rad], of what is in a gripper in the frame
            of the mount, of what is in a hand in the frame of the hand, (robots, 2, 3).
    """

    thing: Int64Array
    grasp: FloatArray

    @classmethod
    def nothing(cls, robots: int) -> Self:
        """Return empty fingers and hands."""
        return cls(np.full((robots, _KINDS), -1, np.int64), np.zeros((robots, _KINDS, 3)))

    def with_another(self) -> Self:
        """Return the same with a further robot, which holds nothing."""
        more = self.nothing(1)
        return type(self)(
            np.concatenate([self.thing, more.thing]), np.concatenate([self.grasp, more.grasp])
        )

    def copy(self) -> Self:
        """Return a copy that shares nothing."""
        return type(self)(self.thing.copy(), self.grasp.copy())

    def any(self) -> bool:
        """Return whether anything is held."""
        return bool((self.thing >= 0).any())

    def take(self, rows: IndexArray, kind: int, things: IndexArray, grasp: FloatArray) -> None:
        """Puts things into the fingers or hands of robots."""
        self.thing[rows, kind] = things
        self.grasp[rows, kind] = grasp

    def drop(self, rows: IndexArray, kind: int) -> None:
        """Takes them out again."""
        self.thing[rows, kind] = -1
        self.grasp[rows, kind] = 0.0

    def in_grippers(self) -> tuple[IndexArray, IndexArray]:
        """Return the robots that hold something in their fingers, rising, and what each holds."""
        return self._held(GRIPPER)

    def in_hands(self) -> tuple[IndexArray, IndexArray]:
        """Return the robots that hold something in their hands, rising, and what each holds."""
        return self._held(HAND)

    def renumbered(self, kept: BoolArray) -> Self:
        """Return what is held when only some of all things are left.

        Args:
            kept: which of the things that can be pushed are, (things,).
        """
        numbers = np.append(np.where(kept, np.cumsum(kept) - 1, -1), -1)
        return type(self)(numbers[self.thing], self.grasp.copy())

    def _held(self, kind: int) -> tuple[IndexArray, IndexArray]:
        rows = np.flatnonzero(self.thing[:, kind] >= 0)
        return rows, self.thing[rows, kind].astype(np.intp)
