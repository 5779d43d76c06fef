"""Runs jobs on a Dask cluster instead of local processes (extra `cluster`).

Each thread of a Dask worker has a process that runs jobs, one of those of `jobs.pool`, so a job is
limited there as it is here. A worker that is lost costs nothing: others run its tasks again, which
gives the same results.

A task may also be started to live as long as something here does: then it has a process and a
thread of its own, and takes none of the worker's.
"""

from __future__ import annotations

import logging
import threading
import uuid
from collections.abc import Generator, Iterable
from functools import cache
from ipaddress import ip_address
from itertools import islice
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Self, TypeAlias

from crs_cc.core.errors import CrsError
from crs_cc.core.source import Location
from crs_cc.jobs.pool import Outcome, Task, Worker
from crs_cc.toolchain.cache import version
from crs_cc.toolchain.fingerprint import WORLDS

if TYPE_CHECKING:
    from distributed import Client, Future

Where: TypeAlias = "str | Client"
"""A cluster: its scheduler's address, or a connection to it."""

_CONNECT_S: Final = 10.0
"""Real time to find the scheduler, and a first worker."""

_AHEAD: Final = 2
"""Tasks for each thread that are on their way, so that none waits for the next."""


class ClusterError(CrsError):
    """A cluster that cannot be used, or not any more."""

    exit_status = 2


class Cluster:
    """A Dask cluster that runs tasks, as `jobs.pool.Pool` does."""

    def __init__(self, module: str, where: Where) -> None:
        """Connect to a cluster.

        Args:
            module: the module that a process runs, see `crs_cc.jobs.worker.serve`.
            where: the scheduler's address, such as `tcp://hall:8786`; `dask://` means `tls://`
                if Dask's configuration names certificates, else for `tcp://`. Or a connection,
                which stays open.

        Raises:
            ClusterError: it cannot be reached, or has no workers.
        """
        self._module, self._is_ours = module, isinstance(where, str)
        self._client: Any = self._connected(where) if isinstance(where, str) else where
        self._address = self.address
        try:
            self._client.wait_for_workers(1, timeout=_CONNECT_S)
        except TimeoutError:
            self.close()
            hint = f"start some with 'dask worker {self._address} --nthreads 1'"
            raise self._error("the Dask scheduler has no workers", hint) from None

    def _connected(self, address: str) -> Any:
        self._address = address
        if not _is_address(address):
            raise self._error("not the address of a Dask scheduler", "write it as dask://HOST:PORT")
        import distributed

        connect: Any = distributed.Client  # without types
        logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # we report errors
        try:
            return connect(_with_scheme(address), timeout=_CONNECT_S, set_as_default=False)
        except (OSError, ValueError) as error:
            hint = "start one with 'dask scheduler', which prints its address"
            raise self._error(f"no Dask scheduler: {_first_line(error)}", hint) from None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _where: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Close the connection, if it is ours."""
        if self._is_ours:
            self._client.close()

    @property
    def address(self) -> str:
        """The scheduler's address, such as `tcp://127.0.0.1:8786`."""
        return str(self._client.scheduler.address)

    @property
    def location(self) -> Location:
        """Return the place that error messages name."""
        return Location(self._address)

    @property
    def own_host(self) -> str:
        """The address of this machine by which the scheduler's or a worker's machine reaches it.

        Where the scheduler is on this machine and called by a name that only stands for it here,
        such as 127.0.1.1, workers on other machines still reach this one.
        """
        from distributed.comm.addressing import get_address_host
        from distributed.utils import get_ip

        others = [self.address, *sorted(self._client.scheduler_info(n_workers=-1)["workers"])]
        found = ""
        for other in others:
            found = get_ip(get_address_host(other))  # type: ignore[no-untyped-call]
            if not ip_address(found).is_loopback:
                break
        return found

    @property
    def threads(self) -> int:
        """Return the number of threads of all workers, at least 1."""
        found: int = max(1, sum(self._client.nthreads().values()))
        return found

    def start(self, task: Task) -> Started:
        """Start a task that lives as long as something here does; it needs no free thread."""
        arguments = self._module, task, _sources()
        key = f"crs-{uuid.uuid4().hex}"
        return Started(self, self._client.submit(_run_beside, *arguments, key=key))

    def run(self, tasks: Iterable[Task], retries: int = 0) -> Generator[Outcome, None, None]:
        """Yield the outcomes of tasks, in the order in which they end.

        Tasks are taken from their iterator when the cluster has room for them; what is still to do
        is cancelled when the generator is closed before its end, or raises.

        Args:
            tasks: the tasks.
            retries: how often a task is tried again whose process crashed; how often one is whose
                worker is lost is a setting of the cluster.

        Raises:
            ClusterError: the cluster is lost, or cannot run jobs of this version.
        """
        from distributed import as_completed

        todo = enumerate(tasks)
        name = f"crs-{uuid.uuid4().hex}"
        numbers: dict[Future[Outcome], int] = {}
        ended: Any = as_completed(loop=self._client.loop)  # type: ignore[no-untyped-call]

        def submit() -> None:
            for number, task in islice(todo, max(0, self._room() - len(numbers))):
                arguments = (self._module, number, task, retries, _sources())
                future = self._client.submit(_run, *arguments, key=f"{name}-{number}")
                numbers[future] = number
                ended.add(future)

        try:
            submit()
            for future in ended:
                yield self.outcome(future, numbers.pop(future))
                submit()
        finally:
            if numbers:
                self._client.cancel(list(numbers), force=True)

    def _room(self) -> int:
        """Return the capacity of the cluster, including tasks that wait for a thread."""
        return _AHEAD * self.threads

    def outcome(self, future: Future[Outcome], number: int = 0) -> Outcome:
        """Return the outcome of a task that has ended.

        Raises:
            ClusterError: the cluster is lost, or cannot run jobs of this version.
        """
        from distributed import KilledWorker
        from distributed.client import FutureCancelledError

        try:
            return future.result()
        except FutureCancelledError as error:
            hint = "finished runs are kept: continue on another cluster, or on this machine"
            raise self._error(f"connection to the cluster lost: {error.reason}", hint) from None
        except KilledWorker as error:
            text = f"{error.allowed_failures + 1} workers ended while they ran it"
            return Outcome(number, None, "crashed", text)
        except Exception as error:  # whatever Dask or its connections raise
            raise self._error(f"cannot run jobs: {_first_line(error)}") from None

    def _error(self, text: str, hint: str = "") -> ClusterError:
        return ClusterError.at(self.location, text, hint)


