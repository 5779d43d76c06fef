"""`crs_cc.sweep`: sweeps from Python."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

import crs_cc
from crs_cc.sweeps.rows import RowFile, read_rows
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


def test_rows_share_the_names_that_they_have_in_common(tmp_path: Path) -> None:
    lines = [json.dumps({"run": run, "measures": {"distance_m": float(run)}}) for run in range(3)]
    (tmp_path / "rows.jsonl").write_text("\n".join(lines[:2]) + "\n")
    with RowFile(tmp_path) as file:
        file.add(json.loads(lines[2]))
        rows = list(file.rows.values())
    assert rows == list(read_rows(tmp_path / "rows.jsonl")[0].values())
    assert [row["measures"] for row in rows] == [{"distance_m": float(run)} for run in range(3)]
    names = [name for row in rows for each in (row, row["measures"]) for name in each]
    assert len({id(name) for name in names}) == len(set(names))
