"""Goals that robots cannot reach."""

from __future__ import annotations

import math

import pytest

from crs_cc.builder.world_builder import WorldBuilder

HALL = """<world version="1">
  <area length="6m" width="4m"/>
  <wall id="screen" x1="3m" y1="0" x2="3m" y2="{y2}"/>
  <box id="safe" x="5.5m" y="3.5m" length="40cm" width="40cm"/>
  <robot id="near" x="1m" y="1m"/>
  <robot id="far" x="5m" y="1m"/>
  <goal id="there">{goal}</goal>
</world>
"""
PLACE = '<reach x="1m" y="3m" radius="10cm"/>'
BOTH = '<visit><place x="1m" y="3m" radius="1cm"/><place x="5m" y="2m" radius="1cm"/></visit>'


@pytest.mark.parametrize(
    ("y2", "goal", "robots", "wrong"),
    [
        ("4m", PLACE, "far", "robot 'far' cannot get there"),
        ("4m", PLACE, "near far", "robot 'far' cannot get there"),
        ("4m", PLACE, "near", ""),
        ("4m", PLACE, "", ""),
        ("3.4m", PLACE, "far", ""),
        ("3.75m", PLACE, "far", "robot 'far' cannot get there"),
        ("4m", BOTH, "", ""),
        ("4m", BOTH, "near", "no robot can get there"),
        ("4m", '<approach object="safe" distance="25cm"/>', "near", "robot 'near' cannot get"),
        ("4m", '<approach object="safe" distance="25cm"/>', "", ""),
        ("4m", '<reach x="3m" y="2m" radius="1cm"/>', "", "no robot can get there"),
    ],
)
def test_goals_behind_walls_are_warned_of(y2: str, goal: str, robots: str, wrong: str) -> None:
    builder = WorldBuilder(text=HALL.format(y2=y2, goal=goal))
    builder.set("there", robots=robots)
    assert not builder.problems()
    found = [(each.severity, each.location.line, each.text) for each in builder.warnings()]
    assert [row[:2] for row in found] == [("warning", 7)] * bool(wrong)
    assert all(f"goal 'there': {wrong}" in row[2] for row in found)


ROOMS = """<world version="1">
  <area length="6m" width="4m"/>
  <wall id="screen" x1="3m" y1="0" x2="3m" y2="{y2}"/>
  <box id="crate" x="1m" y="3m" length="60cm" width="40cm" mass="2kg"/>
  <robot id="near" x="1m" y="1m"/>
  <robot id="far" x="5m" y="1m"/>
  <goal id="there">{goal}</goal>
</world>
"""
BRING = '<bring objects="crate" x="5m" y="3m" radius="20cm"/>'
FOLLOW = '<follow target="far" most="{to}" share="0.50"/>'
CRATE = '<follow target="crate" most="30cm" share="0.50"/>'


@pytest.mark.parametrize(
    ("y2", "goal", "robots", "wrong"),
    [
        ("4m", BRING, "", "object 'crate' cannot get there"),
        ("3.3m", BRING, "", ""),
        ("3.7m", BRING, "", "object 'crate' cannot get there"),
        ("4m", BRING.replace("5m", "2m"), "", ""),
        ("4m", FOLLOW.format(to="30cm"), "near", "robot 'near' cannot get near 'far'"),
        ("4m", FOLLOW.format(to="30cm"), "", "no robot can get near 'far'"),
        ("4m", FOLLOW.format(to="1m"), "near", ""),
        ("3m", FOLLOW.format(to="30cm"), "near", ""),
        ("4m", CRATE, "far", "robot 'far' cannot get near 'crate'"),
        ("4m", CRATE, "", ""),
        ("4m", '<cover share="0.90" cell="10cm"/>', "near", "robots can get to "),
        ("4m", '<cover share="0.40" cell="10cm"/>', "near", ""),
        ("4m", '<cover share="0.95" cell="10cm"/>', "", ""),
        ("3m", '<cover share="0.95" cell="10cm"/>', "near", ""),
    ],
)
def test_objects_that_cannot_be_brought_and_floors_that_cannot_be_covered(
    y2: str, goal: str, robots: str, wrong: str
) -> None:
    builder = WorldBuilder(text=ROOMS.format(y2=y2, goal=goal))
    if robots:
        builder.set("there", robots=robots)
    assert not builder.problems()
    found = [each.text for each in builder.warnings()]
    assert len(found) == bool(wrong), found
    assert all(f"goal 'there': {wrong}" in text for text in found)


def test_an_object_that_no_robot_can_get_at_is_named() -> None:
    text = ROOMS.format(y2="4m", goal=BRING.replace("5m", "2m"))
    builder = WorldBuilder(text=text)
    builder.remove("near")
    (found,) = builder.warnings()
    assert found.text == "goal 'there': no robot can get at object 'crate'"


def test_a_passage_that_is_wide_enough_is_passed_at_any_angle() -> None:
    for degrees in range(0, 90, 15):
        angle = math.radians(degrees)
        builder = WorldBuilder.new(12, 12)
        builder.add("robot", x=6, y=6)
        for side in (1, -1):  # a corridor of 43 cm for a robot of 40.6 cm
            dx, dy = -side * 0.265 * math.sin(angle), side * 0.265 * math.cos(angle)
            ends = [6 + sign * 3 * math.cos(angle) for sign in (1, -1)]
            tops = [6 + sign * 3 * math.sin(angle) for sign in (1, -1)]
            builder.add("wall", x1=ends[0] + dx, y1=tops[0] + dy, x2=ends[1] + dx, y2=tops[1] + dy)
        builder.add("reach", x=1, y=11, radius=0.1)
        assert not builder.warnings(), degrees


def test_a_large_world_is_not_examined_beyond_a_bound() -> None:
    builder = WorldBuilder.new(10_000, 10_000)
    builder.add("robot", x=5, y=5)
    builder.add("reach", x=1000, y=1000, radius=0.1)
    assert not builder.warnings()
