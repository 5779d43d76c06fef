"""Robots steered from Python, alone and by the interfaces of Gymnasium and PettingZoo."""

from __future__ import annotations

import re
import subprocess
import sys
import warnings

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from pettingzoo.test import parallel_api_test

import crs_cc

PAIR = """<world version="1" duration="0.5s" seed="3"><area length="6m" width="5m"/>
  <robot id="a" x="1m" y="1m"/><robot id="b" x="3m" y="1m" setup="noisy"/>
  <goal id="there" points="4"><reach x="1.2m" y="1m" radius="15cm"/></goal></world>"""
STANDS = "int main(void) { return 0; }"


def test_a_robot_drives_at_the_speeds_that_python_sets() -> None:
    env = crs_cc.Env(PAIR, robots=["b"], observe=["pose", "speeds", "odometry"], duration_s=9.0)
    env.reset()
    for _ in range(40):
        seen = env.step({"b": [0.1, 0.2]})["b"]
    assert seen["speeds"].tolist() == [0.1, 0.2]
    assert seen["pose"][2] == pytest.approx(2 * np.pi - 2.0 * 0.1 / 0.345, abs=0.1)
    again = crs_cc.Env(PAIR, robots=["b"], observe=["speeds"], actions="vendor", duration_s=9.0)
    again.reset()
    for _ in range(45):
        (speeds,) = again.step({"b": [100, 9999]})["b"].values()
    limit = again.session.robots["b"].model.drive.wheels.speed_limit
    assert speeds.tolist() == pytest.approx([0.254, limit])


def test_an_episode_is_the_same_for_the_same_seed_and_another_one_for_another() -> None:
    env = crs_cc.Env(PAIR, {"a": "samples/scout_c/wander.c"}, duration_s=9.0)
    assert env.steered == ("b",)
    hashes = []
    for seed in (3, None, 4):
        env.reset(seed)
        for number in range(20):
            env.step({"b": [0.2, 0.01 * number]})
        hashes.append(env.session.state_hash())
    assert hashes[0] == hashes[1] != hashes[2]


def test_goals_are_the_rewards_and_end_the_task() -> None:
    env = crs_cc.Env(PAIR)
    env.reset()
    assert not any(env.done().values())
    rewards, steps = [], 0
    while not env.done()["a"]:
        env.step({"a": [0.4, 0.4]})
        rewards.append(env.rewards["a"])
        assert env.rewards["a"] == rewards[-1]  # reading them changes nothing
        steps += 1
    assert sum(rewards) == rewards[-1] == 4.0
    assert 2 < steps < 10


def test_what_is_observed_is_within_its_limits() -> None:
    """No echo is the largest range; what was never measured is 0; a missing device is an error."""
    env = crs_cc.Env(observe=["sonar", "heat", "bumper"])
    seen = env.reset()["robot0"]
    limits = {each.name: each.high for each in env.observation_specs["robot0"]}
    assert seen["sonar"].tolist() == [limits["sonar"]] * 16
    assert (seen["bumper"].shape, seen["heat"].tolist()) == ((24,), [0.0])
    with pytest.raises(ValueError, match="unknown observation 'camera'"):
        crs_cc.Env(observe=["camera"])


