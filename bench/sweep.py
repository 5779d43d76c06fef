"""Runs a sweep in several ways, kills what can be killed, and compares the tables.

Each run is two robots for 0.2 s, with one of ten programs, of which the first fails. The ways: on
this machine; again, with a worker killed now and then; killed by SIGKILL in the middle, and
resumed; and with --dask on a cluster of three workers, one of which is killed. What is told is the
time for each run, the most memory of the process that runs the sweep, and whether the table has
the bytes of the first one. With --measures, runs have measures of one's own, too.

At the end: the processor time of a run that does not fail, of what a sweep takes before its first
run, and of a run that fails, with its recording. A run is taken apart into its simulation, which is
measured in a process that does nothing else, and the rest.

    python bench/sweep.py [--dask] [--measures] [--programs N] [--jobs N] [RUNS]
"""

from __future__ import annotations

import argparse
import gc
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from crs_cc.jobs.pool import Worker
from crs_cc.sweeps import single_run
from crs_cc.sweeps.experiment_file import parse
from crs_cc.sweeps.plan import runs_of
from crs_cc.sweeps.sweep import Progress, Sweep
from crs_cc.sweeps.variant import VariantLoader

WORLD = """<world version="1" duration="0.2s"><area length="6m" width="4m"/>
<robot id="a" x="1m" y="1m" setup="noisy"/><robot id="b" x="1m" y="3m" setup="noisy"/></world>
"""
PROGRAM = """#include <Nclient.h>
int main(void)
{
    connect_robot(1);
    vm(SPEED, SPEED, 0);
    get_sn();
    return SPEED == 10 ? 1 / (SPEED - 10) : 0;
}
"""
MEASURES = """def west_m(session):
    return session.poses[:, 0].min()
"""
SIMULATED = 60
"""Runs, at most, of which the simulation alone is measured."""


def experiment(
    folder: Path, runs: int, programs: int, *, measures: bool, fails: bool = True
) -> Path:
    """Write an experiment of so many runs, each of one of so many programs; return its file."""
    folder.mkdir()
    (folder / "hall.xml").write_text(WORLD)
    (folder / "drive.c").write_text(PROGRAM)
    path = folder / "trial.toml"
    speeds = [10 * number + 5 * (not fails) for number in range(1, programs + 1)]
    path.write_text(
        f'world = "hall.xml"\nprograms = ["drive.c"]\nseeds = {max(1, runs // programs)}\n'
        + ('measures = "measures.py"\n' if measures else "")
        + f"[parameters]\ndefine.SPEED = {speeds}\n"
    )
    (folder / "measures.py").write_text(MEASURES)
    return path


def local(path: Path, out: Path, jobs: int) -> None:
    """Run on this machine."""
    Sweep(path, out).run(jobs)


def workers_killed(path: Path, out: Path, jobs: int) -> None:
    """Run on this machine, and kill a worker after one run of fifty."""
    processes: list[subprocess.Popen[bytes]] = []
    start, chance = Worker._start, random.Random(1)

    def noting(worker: Worker) -> subprocess.Popen[bytes]:
        processes.append(start(worker))
        return processes[-1]

    def kill(_progress: Progress) -> None:
        if processes and chance.random() < 0.02:
            with suppress(ProcessLookupError):
                os.kill(processes[-1].pid, signal.SIGKILL)

    Worker._start = noting  # type: ignore[method-assign]
    try:
        Sweep(path, out).run(jobs, report=kill)
    finally:
        Worker._start = start  # type: ignore[method-assign]
    print(f"  {len(processes) - jobs} workers killed")


def resumed(path: Path, out: Path, jobs: int) -> None:
    """Run on this machine, kill it when it has a third of the rows, and go on."""
    command = [sys.executable, "-m", "crs_cc", "sweep", str(path), "--out", str(out)]
    process = subprocess.Popen([*command, "--jobs", str(jobs)])
    while _rows(out) < (_runs(path) + 2) // 3:
        time.sleep(0.01)
    process.kill()
    process.wait()
    print(f"  killed after {_rows(out)} rows")
    Sweep(path, out).run(jobs, resume=True)


def on_dask(path: Path, out: Path, _jobs: int) -> None:
    """Run on a cluster of three workers, and kill one of them."""
    from distributed import LocalCluster

    with LocalCluster(  # type: ignore[no-untyped-call]
        n_workers=3, threads_per_worker=1, dashboard_address=None
    ) as cluster:
        pid = cluster.workers[0].pid

        def kill(progress: Progress) -> None:
            if progress.done == progress.runs // 3:
                os.kill(pid, signal.SIGKILL)

        Sweep(path, out).run(1, dask=cluster.scheduler_address, report=kill)


