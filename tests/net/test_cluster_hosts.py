"""Hosts on a Dask cluster, whose scheduler and workers are processes of their own."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from crs_cc.api.programs import compile_c
from crs_cc.api.session import Session
from crs_cc.cli.main import main
from crs_cc.jobs import cluster
from crs_cc.jobs.cluster import Cluster, ClusterError
from crs_cc.jobs.pool import Outcome, Task
from crs_cc.net.cluster_hosts import MAX_FAILURES, ClusterHosts, Endpoint
from crs_cc.net.host_job import HostJob, packed
from crs_cc.net.host_registry import HostRegistry
from crs_cc.runtime.executable import Executable
from crs_cc.sim.files.world_xml import parse_world
from tests.session.programs import ROAM

WORLD = b"""<world version="1"><area length="9m" width="4m"/>
<robot id="a" x="1m" y="2m"/><robot id="b" x="4m" y="2m" heading="90deg"/></world>"""
SLEEPS = "#include <unistd.h>\nint main(void) { return sleep(2) + 7; }\n"
PAGE = Path(__file__).parents[2] / "docs" / "cluster.md"
TIMEOUT_S = 120.0


def wait_until_written(path: Path) -> str:
    end_s = time.monotonic() + TIMEOUT_S
    while not path.is_file() or not path.read_text():
        assert time.monotonic() < end_s
        time.sleep(0.02)
    return path.read_text()


@dataclass
class Dask:
    """A cluster of processes.

    Attributes:
        address: the scheduler's.
        workers: its workers.
    """

    address: str
    workers: list[subprocess.Popen[bytes]]

    def kill_a_busy_worker(self) -> None:
        psutil = pytest.importorskip("psutil")  # which Dask needs
        busy = (each for each in self.workers if psutil.Process(each.pid).children())
        next(busy).send_signal(signal.SIGKILL)


def certificates(folder: Path) -> dict[str, str]:
    """Make a certificate as in docs/cluster.md; return the resulting settings of Dask."""
    script = re.findall(r"```sh\n(.*?)```", PAGE.read_text(), re.DOTALL)[1]
    shown = subprocess.run(
        ["bash", "-ec", f"{script}env"], cwd=folder, capture_output=True, text=True, check=True
    )
    variables = (line.partition("=") for line in shown.stdout.splitlines())
    return {name: value for name, _, value in variables if name.startswith("DASK_")}


@pytest.fixture(scope="module")
def dask(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Dask]:
    """A cluster whose connections are encrypted."""
    pytest.importorskip("distributed", reason="needs the extra 'cluster'")
    from dask import config

    folder = tmp_path_factory.mktemp("dask")
    variables = certificates(folder)
    with ExitStack() as stack:
        tls = config.collect_env(variables)["distributed"]["comm"]["tls"]
        tls = config.merge(config.get("distributed.comm.tls"), tls)
        stack.enter_context(config.set({"distributed.comm.tls": tls}))

        def start(module: str, *words: str) -> subprocess.Popen[bytes]:
            command = [sys.executable, "-m", f"distributed.cli.dask_{module}", *words]
            with (folder / "log").open("ab") as log:
                process = subprocess.Popen(command, cwd=folder, stdout=log, stderr=log,
                                           env=os.environ | variables)  # fmt: skip
            stack.callback(process.wait)
            stack.callback(process.kill)
            return process

        file = folder / "scheduler.json"
        start("scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
              "--protocol", "tls", "--scheduler-file", str(file))  # fmt: skip
        address = json.loads(wait_until_written(file))["address"]
        options = address, "--nthreads", "1", "--no-nanny", "--no-dashboard"
        yield Dask(address, [start("worker", *options) for _ in range(2)])


def test_a_run_on_a_cluster_that_loses_a_worker_equals_one_in_a_single_process(dask: Dask) -> None:
    """The other worker has one thread, which runs a host: it takes the lost one beside it."""
    from distributed import Client

    world = parse_world(WORLD, "world")
    programs = [compile_c(ROAM), compile_c(SLEEPS)]
    local = Session(world, programs, duration_s=3.0)
    expected = local.run()
    with Client(dask.address) as client:
        client.wait_for_workers(2)
        with Session(world, programs, duration_s=3.0, hosts=client, per_host=1) as session:
            session.run(1.0)
            dask.kill_a_busy_worker()
            result = session.run()
    assert result.state_hash == expected.state_hash == session.state_hash()
    assert [each.exit_status for each in result.robots] == [None, 7]
    assert session.robots["a"].stdout == local.robots["a"].stdout != ""
    with pytest.raises(ValueError, match="can only go forward"):
        session.restore(local.snapshot())


def test_workers_of_another_version_run_no_program(
    dask: Dask, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster, "_sources", lambda: "another")
    with pytest.raises(ClusterError, match="a worker has a different version of crs"):
        Session(programs="int main(void) { return 7; }", hosts=dask.address.replace("tls", "dask"))


def test_a_program_compiled_for_a_different_architecture_is_recompiled() -> None:
    program = compile_c("int main(void) { return 7; }")
    foreign = replace(program, machine_code=b"of another processor", _loaded=None)
    assert Session(programs=foreign).run().robots[0].exit_status == 7


class Ended:
    """A task that has ended as soon as it has started."""

    def __init__(self, result: dict[str, str]) -> None:
        self._result = result

    def outcome(self) -> Outcome:
        return Outcome(0, self._result)

    def cancel(self) -> None:
        """Do nothing."""


class Unlucky:
    """A cluster whose tasks end at once."""

    threads = 1
    location = cluster.Location("tcp://hall:8786")

    def __init__(self, *results: dict[str, str]) -> None:
        self._results = list(results)
        self.jobs: list[HostJob] = []

    def start(self, task: Task) -> Ended:
        self.jobs.append(HostJob.of(json.loads(json.dumps(task.job))))
        return Ended(self._results[min(len(self.jobs), len(self._results)) - 1])


def placed(where: Any, executables: list[tuple[str, Executable]]) -> ClusterHosts:
    registry = HostRegistry(parse_world(WORLD, "world").robots)
    return ClusterHosts(where, registry, executables, Endpoint("127.0.0.1", 9, "t" * 16), 2)


PROGRAMS = [(name, compile_c("int main(void) { return 7; }")) for name in "a"]


@pytest.mark.parametrize(
    ("results", "starts", "text"),
    [
        ([{"refused": "the run has ended"}], 1, "no host for a: the run has ended"),
        ([{"unreached": "timed out"}], MAX_FAILURES, "no host for a: timed out"),
        ([{"lost": "cut"}] * 9 + [{}], 9 + MAX_FAILURES, "no host for a: it has ended"),
    ],
)
def test_hosts_that_keep_ending_are_reported_once(
    results: list[dict[str, str]], starts: int, text: str
) -> None:
    where = Unlucky(*results)
    with pytest.raises(ClusterError, match=f"tcp://hall:8786: error: {text}"):
        placed(where, PROGRAMS).assignments()
    assert len(where.jobs) == starts
    assert len({each.name for each in where.jobs}) == 1  # it comes back as the same host


def test_a_host_has_robots_of_one_program_and_no_more_than_the_limit() -> None:
    one, two = (compile_c(f"int main(void) {{ return {number}; }}") for number in (1, 2))
    where = Unlucky({})
    placed(where, [("a", one), ("b", two), ("c", one), ("d", one)])
    assert [each.robots for each in where.jobs] == [("a", "c"), ("d",), ("b",)]
    assert where.jobs[0].executable == packed(one)


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["roam.c", "world.xml"], "here, only with --hosts"),
        (["world.xml", "-DX"], "here, only with --hosts"),
        (["world.xml", "--per-host", "5"], "--per-host requires --hosts"),
        (
            ["world.xml", "--hosts", "dask://h:1", "--nserver", "0"],
            "--hosts applies to programs that",
        ),
        (["roam.c", "--hosts", "dask://h:1"], "no world file"),
        (["world.xml", "--hosts", "dask://h:1"], "no program"),
    ],
)
def test_incompatible_options_are_rejected(
    words: list[str],
    text: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("world.xml").write_bytes(WORLD)
    assert main(["serve", *words]) == 2
    assert text in capfd.readouterr().err


def test_remote_workers_receive_a_reachable_address(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    utils = pytest.importorskip("distributed.utils")
    ways = {"127.0.1.1": "127.0.0.1", "127.0.0.1": "127.0.0.1", "10.77.1.2": "10.77.1.1"}
    monkeypatch.setattr(utils, "get_ip", ways.__getitem__)
    workers = {"tcp://127.0.0.1:40001": {}, "tcp://10.77.1.2:40001": {}}
    for there, told in ((workers, "10.77.1.1"), ({"tcp://127.0.0.1:40001": {}}, "127.0.0.1")):
        client = SimpleNamespace(
            scheduler=SimpleNamespace(address="tcp://127.0.1.1:8786"),
            scheduler_info=lambda n_workers, there=there: {"workers": there},
            wait_for_workers=lambda count, timeout: None,
        )
        assert Cluster("crs_cc.net.host_job", client).own_host == told  # type: ignore[arg-type]