@pytest.mark.parametrize(
    ("action", "expected"),
    [
        ([0.1, float("nan")], "expected 2 finite numbers, the speeds of right and left"),
        ([0.1], "a: invalid speeds"),
        (np.zeros((2, 2)), "a: invalid speeds"),
        ("fast", "a: invalid speeds 'fast'"),
        (None, "a: invalid speeds None"),
    ],
)
def test_a_wrong_action_is_one_clear_error(action: object, expected: str) -> None:
    env = crs_cc.Env(PAIR)
    before = env.session.state_hash()
    with pytest.raises(ValueError, match=expected):
        env.step({"b": [0.1, 0.1], "a": action})
    assert env.session.state_hash() == before


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ({"robots": ["c"]}, "unknown robot without a program 'c' (known: a, b)"),
        ({"robots": "both"}, "unknown robot without a program 'both' (known: a, b)"),
        ({"observe": "radar"}, "unknown observation 'radar'"),
        ({"step_s": "0.1"}, "step_s must be a number, not '0.1'"),
        ({"seed": 1.5}, "seed must be an integer, not 1.5"),
        ({"programs": STANDS}, "no robot to steer: each has a program"),
        ({"step_s": 0.07}, "invalid step_s 0.07 (expected a multiple of the timestep, 0.05 s)"),
        ({"actions": "wheels"}, "unknown kind of actions 'wheels'"),
        ({"duration_s": -1.0}, "duration_s must be a positive number, not -1.0"),
        ({"seed": -1}, "seed must be 0 or more, not -1"),
    ],
)
def test_wrong_options_are_one_clear_error(options: dict[str, object], expected: str) -> None:
    with pytest.raises((TypeError, ValueError), match=re.escape(expected)):
        crs_cc.Env(PAIR, **options)
    with pytest.raises(ValueError, match="unknown steered robot 'c'"):
        crs_cc.Env(PAIR).step({"c": [0, 0]})
    with pytest.raises(TypeError, match="actions must be a dictionary"):
        crs_cc.Env(PAIR).step([0, 0])


def test_a_robot_that_joins_later_is_not_done_before() -> None:
    """It was taken for one that has left, and an action for it ended the training."""
    late = PAIR.replace('id="b"', 'id="b" join="0.1s" leave="0.3s"')
    env = crs_cc.ParallelEnv(late, observe=["pose", "speeds"], duration_s=9.0)
    env.reset()
    actions = {"b": [0.0, 0.2], "a": [0.2, 0.0]}  # not in the order of the world
    agents, seen = [], []
    for _ in range(7):
        observations, *_ = env.step(actions)
        agents.append(len(env.agents))
        seen.append({name: each["speeds"].tolist() for name, each in observations.items()})
    assert agents[0] == agents[3] == 2
    assert agents[-1] == 1
    assert seen[0]["b"] == [0.0, 0.0]
    assert seen[4]["a"] == [pytest.approx(0.127), 0.0]
    assert seen[4]["b"] == [0.0, pytest.approx(0.0762)]
    with pytest.raises(ValueError, match="unknown steered robot 'robo'"):
        env.env.action_limits("robo")


def test_gymnasiums_checker_passes() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", UserWarning)
        warnings.filterwarnings("ignore", message=".*Not able to test alternative render modes.*")
        env = crs_cc.GymEnv(
            PAIR, {"a": STANDS}, observe=["sonar", "bumper", "speeds"], render_mode="svg"
        )
        check_env(env)
    assert env.render().startswith("<?xml")
    with pytest.raises(ValueError, match="several robots to steer: a, b"):
        crs_cc.GymEnv(PAIR)


def test_pettingzoos_checker_passes() -> None:
    parallel_api_test(crs_cc.ParallelEnv(PAIR, observe=["sonar", "pose"]), num_cycles=30)


def test_environments_are_vectorised_over_seeds() -> None:
    vector = crs_cc.vector_env([1, 1, 2], PAIR, {"a": STANDS})
    seen, _ = vector.reset()
    assert seen["sonar"].shape == (3, 16)
    assert (seen["sonar"][0] == seen["sonar"][1]).all()
    assert (seen["sonar"][0] != seen["sonar"][2]).any()
    truncated = [vector.step(np.full((3, 2), 0.2))[3].all() for _ in range(10)]
    assert truncated == [False] * 9 + [True]


def test_without_the_extra_there_is_a_hint() -> None:
    code = "import crs_cc, sys; sys.modules[sys.argv[1]] = None; getattr(crs_cc, sys.argv[2])"
    for package, name in (("gymnasium", "GymEnv"), ("pettingzoo", "ParallelEnv")):
        done = subprocess.run(
            [sys.executable, "-c", code, package, name], capture_output=True, text=True, check=False
        )
        message = f"ImportError: {package} is not installed (install it with: pip install"
        assert message in done.stderr.splitlines()[-1]
