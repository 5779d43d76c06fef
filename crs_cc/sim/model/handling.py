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


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint of an arm.

    Attributes:
        least_rad: how far it turns clockwise; 0 is straight on.
        most_rad: how far it turns counter-clockwise.
        speed_radps: how fast.
    """

    least_rad: float
    most_rad: float
    speed_radps: float

    def within(self, angle_rad: float) -> float:
        """Gives the angle that is nearest to one, of those to which it turns."""
        return min(max(angle_rad, self.least_rad), self.most_rad)


@dataclass(frozen=True, slots=True)
class Arm:
    """Two links in a plane above everything, and a hand at their end.

    Attributes:
        x_m: where the shoulder is.
        y_m: the same.
        upper_m: the length of the link between shoulder and elbow.
        fore_m: the length of the link between elbow and tip.
        shoulder: the joint between mount and upper link.
        elbow: the joint between both links.
        hand_m: how far from the tip the hand takes hold of things.
        most_kg: the heaviest thing that it lifts.
    """

    x_m: float
    y_m: float
    upper_m: float
    fore_m: float
    shoulder: Joint
    elbow: Joint
    hand_m: float
    most_kg: float
