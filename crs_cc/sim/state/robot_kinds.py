"""What kernels know of the robots of a world besides their state."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.core.arrays import FloatArray, IndexArray


@dataclass(frozen=True, slots=True, eq=False)
class RobotKinds:
    """The kinds of robots, by which their constants are the same.

    Attributes:
        table: the constants of each kind, see `kernels/robot.h`, (kinds, `KIND_SIZE`).
        kind: the kind of each robot, (robots,).
        battery: the number of its motor battery among all, -1 for none, (robots,).
    """

    table: FloatArray
    kind: IndexArray
    battery: IndexArray
