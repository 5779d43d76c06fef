"""A robot as an environment of Gymnasium, for learning.

>>> env = GymEnv(duration_s=1.0)
>>> observation, info = env.reset(seed=1)
>>> observation["sonar"].shape, env.action_space.shape
((16,), (2,))
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from crs_cc.api.env import Env
from crs_cc.api.spaces import action_space, check_render_mode, info_of, observation_space
from crs_cc.core.arrays import FloatArray

import gymnasium  # isort: skip - after `spaces`, which says how to install it

Observation = dict[str, FloatArray]


class GymEnv(gymnasium.Env[Any, Any]):
    """One robot controlled from Python, beside any others that run C or do not move.

    Attributes:
        env: the environment behind this one.
    """

    metadata: dict[str, Any] = {"render_modes": ["svg"]}

    def __init__(self, *arguments: Any, render_mode: str | None = None, **options: Any) -> None:
        """Prepare episodes.

        Args:
            arguments: those of `Env`.
            render_mode: `svg` to have pictures of the run from `render`.
            options: those of `Env`.

        Raises:
            ValueError: several robots could be steered, and `robots` names none of them.
        """
        check_render_mode(render_mode)
        self.env = Env(*arguments, **options)
        if len(self.env.steered) != 1:
            names = ", ".join(self.env.steered)
            raise ValueError(f"several robots to steer: {names} (name one with robots=[...])")
        (self._robot,) = self.env.steered
        self.metadata = {**self.metadata, "render_fps": 1.0 / self.env.step_s}
        self.render_mode = render_mode
        self.action_space = action_space(self.env, self._robot)
        self.observation_space = observation_space(self.env, self._robot)
        self._is_new = True

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Start an episode; the first one has the world's seed unless one is given."""
        if seed is None and self._is_new:
            seed = self.env.session.seed
        super().reset(seed=seed, options=options)
        self._is_new = False
        if seed is None:
            seed = int(self.np_random.integers(2**31))
        observation = self.env.reset(seed)[self._robot]
        return observation, info_of(self.env, self._robot)

    def step(self, action: FloatArray) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Steer the robot for a step."""
        observation = self.env.step({self._robot: action})[self._robot]
        reward = self.env.rewards[self._robot]
        is_done = self.env.done()[self._robot]
        info = info_of(self.env, self._robot)
        return observation, reward, is_done, self.env.is_time_up and not is_done, info

    def render(self) -> Any:
        """Return a picture of the episode so far as SVG, in the mode `svg`."""
        return self.env.session.svg() if self.render_mode == "svg" else None


def vector_env(
    seeds: Sequence[int], *arguments: Any, processes: bool = False, **options: Any
) -> gymnasium.vector.VectorEnv[Any, Any, Any]:
    """Return several environments that are stepped together, one for each seed.

    Args:
        seeds: the seed of each environment's first episode.
        arguments: those of `Env`.
        processes: whether each runs in a process of its own.
        options: those of `Env`; with processes they must be picklable.
    """
    if not seeds:
        raise ValueError("no seeds: there is an environment for each of them")
    makers: list[Callable[[], gymnasium.Env[Any, Any]]] = [
        partial(GymEnv, *arguments, **{**options, "seed": int(seed)}) for seed in seeds
    ]
    if processes:
        return gymnasium.vector.AsyncVectorEnv(makers)
    return gymnasium.vector.SyncVectorEnv(makers)
