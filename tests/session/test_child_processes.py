"""Sessions in child processes, however they are started: for sweeps over many runs."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = """
#include "Nclient.h"
int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 5; i++) { vm(100, 100, 0); gs(); }
    return State[1] & 127;
}
"""

RUNS = """
import multiprocessing, sys
import crs_cc

WORLD = b'''<world version="1"><area length="3m" width="3m"/>
<robot setup="noisy" x="1m" y="1m"/><robot x="2m" y="2m"/></world>'''

def run(folder):
    from crs_cc.runtime import fleet
    from crs_cc.sim.files.world_xml import parse_world
    fleet.PARALLEL_S = -1.0  # threads for every round
    programs = [crs_cc.compile_c(folder + "/drive.c")] * 2
    session = crs_cc.Session(parse_world(WORLD, "room"), programs, seed=3, threads=2)
    while session.step():
        pass
    return session.state_hash()

if __name__ == "__main__":
    ours = run("parent")
    # A fork has whatever the compiler has started.
    with multiprocessing.get_context(sys.argv[1]).Pool(1) as pool:
        child = pool.apply_async(run, ("child",))  # for which nothing is in the cache
        assert child.get(timeout=100) == ours
"""


@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_a_child_compiles_and_runs_after_its_parent_did(method: str, tmp_path: Path) -> None:
    """A forked child waited forever for threads of the compiler that it did not have.

    Threads that run programs are not inherited, either: a child starts its own.
    """
    for whose in ("parent", "child"):
        (tmp_path / whose).mkdir()
        (tmp_path / whose / "drive.c").write_text(PROGRAM)
    (tmp_path / "runs.py").write_text(RUNS)
    done = subprocess.run(
        [sys.executable, "runs.py", method],
        check=False, capture_output=True, text=True, timeout=200, cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
