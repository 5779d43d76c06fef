"""How `crs` starts as a process, what it loads, and how it ends."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.commands import python

HELLO = '#include <stdio.h>\nint main(void) { printf("hello\\n"); return 0; }\n'

ROOM = """<world version="1"><area length="6m" width="5m"/>
  <robot x="1m" y="1m"/><box x="3m" y="3m" length="1m" width="1m"/></world>"""

NOISE = """#include <stdio.h>
#include "Nclient.h"
int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 16; i++) { vm(100, 100, 0); gs(); printf("%ld %ld\\n", State[1], State[41]); }
    return 0;
}
"""

START = "from crs_cc.cli.process import start; start()"

NEW_WORLD = """
import os
from crs_cc.session import empty_world
device_sources = empty_world.device_sources
empty_world.device_sources = lambda: device_sources() + os.getcwd()
"""
"""Gives the empty world another name in the cache, which does not have it at first."""

LOADED = """
import sys
from crs_cc.cli.main import main
status = main(sys.argv[1:])
print(*sys.modules, file=sys.stderr)
sys.exit(status)
"""

COMPILES = {
    "pycparser",
    "crs_cc.ir.program",
    "crs_cc.frontend.unit",
    "crs_cc.runtime.codegen.module",
    "crs_cc.runtime.wasm",
}
READS_WORLDS = {"lxml.etree", "crs_cc.sim.files.world_xml"}
SLOW = {
    "PIL",
    "importlib.metadata",
    "json",
    "logging",
    "numpy.ma",
    "numpy.random",
    "rich",
    "statistics",
    "tempfile",
    "textual",
    "crs_cc.plot.picture",
}
"""What only some runs need."""


def crs(
    folder: Path, code: str, *arguments: str, **variables: str
) -> subprocess.CompletedProcess[str]:
    """Run Python code with arguments, by default with a cache of its own."""
    return subprocess.run(
        [sys.executable, "-c", code, *arguments],
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
        env={**os.environ, "CRS_CACHE": str(folder / "cache"), **variables},
    )


def loaded(folder: Path, *arguments: str) -> set[str]:
    """Return the modules that a run loads for what is in the cache that tests share."""
    (folder / "hello.c").write_text(HELLO)
    (folder / "room.xml").write_text(ROOM)
    for _ in range(2):
        done = crs(folder, LOADED, "run", "hello.c", *arguments, CRS_CACHE=os.environ["CRS_CACHE"])
        assert (done.returncode, done.stdout) == (0, "hello\n"), done.stderr
    return set(done.stderr.split())


def test_a_known_program_in_no_world_loads_only_what_it_runs_with(
    tmp_path: Path,
) -> None:
    modules = loaded(tmp_path)
    assert not modules & (COMPILES | READS_WORLDS | SLOW | {"pymunk"})
    assert "wasmtime" in modules


def test_a_known_program_in_a_room_without_contact_needs_no_pymunk(
    tmp_path: Path,
) -> None:
    modules = loaded(tmp_path, "room.xml")
    assert not modules & (COMPILES | {"numpy.ma", "pymunk"})  # np.unique loads numpy.ma
    assert modules > READS_WORLDS


@pytest.mark.parametrize("robot", [[], ["--robot", "pioneer2dx"], ["--setup", "noisy"]], ids=str)
def test_the_empty_world_from_the_cache_is_the_one_that_was_read(
    robot: list[str], tmp_path: Path
) -> None:
    (tmp_path / "noise.c").write_text(NOISE)
    command = python("-c", NEW_WORLD + START, "run", "--json", *robot, "noise.c")
    read, cached = (
        json.loads(subprocess.run(command, capture_output=True, check=True, cwd=tmp_path).stdout)
        for _ in range(2)
    )
    assert read["robots"] == cached["robots"]
    assert read["state_hash"] == cached["state_hash"]
    assert read["robots"][0]["stdout"].count("\n") == 16


def ends(
    folder: Path, before: str, code: str = "exit_process(3)"
) -> subprocess.CompletedProcess[str]:
    return crs(
        folder, f"import atexit, sys\nfrom crs_cc.cli.process import exit_process\n{before}\n{code}"
    )


def test_exiting_flushes_output_and_runs_exit_handlers(tmp_path: Path) -> None:
    before = (
        "atexit.register(print, 'handler'); print('out'); print('err', end='', file=sys.stderr)"
    )
    done = ends(tmp_path, before)
    assert (done.returncode, done.stdout, done.stderr) == (3, "out\nhandler\n", "err")


def test_leaving_ends_at_once(tmp_path: Path) -> None:
    """Objects that are still in use are not freed one by one."""
    done = ends(tmp_path, "class Slow:\n    def __del__(self): print('freed')\nslow = Slow()")
    assert (done.returncode, done.stdout) == (3, "")


def test_leaving_waits_for_other_threads(tmp_path: Path) -> None:
    before = "import threading, time\n"
    before += "threading.Thread(target=lambda: (time.sleep(0.2), print('done'))).start()"
    done = ends(tmp_path, before)
    assert (done.returncode, done.stdout) == (3, "done\n")


def test_leaving_returns_to_a_profiler(tmp_path: Path) -> None:
    code = "try: exit_process(3)\nexcept SystemExit as end: print('returned', end.code)"
    done = ends(tmp_path, "sys.setprofile(lambda *_: None)", code)
    assert done.stdout == "returned 3\n"


def test_a_full_disk_at_the_end_is_reported(tmp_path: Path) -> None:
    before = "sys.stdout = open('/dev/full', 'w'); print('lost')"
    done = ends(tmp_path, before)
    assert done.returncode != 3
    assert "No space left on device" in done.stderr


def test_blas_starts_no_threads_unless_the_user_wants_them(tmp_path: Path) -> None:
    code = "import atexit, os\n"
    code += "atexit.register(lambda: print(os.environ['OPENBLAS_NUM_THREADS']))\n" + START
    alone = crs(tmp_path, code, "--version")
    assert alone.stdout.splitlines()[1] == "1"
    chosen = crs(tmp_path, code, "--version", OPENBLAS_NUM_THREADS="2")
    assert chosen.stdout.splitlines()[1] == "2"
