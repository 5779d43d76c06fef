"""Sweeps on a Dask cluster: the table of a sweep on one machine, whatever happens to workers."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING
from unittest import mock

import pytest

from crs_cc.cli.main import main
from crs_cc.jobs import cluster
from crs_cc.jobs.cluster import Cluster, ClusterError
from crs_cc.sweeps.sweep import Progress, Sweep
from tests.sweeps.trials import MANY, swept, write

NO_ADDRESS = "error: not the address of a Dask scheduler"

if TYPE_CHECKING:
    from distributed import LocalCluster

pytestmark = pytest.mark.skipif(not find_spec("distributed"), reason="needs the extra 'cluster'")
"""It is imported where it is used: every run of any tests would wait for it."""


@pytest.fixture(scope="module")
def dask() -> Iterator[LocalCluster]:
    """A cluster of two workers on this machine."""
    from distributed import LocalCluster

    with (
        mock.patch.dict(os.environ),  # in which it leaves what its processes are to have
        LocalCluster(  # type: ignore[no-untyped-call]
            n_workers=2, threads_per_worker=1, dashboard_address="127.0.0.1:0"
        ) as found,
    ):
        yield found


def test_a_cluster_that_loses_a_worker_makes_the_same_table(
    tmp_path: Path, dask: LocalCluster
) -> None:
    swept(write(tmp_path / "here", MANY), tmp_path / "here" / "out")
    out = tmp_path / "there" / "out"
    sweep = Sweep(write(tmp_path / "there", MANY), out)
    killed = []

    def kill(progress: Progress) -> None:
        if progress.done == 4 and not killed:
            killed.append(dask.workers[0].pid)
            os.kill(killed[0], signal.SIGKILL)

    sweep.run(1, dask=dask.scheduler_address, report=kill)
    assert killed
    assert len((out / "rows.jsonl").read_text().splitlines()) == 12
    assert (out / "runs.csv").read_bytes() == (tmp_path / "here/out/runs.csv").read_bytes()
    assert (out / "failed" / "0003.mcap").exists()


def test_rows_outlive_the_connection_to_a_cluster(tmp_path: Path, dask: LocalCluster) -> None:
    path, out = write(tmp_path, MANY), tmp_path / "out"
    sweep = Sweep(path, out)
    with Cluster("crs_cc.sweeps.worker", dask.scheduler_address) as lost:
        submit = lost._client.submit

        def cancelled(run: object, module: str, number: int, *more: object, key: str) -> object:
            future = submit(run, module, number, *more, key=key)
            if number == 5:
                future.cancel(force=True)  # as all of them are when the scheduler ends
            return future

        lost._client.submit = cancelled
        with pytest.raises(ClusterError, match="connection to the cluster lost: "):
            sweep.run(1, pool=lost.run)
    assert len((out / "runs.csv").read_text().splitlines()) == 1 + len(sweep.rows)
    assert 0 < len(sweep.rows) < 12
    assert len(swept(path, out, resume=True).rows) == 12


def test_a_cluster_with_another_version_runs_nothing(
    tmp_path: Path, dask: LocalCluster, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster, "_sources", lambda: "another")
    with pytest.raises(ClusterError, match="a worker has a different version of crs"):
        Sweep(write(tmp_path), tmp_path / "out").run(1, dask=dask.scheduler_address)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("address", "text"),
    [
        ("tcp://127.0.0.1:9", "tcp://127.0.0.1:9: error: no Dask scheduler: "),
        ("nowhere://127.0.0.1", f"nowhere://127.0.0.1: {NO_ADDRESS}"),
        ("dask://127.0.0.1:x", f"dask://127.0.0.1:x: {NO_ADDRESS}"),
        ("dask://:8786", f"dask://:8786: {NO_ADDRESS}"),
        ("tcp://hall:65536", f"tcp://hall:65536: {NO_ADDRESS}"),
    ],
)
def test_an_address_without_a_scheduler_is_one_clear_error(
    address: str,
    text: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(cluster, "_CONNECT_S", 0.2)
    out = str(tmp_path / "out")
    assert main(["sweep", str(write(tmp_path)), "--out", out, "--dask", address]) == 2
    assert text in capfd.readouterr().err
