"""Polygons: validity and triangulation."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from crs_cc.sim.geometry.placement import misplaced
from crs_cc.sim.model.polygon import (
    area_m2,
    centroid_m,
    second_moment_m4,
    triangles,
    validation_error,
)
from crs_cc.sim.model.robot import Drive, RobotModel
from crs_cc.sim.model.world import Area, Cylinder, Polygon, Pose, Robot, WorldModel

SQUARE = np.array([(1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 3.0)])


@st.composite
def stars(draw):
    """Draw a concave polygon around the origin, in some cases with collinear corners."""
    radii = draw(st.lists(st.floats(0.2, 5), min_size=3, max_size=30))
    angles = np.arange(len(radii)) * math.tau / len(radii)
    star = np.array(radii)[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    if not draw(st.booleans()):
        return star
    middles = (star + np.roll(star, -1, axis=0)) / 2
    return np.stack([star, middles], axis=1).reshape(-1, 2)


@given(stars())
def test_triangulation_covers_the_polygon_counter_clockwise(star):
    parts = [area_m2(star[three]) for three in triangles(star)]
    assert min(parts) > 0
    assert sum(parts) == pytest.approx(area_m2(star))
    assert len(parts) <= len(star) - 2


def comb(teeth: int) -> np.ndarray:
    tips = [(teeth - n / 2, 10.0 if n % 2 == 0 else 1.0) for n in range(2 * teeth + 1)]
    return np.array([(0.0, 0.0), (float(teeth), 0.0), *tips])


def spiral(turns: int) -> np.ndarray:
    angle = np.linspace(1, turns * math.tau, 20 * turns)
    way = np.column_stack([np.cos(angle), np.sin(angle)])
    return np.concatenate([angle[:, None] * way, ((angle + 2)[:, None] * way)[::-1]])[::-1]


@pytest.mark.parametrize("corners", [comb(60), spiral(5)], ids=["comb", "spiral"])
def test_triangulation_of_combs_and_spirals(corners):
    assert validation_error(corners) == ""
    parts = [area_m2(corners[three]) for three in triangles(corners)]
    assert min(parts) > 0
    assert sum(parts) == pytest.approx(area_m2(corners))


def test_area_centroid_and_moment_match_the_formulas():
    assert area_m2(SQUARE) == 4.0
    assert area_m2(SQUARE[::-1]) == -4.0
    assert centroid_m(SQUARE).tolist() == centroid_m(SQUARE[::-1]).tolist() == [2.0, 2.0]
    assert second_moment_m4(SQUARE - 2) == pytest.approx(2 * 2 * (2**2 + 2**2) / 12)


@pytest.mark.parametrize("turn", range(5))
@pytest.mark.parametrize("step", [1, -1])
def test_sides_too_close_are_found_for_any_first_corner(turn, step):
    narrow = np.array([(0, 0), (4, 0), (4, 3), (2, 0.0005), (0, 3)])
    assert "meets the side" in validation_error(np.roll(narrow, turn, axis=0)[::step])
    spike = np.array([(0, 0), (4, 0), (4, 3), (6, 3), (2, 3.0001)])
    assert "meets the side" in validation_error(np.roll(spike, turn, axis=0)[::step])


def test_clockwise_corners_are_reversed():
    assert area_m2(np.array(Polygon.of("p", SQUARE[::-1]).corners_m)) == 4.0


def test_initial_overlaps_are_found_for_all_sizes():
    rng = np.random.default_rng(3)
    cylinders = tuple(
        Cylinder(f"c{n}", Pose(*rng.uniform(5, 95, 2)), float(rng.choice([0.01, 0.3, 4.0])))
        for n in range(60)
    )
    models = [RobotModel(f"m{size}", size, Drive(0.3)) for size in (0.05, 0.4, 3.0)]
    robots = tuple(Robot(f"r{n}", models[n % 3], Pose(*rng.uniform(5, 95, 2))) for n in range(300))
    world = WorldModel("w", Area(0, 0, 100, 100), cylinders=cylinders, robots=robots)
    elements = [(c.pose, c.radius_m, f"cylinder {c.id!r}") for c in cylinders]
    expected = set()
    for number, robot in enumerate(robots):
        before = [(r.start, r.model.radius_m, f"robot {r.id!r}") for r in robots[:number]]
        for pose, radius_m, name in [*elements, *before]:
            away_m = math.dist((pose.x_m, pose.y_m), (robot.start.x_m, robot.start.y_m))
            if away_m < radius_m + robot.model.radius_m - 1e-6:
                expected.add((number, f"robot {robot.id!r} overlaps {name}"))
    assert set(misplaced(world)) == expected
    assert len(expected) > 50
    assert len(misplaced(world, 7)) == 7
