"""From the elements of a robot definition file to what the robot handles things with."""

from __future__ import annotations

from crs_cc.sim.document import Element, Reader
from crs_cc.sim.handling_model import Gripper
from crs_cc.sim.quantity import FORCE, LENGTH, MASS, TIME


def gripper(root: Element, radius_m: float, reader: Reader) -> Gripper | None:
    """Gives the gripper, None for a robot without one; mistakes go to the reader.

    Args:
        root: the outermost element.
        radius_m: the robot's, where the palm is if nothing else is said.
        reader: reads the values.
    """
    for element in root.all("gripper"):
        return Gripper(
            place_m=reader.not_negative(element, "place", LENGTH, radius_m),
            reach_m=reader.positive(element, "reach", LENGTH),
            opening_m=reader.positive(element, "opening", LENGTH),
            closing_s=reader.positive(element, "closing", TIME),
            most_kg=reader.positive(element, "max-mass", MASS),
            force_n=reader.positive(element, "force", FORCE),
        )
    return None
