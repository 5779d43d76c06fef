"""Measures how many planted errors are found, beside sanitizers of gcc and clang, and valgrind.

The programs are in `tests/c/planted`. Each way of finding errors is asked three things: is the
program with the error stopped or reported, on the line of the error, and is the same program
without the error left alone?

    python bench/planted.py [--verbose] [NAMES ...]

Each NAMES is a pattern of programs, such as `first/*` or `first/const_local`.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))

from tests.c.planted_errors import RIGHT, WRONG, Found, Planted, look, planted

OPTIONS = ["-std=gnu17", "-g", "-w", "-fno-common"]
GCC = ["gcc", *OPTIONS]
SANITIZERS = ["-O1", "-fno-omit-frame-pointer", "-fsanitize=address,undefined"]
PAIRS = ["-fsanitize=pointer-compare,pointer-subtract"]
CLANG = next(filter(shutil.which, ["clang", "clang-14"]), "")
MEMORY = ["-O1", "-fno-omit-frame-pointer", "-fsanitize=memory"]
NEEDED = {
    "gcc, ASan and UBSan": ["gcc", *SANITIZERS],
    "clang, ASan and UBSan": [CLANG, *SANITIZERS],
    "clang, MSan": [CLANG, *MEMORY],
    "valgrind": ["gcc" if shutil.which("valgrind") else ""],
}
"""The compiler and the options of each other way; the libraries of sanitizers may be missing."""
REPORT = r"(?:ERROR|WARNING): \w+Sanitizer|runtime error: "
ASAN = "detect_stack_use_after_return=1:detect_invalid_pointer_pairs=2:strict_string_checks=1"
ENVIRONMENT = {**os.environ, "ASAN_OPTIONS": ASAN, "UBSAN_OPTIONS": "print_stacktrace=1"}
TIMEOUT_S = 20

Way = Callable[[Planted, str], Found]


@dataclass
class Tally:
    """What one way has found."""

    found: list[str] = field(default_factory=list)
    on_line: list[str] = field(default_factory=list)
    clean: list[str] = field(default_factory=list)


def crs(case: Planted, definition: str) -> Found:
    """Run in the sandbox."""
    return look(case.path, definition)


def crs_trapping(case: Planted, definition: str) -> Found:
    """Run in the sandbox with `--trap-overflow`."""
    return look(case.path, definition, trap_overflow=True)


def sanitized(case: Planted, definition: str) -> Found:
    """Run with gcc's ASan and UBSan."""
    return _native(case, definition, [*GCC, *SANITIZERS, *PAIRS], [], REPORT)


def sanitized_by_clang(case: Planted, definition: str) -> Found:
    """Run with clang's ASan and UBSan."""
    return _native(case, definition, [CLANG, *OPTIONS, *SANITIZERS], [], REPORT)


def memory_sanitized(case: Planted, definition: str) -> Found:
    """Run with clang's MSan."""
    return _native(case, definition, [CLANG, *OPTIONS, *MEMORY], [], REPORT)


def valgrind(case: Planted, definition: str) -> Found:
    """Run in valgrind's memcheck."""
    command = ["valgrind", "-q", "--leak-check=full", "--error-exitcode=99"]
    return _native(case, definition, [*GCC, "-O0"], command, r"==\d+== +(?=\w)")


def _native(
    case: Planted, definition: str, compiler: list[str], command: list[str], mark: str
) -> Found:
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program"
        build = [*compiler, "-D", definition, str(case.path), "-o", str(program), "-lm"]
        subprocess.run(build, check=True, capture_output=True)
        try:
            done = subprocess.run(
                [*command, program], check=False, capture_output=True, env=ENVIRONMENT,
                timeout=TIMEOUT_S,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return Found()
    text = done.stderr.decode(errors="replace")
    if re.search(mark, text):
        place = re.search(rf"{re.escape(case.path.name)}:(\d+)", text)
        return Found("error", text, int(place[1]) if place else 0)
    return Found("crash") if done.returncode < 0 else Found()


def _links(tool: str, flags: list[str]) -> bool:
    """Return whether a compiler is there, with what programs with these options need."""
    if not shutil.which(tool):
        return False
    command = [tool, *flags, "-xc", "-", "-o", os.devnull]
    program = b"int main(void) { return 0; }"
    return subprocess.run(command, input=program, check=False, capture_output=True).returncode == 0


def matches(case: Planted, found: Found) -> bool:
    """Return whether the planted error was found, and not something else by our own checks."""
    if case.severity == "warning":
        return case.text in found.text or found.severity == "error"
    return found.severity not in {"", "warning"}


def main() -> None:
    """Print the comparison."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", default=["first/*", "second/*", "third/*", "fourth/*"])
    parser.add_argument("--verbose", action="store_true", help="name what was not found")
    parser.add_argument("--only-crs", action="store_true", help="leave the other tools out")
    options = parser.parse_args()
    ways: dict[str, Way] = {"crs": crs}
    if not options.only_crs:
        ways["crs --trap-overflow"] = crs_trapping
        ways["gcc, ASan and UBSan"] = sanitized
        ways["clang, ASan and UBSan"] = sanitized_by_clang
        ways["clang, MSan"] = memory_sanitized
        ways["valgrind"] = valgrind
        missing = [name for name, (tool, *flags) in NEEDED.items() if not _links(tool, flags)]
        for name in missing:
            print(f"not installed, or not whole: {name}")
            del ways[name]
    for names in options.names:
        cases = list(planted(names))
        print(f"{names}: {len(cases)} programs")
        for name, way in ways.items():
            _print(name, cases, _measure(way, cases), verbose=options.verbose)


def _measure(way: Way, cases: list[Planted]) -> Tally:
    tally = Tally()
    for case in cases:
        found = way(case, WRONG)
        if matches(case, found):
            tally.found.append(case.name)
            if found.line == case.line:
                tally.on_line.append(case.name)
        if not way(case, RIGHT).severity:
            tally.clean.append(case.name)
    return tally


def _print(name: str, cases: list[Planted], tally: Tally, *, verbose: bool) -> None:
    rows = tally.found, tally.on_line, tally.clean
    counts = "   ".join(
        f"{what} {len(row)}"
        for what, row in zip(("found", "on the line", "twins clean"), rows, strict=True)
    )
    print(f"  {name:23} {counts}")
    if verbose:
        for what, row in zip(("not found", "other line", "twin blamed"), rows, strict=True):
            before = tally.found if what == "other line" else [case.name for case in cases]
            missing = [each for each in before if each not in row]
            print(f"      {what}: {' '.join(missing) or 'none'}")


if __name__ == "__main__":
    main()
