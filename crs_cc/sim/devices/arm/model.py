"""Constants of arms, and the reader of their element in robot definitions."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.core.quantity import ANGLE, LENGTH, MASS, TURN_RATE
from crs_cc.sim.files.device_elements import read_attributes
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.attribute import attribute


@dataclass(frozen=True, slots=True)
class Arm:
    """Two links in a plane above all objects, with a hand at the end.

    Positions are in the frame of the mount: the turret, or the base of a robot without one; x
    ahead, y to the left. Angles are counter-clockwise, 0 for straight on.

    Attributes:
        shoulder_most_rad: its counter-clockwise limit.
        shoulder_radps: its speed.
        elbow_most_rad: its counter-clockwise limit.
        elbow_radps: its speed.
    """

    x_m: float = attribute(
        "x", LENGTH, "0m", "Position of the shoulder, forward of the robot's centre.", signed=True
    )
    y_m: float = attribute(
        "y", LENGTH, "0m", "Position of the shoulder, left of the robot's centre.", signed=True
    )
    upper_m: float = attribute(
        "upper", LENGTH, "25cm", "Length of the link from shoulder to elbow.", positive=True
    )
    fore_m: float = attribute(
        "fore", LENGTH, "25cm", "Length of the link from elbow to tip.", positive=True
    )
    shoulder_least_rad: float = attribute(
        "shoulder-min",
        ANGLE,
        "-135deg",
        "Clockwise limit of the shoulder, measured from straight ahead.",
        signed=True,
    )
    shoulder_most_rad: float = attribute(
        "shoulder-max", ANGLE, "135deg", "Counter-clockwise limit of the shoulder.", signed=True
    )
    shoulder_radps: float = attribute(
        "shoulder-speed", TURN_RATE, "60deg/s", "Angular speed of the shoulder.", positive=True
    )
    elbow_least_rad: float = attribute(
        "elbow-min", ANGLE, "-135deg",
        "Clockwise limit of the elbow, measured from the direction of the upper link.",
        signed=True,
    )  # fmt: skip
    elbow_most_rad: float = attribute(
        "elbow-max", ANGLE, "135deg", "Counter-clockwise limit of the elbow.", signed=True
    )
    elbow_radps: float = attribute(
        "elbow-speed", TURN_RATE, "90deg/s", "Angular speed of the elbow.", positive=True
    )
    hand_m: float = attribute(
        "hand", LENGTH, "5cm", "Distance from the tip within which the hand can grasp objects.",
        positive=True,
    )  # fmt: skip
    most_kg: float = attribute(
        "max-mass", MASS, "1kg", "Maximum mass of an object that the hand can hold.", positive=True
    )


def read(root: Element, reader: Reader) -> Arm | None:
    """Return the arm of a robot definition, None without one; errors go to the reader."""
    element = root.find_child("arm")
    if element is None:
        return None
    arm: Arm = read_attributes(Arm, element, reader)
    for joint, least_rad, most_rad in (
        ("shoulder", arm.shoulder_least_rad, arm.shoulder_most_rad),
        ("elbow", arm.elbow_least_rad, arm.elbow_most_rad),
    ):
        if least_rad > most_rad:
            reader.refuse(element, f"{joint}-min: must not be greater than {joint}-max")
    return arm
