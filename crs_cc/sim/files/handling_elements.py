"""Elements of grippers and arms in a robot definition."""

from __future__ import annotations

from crs_cc.core.quantity import ANGLE, FORCE, LENGTH, MASS, TIME, TURN_RATE
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.handling import Arm, Gripper, Joint


def gripper(root: Element, radius_m: float, reader: Reader) -> Gripper | None:
    """Return the gripper, None for a robot without one; errors go to the reader.

    Args:
        root: the root element.
        radius_m: the robot's radius, the default position of the palm.
        reader: reads the values.
    """
    element = root.maybe("gripper")
    if element is None:
        return None
    return Gripper(
        place_m=reader.not_negative(element, "place", LENGTH, radius_m),
        reach_m=reader.positive(element, "reach", LENGTH),
        opening_m=reader.positive(element, "opening", LENGTH),
        closing_s=reader.positive(element, "closing", TIME),
        most_kg=reader.positive(element, "max-mass", MASS),
        force_n=reader.positive(element, "force", FORCE),
    )


def arm(root: Element, reader: Reader) -> Arm | None:
    """Return the arm, None for a robot without one; errors go to the reader."""
    element = root.maybe("arm")
    if element is None:
        return None
    return Arm(
        x_m=reader.quantity(element, "x", LENGTH),
        y_m=reader.quantity(element, "y", LENGTH),
        upper_m=reader.positive(element, "upper", LENGTH),
        fore_m=reader.positive(element, "fore", LENGTH),
        shoulder=_joint(element, "shoulder", reader),
        elbow=_joint(element, "elbow", reader),
        hand_m=reader.positive(element, "hand", LENGTH),
        most_kg=reader.positive(element, "max-mass", MASS),
    )


def _joint(element: Element, name: str, reader: Reader) -> Joint:
    joint = Joint(
        reader.quantity(element, f"{name}-min", ANGLE),
        reader.quantity(element, f"{name}-max", ANGLE),
        reader.positive(element, f"{name}-speed", TURN_RATE),
    )
    if joint.least_rad > joint.most_rad:
        reader.refuse(element, f"{name}-min: must not be greater than {name}-max")
    return joint
