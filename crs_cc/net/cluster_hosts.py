"""The hosts of a run on a Dask cluster: tasks, which Dask starts and restarts.

Slots are sent over the environment's own connections, not by Dask. The tasks of a lost worker are
repeated by others; such a host replaces the lost one, see `host_link`. Hosts are checked only while
the run waits for one.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.jobs.cluster import ClusterError
from crs_cc.jobs.pool import Outcome, Task
from crs_cc.net.host_job import HostJob, packed

if TYPE_CHECKING:
    from crs_cc.jobs.cluster import Cluster, Started
    from crs_cc.net.channel import Channel
    from crs_cc.net.host_registry import Assignment, HostRegistry
    from crs_cc.runtime.executable import Executable

MODULE: Final = "crs_cc.net.host_job"
"""What the processes of a cluster run."""

MAX_FAILURES: Final = 5
"""Limit of consecutive starts of a host that ends before it has reached the environment. Chosen by
us."""

_PREPARE_S: Final = 600.0
_NO_LIMIT_S: Final = 1e9
"""In effect no time limit: a host runs until the end of the run."""


@dataclass(frozen=True, slots=True)
class Endpoint:
    """The address and the token by which hosts reach the environment.

    Attributes:
        host: its host or address, as workers reach it.
        port: its port.
        token: the token for robots.
        fingerprint: of its certificate; empty without TLS.
    """

    host: str
    port: int
    token: str
    fingerprint: str = ""


@dataclass(slots=True)
class _HostTask:
    """A host.

    Attributes:
        task: what it does.
        started: the task on the cluster.
        failures: the number of consecutive starts without reaching the environment.
    """

    task: Task
    started: Started
    failures: int = 0


class ClusterHosts:
    """Hosts on a cluster, with each robot once."""

    def __init__(
        self,
        cluster: Cluster,
        registry: HostRegistry,
        executables: Sequence[tuple[str, Executable]],
        endpoint: Endpoint,
        per_host: int | None = None,
    ) -> None:
        """Start the hosts.

        Args:
            cluster: the cluster.
            registry: the assignment of robots to hosts.
            executables: each robot's name and program.
            endpoint: how hosts reach the environment.
            per_host: how many robots a host has at most; by default, each thread of the cluster's
                workers has a host.

        Raises:
            ClusterError: the cluster is lost.
        """
        self._registry = registry
        per_host = per_host or -(-len(executables) // cluster.threads)
        tasks = _tasks(executables, endpoint, per_host)
        self._cluster = cluster
        self._hosts = [_HostTask(task, cluster.start(task)) for task in tasks]

    def __len__(self) -> int:
        return len(self._hosts)

    def assignments(self) -> list[Assignment]:
        """Wait until all hosts are ready; begin the run and return their seats.

        Raises:
            ClusterError: hosts cannot run on the cluster.
        """
        while self._registry.missing():
            self.restart_ended()
            self._registry.wait()
        return self._registry.begin()

    def wait_for_channel(
        self, assignment: Assignment, is_ended: Callable[[], bool]
    ) -> Channel | None:
        """Wait for a connection to a host, see `HostRegistry.wait_for_channel`.

        Raises:
            ClusterError: hosts can no longer run on the cluster.
        """

        def look() -> bool:
            self.restart_ended()
            return is_ended()

        return self._registry.wait_for_channel(assignment, look)

    def restart_ended(self) -> None:
        """Restart hosts that have ended.

        Raises:
            ClusterError: hosts cannot run on the cluster.
        """
        for each in self._hosts:
            outcome = each.started.outcome()
            if outcome is None:
                continue
            self._check(each, outcome)
            each.started = self._cluster.start(each.task)

    def _check(self, host: _HostTask, outcome: Outcome) -> None:
        """Check that a host may be restarted."""
        result = outcome.result or {}
        reason = result.get("refused")
        host.failures = 0 if "lost" in result else host.failures + 1
        if host.failures == MAX_FAILURES:
            reason = outcome.text or result.get("unreached") or "it has ended"
        if reason is not None:
            robots = _shown(host.task.job["robots"])
            raise ClusterError.at(self._cluster.location, f"no host for {robots}: {reason}")

    def close(self) -> None:
        """Cancel all hosts."""
        for each in self._hosts:
            each.started.cancel()


def _tasks(
    executables: Sequence[tuple[str, Executable]], endpoint: Endpoint, per_host: int
) -> Iterator[Task]:
    """Yield a task for each host; a host has one program."""
    groups: dict[int, tuple[Executable, list[str]]] = {}
    for name, executable in executables:
        groups.setdefault(id(executable), (executable, []))[1].append(name)
    for executable, names in groups.values():
        program = packed(executable)
        for start in range(0, len(names), per_host):
            job = HostJob(
                endpoint.host,
                endpoint.port,
                endpoint.token,
                endpoint.fingerprint,
                name=secrets.token_hex(16),
                robots=tuple(names[start : start + per_host]),
                executable=program,
            )
            yield Task(job.data(), _PREPARE_S, _NO_LIMIT_S)


def _shown(robots: Sequence[str]) -> str:
    return ", ".join(robots[:3]) + (", ..." if len(robots) > 3 else "")
