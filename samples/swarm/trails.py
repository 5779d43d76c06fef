"""What the robots brought to the nest."""

from crs_cc import Session


def items_per_min(session: Session) -> float:
    """Return the items brought, of all robots together, per minute."""
    result = session.result()
    return sum(nest.brought for nest in result.nests) * 60.0 / result.simulated_s
