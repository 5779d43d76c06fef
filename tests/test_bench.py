"""Every script in `bench/` runs to its end in its smallest size and prints what it measured."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.commands import python, python_in

BENCH = Path(__file__).parents[1] / "bench"

SMALLEST = {
    "builder.py": ["--no-browser", "20", "2"],
    "c_speed.py": ["--repeat", "1", "fib"],
    "compile.py": ["--lines", "80", "--repeat", "1", "--stages"],
    "debug.py": ["--minutes", "2", "--minute", "2", "--depth", "100", "1"],
    "hosts.py": ["--steps", "1", "--hosts", "1", "--", "2"],
    "environment.py": ["--seconds", "0", "--scouts", "1", "1"],
    "fields.py": ["--robots", "4", "--timesteps", "2"],
    "fleet.py": ["--rounds", "1", "1"],
    "messages.py": ["4"],
    "planted.py": ["first/const_local"],
    "python_env.py": ["--steps", "2", "1"],
    "ranges.py": ["1"],
    "record.py": ["--seconds", "1", "--repeat", "1", "1"],
    "quiet_time.py": ["--steps", "20", "--repeat", "1", "bits"],
    "requests.py": ["--steps", "3", "gs"],
    "start.py": ["--repeat", "1"],
    "sweep.py": ["--programs", "2", "--jobs", "1", "4"],
    "wander.py": ["--repeats", "1"],
    "workbench.py": ["--no-browser", "--pages", "2", "--seconds", "0.1", "4"],
}
"""Of each script, the arguments with which it measures least."""

MEASURED = {
    "builder.py": ["20 objects, 2 robots", "one changed: ", "all changed: "],
    "c_speed.py": ["crs unchecked", "\nfib ", "\nmean "],
    "compile.py": ["\nnew program ", "\nknown program ", "  lex ", "  generate "],
    "debug.py": ["run build", "reverse-continue, a minute", "goto the middle"],
    "hosts.py": ["\nwaiting ", "\ncomputing ", " 1 "],
    "environment.py": ["\n       1 ", "1 times a scout: ", "1 times a noisy scout: "],
    "fields.py": ["4 robots: a request ", " smelling ", " laying ", " tiles, "],
    "fleet.py": ["    bare request ", "      small loop "],
    "messages.py": [
        "4 robots to whom nobody speaks: ",
        "radio: ",
        "infrared: ",
        "local: ",
        "10 m: ",
    ],
    "planted.py": ["first/const_local: 1 programs", "  crs  ", "gcc, ASan and UBSan "],
    "python_env.py": ["\nGymEnv ", "\nEnv, 1 robot ", "vector_env, ", "\ngymnasium CartPole "],
    "ranges.py": ["camera, pixels ", "camera, blobs ", "laser, ranges ", "laser, points "],
    "record.py": ["sensors none", "sensors read", "JSON lines", "Parquet"],
    "quiet_time.py": ["\nas crs run ", "\nnothing skipped ", "\nbits ", "\nmean "],
    "requests.py": ["\ngs ", "aim: "],
    "start.py": ["python -c pass ", "crs --help ", "crs run, warm ", "crs run, empty cache "],
    "sweep.py": ["\nlocal ", "\nworkers_killed ", "\nresumed "],
    "wander.py": ["\ncalm time allowed ", "\nwithout calm time ", "the states are the same"],
    "workbench.py": ["frame bytes", "server %", "\n       4 "],
}
"""Of each script, words of what it prints."""

STARTING = """
import os, runpy, sys
_, sys.executable, *sys.argv = sys.argv
sys.path[0] = os.path.dirname(sys.argv[0])
runpy.run_path(sys.argv[0], run_name="__main__")
"""
"""Runs a script in which `sys.executable` is another command."""

KILLING = {"sweep.py"}
"""Scripts that go on with the files of a command that they have killed: a fork may end later."""


def test_every_script_has_a_smallest_size() -> None:
    texts = {path.name: path.read_text("utf-8") for path in BENCH.glob("*.py")}
    scripts = {name for name, text in texts.items() if f"python bench/{name}" in text}
    assert scripts == SMALLEST.keys() == MEASURED.keys()


@pytest.mark.parametrize("script", SMALLEST)
def test_a_script_measures_in_its_smallest_size(script: str, tmp_path: Path) -> None:
    started = sys.executable if script in KILLING else python_in(tmp_path)
    done = subprocess.run(
        python("-c", STARTING, started, BENCH / script, *SMALLEST[script]),
        check=False, capture_output=True, text=True, timeout=300,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    for words in MEASURED[script]:
        assert words in done.stdout
