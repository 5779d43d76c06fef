"""Nothing that only Unix has is needed: one module knows the differences, and crs runs without."""

from __future__ import annotations

import ast
import os
import platform
import re
import subprocess
import sys
from pathlib import Path

from tests.without_unix.unix_names import MODULES, NAMES

ROOT = Path(__file__).parents[1]
KNOWS = ROOT / "crs_cc" / "core" / "host_system.py"
ALLOWED = {
    "crs_cc/jobs/pool.py": {"killpg"},  # each of these does without it:
    "crs_cc/jobs/forked.py": {"fork"},
    "crs_cc/jobs/memory_limit.py": {"resource"},
    "crs_cc/jobs/worker.py": {"fork", "select"},
    "crs_cc/sweeps/rows.py": {"fcntl"},
    "crs_cc/cli/real_network.py": {"select"},  # of sockets, which all systems have
    "crs_cc/net/local_socket.py": {"geteuid"},
    "crs_cc/debug/repl/keyboard.py": {"readline"},
    "crs_cc/runtime/resident_pages.py": {"pread"},  # where host_system has opened a page map
}
TESTS = (
    "tests/cli/test_save_files.py::test_links_and_devices_are_not_followed",
    "tests/cli/test_save_files.py::test_a_named_file_is_readable_and_a_written_one_is_saved",
    "tests/cli/test_typed_input.py",
    "tests/debug/dap/test_processes.py::test_compiler_messages_reach_the_client",
    "tests/debug/test_scripts.py::test_script_output[scripts]",
    "tests/recording/test_replay.py::test_the_same_run_is_verified",
    "tests/runtime/test_resident_pages.py",
    "tests/session/test_files.py",
    "tests/sim/files/test_image.py",
    "tests/toolchain/test_cache_size.py",
)
"""Tests of each part that would use such names, and of programs that are compiled and run."""

SPAWNS = """
import multiprocessing, os
import crs_cc
from crs_cc.sim.files.world_xml import empty_world

def run():
    assert not hasattr(os, "uname")
    session = crs_cc.Session(empty_world(), [crs_cc.compile_c("drive.c")])
    while session.step():
        pass
    return session.state_hash()

if __name__ == "__main__":
    with multiprocessing.Pool(1) as pool:
        assert pool.apply(run) == run()
"""
DRIVES = (
    '#include "Nclient.h"\nint main(void) { connect_robot(1); pr(90, 90, 0); ws(1, 1, 0, 5); }\n'
)

MENTION = re.compile(rf"\b({'|'.join((*MODULES, *NAMES, 'select'))})\b")


def unix_names(text: str) -> set[str]:
    """Return the modules and names of `os` in a file that only Unix has."""
    found: set[str] = set()
    if not MENTION.search(text):  # most files: to parse all takes long
        return found
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names} & {*MODULES, "select"}
        elif isinstance(node, ast.ImportFrom):
            found |= {node.module or ""} & {*MODULES, "select"}
        elif isinstance(node, ast.Attribute) and node.attr in NAMES:
            found |= {node.attr} if ast.unparse(node.value) == "os" else set()
    return found


def test_only_one_module_names_what_only_unix_has() -> None:
    assert {"uname", "select", "resource"} <= unix_names(KNOWS.read_text("utf-8"))
    for path in (ROOT / "crs_cc").rglob("*.py"):
        if path != KNOWS:
            allowed = ALLOWED.get(path.relative_to(ROOT).as_posix(), set())
            assert unix_names(path.read_text("utf-8")) == allowed, path


def without_unix(
    *arguments: str, folder: Path = ROOT, **variables: str
) -> subprocess.CompletedProcess[str]:
    """Run Python without what only Unix has, with the library that tests have compiled."""
    paths = [str(ROOT / "tests" / "without_unix"), str(ROOT), os.environ.get("PYTHONPATH", "")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    environment.pop("PYTEST_XDIST_WORKER", None)
    environment |= {"PROCESSOR_ARCHITECTURE": platform.machine(), **variables}  # as Windows does
    return subprocess.run(
        [sys.executable, *arguments],
        cwd=folder, env=environment, check=False, capture_output=True, text=True,
    )  # fmt: skip


def test_tests_of_all_parts_pass_without_it() -> None:
    # As a further worker, whose folder is beside the cache: the library is compiled once.
    folder = Path(os.environ["CRS_CACHE"]).parent / "without_unix"
    options = ["-p", "no:cacheprovider", "-n", "0", "--basetemp", str(folder)]
    done = without_unix("-m", "pytest", *options, *TESTS, PYTEST_XDIST_WORKER="without_unix")
    assert done.returncode == 0, done.stdout[-5000:] + done.stderr[-1000:]


def test_a_spawned_child_runs_programs_without_it(tmp_path: Path) -> None:
    (tmp_path / "drive.c").write_text(DRIVES)
    (tmp_path / "runs.py").write_text(SPAWNS)
    done = without_unix("runs.py", folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
