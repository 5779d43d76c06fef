"""What the host system is asked for."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys

import pytest

from crs_cc.core.host_system import KeptProcessor

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


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux has this")
def test_a_thread_is_kept_on_its_processor_for_a_block_and_then_is_as_before() -> None:
    before = os.sched_getaffinity(0)
    try:
        for usable in (before, {min(before)}):
            os.sched_setaffinity(0, usable)
            for error in (None, KeyboardInterrupt):
                expected = pytest.raises(error) if error else contextlib.nullcontext()
                with expected, KeptProcessor():
                    kept = os.sched_getaffinity(0)
                    if error:
                        raise error
                assert len(kept) == 1
                assert kept <= usable
                assert os.sched_getaffinity(0) == usable
    finally:
        os.sched_setaffinity(0, before)


def test_where_a_thread_cannot_be_kept_the_block_is_run(monkeypatch: pytest.MonkeyPatch) -> None:
    def forbid(*_: object) -> None:
        raise PermissionError

    monkeypatch.setattr(os, "sched_setaffinity", forbid, raising=False)
    with KeptProcessor():
        done = True
    assert done