class Started:
    """A task that has been started on a cluster, which runs it again if its worker is lost."""

    def __init__(self, cluster: Cluster, future: Future[Outcome]) -> None:
        self._cluster = cluster
        self._future: Any = future  # without types

    def outcome(self) -> Outcome | None:
        """Return the outcome, or None if the task has not ended.

        Raises:
            ClusterError: the cluster is lost, or cannot run jobs of this version.
        """
        return self._cluster.outcome(self._future) if self._future.done() else None

    def cancel(self) -> None:
        """Prevent a restart; its process ends when its job does."""
        self._future.cancel(force=True)


_here = threading.local()
"""The process that runs the jobs of a thread of a Dask worker."""


def _run(module: str, number: int, task: Task, retries: int, sources: str) -> Outcome:
    """Run a task in a process of this Dask worker."""
    _require_same(sources)
    if not hasattr(_here, module):
        setattr(_here, module, Worker(module))
    worker: Worker = getattr(_here, module)
    for _ in range(retries):
        outcome = worker.run(number, task)
        if outcome.kind != "crashed":
            return outcome
    return worker.run(number, task)


def _run_beside(module: str, task: Task, sources: str) -> Outcome:
    """Run a task in a process of its own, and leave the worker's thread to others."""
    from distributed import secede

    _require_same(sources)
    secede()  # type: ignore[no-untyped-call]
    worker = Worker(module)
    try:
        return worker.run(0, task)
    finally:
        worker.stop()


def _require_same(sources: str) -> None:
    if sources != _sources():
        raise RuntimeError("a worker has a different version of crs, Python or wasmtime")


@cache
def _sources() -> str:
    """Return a hash of what may change a result."""
    return version(WORLDS)


def _is_address(address: str) -> bool:
    """Return whether a text names a scheduler's host and port.

    >>> [_is_address(each) for each in ("dask://hall:8786", "[::1]:8786", "hall", "tcp://hall:x")]
    [True, True, False, False]
    """
    scheme, _, rest = address.rpartition("://")
    host, _, port = rest.rpartition(":")
    is_port = port.isascii() and port.isdecimal() and len(port) <= 5 and 0 < int(port) < 1 << 16
    return scheme in ("", "dask", "tcp", "tls") and bool(host) and is_port


def _with_scheme(address: str) -> str:
    """Return an address as Dask writes it."""
    scheme, separator, rest = address.partition("://")
    if scheme != "dask" or not separator:
        return address
    from distributed import Security

    security: Any = Security()  # type: ignore[no-untyped-call]
    return f"{'tls' if security.tls_ca_file else 'tcp'}://{rest}"


def _first_line(error: Exception) -> str:
    return str(error).partition("\n")[0] or type(error).__name__
