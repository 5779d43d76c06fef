"""What `crs serve` shows of programs that run elsewhere."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from crs_cc.cli.remote_hosts import RemoteHosts
from crs_cc.net.host_registry import HostRegistry


@pytest.mark.parametrize(
    ("on_cluster", "time_s", "is_shown"),
    [(False, 3.0, True), (True, 1.9, True), (True, 2.0, False)],
)
def test_a_resumed_run_on_a_cluster_prints_nothing_twice(
    on_cluster: bool, time_s: float, is_shown: bool
) -> None:
    """What hosts of users print they show themselves; what those of a cluster print, we do."""
    recorded: Any = SimpleNamespace(end_s=2.0)
    hosts: Any = object() if on_cluster else None
    run = RemoteHosts(
        HostRegistry([]), [], [], [], waits=True, front=None, resumption=recorded, hosts=hosts
    )
    session: Any = SimpleNamespace(time_s=time_s)
    run.begin(session, lambda: False)
    assert run.shows_output is is_shown
