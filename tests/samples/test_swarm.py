"""The experiments in samples/swarm, small: each shows what its page says."""

from __future__ import annotations

import csv
import math
import runpy
from importlib import import_module
from pathlib import Path
from statistics import mean, median
from types import ModuleType
from typing import Any

import pytest

from crs_cc import Session, load_world
from crs_cc.sweeps.sweep import Sweep
from tests.sweeps.trials import inline

SWARM = Path(__file__).parents[2] / "samples" / "swarm"


def rows_of(
    name: str, folder: Path, parameter: str, values: list[int], duration: str, *, most: float = 0.5
) -> list[dict[str, Any]]:
    """Run an experiment with some values of its parameter and one seed; return the rows.

    Robots may have so many collisions per minute at most.
    """
    changes = {"seeds": "[2]", parameter: str(values), "duration": f'"{duration}"'}
    lines = (SWARM / f"{name}.toml").read_text().splitlines()
    kept = [line for line in lines if line.partition(" =")[0] not in changes]
    at = kept.index("[parameters]")
    kept[at:at] = [f"{key} = {changes[key]}" for key in ("seeds", "duration")]
    text = "\n".join([*kept, f"{parameter} = {changes[parameter]}"])
    return rows_of_text(name, text, folder, most)


def rows_of_text(name: str, text: str, folder: Path, most: float) -> list[dict[str, Any]]:
    """Run an experiment with another text; return the rows, with at most so many collisions."""
    sweep = Sweep(SWARM / f"{name}.toml", folder / name, text)
    sweep.run(1, pool=inline)
    rows = [sweep.rows[number] for number in sorted(sweep.rows)]
    assert [row["error"] for row in rows] == [""] * len(rows)
    assert all(row["measures"]["collisions_per_robot_min"] < most for row in rows)
    return rows


def test_several_robots_cool_everything_before_one_does(tmp_path: Path) -> None:
    one, several = rows_of("heat", tmp_path, "robots", [1, 4], "40s")
    assert one["goals"]["cool"]["status"] == "open"
    assert several["goals"]["cool"]["status"] == "met"


def test_too_many_foragers_bring_less(tmp_path: Path) -> None:
    few, some, too_many = (
        row["measures"]["items_per_min"]
        for row in rows_of("foraging", tmp_path, "robots", [2, 10, 60], "30s")
    )
    assert few < some
    assert too_many < some


def test_trails_lead_foragers_to_the_source(tmp_path: Path) -> None:
    without, with_trails = (
        row["measures"]["items_brought"]
        for row in rows_of("trails", tmp_path, "world.ant.count", [5], "60s")
    )
    assert 0 < without < with_trails


def test_faults_cost_foragers_items_or_collisions(tmp_path: Path) -> None:
    text = """
        world = "faults.xml"
        measures = "trails.py"
        seeds = [4]
        duration = "40s"
        parameters = { world.faulty.setup = ["ideal", "blind", "weak"] }
        cases = [{ world.sound.count = 0, world.faulty.count = 4 }]
    """
    sound, blind, weak = (
        row["measures"] for row in rows_of_text("faults", text, tmp_path, most=10.0)
    )
    assert weak["items_brought"] < sound["items_brought"]
    assert sound["collisions"] == 0 < blind["collisions"]


def test_each_fault_begins_with_the_robots_that_have_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(SWARM)
    shown = import_module("foraging_results")
    cases = [("ideal", 4, 9.0), ("weak", 8, 4.0), ("blind", 12, 8.0), ("weak", 4, 6.0)]
    rows = [
        {
            "run": run,
            "parameters": {"world.faulty.setup": setup, "world.faulty.count": count},
            "status": "ended",
            "measures": {"items_per_min": items},
        }
        for run, (setup, count, items) in enumerate(cases)
    ]
    found = shown.with_faults(rows)
    assert [tuple(group.parameters.values()) for group in found.groups] == [
        (0, "none"),
        (12, "blind"),
        (4, "weak"),
        (8, "weak"),
    ]
    lines = [(*group.parameters.values(), *group.values) for group in shown.from_none(found).groups]
    assert lines[:2] == [(0, "blind", 9.0), (0, "weak", 9.0)]
    assert lines[2:] == [(12, "blind", 8.0), (4, "weak", 6.0), (8, "weak", 4.0)]


def test_robots_gather_if_they_stay_where_others_are(tmp_path: Path) -> None:
    alone, together = (
        row["measures"]["largest_group"]
        for row in rows_of("aggregation", tmp_path, "define.STEEP", [0, 2], "30s", most=1.0)
    )
    assert alone < together


def test_robots_that_leave_pucks_with_others_make_clusters(tmp_path: Path) -> None:
    text = """
        world = "clustering.xml"
        measures = "clustering.py"
        seeds = [1]
        duration = "25s"
        parameters = { define.LEAVE = [1, 0] }
    """
    leaving, holding = (
        row["measures"]["clusters"] for row in rows_of_text("clustering", text, tmp_path, most=20.0)
    )
    assert leaving < holding - 1


def test_pucks_without_bodies_are_put_together_in_clusters() -> None:
    model = runpy.run_path(str(SWARM / "clustering_model.py"))
    for seed in range(20):
        sizes = model["sizes"](seed)
        assert sum(sizes) == model["PUCKS"]
        assert min(sizes) > 1


def test_robots_that_follow_their_trail_agree_on_one_of_two_branches(tmp_path: Path) -> None:
    (row,) = rows_of("bridge", tmp_path, "define.DETOUR", [0], "120s")
    shares = list(map(float, row["measures"]["north_by_minute"].split()))
    assert max(shares[-1], 1.0 - shares[-1]) > 0.75  # 0.5 if they did not smell


