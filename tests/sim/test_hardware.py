"""Wheel profiles: worked examples, and what must hold for every profile and every slicing."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.sim.hardware import ALL, Wheels, advance, plan_move, plan_speed

ZERO = np.array([0.0])


def wheels_at(right_mps: float, left_mps: float = 0.0) -> Wheels:
    """Gives wheels that have reached a speed at the instant 0."""
    wheels = Wheels.standing(1)
    wheels.speed_mps[:] = right_mps, left_mps
    wheels.cruise_s[:] = math.inf
    return wheels


def way(wheels: Wheels, to_s: float) -> list[float]:
    return advance(wheels, ALL, np.array([to_s]))[0].tolist()


MOVES = {
    # way, first speed, limit, ramp: end and way at the middle of the time
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
def test_a_move_ends_on_time_and_on_its_goal(name):
    (way_m, first_mps, limit_mps, ramp_mps2), end_s, middle_m = MOVES[name]
    wheels = wheels_at(first_mps)
    goal = np.array([[way_m, 0.0]])
    plan_move(wheels, ALL, ZERO, goal, limit_mps=limit_mps, ramp_mps2=ramp_mps2)
    assert wheels.end_s()[0, 0] == pytest.approx(end_s, abs=1e-12)
    first_half_m = way(wheels, end_s / 2)[0]
    if middle_m is not None:
        assert first_half_m == pytest.approx(middle_m, abs=1e-12)
    assert first_half_m + way(wheels, end_s + 1e-9)[0] == pytest.approx(way_m, abs=1e-12)
    assert wheels.speed_mps[0, 0] == 0.0


def test_a_speed_command_ramps_and_then_keeps_the_speed():
    wheels = wheels_at(0.2, -0.2)
    plan_speed(wheels, ALL, ZERO, np.array([[0.5, -0.5]]), ramp_mps2=0.5)
    assert way(wheels, 0.6) == pytest.approx([0.21, -0.21])
    assert way(wheels, 2.6) == pytest.approx([1.0, -1.0])
    assert wheels.speed_mps.tolist() == [[0.5, -0.5]]
    assert math.isinf(wheels.end_s()[0, 0])


def test_a_new_command_starts_from_the_speed_reached():
    wheels = Wheels.standing(1)
    plan_speed(wheels, ALL, ZERO, np.array([[1.0, 1.0]]), ramp_mps2=1.0)
    way(wheels, 0.5)
    plan_speed(wheels, ALL, np.array([0.5]), np.array([[0.0, 0.0]]), ramp_mps2=1.0)
    assert wheels.end_s().tolist() == [[1.0, 1.0]]
    assert way(wheels, 9.0) == pytest.approx([0.125, 0.125])


def test_a_wheel_that_is_not_meant_keeps_its_profile():
    wheels = Wheels.standing(1)
    plan_speed(wheels, ALL, ZERO, np.array([[1.0, 1.0]]), ramp_mps2=1.0)
    way(wheels, 0.5)
    only_left = np.array([[False, True]])
    now_s, none = np.array([0.5]), np.zeros((1, 2))
    plan_speed(wheels, ALL, now_s, none, ramp_mps2=1.0, which=only_left)
    assert way(wheels, 2.0) == pytest.approx([0.375 + 1.0, 0.125])


SPEEDS = st.floats(-1.0, 1.0)
WAYS = st.floats(-50.0, 50.0)
LIMITS = st.floats(0.001, 1.0)
RAMPS = st.floats(0.01, 2.0)


@settings(max_examples=150, deadline=None)
@given(SPEEDS, WAYS, LIMITS, RAMPS, st.lists(st.floats(0.0, 1.0), min_size=1, max_size=60))
def test_slices_of_any_length_add_up_to_the_whole_move(first, way_m, limit, ramp, cuts):
    wheels = wheels_at(first)
    plan_move(wheels, ALL, ZERO, np.array([[way_m, 0.0]]), limit_mps=limit, ramp_mps2=ramp)
    end_s = float(wheels.end_s()[0, 0])
    instants = [share * end_s for share in sorted(cuts)] + [end_s + 0.1]
    assert sum(way(wheels, to_s)[0] for to_s in instants) == pytest.approx(way_m, abs=1e-9)


@settings(max_examples=60, deadline=None)
@given(SPEEDS, WAYS, LIMITS, RAMPS)
def test_speed_and_acceleration_keep_within_their_limits(first, way_m, limit, ramp):
    wheels = wheels_at(first)
    plan_move(wheels, ALL, ZERO, np.array([[way_m, 0.0]]), limit_mps=limit, ramp_mps2=ramp)
    end_s = min(float(wheels.end_s()[0, 0]), 200.0)
    step_s = end_s / 100 or 0.01
    before = first
    for number in range(1, 103):
        way(wheels, number * step_s)
        speed = float(wheels.speed_mps[0, 0])
        assert abs(speed) <= max(limit, abs(first)) + 1e-9
        assert abs(speed - before) <= ramp * step_s + 1e-6
        before = speed
    if end_s < 200.0:
        assert before == 0.0


def test_many_robots_move_as_each_would_alone():
    rng = np.random.default_rng(5)
    count = 40
    ways, limits = rng.uniform(-3, 3, (count, 2)), rng.uniform(0.05, 1, (count, 2))
    ramps, at_s = rng.uniform(0.1, 2, (count, 2)), rng.uniform(0, 4, count)
    together = Wheels.standing(count)
    plan_move(together, ALL, np.zeros(count), ways, limit_mps=limits, ramp_mps2=ramps)
    moved = advance(together, ALL, at_s)
    for row in range(count):
        alone = Wheels.standing(1)
        one = slice(row, row + 1)
        plan_move(alone, ALL, ZERO, ways[one], limit_mps=limits[one], ramp_mps2=ramps[one])
        assert way(alone, at_s[row]) == moved[row].tolist()
