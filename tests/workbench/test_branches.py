"""Runs that changes in the past have left: kept, shown again, and compared."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.start_view import screen_of
from crs_cc.debug.branches import MAX_KEPT
from crs_cc.debug.errors import DebugError
from crs_cc.workbench import control
from crs_cc.workbench.commands import TABLE
from crs_cc.workbench.screen import Screen

PROGRAM = """\
#include <Nclient.h>
#include <stdio.h>

int main(void)
{
    connect_robot(1);
    vm(100, 100, 0);
    for (;;) {
        get_sn();
        printf("%ld\\n", State[17]);
    }
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="20m" width="4m"/><robot id="ada" x="1m" y="2m"/>
</world>
"""


@pytest.fixture
def screen(tmp_path: Path) -> Iterator[Screen]:
    """Ada was seen driving for three seconds, and is turned at one."""
    (tmp_path / "go.c").write_text(PROGRAM)
    (tmp_path / "long.xml").write_text(WORLD)
    files = Inputs((tmp_path / "go.c",), tmp_path / "long.xml")
    made = screen_of(DebugOptions(inputs=files, quiet=True), 0)
    made.run.advance(60)
    made.run.seek(1.0)
    control.edit(made, "turn ada to 90")
    made.run.advance(30)
    yield made
    made.server.close()


def hash_at(screen: Screen, time_s: float) -> str:
    screen.run.seek(time_s)
    return screen.run.debugger().session.state_hash()


def names(screen: Screen) -> list[str]:
    return [each["name"] for each in screen.run.branches().listing()]


def test_the_run_before_a_change_in_the_past_is_kept_as_a_branch(screen: Screen) -> None:
    assert names(screen) == ["main", "run2"]
    changed = hash_at(screen, 1.5)
    control.switch(screen, "main")
    assert screen.run.time_s == pytest.approx(1.5)
    assert screen.feed.end_s == pytest.approx(3.0)
    assert screen.run.debugger().run.history.changes == ()
    plain = hash_at(screen, 1.5)
    output = screen.feed.output()
    control.switch(screen, "run2")
    assert screen.feed.end_s == pytest.approx(2.5)
    assert hash_at(screen, 1.5) == changed != plain
    assert screen.feed.output() != output
    control.revert(screen, 0)  # it lies in the past: the changed run is kept, too
    assert names(screen) == ["main", "run2", "run3"]
    screen.run.advance(10)
    assert hash_at(screen, 1.5) == plain
    with pytest.raises(DebugError, match="unknown run 'run9'"):
        control.switch(screen, "run9")


def test_two_runs_are_compared_from_where_they_diverge(screen: Screen) -> None:
    found = TABLE["compare"](screen, {"name": "main"})
    first = found["differences"][0]
    assert (first["t"], first["robot"]) == (pytest.approx(1.05), "ada")
    rows = {each["what"]: each for each in found["differences"]}
    assert float(rows["pose.heading"]["here"]) == pytest.approx(90.0, abs=0.1)
    assert float(rows["pose.heading"]["there"]) == pytest.approx(0.0, abs=0.1)
    assert rows["print"]["t"] >= 1.0
    path = found["paths"]["ada"]
    assert path[-1][0] > path[0][0]
    assert path[-1][1] == pytest.approx(2.0, abs=1e-3)


def test_a_change_at_the_current_position_creates_no_branch(screen: Screen) -> None:
    control.edit(screen, "turn ada to 45")
    assert names(screen) == ["main", "run2"]


def test_the_oldest_of_many_branches_is_discarded(screen: Screen) -> None:
    for heading in range(MAX_KEPT + 2):
        screen.run.seek(1.0)
        control.edit(screen, f"turn ada to {heading}")
        screen.run.advance(10)
    assert len(names(screen)) == MAX_KEPT
    assert names(screen)[0] == "main"
    control.switch(screen, names(screen)[1])
    assert screen.run.debugger().names == ("ada",)
