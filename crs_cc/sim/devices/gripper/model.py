"""Constants of grippers, and the reader of their element in robot definitions."""

from __future__ import annotations

from dataclasses import dataclass, replace

from crs_cc.core.quantity import FORCE, LENGTH, MASS, TIME
from crs_cc.sim.files.device_elements import read_attributes
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.attribute import attribute


@dataclass(frozen=True, slots=True)
class Gripper:
    """A gripper with two fingers.

    Lengths are in the frame of the mount: the turret, or the base of a robot without one.
    """

    place_m: float = attribute(
        "place", LENGTH, "",
        "Position of the palm, forward of the robot's centre. Default: the radius of the body.",
    )  # fmt: skip
    reach_m: float = attribute("reach", LENGTH, "10cm", "Length of the fingers.", positive=True)
    opening_m: float = attribute(
        "opening", LENGTH, "20cm", "Distance between the open fingers.", positive=True
    )
    closing_s: float = attribute(
        "closing",
        TIME,
        "1s",
        "Time that the fingers take to close or open completely.",
        positive=True,
    )
    most_kg: float = attribute(
        "max-mass",
        MASS,
        "2kg",
        "Maximum mass of an object that the gripper can hold.",
        positive=True,
    )
    force_n: float = attribute(
        "force", FORCE, "100N", "Maximum force on an object that other grippers also hold.",
        positive=True,
    )  # fmt: skip

    @property
    def middle_m(self) -> float:
        """Distance of the fingers' centre ahead of the mount's centre."""
        return self.place_m + self.reach_m / 2


def read(root: Element, reader: Reader) -> Gripper | None:
    """Return the gripper of a robot definition, None without one; errors go to the reader."""
    element, body = root.find_child("gripper"), root.first("body")
    if element is None:
        return None
    gripper: Gripper = read_attributes(Gripper, element, reader)
    if "place" in element.attributes or body.broken:
        return gripper
    return replace(gripper, place_m=reader.positive(body, "radius", LENGTH))
