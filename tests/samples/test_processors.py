"""Runs have the same state hashes on processors with fewer instructions.

numpy leaves out those that the environment names, and the C library of Linux those that its
tunables name: there are fewer of them, but never more, than the processor has.
"""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from tests.samples import hashes
from tests.samples.driving import ROOT

WITHOUT_AVX512 = {"NPY_DISABLE_CPU_FEATURES": "X86_V4 AVX512_ICL"}
WITHOUT_AVX2_AND_FMA = {"NPY_DISABLE_CPU_FEATURES": "X86_V3 X86_V4 AVX512_ICL"}
OTHER_LIBRARY = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA,-FMA4"}
FEWER = [WITHOUT_AVX512 | OTHER_LIBRARY, WITHOUT_AVX2_AND_FMA]


def with_fewer(instructions: dict[str, str]) -> list[str]:
    """Return what `hashes.py` writes in a process with fewer instructions."""
    done = subprocess.run(
        [sys.executable, "-m", "tests.samples.hashes"],
        env={**os.environ, **instructions},
        capture_output=True, text=True, check=False, cwd=ROOT,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_state_hashes_do_not_depend_on_the_processor(subtests: pytest.Subtests) -> None:
    ours = list(hashes.hashes())
    for fewer in FEWER:
        with subtests.test(" ".join(fewer.values())):
            instructions, *found = with_fewer(fewer)
            if instructions == hashes.instructions():
                pytest.skip("this processor, or this library, has no such instructions")
            assert found == ours
