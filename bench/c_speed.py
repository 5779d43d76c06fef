"""Measures how fast compiled C runs in the sandbox, against gcc and tcc where they are present.

Every kernel in `kernels/` is a whole C program that prints a checksum. Only its run is measured,
never its compilation: in the sandbox the processor time of the rounds, for native programs their
processor time less that of an empty program compiled the same way. All ways of running take turns,
several times, and the least times are compared, which a busy machine disturbs least; so the ratios
mean something on any machine, the times do not.

    python bench/c_speed.py [--repeat N] [--compiler NAME] [KERNEL ...]
"""

from __future__ import annotations

import argparse
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.requests import FAILED
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_executable
from crs_cc.session.host import Host, HostRequest

KERNELS = Path(__file__).parent / "kernels"
FUEL = 10**12

GCC = ["gcc", "-std=gnu17", "-fno-strict-aliasing", "-w"]
SANITIZERS = ["-fsanitize=address,undefined"]
NATIVE = {
    "gcc -m32 -O0": [*GCC, "-m32", "-msse2", "-mfpmath=sse", "-O0"],
    "gcc -m32 -O2": [*GCC, "-m32", "-msse2", "-mfpmath=sse", "-O2"],
    "gcc -O0": [*GCC, "-O0"],
    "gcc -O2": [*GCC, "-O2"],
    "gcc sanitized": [*GCC, "-O1", *SANITIZERS],
    "tcc": ["tcc", "-w"],
}
"""Compilers and their options, for 64 bits without -m32; "sanitized" is -O1 with ASan and UBSan."""
SANDBOX = {"crs": True, "crs unchecked": False}
BASE = "gcc -O2"
ENVIRONMENT = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0"}

LIMITS = [
    ("geometric mean", "", "crs", 2.6),
    ("geometric mean", "", "crs unchecked", 2.0),
    ("recursive calls", "fib", "crs unchecked", 5.0),
    ("structs by value", "structs", "crs unchecked", 4.0),
]
"""What is aimed at: (what, kernel or all, way of running, most times as slow as the base)."""

Way = Callable[[], tuple[float, bytes]]
"""Run a kernel; gives its processor time [s] and what it printed."""


@dataclass
class InSandbox:
    """A kernel compiled by us."""

    executable: Executable

    def __call__(self) -> tuple[float, bytes]:
        printed: list[bytes] = []
        host = Host(
            [["kernel"]],
            lambda _robot, _stream, content: printed.append(content),
            lambda _r, _w: b"",
        )
        fleet = Fleet([self.executable])
        slot = fleet.slots[0]
        seconds = 0.0
        while host.exit_status[0] is None:
            slot["run"], slot["fuel"] = 1, FUEL
            start = time.process_time()
            fleet.run_round()
            seconds += time.process_time() - start
            if slot["status"] == FAILED:
                sys.exit(f"{self.executable.name}: {fleet.failure(0)}")
            host.serve(int(slot["code"]), HostRequest(0, slot["message"]))
        return seconds, b"".join(printed)


@dataclass
class AsProcess:
    """A kernel compiled to a native program."""

    program: Path
    start_s: float = 0.0

    def __call__(self) -> tuple[float, bytes]:
        before_s = children_s()
        done = subprocess.run([self.program], check=True, capture_output=True, env=ENVIRONMENT)
        return max(children_s() - before_s - self.start_s, 1e-6), done.stdout


def children_s() -> float:
    """Return the processor time of all child processes that have ended [s]."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def compile_native(source: Path, command: list[str], folder: Path) -> Path | None:
    """Return the program that a compiler makes of a file; None where it cannot."""
    if shutil.which(command[0]) is None:
        return None
    program = folder / f"{source.stem}{'_'.join(command)}"
    done = subprocess.run(
        [*command, str(source), "-o", str(program), "-lm"], check=False, capture_output=True
    )
    return program if done.returncode == 0 else None


def ways_to_run(source: Path, folder: Path, starts_s: dict[str, float]) -> dict[str, Way]:
    """Return every way in which a kernel can be run here."""
    ways: dict[str, Way] = {}
    for name, start_s in starts_s.items():
        program = compile_native(source, NATIVE[name], folder)
        if program is not None:
            ways[name] = AsProcess(program, start_s)
    for name, checked in SANDBOX.items():
        ways[name] = InSandbox(build_executable([source], Diagnostics(), checked=checked))
    return ways


def process_starts(compilers: list[str], folder: Path, repeat: int) -> dict[str, float]:
    """Return the processor time of an empty program of each compiler that works here [s]."""
    source = folder / "empty.c"
    source.write_text("int main(void) { return 0; }\n")
    starts_s = {}
    for name in compilers:
        program = compile_native(source, NATIVE[name], folder)
        if program is not None:
            empty = AsProcess(program)
            starts_s[name] = min(empty()[0] for _ in range(repeat))
    return starts_s


def measure(ways: dict[str, Way], repeat: int) -> dict[str, float]:
    """Return the least time of each way [s]; the ways take turns."""
    times: dict[str, list[float]] = {name: [] for name in ways}
    outputs = set()
    for _ in range(repeat):
        for name, way in ways.items():
            seconds, output = way()
            times[name].append(seconds)
            outputs.add(output)
    if len(outputs) != 1:
        sys.exit(f"different results: {outputs}")
    return {name: min(rows) for name, rows in times.items()}


def print_table(results: dict[str, dict[str, float]]) -> None:
    """Print the time of each way over that of the base, and geometric means."""
    names = list(dict.fromkeys(name for row in results.values() for name in row))
    base = BASE if BASE in names else names[0]
    print(f"\ntime over {base}; geometric means below")
    print(f"{'':16}" + "".join(f"{name:>15}" for name in names) + f"{base + ' [ms]':>16}")
    ratios: dict[str, list[float]] = {name: [] for name in names}
    for kernel, row in results.items():
        line = f"{kernel:16}"
        for name in names:
            ratios[name].append(row[name] / row[base])
            line += f"{ratios[name][-1]:15.2f}"
        print(line + f"{row[base] * 1000:16.0f}")
    means = {name: statistics.geometric_mean(rows) for name, rows in ratios.items()}
    print(f"{'mean':16}" + "".join(f"{mean:15.2f}" for mean in means.values()))
    print()
    for what, kernel, name, most in LIMITS:
        if not kernel or kernel in results:
            reached = results[kernel][name] / results[kernel][base] if kernel else means[name]
            print(f"{what}, {name}: {reached:.2f} times {base}, aim {most}")
    print("Only the ratios mean something on another machine.")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("kernels", nargs="*", help="names of kernels; all by default")
    parser.add_argument("--repeat", type=int, default=7, help="runs of each (default 7)")
    parser.add_argument(
        "--compiler", action="append", choices=NATIVE, help="compare with this one; repeatable"
    )
    options = parser.parse_args()
    sources = sorted(KERNELS.glob("*.c"))
    if options.kernels:
        sources = [source for source in sources if source.stem in options.kernels]
    if not sources:
        parser.error(f"no such kernel in {KERNELS}")
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        starts_s = process_starts(options.compiler or list(NATIVE), Path(folder), options.repeat)
        for source in sources:
            print(f"{source.stem} ...", file=sys.stderr)
            ways = ways_to_run(source, Path(folder), starts_s)
            results[source.stem] = measure(ways, options.repeat)
    print_table(results)


if __name__ == "__main__":
    main()
