"""Composite objects that can be pushed move as one body."""

from __future__ import annotations

import math

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.mass_properties import FLOOR_FRICTION, GRAVITY_MPS2
from crs_cc.sim.physics.rigid import Rigid
from tests.sim.driver import Driver, open_world, world_of

# A dumb-bell across the way: two drums of 40 cm, 1 m apart, with a bar between them.
BELL = """<define name="bell"><cylinder id="left" x="0" y="50cm" radius="20cm"/>
<cylinder id="right" x="0" y="-50cm" radius="20cm"/>
<box id="bar" x="0" y="0" length="10cm" width="80cm"/></define>"""

FENCE = '<define name="a"><wall x1="0" y1="0" x2="1" y2="0"/></define>'


def bell(x_m: float, mass: str = "6kg", y_m: float = 5.0, heading: float = 0.0) -> str:
    return (
        f'{BELL}<object id="b" ref="bell" x="{x_m}" y="{y_m}" heading="{heading}" mass="{mass}"/>'
    )


def shape(driver: Driver) -> np.ndarray:
    """Return the distances between all parts, and their rotations relative to the first."""
    bodies, first = driver.state.bodies, len(driver.state.heading_rad)
    place, angle = bodies.position_m[first:], bodies.angle_rad[first:]
    apart = np.hypot(*(place[:, None] - place).T)
    return np.append(apart.ravel(), angle - angle[0])


def test_mass_is_distributed_to_parts_by_area():
    world = open_world('<robot x="0" y="0"/>' + bell(3.0))
    drum_m2, bar_m2 = math.pi * 0.04, 0.08
    whole_m2 = 2 * drum_m2 + bar_m2
    bar, left, right = world.boxes[0], *world.cylinders
    assert bar.mass_kg == pytest.approx(6 * bar_m2 / whole_m2)
    assert left.mass_kg == right.mass_kg == pytest.approx(6 * drum_m2 / whole_m2)
    assert {obj.part_of for obj in (bar, left, right)} == {"b"}


def test_composite_has_the_moment_and_friction_of_its_parts():
    """Drums turn about the centre half a metre away, the bar about itself."""
    rigid = Rigid(Scene(open_world('<robot x="0" y="0"/>' + bell(3.0))))
    whole = rigid.wholes[0]
    drum_kg = 6 * math.pi * 0.04 / (2 * math.pi * 0.04 + 0.08)
    bar_kg = 6 - 2 * drum_kg
    moment = 2 * drum_kg * (0.2**2 / 2 + 0.5**2) + bar_kg * (0.1**2 + 0.8**2) / 12
    assert whole.mass_kg == pytest.approx(6)
    assert whole.moment_kgm2 == pytest.approx(moment)
    assert whole.friction_n == pytest.approx(FLOOR_FRICTION * GRAVITY_MPS2 * 6)
    drum_lever_m = math.hypot(0.5, 0.2 * 2 / 3)
    bar_lever_m = 2 / 3 * math.sqrt(0.08 / math.pi)
    lever = 2 * drum_kg * drum_lever_m + bar_kg * bar_lever_m
    assert whole.friction_nm == pytest.approx(FLOOR_FRICTION * GRAVITY_MPS2 * lever)
    assert rigid.others == {1, 2}


def test_push_at_the_centre_moves_the_composite_straight():
    driver = Driver.of(world_of('<robot x="1m" y="5m"/>' + bell(2.0)))
    before = shape(driver)
    driver.ask("VM", 100, 100)
    driver.run_s(8)
    bodies = driver.state.bodies
    assert shape(driver) == pytest.approx(before, abs=1e-9)
    assert bodies.position_m[1, 0] > 2.4
    assert bodies.position_m[1:, 0] == pytest.approx(bodies.position_m[1, 0])
    assert bodies.angle_rad[1] == pytest.approx(0.0, abs=1e-3)


def test_push_at_one_end_turns_the_composite():
    driver = Driver.of(world_of('<robot x="1m" y="5.5m"/>' + bell(2.0)))
    before = shape(driver)
    driver.ask("VM", 100, 100)
    driver.run_s(10)
    bodies = driver.state.bodies
    assert shape(driver) == pytest.approx(before, abs=1e-9)
    assert bodies.angle_rad[1] < -0.2, "the left end goes ahead: clockwise"
    left, right = bodies.position_m[2], bodies.position_m[3]
    assert left[0] > right[0] + 0.1


def test_composite_with_a_heading_is_pushed_likewise():
    """The bell along the path, pushed at its end: it moves straight on."""
    driver = Driver.of(world_of('<robot x="1m" y="5m"/>' + bell(2.5, heading=90)))
    driver.ask("VM", 100, 100)
    driver.run_s(8)
    bodies = driver.state.bodies
    assert bodies.position_m[1, 0] > 2.6
    assert bodies.angle_rad[1] == pytest.approx(math.pi / 2, abs=1e-3)


def test_heavy_composite_does_not_move():
    driver = Driver.of(world_of('<robot x="1m" y="5m"/>' + bell(2.0, "60kg")))
    before = driver.state.bodies.position_m[1:].copy()
    driver.ask("VM", 100, 100)
    driver.run_s(6)
    assert driver.state.bodies.position_m[1:] == pytest.approx(before, abs=2e-3)


def test_untouched_composite_keeps_its_exact_pose():
    """The robot pushes the box, which is the first object, and the bell is far away."""
    elements = '<robot x="1m" y="1m"/><box x="3m" y="1m" length="40cm" width="40cm" mass="2kg"/>'
    driver = Driver.of(world_of(elements + bell(7.0, y_m=7.0, heading=33)))
    before = driver.state.bodies.position_m[2:].copy()
    driver.ask("VM", 100, 100)
    driver.run_s(9)
    assert driver.state.bodies.position_m[1, 0] > 3.05
    assert np.array_equal(driver.state.bodies.position_m[2:], before)


def test_snapshot_replays_to_the_same_bits():
    driver = Driver.of(world_of('<robot x="1m" y="5.3m"/>' + bell(2.0)))
    driver.ask("VM", 100, 100)
    driver.run_s(7)
    snapshot = driver.environment.snapshot()
    driver.run_s(2)
    expected = driver.environment.hash()
    driver.environment.restore(snapshot)
    driver.run_s(2)
    assert driver.environment.hash() == expected


def test_parts_may_overlap_each_other_but_no_other_object():
    text = f"""<world version="1"><area length="9m" width="9m"/><robot x="1" y="1"/>
        {bell(5.0)}<box id="c" x="5" y="5.6" length="1" width="1"/></world>"""
    with pytest.raises(WorldError) as caught:
        parse_world(text.encode(), "w.xml")
    message, *_ = caught.value.diagnostics
    assert message.text == "cylinder 'b.left' overlaps box 'c'"


@pytest.mark.parametrize(
    ("row", "expected"),
    [
        (
            f'{FENCE}<object ref="a" x="5" y="5" mass="1"/>',
            "object, mass: an object that contains walls cannot be movable",
        ),
        (
            f'{BELL}<define name="a"><object ref="bell" x="0" y="0" mass="1"/></define>',
            "object, mass: not allowed on an object inside a definition",
        ),
        (f'{BELL}<object ref="bell" x="5" y="5" mass="0"/>', "object, mass: '0' must be greater"),
    ],
)
def test_invalid_mass_is_rejected(row: str, expected: str):
    text = f"""<world version="1"><area length="9m" width="9m"/><robot x="1" y="1"/>{row}</world>"""
    with pytest.raises(WorldError, match=expected):
        parse_world(text.encode(), "w.xml")
