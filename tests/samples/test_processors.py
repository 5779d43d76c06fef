"""Runs have the same state hashes on processors with fewer instructions.

numpy leaves out those that the environment names, and the C library of Linux those that its
tunables name: there are fewer of them, but never more, than the processor has.
"""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from tests.samples.driving import ROOT

WITHOUT_AVX512 = {"NPY_DISABLE_CPU_FEATURES": "X86_V4 AVX512_ICL"}
WITHOUT_AVX2_AND_FMA = {"NPY_DISABLE_CPU_FEATURES": "X86_V3 X86_V4 AVX512_ICL"}
OTHER_LIBRARY = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA,-FMA4"}
FEWER = [WITHOUT_AVX512 | OTHER_LIBRARY, WITHOUT_AVX2_AND_FMA]

ARCTAN2 = (
    "import math, numpy as np; x = np.linspace(0.1, 9, 9999);"
    "print(hash((np.arctan2(x, 0.7).tobytes(), ((x + 2j) * (x - 1j)).tobytes())),"
    "hash(tuple(map(math.sin, x))))"
)


def output(command: list[str], environment: dict[str, str]) -> str:
    names = ("NPY_DISABLE_CPU_FEATURES", "GLIBC_TUNABLES")
    inherited = {name: value for name, value in os.environ.items() if name not in names}
    done = subprocess.run(
        [sys.executable, *command],
        env={**inherited, "PYTHONHASHSEED": "0", **environment},
        capture_output=True, text=True, check=False, cwd=ROOT,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_state_hashes_do_not_depend_on_the_processor(subtests: pytest.Subtests) -> None:
    arctan2 = output(["-c", ARCTAN2], {})
    hashes = output(["-m", "tests.samples.hashes"], {})
    for fewer in FEWER:
        with subtests.test(" ".join(fewer.values())):
            if output(["-c", ARCTAN2], fewer) == arctan2:
                pytest.skip("this processor, or this library, has no such instructions")
            assert output(["-m", "tests.samples.hashes"], fewer) == hashes
