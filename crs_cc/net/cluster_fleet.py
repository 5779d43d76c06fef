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
from crs_cc.net.cluster_hosts import MODULE, ClusterHosts, Entrance
from crs_cc.net.distant_fleet import DistantFleet
from crs_cc.net.gate import Gate, bound
from crs_cc.net.host_link import HostLink
from crs_cc.net.roster import Roster

if TYPE_CHECKING:
    from crs_cc.jobs.cluster import Where
    from crs_cc.net.channel import Channel
    from crs_cc.net.roster import Seat
    from crs_cc.runtime.executable import Executable
    from crs_cc.sim.model.world import Robot


class ClusterFleet(DistantFleet):
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
        self._roster = Roster(robots)
        access, host = Access.made(), self._cluster.own_host
        secure = None if host == LOOPBACK else tls.self_made()
        self._gate = Gate(
            bound(host, 0), access, self._roster, secure.secure if secure else lambda plain: plain
        )
        fingerprint = secure.fingerprint if secure else ""
        entrance = Entrance(host, self._gate.port, access.token("robot"), fingerprint)
        names = [robot.id for robot in robots]
        programs = list(zip(names, executables, strict=True))
        self._hosts = ClusterHosts(self._cluster, self._roster, programs, entrance, per_host)
        try:
            self._seats = {seat.names: seat for seat in self._hosts.seats()}
            super().__init__(
                executables, [self._link(seat, names) for seat in self._seats.values()]
            )
        except BaseException:
            self._close_hosts()
            raise

    def _link(self, seat: Seat, names: Sequence[str]) -> HostLink:
        robots = np.array([names.index(name) for name in seat.names], np.intp)
        return HostLink(seat.names, robots, self._taken(seat), self._replace)

    def _replace(self, link: HostLink, _reason: str) -> Channel:
        """Return a connection to a host that replaces a lost one."""
        seat = self._seats[link.names]
        self._roster.lose(seat)
        return self._taken(seat)

    def _taken(self, seat: Seat) -> Channel:
        channel = self._hosts.take(seat, lambda: False)
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
        self._roster.end()
        self._hosts.close()
        self._gate.close()
        self._cluster.close()
