"""What robots handle things with: constant data, as the robot's definition file says.

Places are in the frame of the mount: the turret, or the base of a robot without one; x ahead, y to
the left. Units: metres, seconds, kilograms, newtons, radians.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Gripper:
    """Two fingers that close on what is between them.

    Attributes:
        place_m: how far ahead of the mount's middle the palm is.
        reach_m: how far the fingers reach from the palm.
        opening_m: the distance between the fingers when they are open.
        closing_s: how long they take to close altogether, or to open.
        most_kg: the heaviest thing that they hold.
        force_n: what pulls a thing out of them that another gripper holds too.
    """

    place_m: float
    reach_m: float
    opening_m: float
    closing_s: float
    most_kg: float
    force_n: float

    @property
    def middle_m(self) -> float:
        """How far ahead of the mount's middle the middle of the fingers is."""
        return self.place_m + self.reach_m / 2
