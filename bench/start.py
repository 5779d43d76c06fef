"""Measures how long `crs run` takes for a program that prints hello, in an empty world.

Three states of the cache: empty (what it uses of the C library is compiled too), with the library
but not the program, and with both; and `crs --help`; against a bare start of Python. Wall time,
medians, taken in turns, with Python's own cache of compiled modules.

    python bench/start.py [--repeat N]
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

HELLO = '#include <stdio.h>\nint main(void) { printf("hello\\n"); return 0; }\n'
LIMITS = {"crs run, warm": 15.0}
"""What we allow, in bare starts of Python."""


def timed(command: list[str], environment: dict[str, str]) -> float:
    """Return the wall time of a command [s]."""
    start = time.perf_counter()
    subprocess.run(command, env=environment, check=True, capture_output=True)
    return time.perf_counter() - start


class Starts:
    """The kinds of start, in an order in which each leaves the cache that the next one needs."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.environment = {**os.environ, "CRS_CACHE": str(folder / "cache")}
        self.environment.pop("PYTHONDONTWRITEBYTECODE", None)
        (folder / "hello.c").write_text(HELLO)
        self.kinds: dict[str, Callable[[], float]] = {
            "python -c pass": self.python,
            "crs --help": self.help,
            "crs run, empty cache": self.empty,
            "crs run, new program": self.new_program,
            "crs run, warm": self.warm,
        }

    def run(self, program: str) -> float:
        command = [sys.executable, "-m", "crs_cc", "run", str(self.folder / program)]
        return timed(command, self.environment)

    def python(self) -> float:
        return timed([sys.executable, "-c", "pass"], self.environment)

    def help(self) -> float:
        return timed([sys.executable, "-m", "crs_cc", "--help"], self.environment)

    def empty(self) -> float:
        shutil.rmtree(self.folder / "cache", ignore_errors=True)
        return self.run("hello.c")

    def new_program(self) -> float:
        (self.folder / "other.c").write_text(HELLO.replace("hello", "other"))
        return self.run("other.c")

    def warm(self) -> float:
        return self.run("hello.c")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("--repeat", type=int, default=5, help="runs of each (default 5)")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        starts = Starts(Path(folder))
        starts.python()
        times: dict[str, list[float]] = {kind: [] for kind in starts.kinds}
        for _ in range(options.repeat):
            for kind, start in starts.kinds.items():
                times[kind].append(start())
    medians = {kind: statistics.median(rows) for kind, rows in times.items()}
    base = medians["python -c pass"]
    for kind, seconds in medians.items():
        limit = f"   (limit {LIMITS[kind]:.0f})" if kind in LIMITS else ""
        print(f"{kind:24}{seconds * 1000:8.0f} ms{seconds / base:8.1f} x python{limit}")


if __name__ == "__main__":
    main()
