"""A small experiment, and a pool that runs it without processes of its own."""

from __future__ import annotations

import json
import os
from collections.abc import Generator, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from crs_cc.jobs.pool import Outcome, Task
from crs_cc.sweeps import worker
from crs_cc.sweeps.sweep import Sweep

WORLD = """<world version="1" name="hall" duration="1s"><area length="6m" width="4m"/>
<box id="crate" x="3m" y="2m" length="40cm" width="40cm"/>
<robot id="a" x="1m" y="1m" setup="noisy"/>
<robot id="b" x="1m" y="3m"/>
<goal id="clean" points="2"><no-collision/></goal></world>
"""

PROGRAM = """#include "Nclient.h"
#include <stdio.h>
#include <stdlib.h>
#ifndef SPEED
#define SPEED 100
#endif
int main(int argc, char **argv)
{
    connect_robot(1);
    conf_tm(0);
    vm(SPEED, SPEED, 0);
    get_sn();
    if (argc > 1 && atoi(argv[1]) == 7) {
        int *nowhere = 0;
        return *nowhere;
    }
    printf("%d\\n", State[17]);
    for (;;)
        gs();
}
"""

EXPERIMENT = """world = "hall.xml"
programs = ["drive.c"]
seeds = 3
"""

MANY = """
[parameters]
define.SPEED = [50, 100]
argument.1 = [1, 7]
"""
"""Twelve runs, half of which fail."""


def write(folder: Path, more: str = "", experiment: str = EXPERIMENT) -> Path:
    """Write an experiment with its files; return its file."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "hall.xml").write_text(WORLD)
    (folder / "drive.c").write_text(PROGRAM)
    path = folder / "trial.toml"
    path.write_text(experiment + more)
    return path


@contextmanager
def _as_worker() -> Iterator[None]:
    """Do as a process of its own does."""
    before, worker._loaded = Path.cwd(), None
    run_forked, worker.run_forked = worker.run_forked, lambda compute: compute()  # no fork of this
    try:
        yield
    finally:
        os.chdir(before)
        worker._loaded, worker.run_forked = None, run_forked


def inline(tasks: Iterable[Task], _retries: int = 0) -> Generator[Outcome, None, None]:
    """Run tasks in this process."""
    with _as_worker():
        for number, task in enumerate(tasks):
            job = json.loads(json.dumps(task.job))
            result = worker._work(job, lambda: None)
            yield Outcome(number, json.loads(json.dumps(result)))


def swept(path: Path, out: Path, **options: bool) -> Sweep:
    """Run an experiment in this process."""
    sweep = Sweep(path, out)
    sweep.run(1, pool=inline, **options)
    return sweep
