"""What becomes of single values, worked out by hand."""

import math

import numpy as np
import pytest

from crs_cc.sim.model.degradation import Degradation, degradables
from tests.sim.degradation.law import Law


def fault(**what) -> Degradation:
    return Degradation("robot0", what.pop("device", "sonar"), **what)


@pytest.mark.parametrize(
    ("what", "told"),
    [
        ({"bias": 0.5}, 2.5),
        ({"gain": 0.25}, 0.5),
        ({"gain": -1.0}, -2.0),
        ({"step": 0.75}, 2.25),
        ({"step": 1e-300}, 2.0),
        ({"stuck": 7.0}, 7.0),
        ({"stuck": "hold"}, 2.0),
        ({"dead": True}, math.nan),
        ({"dropouts": 1.0}, math.nan),
        ({"dropouts": 0.0, "bias": 1.0}, 3.0),
        ({"gain": 2.0, "bias": 0.6, "step": 1.0}, 5.0),  # 4.6, rounded last
        ({"bias": 1.0, "stuck": 0.3}, 0.3),
        ({"gain": 1e3, "bias": 1e4}, 12_000.0),
    ],
)
def test_each_kind_by_itself_and_in_its_order(what, told):
    assert Law.of(fault(**what)).read(2.0) == pytest.approx(told, nan_ok=True)


def test_where_nothing_was_measured_nothing_is_told():
    law = Law.of(fault(bias=1.0, gain=0.0, noise=1.0, step=0.1))
    assert law.read([math.inf, math.nan, 1.0])[:2] == pytest.approx(
        [math.inf, math.nan], nan_ok=True
    )


def test_one_element_alone_is_meant_or_all():
    assert Law.of(fault(element=1, bias=1.0)).read([1.0, 2.0, 3.0]) == [1.0, 3.0, 3.0]
    assert Law.of(fault(bias=1.0)).read([1.0, 2.0, 3.0]) == [2.0, 3.0, 4.0]


@pytest.mark.parametrize(
    ("at_s", "told"),
    [(9.99, 2.0), (10.0, 6.0), (14.99, 6.0), (15.0, 6.0), (15.5, 5.0), (16.0, 4.0), (17.0, 2.0)],
)
def test_it_begins_at_its_onset_and_fades_after_its_duration(at_s, told):
    """Gain 2 and bias 2 of a value of 2: +4 at most; a quarter less each half second of 2 s."""
    law = Law.of(fault(gain=2.0, bias=2.0, onset_s=10.0, duration_s=5.0, recovery_s=2.0))
    assert law.read(2.0, at_s) == pytest.approx(told)


def test_without_a_recovery_it_ends_at_once():
    law = Law.of(fault(bias=1.0, onset_s=0.15, duration_s=0.15))
    told = [law.read(0.0, cycle * 0.05) for cycle in range(8)]
    assert told == [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0]


def test_what_is_stuck_keeps_the_last_value_before_the_onset_and_lets_go_slowly():
    law = Law.of(fault(stuck="hold", onset_s=1.0, duration_s=1.0, recovery_s=1.0))
    told = [
        law.read(value, at_s)
        for at_s, value in (
            (0.5, 3.0),
            (0.9, 4.0),
            (1.0, 9.0),
            (1.9, 8.0),
            (2.25, 8.0),
            (2.75, 8.0),
            (3.0, 8.0),
        )
    ]
    assert told == pytest.approx([3.0, 4.0, 4.0, 4.0, 5.0, 7.0, 8.0])  # fmt: skip


def test_rounding_moves_no_value_across_the_onset():
    """0.1 + 0.2 is a little more than 0.3, and both are the same instant."""
    law = Law.of(fault(stuck="hold", onset_s=0.1 + 0.2))
    assert [law.read(value, at_s) for at_s, value in ((0.2, 4.0), (0.3, 9.0))] == [4.0, 4.0]
    law = Law.of(fault(device="drive", stuck="hold", onset_s=0.3))
    for speed, from_s, to_s in ((4.0, 0.1, 0.2), (9.0, 0.2, 0.1 + 0.2)):
        assert law.go((speed, 0.0, 0.0), from_s, to_s)[0] == speed * (to_s - from_s)
    assert law.go((0.0, 0.0, 0.0), 0.3, 0.4)[0] == pytest.approx(0.9)


