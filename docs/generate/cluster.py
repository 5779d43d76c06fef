"""The figures of `docs/cluster.md`."""

from __future__ import annotations

from crs_cc.net.cluster_hosts import MAX_FAILURES
from docs.generate import Fillers

FILLERS: Fillers = {"failures": lambda: str(MAX_FAILURES)}
