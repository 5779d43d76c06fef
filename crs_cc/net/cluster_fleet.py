"""A fleet whose programs run on a Dask cluster, for a session in this process.

`crs serve --hosts` has the same hosts; here there are no viewers, and errors are raised.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.loopback import LOOPBACK
from crs_cc.jobs.cluster import Cluster
from crs_cc.net import tls
from crs_cc.net.access import Access
from crs_cc.net.cluster_hosts import MODULE, ClusterHosts, Endpoint
from crs_cc.net.host_link import HostLink
from crs_cc.net.host_registry import HostRegistry
from crs_cc.net.listener import Listener, bound_socket
from crs_cc.net.remote_fleet import RemoteFleet

if TYPE_CHECKING:
    from crs_cc.jobs.cluster import Where
    from crs_cc.net.channel import Channel
    from crs_cc.net.host_registry import Assignment
    from crs_cc.runtime.executable import Executable
    from crs_cc.sim.model.world import Robot


class ClusterFleet(RemoteFleet):
    """The programs of a session, on hosts that are replaced when they are lost."""

    def __init__(
        self,
        robots: Sequence[Robot],
        executables: Sequence[Executable],
        where: Where,
        per_host: int | None = None,
    ) -> None:
        """Start hosts, and wait until they are ready.

        Args:
            robots: the robots.
            executables: each robot's program.
            where: the cluster, see `Cluster`.
            per_host: how many robots a host has at most, see `ClusterHosts`.

        Raises:
            ClusterError: the cluster cannot be used.
            OSError: workers are on other machines, and no certificate can be made.
        """
        self._is_closed = False
        self._cluster = Cluster(MODULE, where)
        self._registry = HostRegistry(robots)
        access, host = Access.made(), self._cluster.own_host
        secure = None if host == LOOPBACK else tls.self_made()
        self._listener = Listener(
            bound_socket(host, 0),
            access,
            self._registry,
            secure.secure if secure else lambda plain: plain,
        )
        fingerprint = secure.fingerprint if secure else ""
        endpoint = Endpoint(host, self._listener.port, access.token("robot"), fingerprint)
        names = [robot.id for robot in robots]
        programs = list(zip(names, executables, strict=True))
        self._hosts = ClusterHosts(self._cluster, self._registry, programs, endpoint, per_host)
        try:
            self._assignments = {
                assignment.names: assignment for assignment in self._hosts.assignments()
            }
            super().__init__(
                executables,
                [self._link(assignment, names) for assignment in self._assignments.values()],
            )
        except BaseException:
            self._close_hosts()
            raise

    def _link(self, assignment: Assignment, names: Sequence[str]) -> HostLink:
        robots = np.array([names.index(name) for name in assignment.names], np.intp)
        return HostLink(assignment.names, robots, self._taken(assignment), self._replace)

    def _replace(self, link: HostLink, _reason: str) -> Channel:
        """Return a connection to a host that replaces a lost one."""
        assignment = self._assignments[link.names]
        self._registry.mark_lost(assignment)
        return self._taken(assignment)

    def _taken(self, assignment: Assignment) -> Channel:
        channel = self._hosts.wait_for_channel(assignment, lambda: False)
        assert channel is not None
        return channel

    def close(self) -> None:
        """Dismiss the hosts; the state of the programs is kept."""
        if self._is_closed:
            return
        self.dismiss(everyone=True)
        super().close()
        self._close_hosts()

    def _close_hosts(self) -> None:
        self._is_closed = True
        self._registry.end()
        self._hosts.close()
        self._listener.close()
        self._cluster.close()