def test_what_has_told_nothing_yet_is_stuck_at_its_first_value():
    law = Law.of(fault(stuck="hold"))
    assert [law.read(value) for value in (math.nan, 3.0, 4.0)] == pytest.approx(
        [math.nan, 3.0, 3.0], nan_ok=True
    )


def test_a_delay_tells_the_last_value_that_is_old_enough():
    law = Law.of(fault(delay_s=0.3))
    told = [law.read(float(n), n / 10) for n in range(10)]
    assert told == [0, 0, 0, 0, 1, 2, 3, 4, 5, 6]


def test_a_delay_is_known_at_its_onset_since_values_were_kept_before():
    law = Law.of(fault(delay_s=0.2, onset_s=0.5, duration_s=0.2, recovery_s=0.2))
    told = [law.read(float(n), n / 10) for n in range(10)]
    assert told == pytest.approx([0, 1, 2, 3, 4, 3, 4, 5, 7, 9])  # at 0.8 s halfway from 6 to 8


def test_a_long_delay_of_many_values_is_right_to_a_62nd_of_it():
    law = Law.of(fault(delay_s=10.0))
    told = [law.read(n / 100, n / 100) for n in range(3000)]
    late = np.arange(3000) / 100 - told
    assert late[1100:].min() >= 10.0 - 1e-6
    assert late[1100:].max() <= 10.0 * (1 + 1 / 62) + 0.011


def test_noise_has_the_deviation_that_was_asked_for():
    """4,000 deviates: the standard error of their deviation is 1.1%, of their mean 1.6%."""
    law = Law.of(fault(noise=0.5))
    told = np.array([law.read(2.0) for _ in range(4000)])
    assert told.std() == pytest.approx(0.5, rel=0.05)
    assert told.mean() == pytest.approx(2.0, abs=0.03)


def test_noise_fades_in_its_deviation():
    law = Law.of(fault(noise=0.5, duration_s=1.0, recovery_s=1.0))
    assert np.std([law.read(2.0, 1.75) for _ in range(4000)]) == pytest.approx(0.125, rel=0.05)


@pytest.mark.parametrize(
    ("what", "share"),
    [({"dropouts": 0.3}, 0.3), ({"dropouts": 0.6, "duration_s": 0.5, "recovery_s": 1.0}, 0.3),
     ({"dead": True, "duration_s": 0.5, "recovery_s": 1.0}, 0.5)],
)  # fmt: skip
def test_dropouts_come_as_often_as_was_asked_for(what, share):
    """4,000 values: the standard error is at most 0.8%."""
    law = Law.of(fault(**what))
    lost = np.isnan([law.read(2.0, 1.0) for _ in range(4000)])
    assert lost.mean() == pytest.approx(share, abs=0.025)


def test_several_work_one_after_the_other():
    gain, bias = fault(gain=2.0), fault(bias=1.0)
    assert Law.of(gain, bias).read(3.0) == 7.0
    assert Law.of(bias, gain).read(3.0) == 8.0
    assert Law.of(bias, bias, bias).read(3.0) == 6.0
    assert math.isnan(Law.of(fault(dead=True), bias).read(3.0))
    assert Law.of(fault(dead=True), fault(stuck=5.0)).read(3.0) == 5.0


def test_two_of_a_kind_draw_different_numbers():
    law = Law.of(fault(noise=1.0), fault(noise=1.0))
    told = np.array([law.read(0.0) for _ in range(4000)])
    assert told.std() == pytest.approx(math.sqrt(2), rel=0.05)


def test_a_direction_mixes_the_shorter_way_around():
    law = Law.of(fault(device="compass", stuck=math.radians(350), duration_s=1.0, recovery_s=1.0))
    told = law.read(math.radians(10), 1.5, device="compass")
    assert math.degrees(told) % 360 == pytest.approx(0.0, abs=1e-6)


def test_nothing_changes_for_other_robots_and_devices():
    noisy = Degradation("robot1", "sonar", noise=1.0)
    alone, both = Law.of(noisy, robots=2), Law.of(fault(noise=1.0), noisy, robots=2)
    told = [both.read(0.0, robot=n % 2) for n in range(40)]
    assert told[1::2] == [alone.read(0.0, robot=1) for _ in range(20)]
    assert both.read(1.0, device="infrared") == 1.0


