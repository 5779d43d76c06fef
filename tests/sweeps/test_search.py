"""Searches: the best parameters, and the same trials however they come to be."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from crs_cc.sweeps.experiment import ExperimentError
from crs_cc.sweeps.rows import RowFile
from crs_cc.sweeps.sweep import Sweep
from tests.sweeps.trials import inline, swept, write

pytestmark = pytest.mark.skipif(
    not all(map(find_spec, ("optuna", "cmaes"))), reason="needs the extra 'search'"
)
"""They are imported where they are used: every run of any tests would wait for it."""

SEARCH = """
[parameters]
define.SPEED = {{ low = 10, high = 200, integer = true }}
[search]
measure = "distance_m"
maximize = true
trials = 4
batch = 2
method = "{}"
"""
ONE_SEED = 'world = "hall.xml"\nprograms = ["drive.c"]\n'


@pytest.mark.parametrize("method", ["tpe", "cma-es"])
def test_a_search_goes_on_with_the_same_trials(
    method: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write(tmp_path / "trial", SEARCH.format(method), ONE_SEED)
    whole = swept(path, tmp_path / "whole")
    speeds = [whole.rows[number]["parameters"]["define.SPEED"] for number in range(4)]
    assert all(isinstance(speed, int) and 10 <= speed <= 200 for speed in speeds)
    assert len(set(speeds)) > 2
    add = RowFile.add

    def interrupted(rows: RowFile, row: dict[str, Any]) -> None:
        if len(rows.rows) == 3:
            raise KeyboardInterrupt
        add(rows, row)

    with monkeypatch.context() as patched:
        patched.setattr(RowFile, "add", interrupted)
        with pytest.raises(KeyboardInterrupt):
            swept(path, tmp_path / "parts")
    swept(path, tmp_path / "parts", resume=True)
    tables = [(tmp_path / name / "runs.csv").read_bytes() for name in ("whole", "parts")]
    assert tables[0] == tables[1]
    from crs_cc.sweeps.search import ParameterSearch, best

    study = ParameterSearch(whole.experiment, tmp_path / "parts").study
    farthest = max(whole.rows.values(), key=lambda row: row["measures"]["distance_m"])
    assert study.best_params == farthest["parameters"]
    assert whole.experiment.search is not None
    found = best(whole.experiment.search, whole.rows.values())
    assert found == (farthest["parameters"], farthest["measures"]["distance_m"])


def test_the_ends_of_a_search_are_checked_before_it(tmp_path: Path) -> None:
    wrong = SEARCH.format("tpe").replace("define.SPEED", "robots")
    path = write(tmp_path / "trial", wrong, ONE_SEED)
    with pytest.raises(ExperimentError, match="robots = 10: expected a whole number from 1 to 2"):
        Sweep(path, tmp_path / "out").run(1, pool=inline)
