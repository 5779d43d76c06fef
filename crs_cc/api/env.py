"""Robots steered from Python, beside robots that run C programs, in steps of equal length.

>>> env = Env(observe=["sonar", "pose"])        # one Scout in the empty world
>>> observations = env.reset()
>>> observations["robot0"]["sonar"].shape
(16,)
>>> while env.time_s < 2.0:
...     observations = env.step({"robot0": [0.3, 0.3]})
>>> round(float(observations["robot0"]["pose"][0]), 2)
0.51
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Final, Literal

import numpy as np
import numpy.typing as npt

from crs_cc.api.numbers import check_number
from crs_cc.api.observations import ObservationSpec, measure
from crs_cc.api.program_choice import Programs
from crs_cc.api.session import Session
from crs_cc.api.worlds import WorldSource, world_of
from crs_cc.core.arrays import FloatArray
from crs_cc.core.suggest import unknown
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.model.world import WorldModel

Actions = Literal["speeds", "vendor"]
Observations = dict[str, dict[str, FloatArray]]
"""Observations by robot and name."""

_ROUNDING: Final = 1e-6


class Env:
    """A world whose robots are steered from Python, all or some.

    Attributes:
        world: the world at the start.
        steered: the names of the steered robots.
        timesteps_per_step: number of timesteps of each step.
        observation_specs: what is observed of each robot, by the robot's name.
        rewards: the reward of each robot for the last step, by the robot's name.
        session: the run; a new one for each episode.
    """

    def __init__(
        self,
        world: WorldModel | WorldSource | None = None,
        programs: Programs = None,
        *,
        robots: Sequence[str] | str | None = None,
        observe: Sequence[str] | str = ("sonar",),
        actions: Actions = "speeds",
        step_s: float | None = None,
        duration_s: float | None = None,
        seed: int | None = None,
        reward: Callable[[Session, str], float] | None = None,
        is_done: Callable[[Session, str], bool] | None = None,
    ) -> None:
        """Prepare episodes.

        Args:
            world: the world, or what `load_world` takes.
            programs: what the other robots run, see `Session`.
            robots: the names of the steered robots, or one name; by default those without a
                program.
            observe: what is observed of them, several names or one: sensors, `pose`, `odometry`,
                `speeds`.
            actions: what an action consists of, one number for each axis (`RobotView.axis_names`):
                `speeds` in m/s and rad/s, or `vendor` for the vendor's velocities, in 0.1 inch/s
                and 0.1 degree/s, as of `vm`.
            step_s: the time from one action to the next [s], a multiple of the timestep; by
                default one timestep.
            duration_s: the length of an episode [s]; by default the world's duration.
            seed: the random seed of episodes; by default the world's.
            reward: returns a robot's reward for the last step; by default the points of the
                world's goals that were met in it.
            is_done: returns whether the task is over for a robot; by default when all of the
                world's goals have been met or have failed, never without goals.

        Raises:
            ValueError: an argument is invalid.
            CompileError: a program is invalid.
            WorldError: the world is invalid.
        """
        self.world = world_of(world)
        check_number("step_s", step_s)
        robots, observe = _names(robots), _names(observe) or ()
        if actions not in ("speeds", "vendor"):
            raise ValueError(unknown("kind of actions", actions, ("speeds", "vendor")))
        self._actions, self._duration_s, self._seed = actions, duration_s, seed
        self._reward, self._is_done = reward, is_done
        self.timesteps_per_step = self._timesteps(step_s)
        self.session = Session(self.world, programs, seed=seed, duration_s=duration_s)
        self._programs = self.session.programs
        self.steered = self._chosen(robots)
        self._unit = np.ones((len(self.world.robots), AXES))
        if actions == "vendor":
            self._unit = self.session.inner.environment.drives.unit
        self._observed = tuple(dict.fromkeys(observe))
        self.observation_specs = {
            name: [ObservationSpec.of(each, self.session.robots[name]) for each in self._observed]
            for name in self.steered
        }
        self._begin()

    def _begin(self) -> None:
        self._views = {name: self.session.robots[name] for name in self.steered}
        self._rows = np.array([view.number for view in self._views.values()], dtype=np.intp)
        self._points = 0.0  # of the goals met before the last step
        self.rewards = dict.fromkeys(self.steered, 0.0)

    # -- an episode ----------------------------------------------------------------------------

    def reset(self, seed: int | None = None) -> Observations:
        """Start an episode; return the first observations.

        Args:
            seed: the random seed; by default that of the environment.
        """
        seed = self._seed if seed is None else seed
        self.session = Session(self.world, self._programs, seed=seed, duration_s=self._duration_s)
        self._begin()
        return self.observe()

    def step(self, actions: Mapping[str, npt.ArrayLike]) -> Observations:
        """Steer robots, run the world for a step, and return the observations.

        Args:
            actions: of each robot, one number for each axis, clipped to its limit; a robot without
                an action continues. Those of robots that are not in the world have no effect.

        Raises:
            TypeError: the actions are not a dictionary.
            ValueError: a robot is unknown, or an action has another shape or is not finite.
        """
        if not isinstance(actions, Mapping):
            kind = type(actions).__name__
            raise TypeError(f"actions must be a dictionary by the robots' names, not {kind}")
        speeds = np.zeros((len(actions), AXES))
        rows = np.zeros(len(actions), dtype=np.intp)
        for place, (name, action) in enumerate(actions.items()):
            if name not in self._views:
                raise ValueError(unknown("steered robot", name, self.steered))
            robot = self._views[name]
            speeds[place], rows[place] = robot.checked_speeds(action), robot.number
        order = np.argsort(rows)
        order = order[self.session.inner.environment.present[rows[order]]]
        if len(order):
            rows, speeds = rows[order], speeds[order]
            self.session.inner.environment.drive(rows, speeds * self._unit[rows])
        self.session.step(self.timesteps_per_step)
        self.rewards = self._rewards()
        return self.observe()

    def observe(self) -> Observations:
        """Return the current observations of each robot, as new arrays."""
        measure(self.session.inner.environment, self._observed, self._rows)
        return {
            name: {
                each.name: each.value(self._views[name]) for each in self.observation_specs[name]
            }
            for name in self.steered
        }

    @property
    def time_s(self) -> float:
        """The simulated time of the episode [s]."""
        return self.session.time_s

    def _rewards(self) -> dict[str, float]:
        """Return the reward of each robot for the step that has just been run."""
        if self._reward is not None:
            return {name: float(self._reward(self.session, name)) for name in self.steered}
        points = sum(goal.points for goal in self.session.goals if goal.status == "met")
        gained = points - self._points
        self._points = points
        return dict.fromkeys(self.steered, gained)

    def done(self) -> dict[str, bool]:
        """Return for which robots the task is over, or which have left the world."""
        left = np.isfinite(self.session.inner.environment.last_state.presence.left_s)
        return {
            name: self._is_over(name) or bool(left[self._views[name].number])
            for name in self.steered
        }

    @property
    def step_s(self) -> float:
        """The time from one action to the next [s]."""
        return self.timesteps_per_step * self.world.timestep_s

    @property
    def is_time_up(self) -> bool:
        """Whether the duration of the episode has passed."""
        return self.session.is_time_up

    def action_limits(self, robot: str) -> FloatArray:
        """Return the largest magnitude of each number of an action, (axes,).

        Raises:
            ValueError: the robot is not steered.
        """
        if robot not in self._views:
            raise ValueError(unknown("steered robot", robot, self.steered))
        view = self._views[robot]
        limits = self.session.inner.environment.drives.speed_limit[view.number]
        limit: FloatArray = limits / self._unit[view.number]
        return limit[: len(view.axis_names)]

    def _is_over(self, robot: str) -> bool:
        if self._is_done is not None:
            return bool(self._is_done(self.session, robot))
        goals = self.session.goals
        return bool(goals) and all(goal.status in ("met", "failed") for goal in goals)

    def _timesteps(self, step_s: float | None) -> int:
        """Return the number of timesteps of a step."""
        if step_s is None:
            return 1
        timesteps = step_s / self.world.timestep_s
        if not (timesteps > 0.5 and abs(timesteps - round(timesteps)) < _ROUNDING):
            text = f"a multiple of the timestep, {self.world.timestep_s:g} s"
            raise ValueError(f"invalid step_s {step_s!r} (expected {text})")
        return round(timesteps)

    def _chosen(self, robots: Sequence[str] | None) -> tuple[str, ...]:
        """Return the names of the steered robots, in the world's order."""
        steered = self.session.steered
        wanted = steered if robots is None else robots
        for name in wanted:
            if name not in steered:
                raise ValueError(unknown("robot without a program", name, steered))
        if not wanted:
            raise ValueError("no robot to steer: each has a program")
        return tuple(name for name in steered if name in wanted)


def _names(names: Sequence[str] | str | None) -> Sequence[str] | None:
    return (names,) if isinstance(names, str) else names
