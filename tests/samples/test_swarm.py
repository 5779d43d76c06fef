"""The experiments in samples/swarm, small: each shows what its page says."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from crs_cc.sweeps.sweep import Sweep
from tests.sweeps.trials import inline

SWARM = Path(__file__).parents[2] / "samples" / "swarm"


def rows_of(name: str, folder: Path, robots: list[int], duration: str) -> list[dict[str, Any]]:
    """Run an experiment with some numbers of robots and one seed; return the rows."""
    changes = {"seeds": "[2]", "robots": str(robots), "duration": f'"{duration}"'}
    lines = (SWARM / f"{name}.toml").read_text().splitlines()
    kept = [line for line in lines if line.partition(" =")[0] not in changes]
    at = kept.index("[parameters]")
    kept[at:at] = [f"{key} = {changes[key]}" for key in ("seeds", "duration")]
    text = "\n".join([*kept, f"robots = {changes['robots']}"])
    sweep = Sweep(SWARM / f"{name}.toml", folder / name, text)
    sweep.run(1, pool=inline)
    rows = [sweep.rows[number] for number in sorted(sweep.rows)]
    assert [row["error"] for row in rows] == [""] * len(rows)
    assert all(row["measures"]["collisions_per_robot_min"] < 0.5 for row in rows)
    return rows


def test_several_robots_cool_everything_before_one_does(tmp_path: Path) -> None:
    one, several = rows_of("heat", tmp_path, [1, 4], "60s")
    assert one["goals"]["cool"]["status"] == "open"
    assert several["goals"]["cool"]["status"] == "met"


def test_too_many_foragers_bring_less(tmp_path: Path) -> None:
    few, some, too_many = (
        row["measures"]["items_per_min"]
        for row in rows_of("foraging", tmp_path, [2, 20, 200], "40s")
    )
    assert few < some
    assert too_many < some
