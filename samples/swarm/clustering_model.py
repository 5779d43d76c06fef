"""Pucks that are put together one by one, without bodies: the expectation of docs/swarms.md."""

from __future__ import annotations

import random
from typing import Final

PUCKS: Final = 16


def sizes(seed: int) -> list[int]:
    """Return the sizes of the clusters in the end.

    As long as there is a puck that lies alone, one of these is put to another puck that lies alone
    or to a cluster, each with the same probability. Clusters are left in peace.

    Args:
        seed: the random seed.
    """
    generator = random.Random(seed)
    alone, clusters = PUCKS, list[int]()
    while alone and alone + len(clusters) > 1:
        alone -= 1
        to = generator.randrange(alone + len(clusters))
        if to < alone:
            alone -= 1
            clusters.append(2)
        else:
            clusters[to - alone] += 1
    return clusters
