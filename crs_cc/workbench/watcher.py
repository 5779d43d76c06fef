"""Reports the progress of a session to a feed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.debug.world.events import KINDS, world_events

if TYPE_CHECKING:
    from crs_cc.session.session import Session
    from crs_cc.sim.engine.step import Step
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.workbench.feed import Feed

_KINDS: Final = tuple(kind for kind in KINDS if kind != "tick" and "-" not in kind)
_SLACK_S: Final = 1e-9


class Watcher:
    """Watches a session: its frames, events, and what programs write.

    Data before the latest observed timestep is known, and not reported again.

    Attributes:
        feed: receives the data.
    """

    def __init__(self, feed: Feed) -> None:
        self.feed = feed
        self._timesteps = -1
        self._is_off = False
        self._names: tuple[str, ...] = ()
        self._alive: tuple[bool, ...] = ()
        self._has_turret = False

    def begin(self, session: Session, known: int = 0) -> None:
        """Watch a session from its current position.

        Args:
            session: the session.
            known: up to which timestep the feed knows it.
        """
        self._session = session
        self._alive = tuple(session.state.alive.tolist())
        self._timesteps = max(known, session.timesteps)
        if not known:
            self.show()

    def step(self, step: Step) -> None:
        """Report the events of a timestep that has just ended."""
        session = self._session
        if self._is_off:
            return
        self.feed.trace.add(session.environment)
        if session.timesteps <= self._timesteps:
            if session.timesteps == self._timesteps:  # only new ends are reported
                self._alive = tuple(session.state.alive.tolist())
            return
        self._timesteps = session.timesteps
        for each in world_events(step, session.environment.world, _KINDS):
            self.feed.event(each.time_s, each.kind, each.robot, each.text, each.place)
        self.feed.messages.step(step)
        self.report_ends()
        self.show(is_last=False)

    def report_ends(self) -> None:
        """Report the programs that have ended since the last call."""
        session = self._session
        alive = tuple(session.state.alive.tolist())
        if alive == self._alive or session.timesteps < self._timesteps:
            return
        for robot, (was, now) in enumerate(zip(self._alive, alive, strict=False)):
            if was and not now:
                result = session.state.robot_result(robot)
                text = f"{result.id}'s program {result.outcome}"
                if result.exit_status is not None:
                    text += f" with {result.exit_status}"
                text += f" at {result.time_s:.3f} s"
                if result.error is not None:
                    text = f"{result.id}: {result.error.location}: {result.error.text}"
                time_s = min(result.time_s, session.time_s)  # the run may end inside a timestep
                self.feed.event(time_s, result.outcome, robot, text)
        self._alive = alive

    def stop(self) -> None:
        """Report nothing until `resume`: the run switches to another branch."""
        self._is_off = True

    def resume(self, timesteps: int) -> None:
        """Continue in another branch of the run, of which the feed has a number of timesteps."""
        self._is_off = False
        self._timesteps = max(timesteps, self._session.timesteps)
        self._alive = tuple(self._session.state.alive.tolist())
        self._names = ()

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Report the output of a program."""
        if self._is_off or self._session.timesteps < self._timesteps:
            return
        clock_s = float(self._session.state.clock_s[robot])
        time_s = clock_s if np.isfinite(clock_s) else self._session.time_s
        self.feed.write(time_s, robot, stream, content)

    def show(self, *, is_last: bool = True) -> None:
        """Show where everything is now."""
        environment = self._session.environment
        self.feed.trace.add(environment)
        if environment.names is not self._names:
            self._names = environment.names
            robots = [robot.id for robot in environment.world.robots]
            self.feed.roster(environment.time_s, robots, list(environment.pushables))
            self._has_turret = any(
                "turret" in each.model.drive.axis_names for each in environment.world.robots
            )
        self.feed.frame(environment.time_s, self._values(), is_last=is_last)

    def truncate(self, timestep: int | None) -> None:
        """Discard data after a timestep, or after now, as the run diverges from it."""
        session = self._session
        here = session.timesteps
        self._timesteps = here if timestep is None else min(timestep, here)
        self._alive = tuple(session.state.alive.tolist())
        time_s = self._timesteps * session.environment.timestep_s
        self.feed.truncate(min(time_s, session.time_s) - _SLACK_S)

    def _values(self) -> FloatArray:
        state = self._session.environment.last_state
        return values_of(state, has_turret=self._has_turret)


def values_of(state: EnvState, *, has_turret: bool) -> FloatArray:
    """Return a state as a frame: x, y [m], heading and turret [rad], (columns, rows)."""
    robots = len(state.heading_rad)
    values = np.zeros((3 + has_turret, len(state.bodies.angle_rad)))
    values[:2] = state.bodies.position_m.T
    values[2] = state.bodies.angle_rad
    values[2, :robots] = state.heading_rad
    if has_turret:
        values[3, :robots] = state.drive.turret_rad
    values[:, :robots][:, ~state.presence.present] = np.nan
    return values
