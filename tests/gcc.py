"""The compiler that judges ours: gcc for i386, where it is installed; no test may need it."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

GCC = [
    "gcc", "-std=gnu17", "-m32", "-malign-double", "-msse2", "-mfpmath=sse",
    "-ffp-contract=off", "-fwrapv", "-fno-strict-aliasing", "-fcommon",
]  # fmt: skip
"""The C that we promise: i386's sizes, doubles that are doubles, signed overflow that wraps."""

QUICK = ["-pipe", "-fno-use-linker-plugin", *(["-fuse-ld=gold"] if shutil.which("ld.gold") else [])]
"""What changes the time that gcc takes, but not what a program does."""

ENVIRONMENT = {"TZ": "UTC", "LC_ALL": "C"}
"""All that a program of gcc's finds in its environment, on every machine."""


@dataclass(frozen=True)
class Result:
    """What a program did: its output and how it ended."""

    output: bytes
    end: str


def complaint(sources: Sequence[Path], program: Path, options: Sequence[str] = ()) -> str:
    """Compiles a program with gcc, and gives why it cannot be; nothing if it can."""
    command = [*GCC, *QUICK, *options, *map(str, sources), "-o", str(program), "-lm"]
    try:
        done = subprocess.run(command, check=False, capture_output=True)
    except OSError as error:
        return f"gcc: {error.strerror}"
    if done.returncode == 0:
        return ""
    return done.stderr.decode(errors="replace") or f"gcc ends with status {done.returncode}"


def run(program: Path, longest_s: float) -> Result | None:
    """Run a compiled program in its own folder; None if it takes too long, or cannot start."""
    try:
        done = subprocess.run(
            [program], check=False, stdin=subprocess.DEVNULL, capture_output=True,
            timeout=longest_s, cwd=program.parent, env=ENVIRONMENT,
        )  # fmt: skip
    except (subprocess.TimeoutExpired, OSError):
        return None
    return Result(done.stdout, f"exit {done.returncode}")


@cache
def why_not() -> str:
    """Return why nothing can be compared with gcc here; nothing if it can."""
    with tempfile.TemporaryDirectory() as folder:
        source, program = Path(folder, "probe.c"), Path(folder, "probe")
        source.write_text('#include <stdio.h>\nint main(void) { puts("runs"); return 0; }\n')
        said = complaint([source], program)
        if said:
            return f"it cannot compile a program of 32 bits: {said.strip().splitlines()[0]}"
        if run(program, 10.0) != Result(b"runs\n", "exit 0"):
            return "programs of 32 bits do not run"
    return ""
