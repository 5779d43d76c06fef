"""What the robots brought to the nest."""

from crs_cc import Session


def items_per_min(session: Session) -> float:
    """Return the items brought, of all robots together, per minute."""
    items = sum(robot.stdout.count("an item") for robot in session.robots.values())
    return items * 60.0 / session.time_s
