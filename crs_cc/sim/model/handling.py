"""Manipulators: grippers and arms.

Positions are in the frame of the mount: the turret, or the base of a robot without one; x ahead,
y to the left. Units: metres, seconds, kilograms, newtons, radians.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Gripper:
    """A gripper with two fingers.

    Attributes:
        place_m: distance of the palm ahead of the mount's centre.
        reach_m: length of the fingers from the palm.
        opening_m: distance between the open fingers.
        closing_s: time to close completely, or to open.
        most_kg: mass of the heaviest object that it holds.
        force_n: force that pulls out an object that another gripper holds too.
    """

    place_m: float
    reach_m: float
    opening_m: float
    closing_s: float
    most_kg: float
    force_n: float

    @property
    def middle_m(self) -> float:
        """Distance of the fingers' centre ahead of the mount's centre."""
        return self.place_m + self.reach_m / 2


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint of an arm.

    Attributes:
        least_rad: clockwise limit, negative; 0 is straight on.
        most_rad: counter-clockwise limit.
        speed_radps: speed.
    """

    least_rad: float
    most_rad: float
    speed_radps: float

    def within(self, angle_rad: float) -> float:
        """Clamp an angle to the limits."""
        return min(max(angle_rad, self.least_rad), self.most_rad)


@dataclass(frozen=True, slots=True)
class Arm:
    """Two links in a plane above all objects, with a hand at the end.

    Attributes:
        x_m: the shoulder's position.
        y_m: the shoulder's position.
        upper_m: the length of the link between shoulder and elbow.
        fore_m: the length of the link between elbow and tip.
        shoulder: the joint between mount and upper link.
        elbow: the joint between both links.
        hand_m: maximum distance between the tip and an object that it grips.
        most_kg: mass of the heaviest object that it lifts.
    """

    x_m: float
    y_m: float
    upper_m: float
    fore_m: float
    shoulder: Joint
    elbow: Joint
    hand_m: float
    most_kg: float
