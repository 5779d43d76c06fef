"""Several robots as a parallel environment of PettingZoo, for learning together.

>>> env = ParallelEnv(duration_s=1.0)
>>> observations, infos = env.reset(seed=1)
>>> env.agents, observations["robot0"]["sonar"].shape
(['robot0'], (16,))
"""

from __future__ import annotations

from typing import Any

import numpy as np

from crs_cc.api.env import Env, Observations
from crs_cc.api.spaces import (
    Box,
    Dict,
    action_space,
    check_render_mode,
    info_of,
    observation_space,
)
from crs_cc.core.arrays import FloatArray

try:
    import pettingzoo  # type: ignore[import-untyped]  # has no types
except ModuleNotFoundError:
    raise ImportError(
        "pettingzoo is not installed (install it with: pip install 'crs_cc[rl]')"
    ) from None


class ParallelEnv(pettingzoo.ParallelEnv[str, dict[str, FloatArray], FloatArray]):  # type: ignore[misc]
    """All robots of a world that Python steers; their names are those of the agents.

    Attributes:
        env: the environment behind this one.
    """

    metadata: dict[str, Any] = {"name": "crs_cc", "render_modes": ["svg"]}

    def __init__(self, *arguments: Any, render_mode: str | None = None, **options: Any) -> None:
        """Prepare episodes.

        Args:
            arguments: those of `Env`.
            render_mode: `svg` to have pictures of the run from `render`.
            options: those of `Env`.
        """
        check_render_mode(render_mode)
        self.env = Env(*arguments, **options)
        self.metadata = {**self.metadata, "render_fps": 1.0 / self.env.step_s}
        self.render_mode = render_mode
        self._seeds: np.random.Generator | None = None
        self.possible_agents = list(self.env.steered)
        self.agents = list(self.possible_agents)
        self._actions = {name: action_space(self.env, name) for name in self.agents}
        self._observations = {name: observation_space(self.env, name) for name in self.agents}

    def action_space(self, agent: str) -> Box:
        """Return the space of a robot's actions."""
        return self._actions[agent]

    def observation_space(self, agent: str) -> Dict:
        """Return the observation space of a robot."""
        return self._observations[agent]

    def reset(
        self,
        seed: int | None = None,
        options: dict[str, Any] | None = None,  # noqa: ARG002 - of the interface
    ) -> tuple[Observations, dict[str, dict[str, Any]]]:
        """Start an episode; the first one has the world's seed unless one is given."""
        if seed is None and self._seeds is not None:
            seed = int(self._seeds.integers(2**31))
        else:
            seed = self.env.session.seed if seed is None else seed
            self._seeds = np.random.default_rng(seed)
        observations = self.env.reset(seed)
        self.agents = list(self.possible_agents)
        return observations, {name: info_of(self.env, name) for name in self.agents}

    def step(
        self, actions: dict[str, FloatArray]
    ) -> tuple[
        Observations,
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]:
        """Steer the robots for a step; those whose task is over are agents no more."""
        agents = self.agents
        observations, rewards = self.env.step(actions), self.env.rewards
        done, is_time_up = self.env.done(), self.env.is_time_up
        self.agents = [name for name in agents if not (done[name] or is_time_up)]
        return (
            {name: observations[name] for name in agents},
            {name: rewards[name] for name in agents},
            {name: done[name] for name in agents},
            {name: is_time_up and not done[name] for name in agents},
            {name: info_of(self.env, name) for name in agents},
        )

    def render(self) -> Any:
        """Return a picture of the episode so far as SVG, in the mode `svg`."""
        return self.env.session.svg() if self.render_mode == "svg" else None
