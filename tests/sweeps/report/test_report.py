"""Reports on sweeps: what they say of results that are known, and the same bytes each time."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crs_cc.cli.main import main
from crs_cc.recording.field_sketches import FieldSketch
from crs_cc.sim.model.world import Area
from crs_cc.sweeps.report import figures
from crs_cc.sweeps.report.findings import comparisons, failed, medians, scaling
from crs_cc.sweeps.report.page import draw_figures, page
from crs_cc.sweeps.report.results import Results, measures_of, results
from tests.sweeps.trials import inline, swept, write


def row(run: int, parameters: dict[str, Any], at_s: float | None, seed: int) -> dict[str, Any]:
    goal = {"status": "open" if at_s is None else "met", "at_s": at_s}
    return {
        "run": run,
        "parameters": parameters,
        "seed": seed,
        "status": "ended",
        "error": "",
        "simulated_s": 60.0 if at_s is None else at_s,
        "goals": {"cool": goal},
        "measures": {"points": 0.0 if at_s is None else 1.0, "word": "no number"},
        "state_hash": "x",
    }


def made(robots: tuple[int, ...] = (1, 2, 4)) -> list[dict[str, Any]]:
    """Return rows in which twice as many robots take half the time, and one never ends."""
    found = []
    for count in robots:
        for seed in range(1, 6):
            at_s = None if (count, seed) == (1, 5) else (40.0 + seed) / count
            found.append(row(len(found), {"robots": count, "setup": "noisy"}, at_s, seed))
    return found


def timed() -> Results:
    return results(made())


def test_results_are_sorted_by_what_varies() -> None:
    found = timed()
    assert (found.measure, found.varied) == ("goal.cool.at_s", ("robots",))
    assert measures_of(made()) == ["goal.cool.at_s", "points"]
    assert found.labels == ["robots=1", "robots=2", "robots=4"]
    assert found.groups[0].values == (41.0, 42.0, 43.0, 44.0, 60.0)
    assert found.groups[0].reached == (True, True, True, True, False)
    assert results(made(), "points").groups[0].values == (1.0, 1.0, 1.0, 1.0, 0.0)
    with pytest.raises(ValueError, match="unknown measure 'speed'"):
        results(made(), "speed")


def test_a_run_that_failed_counts_in_no_measure() -> None:
    rows = made()
    rows[0] |= {"status": "time out", "goals": {}, "measures": {}}
    found = results(rows)
    assert found.failed == 1
    assert len(found.groups[0].values) == 4
    assert "1 run has no goal.cool.at_s" in medians(found).note


def test_time_of_a_goal_that_was_never_met_is_no_measure() -> None:
    """A goal such as `no-collision` fails at a time, which is not the time to it."""
    rows = made()
    for row in rows:
        row["goals"]["clean"] = {"status": "failed", "at_s": 4.1}
    assert measures_of(rows) == ["goal.cool.at_s", "points"]
    for row in rows:
        row["goals"]["cool"] = {"status": "failed", "at_s": 50.0}
    assert results(rows).measure == "points"


def test_figures_name_the_time_of_a_goal_in_words() -> None:
    found = draw_figures(timed())
    assert all("time to goal cool [s]" in svg for svg in found.values())
    assert "median of points" in figures.curve(results(made(), "points"))


def test_page_lists_each_error_once_with_its_first_run() -> None:
    rows = made()
    for number, error in ((1, "a: loop"), (3, "a: loop\n  hint"), (4, "b: <none>")):
        rows[number] |= {"status": "limit", "error": error}
    found = failed(rows)
    assert [row[:4] for row in found.rows] == [
        ("limit", "a: loop", "2", "1"),
        ("limit", "b: <none>", "1", "4"),
    ]
    text = page("title", rows, timed(), {}, {})
    assert "<h2>Failures</h2>" in text
    assert "b: &lt;none&gt;" in text
    assert "<h2>Failures</h2>" not in page("title", made(), timed(), {}, {})


def test_visits_are_shown_in_the_whole_area() -> None:
    places_m = np.array([[4.0, 3.5], [4.1, 3.5]])
    area = Area(-1.0, 0.0, 9.0, 4.0)
    assert {0.0, 4.0, 8.0} <= ticks_in(figures.visits(places_m, 0.1, area))


def ticks_in(svg: str) -> set[float]:
    """Return the numbers beside the axes of a figure."""
    found = re.findall(r">([\N{MINUS SIGN}\d.]+)</text>", svg)
    return {float(each.replace("\N{MINUS SIGN}", "-")) for each in found}


def test_the_map_of_a_field_has_the_amounts_that_are_left() -> None:
    amounts = np.zeros((20, 20))
    amounts[3, 5] = 1000.0
    sketch = FieldSketch.made("scent", amounts, (0.0, 0.0), 0.1, 10.0)
    area = Area(0.0, 0.0, 2.0, 2.0)
    fresh, old = (figures.field_map(sketch, age_s, area) for age_s in (0.0, 20.0))
    assert "scent" in fresh
    assert max(ticks_in(fresh)) == 1000.0
    assert 100.0 <= max(ticks_in(old)) <= 140.0  # 1000 / e^2


def test_convergence_shows_the_medians_of_the_first_seeds() -> None:
    rows = [row(number, {}, at_s, number) for number, at_s in enumerate((9.0, 5.0, 1.0), 1)]
    assert {1.0, 2.0, 3.0, 5.0, 7.0, 9.0} <= ticks_in(figures.convergence(results(rows)))
    assert "convergence" not in draw_figures(results(rows[:1]))


def test_combinations_are_named_by_distinguishing_parameters_and_long_names_fit() -> None:
    rows = [
        row(number, {"setup": setup, "fault": fault, "world.source.items": items}, 1.0 + seed, seed)
        for number, (setup, fault, items, seed) in enumerate(
            (setup, fault, items, seed)
            for setup, fault in (("", ""), ("noisy", "robot=a device=sonar dead=yes"))
            for items in (10_000_000, 20_000_000)
            for seed in (1, 2)
        )
    ]
    found = results(rows)
    assert found.labels[1:3] == [
        "setup=, world.source.items=20000000",
        "setup=noisy, world.source.items=10000000",
    ]
    assert found.groups[2].parameters["fault"] == "robot=a device=sonar dead=yes"
    text = figures.convergence(found)
    height_pt = float(text.split('height="')[1].split("pt")[0])
    assert height_pt > 72 * 4.2 + 50  # the legend is below what it explains
    assert ">setup=noisy,<" in text


def test_medians_say_where_a_goal_was_not_met() -> None:
    table = medians(timed())
    assert table.heading[:4] == ("robots", "runs", "met", "median")
    assert table.rows[0][:6] == ("1", "5", "4", "43", "42", "44")
    assert table.rows[0][6] == "41 to ≥ 60"
    assert table.rows[1][:4] == ("2", "5", "5", "21.5")


def test_medians_are_bounds_where_runs_without_the_goal_ended_at_different_times() -> None:
    rows = [row(number, {}, None, number) for number in range(3)]
    for each, end_s in zip(rows, (3.9, 3.9, 4.85), strict=True):
        each["simulated_s"] = end_s
    rows.append(row(3, {}, 2.0, 3))
    assert medians(results(rows)).rows == (("4", "1", "≥ 3.9", "3.425", "≥ 4.138", "2 to ≥ 4.85"),)


def test_scaling_and_differences_are_those_of_the_rows() -> None:
    assert [row[1:] for row in scaling(timed()).rows] == [
        ("1.00", "1.00"),
        ("2.00", "1.00"),
        ("4.00", "1.00"),
    ]
    table = comparisons(timed())
    assert [row[:4] for row in table.rows] == [
        ("robots=1", "robots=2", "0.008", "+1.00"),
        ("robots=1", "robots=4", "0.008", "+1.00"),
        ("robots=2", "robots=4", "0.008", "+1.00"),
    ]
    assert table.rows[0][4] == "6 (there are 5)"


def test_equal_results_show_no_effect() -> None:
    rows = made((1, 2))
    for each in rows:
        each["measures"]["points"] = 1.0
    (only,) = comparisons(results(rows, "points")).rows
    assert only[2:] == ("1.000", "+0.00", "no effect")


def test_figures_are_those_that_suit_the_results_and_the_same_each_time() -> None:
    found = draw_figures(timed())
    assert set(found) == {"values", "curve", "survival", "convergence"}
    assert found == draw_figures(timed())
    rows = made()
    for each in rows:
        each["parameters"] = {"robots": each["parameters"]["robots"], "seeded": each["seed"] % 2}
    two = results(rows, "points")
    assert figures.heat_map(two).startswith("<svg")
    assert "&lt;b&gt;" in page("<b>", rows, two, found, {"smallest": "a.html"})


def test_a_report_has_figures_tables_and_replays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("crs_cc.jobs.pool.Pool.run", lambda _pool, *some: inline(*some))
    path = write(tmp_path / "trial", "[parameters]\ndefine.SPEED = [50, 100]\n")
    world = path.parent / "hall.xml"
    world.write_text(world.read_text().replace("<goal", '<field name="scent" cell="5cm"/><goal'))
    out = tmp_path / "out"
    swept(path, out)
    assert main(["sweep", "report", str(out), "--measure", "distance_m"]) == 0
    text = (out / "report.html").read_text()
    assert len(re.findall("<svg", text)) == 4
    assert "<svg" in (out / "figures" / "field-1.svg").read_text()
    links = re.findall(r'href="(replays/\d+.html)"', text)
    assert len(links) == 3
    assert all((out / link).stat().st_size > 10_000 for link in links)
    assert (out / "summary.csv").read_text().splitlines()[0].startswith("define.SPEED,runs,median")
    assert main(["sweep", "report", str(out), "--measure", "speed"]) == 2
    assert main(["sweep", "report", str(tmp_path), "--no-replays"]) == 122
    (path.parent / "drive.c").write_text("int main(void) { return 0; }\n")
    assert main(["sweep", "report", str(out), "--measure", "distance_m"]) == 0
    assert "Replays" not in (out / "report.html").read_text()
