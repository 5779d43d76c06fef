"""Batches: which runs one process does at one go."""

from __future__ import annotations

from crs_cc.jobs.pool import Outcome
from crs_cc.sweeps.batches import MAX_BATCH, Batches
from crs_cc.sweeps.plan import PlannedRun
from crs_cc.sweeps.sweep import rows_of


def planned(*variants: tuple[int, int]) -> list[PlannedRun]:
    """Return so many runs of each variant."""
    numbers = iter(range(1000))
    return [
        PlannedRun(next(numbers), {"define.N": n}, seed)
        for n, count in variants
        for seed in range(count)
    ]


def sizes(batches: Batches, took_s: float | None) -> list[int]:
    """Return how long batches are, if each of their runs took so long."""
    found = []
    for batch in batches:
        found.append(len(batch))
        batches.add_duration(took_s)
    return found


def test_a_batch_has_runs_of_one_variant_and_a_length_by_what_the_last_run_took() -> None:
    runs = planned((1, 20), (2, 3), (3, 1))
    assert sizes(Batches(runs), 0.01) == [1, MAX_BATCH, MAX_BATCH, 3, 3, 1]
    assert sizes(Batches(runs), 0.15) == [1, *[2] * 9, 1, 2, 1, 1]
    assert sizes(Batches(runs), 5.0) == [1] * 24
    assert sizes(Batches(runs), None) == [1] * 24
    assert sizes(Batches(runs, 1), 0.01) == [1] * 24
    assert sizes(Batches([]), 0.01) == []
    assert [run for batch in Batches(runs) for run in batch] == runs


def test_only_a_run_that_was_alone_has_the_row_of_its_process() -> None:
    runs = planned((1, 2))
    late = Outcome(0, None, "time out", "stopped")
    assert rows_of(runs, late) == []
    (row,) = rows_of(runs[:1], late)
    assert (row["run"], row["seed"], row["status"], row["error"]) == (0, 0, "time out", "stopped")
