"""Axis profiles: worked examples, and properties of every profile and every slicing."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.sim.state.motion_profile import ALL, Axes, advance, plan_move
from tests.sim.kernels.numpy_profiles import plan_speed

ZERO = np.array([0.0])


def axes_at(right_mps: float, left_mps: float = 0.0) -> Axes:
    """Return axes that have reached a speed at time 0."""
    axes = Axes.standing(1)
    axes.speed[0, :2] = right_mps, left_mps
    axes.cruise_s[:] = math.inf
    return axes


def way(axes: Axes, to_s: float) -> list[float]:
    return advance(axes, ALL, np.array([to_s]))[0].tolist()


MOVES = {
    # distance, first speed, limit, ramp: end and distance at half of the time
    "too short to reach the limit": ((0.16, 0.0, 1.0, 1.0), 0.8, 0.08),
    "ramp, cruise, brake": ((1.0, 0.0, 0.5, 1.0), 2.5, 0.5),
    "backwards": ((-1.0, 0.0, 0.5, 1.0), 2.5, -0.5),
    "from a speed": ((1.0, 0.5, 0.5, 1.0), 2.25, None),
    "slows to the limit first": ((1.0, 1.0, 0.5, 1.0), 2.0, 0.625),
    "brakes at once and stops on the goal": ((0.5, 1.0, 1.0, 1.0), 1.0, 0.375),
    "overshoots and comes back": ((0.0, 1.0, 1.0, 1.0), 1.0 + 2 * math.sqrt(0.5), None),
    "turns round": ((-1.0, 0.5, 0.5, 1.0), 3.25, None),
    "no way at all": ((0.0, 0.0, 0.5, 1.0), 0.0, 0.0),
}


@pytest.mark.parametrize("name", MOVES)
def test_move_ends_on_time_at_goal(name):
    (way_m, first_mps, limit_mps, ramp_mps2), end_s, middle_m = MOVES[name]
    axes = axes_at(first_mps)
    goal = np.array([[way_m, 0.0, 0.0]])
    plan_move(axes, ALL, ZERO, goal, limit=limit_mps, ramp=ramp_mps2)
    assert axes.end_s()[0, 0] == pytest.approx(end_s, abs=1e-12)
    first_half_m = way(axes, end_s / 2)[0]
    if middle_m is not None:
        assert first_half_m == pytest.approx(middle_m, abs=1e-12)
    assert first_half_m + way(axes, end_s + 1e-9)[0] == pytest.approx(way_m, abs=1e-12)
    assert axes.speed[0, 0] == 0.0


def test_speed_command_ramps_and_then_keeps_speed():
    axes = axes_at(0.2, -0.2)
    plan_speed(axes, ALL, ZERO, np.array([[0.5, -0.5, 0.0]]), ramp=0.5)
    assert way(axes, 0.6) == pytest.approx([0.21, -0.21, 0.0])
    assert way(axes, 2.6) == pytest.approx([1.0, -1.0, 0.0])
    assert axes.speed.tolist() == [[0.5, -0.5, 0.0]]
    assert math.isinf(axes.end_s()[0, 0])


def test_new_command_starts_from_speed_reached():
    axes = Axes.standing(1)
    plan_speed(axes, ALL, ZERO, np.array([[1.0, 1.0, 0.0]]), ramp=1.0)
    way(axes, 0.5)
    plan_speed(axes, ALL, np.array([0.5]), np.zeros((1, 3)), ramp=1.0)
    assert axes.end_s().tolist() == [[1.0, 1.0, 0.5]]
    assert way(axes, 9.0) == pytest.approx([0.125, 0.125, 0.0])


def test_unselected_axis_keeps_its_profile():
    axes = Axes.standing(1)
    plan_speed(axes, ALL, ZERO, np.array([[1.0, 1.0, 0.0]]), ramp=1.0)
    way(axes, 0.5)
    only_left = np.array([[False, True, False]])
    now_s, none = np.array([0.5]), np.zeros((1, 3))
    plan_speed(axes, ALL, now_s, none, ramp=1.0, which=only_left)
    assert way(axes, 2.0) == pytest.approx([0.375 + 1.0, 0.125, 0.0])


SPEEDS = st.floats(-1.0, 1.0)
WAYS = st.floats(-50.0, 50.0)
LIMITS = st.floats(0.001, 1.0)
RAMPS = st.floats(0.01, 2.0)


@settings(max_examples=150, deadline=None)
@given(SPEEDS, WAYS, LIMITS, RAMPS, st.lists(st.floats(0.0, 1.0), min_size=1, max_size=60))
def test_slices_of_any_length_add_up_to_move(first, way_m, limit, ramp, cuts):
    axes = axes_at(first)
    plan_move(axes, ALL, ZERO, np.array([[way_m, 0.0, 0.0]]), limit=limit, ramp=ramp)
    end_s = float(axes.end_s()[0, 0])
    instants = [share * end_s for share in sorted(cuts)] + [end_s + 0.1]
    assert sum(way(axes, to_s)[0] for to_s in instants) == pytest.approx(way_m, abs=1e-9)


@settings(max_examples=60, deadline=None)
@given(SPEEDS, WAYS, LIMITS, RAMPS)
def test_speed_and_acceleration_stay_within_limits(first, way_m, limit, ramp):
    axes = axes_at(first)
    plan_move(axes, ALL, ZERO, np.array([[way_m, 0.0, 0.0]]), limit=limit, ramp=ramp)
    end_s = min(float(axes.end_s()[0, 0]), 200.0)
    step_s = end_s / 100 or 0.01
    before = first
    for number in range(1, 103):
        way(axes, number * step_s)
        speed = float(axes.speed[0, 0])
        assert abs(speed) <= max(limit, abs(first)) + 1e-9
        assert abs(speed - before) <= ramp * step_s + 1e-6
        before = speed
    if end_s < 200.0:
        assert before == 0.0


def test_batched_robots_move_as_single_ones():
    rng = np.random.default_rng(5)
    count = 40
    ways, limits = rng.uniform(-3, 3, (count, 3)), rng.uniform(0.05, 1, (count, 3))
    ramps, at_s = rng.uniform(0.1, 2, (count, 3)), rng.uniform(0, 4, count)
    together = Axes.standing(count)
    plan_move(together, ALL, np.zeros(count), ways, limit=limits, ramp=ramps)
    moved = advance(together, ALL, at_s)
    for row in range(count):
        alone = Axes.standing(1)
        one = slice(row, row + 1)
        plan_move(alone, ALL, ZERO, ways[one], limit=limits[one], ramp=ramps[one])
        assert way(alone, at_s[row]) == moved[row].tolist()
