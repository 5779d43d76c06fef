"""Run a C program compiled by gcc and by crs, and compares the results.

gcc compiles at -O0 and -O2: if the two disagree, the program is undefined and is not compared. Our
programs run checked and unchecked.
"""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator, Sequence
from pathlib import Path

from crs_cc.core.errors import CrsError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_file
from crs_cc.ir.verify import verify
from crs_cc.runtime.executable import make_executable
from crs_cc.runtime.link import link
from crs_cc.session.library import HEADERS, library
from tests.c.execution import Run, Stepping
from tests.gcc import Result, complaint, run

STRICT = [
    "-O1", "-Werror=uninitialized", "-Werror=return-type", "-Werror=implicit-function-declaration",
]  # fmt: skip
SANITIZERS = [
    "-fsanitize=address,undefined", "-fno-sanitize=signed-integer-overflow,shift",
    "-fno-sanitize-recover=all",
]  # fmt: skip
_EXACT = ["-w", "-frounding-math"]
"""Without the second, gcc 12 computes 0.0 - n as -n, which is -0.0 for an integer 0."""
NATIVE_SECONDS = 3.0
COMPILE_SECONDS = 60
FUEL, ROUNDS = 3 * 10**9, 10**5


def gcc_result(source: Path, options: Sequence[str]) -> Result | None:
    """Return the result of gcc's program; None if there is none, or it takes too long."""
    program = source.with_suffix(".exe")
    if complaint([source], program, options):
        return None
    return run(program, NATIVE_SECONDS)


def meaning(source: Path, options: Sequence[str] = ()) -> Result | None:
    """Return the expected result; None if gcc's own results disagree."""
    plain = gcc_result(source, [*options, *_EXACT, "-O0"])
    if plain is None or plain.end.startswith("exit -"):
        return None
    return plain if gcc_result(source, [*options, *_EXACT, "-O2"]) == plain else None


def is_defined(source: Path, options: Sequence[str] = ()) -> bool:
    """Return whether gcc's warnings, and its sanitizers if installed, find nothing wrong."""
    if gcc_result(source, [*options, *STRICT]) is None:
        return False
    found = gcc_result(source, [*options, *STRICT, *SANITIZERS])
    return found is None or not (found.end == "exit 1" or found.end.startswith("exit -"))


@contextlib.contextmanager
def _time_limit(seconds: int) -> Iterator[None]:
    def stop(_signal: int, _frame: object) -> None:
        raise TimeoutError

    previous = signal.signal(signal.SIGALRM, stop)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, previous)


def our_results(source: Path, include_paths: Sequence[Path] = ()) -> dict[str, Result]:
    """Return the result of our program in each build."""
    diagnostics = Diagnostics()
    options = Options(tuple(include_paths), (HEADERS,))
    try:
        with _time_limit(COMPILE_SECONDS):
            unit = compile_file(source, options, diagnostics)
            verify(unit)
            program = link([unit], library(), diagnostics)
    except TimeoutError:
        return {"compiler": Result(b"", "compiling takes too long")}
    except CrsError as error:
        return {"compiler": Result(b"", f"refused: {error}")}
    except Exception as error:  # whatever it is, it is a finding
        return {"compiler": Result(b"", f"traceback: {error!r}")}
    results = {}
    for name, checked in (("checked", True), ("unchecked", False)):
        stepped = Run(make_executable(program, source.name, checked=checked), Stepping(FUEL // 10))
        outcome = stepped.up_to(FUEL, ROUNDS)
        end = f"exit {outcome.status}"
        if outcome.failure is not None:
            end = f"{outcome.failure.kind}: {outcome.failure}"
        elif outcome.status is None:
            end = "does not end"
        results[name] = Result(outcome.output, end)
    return results


def difference(wanted: Result, results: dict[str, Result]) -> str | None:
    """Return a short description of the difference from the expected result, None if none."""
    for way, result in results.items():
        if result == wanted:
            continue
        if result.end != wanted.end:
            return f"{way}: {result.end[:200]}, gcc: {wanted.end}"
        for ours, theirs in zip(
            result.output.split(b"\n"), wanted.output.split(b"\n"), strict=False
        ):
            if ours != theirs:
                return f"{way}: {ours.decode('latin-1')!r}, gcc: {theirs.decode('latin-1')!r}"
        return f"{way}: the output ends too soon or too late"
    return None
