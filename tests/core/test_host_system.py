"""What the host system is asked for."""

from __future__ import annotations

import subprocess
import sys

import pytest

FAULTS = """
import resource
import numpy as np
from crs_cc.core.host_system import keep_freed_memory

def faults():
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    for _ in range(100):
        [np.ones(40_000) for _ in range(8)]
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before

if keep_freed_memory():
    faults()
    print(faults())
"""


@pytest.mark.skipif(sys.platform != "linux", reason="counts page faults as Linux does")
def test_arrays_made_again_and_again_cause_no_page_faults() -> None:
    command = [sys.executable, "-c", FAULTS]
    made = subprocess.run(command, capture_output=True, text=True, check=False)
    if not made.stdout and not made.stderr:
        pytest.skip("the C library has no mallopt")
    assert int(made.stdout) < 100, made.stderr
