"""How far the robots have gathered."""

import numpy as np

from crs_cc import Session

_NEAR_M = 0.25


def largest_group(session: Session) -> float:
    """Return the share of robots in the largest group, in which each is near another one."""
    places = session.poses[:, :2]
    near = np.linalg.norm(places[:, None] - places, axis=2) < _NEAR_M
    group = np.arange(len(places))
    for _ in places:  # each robot gets the lowest number among those near, as far as that spreads
        group = np.where(near, group, len(places)).min(axis=1)
    return float(np.bincount(group).max()) / len(places)