def test_robots_find_both_branches_if_one_is_twice_as_long(tmp_path: Path) -> None:
    (row,) = rows_of("detour", tmp_path, "define.RELEASE", [1], "60s")
    assert 0.0 < float(row["measures"]["north_by_minute"]) < 1.0


@pytest.fixture
def tour_model(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(SWARM)
    return import_module("tour_model")


def test_robots_visit_each_station_once_and_return(tour_model: ModuleType) -> None:
    session = Session(load_world(SWARM / "tour.xml", seed=1), seed=1)
    session.run(60.0)
    printed = "".join(robot.stdout for robot in session.robots.values())
    tours = [line.split() for line in printed.splitlines() if line[:1].isdigit()]
    assert len(tours) >= 4
    for _, length, order in tours:
        tour = tuple(map(int, order))
        assert sorted(tour) == list(range(len(tour_model.STATIONS)))
        assert float(length) == pytest.approx(tour_model.length_m(tour), abs=1e-3)


@pytest.fixture
def maze_model(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(SWARM)
    return import_module("maze_model")


def test_robots_find_ways_through_the_maze(maze_model: ModuleType) -> None:
    assert all(f'"{line}"' in (SWARM / "maze.c").read_text() for line in maze_model.MAZE)
    session = Session(load_world(SWARM / "maze.xml", seed=2), seed=2)
    session.run(50.0)
    printed = "".join(robot.stdout for robot in session.robots.values())
    lengths = [float(line.split()[1]) for line in printed.splitlines() if line[:1].isdigit()]
    assert lengths
    assert min(lengths) >= maze_model.shortest_m() - 0.05
    assert session.field("trail").max() > 0.0


def test_ants_without_bodies_find_the_shortest_way_by_their_trails(
    maze_model: ModuleType,
) -> None:
    with_trails, without = (
        [maze_model.lengths_m(3, seed, marks)[-1] for seed in range(30)]
        for marks in (maze_model.MARKS, 0.0)
    )
    assert median(with_trails) == pytest.approx(maze_model.shortest_m())
    assert median(without) > 1.5 * maze_model.shortest_m()


@pytest.mark.parametrize(("name", "minute"), [("tour", "8"), ("maze", "6")])
def test_ways_are_within_a_tenth_of_the_shortest(name: str, minute: str) -> None:
    with (SWARM / "results" / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        last = [row for row in csv.DictReader(file) if row["minute"] == minute]
    medians = {row["colony"]: float(row["median"]) for row in last}
    assert medians["robots"] <= 1.1
    assert medians["without trails"] > 1.1


def test_ants_without_bodies_find_the_shortest_tour_by_their_trails(
    tour_model: ModuleType,
) -> None:
    shortest = tour_model.shortest_m()
    with_trails, without = (
        [tour_model.lengths_m(3, seed, marks)[-1] / shortest for seed in range(30)]
        for marks in (tour_model.MARKS_M, 0.0)
    )
    assert median(with_trails) == pytest.approx(1.0)
    assert median(without) > 1.2


@pytest.fixture
def bridge_model(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(SWARM)
    return import_module("bridge_model")


def test_ants_without_bodies_choose_the_short_branch_more_often(bridge_model: ModuleType) -> None:
    def share(bridge: object) -> float:
        """Return the share of choices of the first branch in the third minute."""
        return mean(bridge_model.shares_by_minute(bridge, 3, seed)[-1] for seed in range(400))

    equal = share(bridge_model.EQUAL)
    assert equal == pytest.approx(0.5, abs=0.06)
    assert equal + 0.05 < share(bridge_model.DETOUR) < share(bridge_model.FAR_DETOUR)


@pytest.mark.parametrize("bridge", ["detour", "far_detour"])
def test_the_share_of_the_short_branch_agrees_with_theory(bridge: str) -> None:
    with (SWARM / "results" / f"{bridge}.csv").open(encoding="utf-8", newline="") as file:
        rows = {(row["minute"], row["colony"]): row for row in csv.DictReader(file)}
    for minute in "123":
        low, high = map(float, rows[minute, "robots"]["95% interval of the mean"].split(" to "))
        assert 0.5 < low <= float(rows[minute, "without bodies"]["mean"]) <= high


def test_robots_form_a_path_to_the_source(tmp_path: Path) -> None:
    text = """
        world = "path.xml"
        measures = "path.py"
        seeds = [21]
        duration = "70s"
        parameters = { world.ant.count = [8] }
    """
    (row,) = rows_of_text("path", text, tmp_path, most=1.0)
    assert row["measures"]["has_path"] == 1
    assert 10.0 < row["measures"]["path_s"] < 70.0


def test_robots_without_bodies_need_three_for_a_path(chain_model: ModuleType) -> None:
    assert all(chain_model.formed_s(1, 90.0, seed) == math.inf for seed in range(10))
    few, many = (
        sum(chain_model.formed_s(count, 180.0, seed) < 180.0 for seed in range(20))
        for count in (4, 16)
    )
    assert few < many


@pytest.fixture
def chain_model(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(SWARM)
    return import_module("chain_model")


def test_foragers_that_tell_each_other_bring_more(tmp_path: Path) -> None:
    channel = '"world.communication/channel.loss"'
    text = f"""
        world = "radio.xml"
        measures = "trails.py"
        seeds = [1]
        duration = "30s"
        parameters = {{ {channel} = [0, 1] }}
    """
    told, alone = (
        row["measures"]["items_brought"] for row in rows_of_text("radio", text, tmp_path, most=0.5)
    )
    assert alone < told
