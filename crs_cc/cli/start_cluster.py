"""Serve a world whose programs run on a Dask cluster: place hosts there, and run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from crs_cc.cli.load import Loaded, load
from crs_cc.cli.messages import say, show_before_run
from crs_cc.cli.remote_hosts import RemoteHosts
from crs_cc.cli.resumption import Resumption
from crs_cc.cli.served_port import ANY_NAME, ServedPort, greet, is_own_name, served_port
from crs_cc.cli.simulate import run_loaded
from crs_cc.core.source import Diagnostics
from crs_cc.jobs.cluster import Cluster
from crs_cc.net.cluster_hosts import MODULE, ClusterHosts, Endpoint
from crs_cc.net.host_registry import HostRegistry

if TYPE_CHECKING:
    from crs_cc.cli.serve_options import ServeOptions
    from crs_cc.net.host_registry import Assignment


def start_cluster(options: ServeOptions) -> int:
    """Compile programs, run them on a cluster, and return the exit status.

    Raises:
        CrsError: a program or the world is not valid, or the cluster cannot be used.
        click.UsageError: the options do not go together.
        OSError: the port is in use.
    """
    diagnostics = Diagnostics()
    loaded = load(options, diagnostics)
    if not options.quiet:
        show_before_run(diagnostics.messages)
    resumption = None if options.resume is None else Resumption(options.resume)
    registry = HostRegistry(loaded.world.robots)
    with Cluster(MODULE, options.hosts) as cluster:
        options = _reachable(options, cluster)
        with served_port(options, registry) as port:
            greet(options, port)
            hosts = _placed(options, cluster, port, registry, loaded)
            try:
                assignments = _wait_for_hosts(hosts, cluster, options)
                if assignments is None:
                    return 130
                remote_hosts = RemoteHosts(
                    registry,
                    assignments,
                    _names(loaded),
                    loaded.executables,
                    waits=options.on_loss != "stop",  # the cluster restarts hosts itself
                    front=port.front,
                    resumption=resumption,
                    hosts=hosts,
                )
                return run_loaded(loaded, options, diagnostics, remote_hosts)
            finally:
                hosts.close()


def _names(loaded: Loaded) -> Sequence[str]:
    return [robot.id for robot in loaded.world.robots]


def _reachable(options: ServeOptions, cluster: Cluster) -> ServeOptions:
    """Return the options with an address that workers reach, encrypted if others could read."""
    if options.listen[0]:
        return options
    host = cluster.own_host
    is_tls = options.tls or not (is_own_name(host) or options.insecure or options.tls_cert)
    return replace(options, listen=(host, options.listen[1]), tls=is_tls)


def _placed(
    options: ServeOptions,
    cluster: Cluster,
    port: ServedPort,
    registry: HostRegistry,
    loaded: Loaded,
) -> ClusterHosts:
    host = cluster.own_host if options.listen[0] in ANY_NAME else options.listen[0]
    token = port.access.token("robot")
    endpoint = Endpoint(host, port.number, token, port.fingerprint)
    programs = list(zip(_names(loaded), loaded.executables, strict=True))
    return ClusterHosts(cluster, registry, programs, endpoint, options.per_host)


def _wait_for_hosts(
    hosts: ClusterHosts, cluster: Cluster, options: ServeOptions
) -> list[Assignment] | None:
    """Wait until all hosts are connected; return None if the user interrupts."""
    count = len(hosts)
    shown = f"{count} host{'' if count == 1 else 's'} on the cluster at {cluster.address}"
    if not options.quiet:
        say(f"crs: waiting for {shown}")
    try:
        assignments = hosts.assignments()
    except KeyboardInterrupt:
        say("crs: interrupted before the run started")
        return None
    if not options.quiet:
        say("crs: every robot has a program: the run starts")
    return assignments
