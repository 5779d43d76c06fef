"""`crs_cc.sweep`: sweeps from Python."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

import crs_cc
from tests.sweeps.trials import inline, write


def test_a_sweep_returns_its_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("crs_cc.jobs.pool.Pool.run", lambda _pool, *some: inline(*some))
    path = write(tmp_path / "trial", "[parameters]\ndefine.SPEED = [50, 100]\n")
    out = tmp_path / "out"
    found = crs_cc.sweep(path, out, jobs=1)
    assert repr(found) == f"<SweepTable of 6 runs in {out}>"
    with (out / "runs.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [str(each["state_hash"]) for each in found.records] == [r["state_hash"] for r in rows]
    assert [each["define.SPEED"] for each in found.records] == [50] * 3 + [100] * 3
    assert found.failed == 0
    assert crs_cc.sweep(path, out, resume=True).records == found.records
    with pytest.raises(ValueError, match="jobs must be 1 or more"):
        crs_cc.sweep(path, out, jobs=0)


def test_a_table_becomes_a_frame_where_one_is_installed(tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    from crs_cc.sweeps.table import SweepTable

    frame = SweepTable(tmp_path, ("run", "x"), ({"run": 0, "x": 1.5}, {"run": 1})).frame()
    assert isinstance(frame, pandas.DataFrame)
    assert frame["x"].isna().tolist() == [False, True]
