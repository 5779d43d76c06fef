"""How far the pucks have been pushed together."""

import numpy as np

from crs_cc import Session

_NEAR_M = 0.1


def clusters(session: Session) -> int:
    """Return the number of clusters of pucks, in which each is near another one."""
    return len(_sizes(session))


def largest_cluster(session: Session) -> int:
    """Return the number of pucks in the largest cluster."""
    return int(_sizes(session).max())


def _sizes(session: Session) -> np.ndarray:
    """Return the number of pucks in each cluster."""
    places = session.object_poses[:, :2]
    near = np.linalg.norm(places[:, None] - places, axis=2) < _NEAR_M
    cluster = np.arange(len(places))
    for _ in places:  # each puck gets the lowest number among those near, as far as that spreads
        cluster = np.where(near, cluster, len(places)).min(axis=1)
    return np.unique(cluster, return_counts=True)[1]
