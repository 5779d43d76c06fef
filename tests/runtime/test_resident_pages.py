"""Memory is saved without reading untouched pages."""

from __future__ import annotations

import mmap
from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.host_system import open_page_map
from crs_cc.core.source import Diagnostics
from crs_cc.runtime import resident_pages
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_executable

COUNT = 64
NO_OBJECTS = range(0)

TABLE = """#include <stdlib.h>
int table[5000] = {[4999] = 7};
int main(void)
{
    int *block;
    if (table[4999] != 7)
        return 1;
    table[0] = 1;
    block = malloc(100000);
    block[20000] = 5;
    free(block);
    return table[0];
}
"""


def fresh() -> np.ndarray:
    return np.frombuffer(mmap.mmap(-1, COUNT * resident_pages.CHUNK), np.uint8)


@pytest.fixture(params=["told", "not told"])
def system(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """A system with a page map, and one without."""
    if request.param == "not told":
        monkeypatch.setattr(resident_pages, "_pagemap", lambda _process: None)
    return str(request.param)


@pytest.mark.usefixtures("system")
def test_a_memory_is_restored_exactly() -> None:
    rng, memory = np.random.default_rng(3), fresh()
    places = rng.integers(0, len(memory), 20)
    memory[places] = rng.integers(1, 256, 20)
    before = memory.copy()
    kept = resident_pages.save(memory, NO_OBJECTS)
    assert kept[0].tolist() == sorted(set((places // resident_pages.CHUNK).tolist()))
    memory[rng.integers(0, len(memory), 30)] = 9
    resident_pages.load(memory, NO_OBJECTS, *kept)
    assert np.array_equal(memory, before)


@pytest.mark.usefixtures("system")
def test_pages_of_zeros_are_left_out() -> None:
    memory = fresh()
    memory[:] = 1
    memory[resident_pages.CHUNK :] = 0
    assert resident_pages.save(memory, NO_OBJECTS)[0].tolist() == [0]


@pytest.mark.skipif(open_page_map() is None, reason="this system tells nothing")
def test_saving_a_memory_maps_no_pages() -> None:
    memory = fresh()
    memory[3 * resident_pages.CHUNK] = 1
    resident_pages.save(memory, NO_OBJECTS)
    assert np.flatnonzero(resident_pages._existing(memory)).tolist() == [3]


@pytest.mark.usefixtures("system")
@pytest.mark.parametrize("fuel", [0, 60, 200, 10_000])
def test_untouched_initialised_objects_are_saved(tmp_path: Path, fuel: int) -> None:
    path = tmp_path / "table.c"
    path.write_text(TABLE)
    executable = build_executable([path], Diagnostics())
    first, second = Fleet([executable]), Fleet([executable])
    first.slots["run"], first.slots["fuel"] = 1, fuel
    first.run_round()
    whole = first.memory(0).copy()
    second.restore(0, first.snapshot(0))
    assert np.array_equal(second.memory(0), whole)