# -- what it takes -------------------------------------------------------------------------------


def costs(folder: Path, runs: int, programs: int, jobs: int, *, measures: bool) -> None:
    """Print the processor time of a run and of its parts."""

    def sweep_s(name: str, count: int, *, fails: bool = False) -> float:
        path = experiment(folder / name, count, programs, measures=measures, fails=fails)
        before_s = _processor_s()
        Sweep(path, path.parent / "out").run(jobs)
        return _processor_s() - before_s

    few_s = sweep_s("few", programs)
    many_s = sweep_s("many", runs)
    failing_s = sweep_s("failing", runs, fails=True)
    run_ms = 1e3 * (many_s - few_s) / (runs - programs)
    creating_ms, running_ms = simulation_ms(folder / "many" / "trial.toml", min(runs, SIMULATED))
    failed = min(runs // programs, 100)
    print("processor time [ms]")
    print(f"  a run                  {run_ms:8.1f}")
    print(f"    its simulation       {running_ms:8.1f}")
    print(f"    overhead             {run_ms - running_ms:8.1f}")
    print(f"      creating a session {creating_ms:8.1f}")
    print(f"      all else           {run_ms - running_ms - creating_ms:8.1f}")
    print(f"  before the first run   {1e3 * few_s - programs * run_ms:8.0f}")
    print(f"  more for a failed run  {1e3 * (failing_s - many_s) / failed:8.1f}")


def simulation_ms(path: Path, runs: int) -> tuple[float, float]:
    """Return the processor time of creating a session, and of running it [ms]."""
    before = Path.cwd()
    os.chdir(path.parent)  # as processes that run a sweep do
    try:
        wanted = parse(path.read_text(), path)
        loader = VariantLoader(wanted, path.parent / "robots")
        creating_s = running_s = 0.0
        first = next(iter(runs_of(wanted)))
        variant = loader.load(first.parameters)
        for seed in range(-10, runs):  # the first ones load what comes later
            started_s = time.process_time()
            session = single_run.create(wanted, variant, seed + 10)
            created_s = time.process_time()
            single_run.run(wanted, session)
            if seed >= 0:
                creating_s += created_s - started_s
                running_s += time.process_time() - created_s
            del session
            gc.collect()
    finally:
        os.chdir(before)
    return 1e3 * creating_s / runs, 1e3 * running_s / runs


def _processor_s() -> float:
    """Return the processor time of this process and of those that have ended [s]."""
    return sum(os.times()[:4])


def _runs(path: Path) -> int:
    return sum(1 for _ in runs_of(parse(path.read_text(), path)))


def _rows(out: Path) -> int:
    path = out / "rows.jsonl"
    return path.read_bytes().count(b"\n") if path.exists() else 0


def main() -> None:
    """Run in all ways, and compare."""
    parser = argparse.ArgumentParser(description="Compare the tables of sweeps that are disturbed.")
    parser.add_argument("runs", type=int, nargs="?", default=600)
    parser.add_argument("--programs", type=int, default=10, help="of the runs (default 10)")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time (default 2)")
    parser.add_argument("--dask", action="store_true", help="also on a Dask cluster")
    parser.add_argument("--measures", action="store_true", help="with measures of one's own")
    parser.add_argument("--costs", action="store_true", help="only what a run takes")
    options = parser.parse_args()
    ways: list[Callable[[Path, Path, int], None]] = [local, workers_killed, resumed]
    if options.dask:
        ways.append(on_dask)
    if options.costs:
        ways = []
    if ways:
        print("way               ms a run   rows   memory MiB   same table")
    tables = []
    with tempfile.TemporaryDirectory() as folder:
        for way in ways:
            path = experiment(
                Path(folder, way.__name__),
                options.runs,
                options.programs,
                measures=options.measures,
            )
            out = path.parent / "out"
            started_s = time.monotonic()
            way(path, out, options.jobs)
            run_ms = 1e3 * (time.monotonic() - started_s) / _runs(path)
            tables.append((out / "runs.csv").read_bytes())
            memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
            same = "yes" if tables[-1] == tables[0] else "NO"
            print(f"{way.__name__:16} {run_ms:9.1f} {_rows(out):6} {memory:12.0f}   {same}")
        costs(Path(folder), options.runs, options.programs, options.jobs, measures=options.measures)


if __name__ == "__main__":
    main()