def test_many_robots_at_once_are_told_the_same_as_one_after_the_other():
    faults = [Degradation(f"robot{n}", "sonar", bias=float(n), noise=0.1) for n in range(5)]
    law, other = Law.of(*faults, robots=6), Law.of(*faults, robots=6)
    values = np.arange(6.0)[:, None]
    together = law.degradations.alter(law.state, "sonar", np.arange(6), values, np.ones(6))
    assert together[:, 0].tolist() == [other.read(float(n), robot=n) for n in range(6)]
    assert together[5, 0] == 5.0


def test_a_sound_device_is_left_as_it_is():
    law = Law.of(fault(bias=1.0))
    values = np.ones((1, 3))
    for name in set(degradables()) - {"sonar"}:
        told = law.degradations.alter(law.state, name, np.array([0]), values, np.ones(1))
        assert told is values


# -- motions ---------------------------------------------------------------------------------------


def motion(**what) -> Degradation:
    return fault(device="drive", **what)


@pytest.mark.parametrize(
    ("what", "ways"),
    [
        ({"element": 0, "gain": 0.5}, [0.1, 0.2]),
        ({"bias": 0.1}, [0.4, 0.4]),
        ({"element": 1, "dead": True}, [0.2, 0.0]),
        ({"dropouts": 1.0}, [0.0, 0.0]),
        ({"element": 0, "stuck": -0.05}, [-0.1, 0.2]),
        ({"step": 0.04}, [0.16, 0.16]),
    ],
)
def test_the_ways_of_axes_change_with_their_speeds(what, ways):
    """2 s at 0.1 m/s."""
    assert Law.of(motion(**what)).go([0.1, 0.1, 0.0], 0.0, 2.0)[:2] == pytest.approx(ways)


def test_an_onset_within_a_timestep_counts_to_the_instant():
    law = Law.of(motion(dead=True, onset_s=1.3, duration_s=1.0, recovery_s=2.0))
    ways = [law.go([1.0, 1.0, 0.0], float(n), n + 1.0)[0] for n in range(5)]
    # 0.3 s of the second; of the third from 2.3 s on t/2: 0.7^2 / 4; then up to 1 at 4.3 s
    assert ways == pytest.approx([1.0, 0.3, 0.49 / 4, (1.7**2 - 0.7**2) / 4, 1 - 0.3**2 / 4])


def test_however_a_time_is_cut_the_way_is_the_same():
    fast = motion(gain=0.7, bias=0.1, noise=0.3, delay_s=0.2, onset_s=0.1, duration_s=0.5)
    whole, cut = Law.of(fast), Law.of(fast)
    for cycle in range(20):
        whole.state.cycle = cut.state.cycle = cycle
        at_s = cycle * 0.05
        way = np.array(whole.go([0.3, 0.1, 0.0], at_s, at_s + 0.05))
        parts = (
            cut.go([0.3, 0.1, 0.0], at_s, at_s + 0.02),
            cut.go([0.3, 0.1, 0.0], at_s + 0.02, at_s + 0.05),
        )
        assert way == pytest.approx(np.sum(parts, axis=0), abs=1e-9)


def test_a_delayed_motion_is_the_one_of_the_delay_before():
    law = Law.of(motion(delay_s=0.25))
    speeds = [0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0]
    ways = [law.go([speed, 0.0, 0.0], n * 0.5, n * 0.5 + 0.5)[0] for n, speed in enumerate(speeds)]
    assert ways == pytest.approx([0, 0.25, 0.5, 0.5, 0.25, 0, 0])


def test_an_axis_sticks_at_the_speed_that_it_had():
    law = Law.of(motion(stuck="hold", onset_s=1.0, duration_s=1.0))
    ways = [
        law.go([v, 0, 0], n * 0.5, n * 0.5 + 0.5)[0] for n, v in enumerate([0.1, 0.2, 0.9, 0, 0.9])
    ]
    assert ways == pytest.approx([0.05, 0.1, 0.1, 0.1, 0.45])
