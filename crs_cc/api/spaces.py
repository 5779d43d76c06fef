"""Gymnasium's spaces of actions and observations."""

from __future__ import annotations

from typing import Any

import numpy as np

from crs_cc.api.env import Env
from crs_cc.core.arrays import FloatArray
from crs_cc.core.suggest import unknown

try:
    from gymnasium import spaces
except ModuleNotFoundError:
    raise ImportError(
        "gymnasium is not installed (install it with: pip install 'crs_cc[rl]')"
    ) from None

Box = spaces.Box
Dict = spaces.Dict


def action_space(env: Env, robot: str) -> Box:
    """Return the space of a robot's actions, one number for each axis."""
    limits = env.action_limits(robot)
    return Box(-limits, limits, dtype=np.float64)


def observation_space(env: Env, robot: str) -> Dict:
    """Return the observation space of a robot, by name."""
    return Dict(
        {
            each.name: Box(each.low, each.high, each.shape, np.float64)
            for each in env.observation_specs[robot]
        }
    )


def info_of(env: Env, robot: str) -> dict[str, Any]:
    """Return additional information on a robot: its true pose, and the time."""
    pose: FloatArray = env.session.robots[robot].pose
    return {"time_s": env.time_s, "pose": pose}


def check_render_mode(mode: str | None) -> None:
    """Raise ValueError unless an environment can be shown in a mode."""
    if mode not in (None, "svg"):
        raise ValueError(unknown("render mode", str(mode), ("svg",)))
