"""The elements `<scatter>` of world files: places, seeds and errors."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.builder.shapes import shapes
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.geometry.placement import misplaced, overlapping_objects
from crs_cc.sim.model.world import WorldModel

CAN = '<define name="can"><cylinder x="10cm" y="0" radius="5cm"/></define>'
SCREEN = '<wall id="screen" x1="3m" y1="0" x2="3m" y2="3m"/><robot id="r" x="1m" y="1m"/>'


def world(elements: str, seed: int | None = None, more: str = "") -> WorldModel:
    text = f'<world version="1" {more}><area length="6m" width="4m"/>{CAN}{elements}</world>'
    return parse_world(text.encode(), "test", seed=seed)


def places_m(world: WorldModel, name: str) -> np.ndarray:
    found = [each.start for each in world.robots if each.id.startswith(f"{name}.")]
    return np.array([(place.x_m, place.y_m) for place in found])


def test_what_is_scattered_overlaps_nothing() -> None:
    cans = '<scatter id="can" object="can" count="60" mass="1kg"/>'
    robots = '<scatter id="ant" robot="scout" count="25"/>'
    found = world(SCREEN + cans + robots)
    assert [each.id for each in found.robots[:3]] == ["r", "ant.0", "ant.1"]
    assert found.cylinders[59].id == "can.59.cylinder0"
    assert (len(found.robots), len(found.cylinders)) == (26, 60)
    assert not misplaced(found)
    assert not list(overlapping_objects(found))
    assert len({each.start.heading_rad for each in found.robots}) == 26


def test_places_depend_on_the_seed_and_not_on_the_count() -> None:
    def scattered(count: int, **seeds) -> np.ndarray:
        elements = f'{SCREEN}<scatter id="ant" robot="scout" count="{count}" in="0,0 6m,4m"/>'
        return places_m(world(elements, **seeds), "ant")

    ten = scattered(10)
    assert (scattered(20)[:10] == ten).all()
    assert (scattered(10, seed=0) == ten).all()
    assert (scattered(10, more='seed="5"') == scattered(10, seed=5)).all()
    assert (scattered(10, seed=5, more='seed="6"') == scattered(10, seed=5)).all()
    assert (scattered(10, seed=5) != ten).all()


def test_scatters_of_one_file_are_independent() -> None:
    both = '<scatter id="a" robot="scout" count="5"/><scatter id="b" robot="scout" count="5"/>'
    found = world(both)
    assert (places_m(found, "a") != places_m(found, "b")).all()


def test_distributions_are_those_asked_for() -> None:
    """Of 2,000 small cans: the standard error of a mean is 2.2% of the deviation."""
    can = '<define name="dot"><cylinder x="0" y="0" radius="1mm"/></define>'

    def centred(how: str) -> np.ndarray:
        elements = f'<robot x="30cm" y="30cm"/>{can}<scatter object="dot" count="2000" {how}/>'
        found = [(each.pose.x_m, each.pose.y_m) for each in world(elements).cylinders]
        return np.array(found) - (3.0, 2.0)

    even = centred('in="1m,1m 5m,3m" heading="90deg"')
    assert (np.abs(even) <= (2.0, 1.0)).all()
    assert even.std(axis=0) == pytest.approx(np.array([4, 2]) / np.sqrt(12), rel=0.05)
    disc = np.hypot(*centred('x="3m" y="2m" radius="1m"').T)
    assert disc.max() <= 1.0
    assert np.median(disc) == pytest.approx(np.sqrt(0.5), rel=0.05)
    normal = centred('x="3m" y="2m" deviation="30cm"')
    assert normal.std(axis=0) == pytest.approx([0.3, 0.3], rel=0.06)
    cut = centred('x="3m" y="2m" deviation="1m" in="3m,2m 5m,2m 5m,4m"')
    assert (cut[:, 1] >= 0.0).all()
    assert (cut[:, 0] >= cut[:, 1]).all()


def test_gap_is_kept() -> None:
    found = places_m(world('<scatter id="a" robot="scout" count="8" gap="50cm"/>'), "a")
    apart_m = np.hypot(*(found[:, None] - found[None, :]).transpose(2, 0, 1))
    assert apart_m[apart_m > 0].min() >= 2 * 0.2032 + 0.5


@pytest.mark.parametrize(
    ("scatter", "text"),
    [
        ('robot="scout" count="200"', "of 200 found a place (each needs a radius of"),
        ('robot="scout" count="1" in="7m,1m 9m,3m"', "only 0 of 1 found a place"),
        ('count="1"', "one of the attributes robot and object"),
        ('robot="scout" object="can" count="1"', "one of the attributes robot and object"),
        ('robot="nothing" count="3"', "unknown robot definition 'nothing'"),
        ('object="nothing" count="3"', "unknown definition 'nothing'"),
        ('robot="scout" count="1" in="1m"', "in: expected x,y of two opposite corners"),
        ('robot="scout" count="1" in="1m,1m 1m,x"', "in: 'x' is not a length"),
        ('robot="scout" count="1" x="1m" y="1m"', "expected with one of radius and deviation"),
        ('robot="scout" count="1" x="1m" y="1m" radius="0"', "must be greater than 0"),
        ('robot="scout" count="1" gap="-1m"', "must not be negative"),
        ('id="r" robot="scout" count="1"', "duplicate id 'r'"),
        ('robot="scout" count="-1"', "count: '-1' is not an integer from 0 to"),
        ('robot="no" count="0"', "unknown robot definition 'no'"),
        ('robot="scout" count="0" in="1m"', "in: expected x,y of two opposite corners"),
        ('robot="scout" count="3" program="no.c" setup="none"', "setup"),
    ],
)
def test_impossible_scatters_are_one_error(scatter: str, text: str) -> None:
    with pytest.raises(WorldError) as caught:
        world(f"<scatter {scatter}/>{SCREEN}")
    assert text in str(caught.value)
    assert len(caught.value.diagnostics) <= 2


def test_none_scattered_is_a_world_like_any_other() -> None:
    none = '<scatter robot="scout" count="0" id="a"/><scatter object="can" count="0"/>'
    found = world(f'{none}<scatter robot="scout" count="2" id="b"/>')
    assert [robot.id for robot in found.robots] == ["b.0", "b.1"]
    assert not found.cylinders


@pytest.mark.parametrize("robots", ["", '<scatter robot="scout" count="0"/>'])
def test_world_whose_scatters_leave_it_without_a_robot_is_refused(robots: str) -> None:
    with pytest.raises(WorldError, match="no robot in the world"):
        world(f'<scatter object="can" count="3"/>{robots}')


def test_id_of_what_is_scattered_is_taken() -> None:
    with pytest.raises(WorldError, match=r"duplicate id 'a\.1'"):
        world('<scatter id="a" robot="scout" count="2"/><robot id="a.1" x="1m" y="1m"/>')


def test_builder_shows_what_is_scattered_as_the_element() -> None:
    elements = f'{CAN}<scatter id="ant" robot="scout" count="3"/><scatter object="can" count="2"/>'
    text = f'<world version="1"><area length="6m" width="4m"/>{elements}</world>'
    builder = WorldBuilder(text=text)
    builder.set("ant", count="4")
    found = shapes(builder.document, builder.world())
    assert [each["part"] for each in found["ant"]] == ["0", "1", "2", "3"]
    assert [each["part"] for each in found["scatter1"]] == ["0.cylinder0", "1.cylinder0"]
    assert builder.names("robot") == []
