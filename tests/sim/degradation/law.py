"""The law of degradation by itself: values of a device of a robot, without any world around."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from crs_cc.sim.devices.degradation.filter import Degradations
from crs_cc.sim.files.world_xml import empty_world
from crs_cc.sim.model.degradation import Degradation
from crs_cc.sim.model.world import Robot
from crs_cc.sim.state.env_state import EnvState


def world_with(*degradations: Degradation, robots: int = 1, robot: str = "scout"):
    """Return an open world of robots in a row, 10 m apart, with degradations."""
    world = empty_world(robot=robot)
    first = world.robots[0]
    row = tuple(
        Robot(f"robot{n}", first.model, replace(first.start, x_m=10.0 * n)) for n in range(robots)
    )
    numbered = (
        replace(each, id=each.id or f"degradation{n}") for n, each in enumerate(degradations)
    )
    return replace(world, robots=row, degradations=tuple(numbered))


@dataclass
class Law:
    """Devices of the robots of a world, and what becomes of their values."""

    state: EnvState
    degradations: Degradations = field(default_factory=lambda: Degradations(seed=1))

    @classmethod
    def of(cls, *degradations: Degradation, robots: int = 1) -> Law:
        return cls(EnvState.at_start(world_with(*degradations, robots=robots)))

    def read(self, value, at_s: float = 1.0, device: str = "sonar", robot: int = 0):
        """Return what becomes of one reading, or of one for each element."""
        values = np.atleast_2d(np.asarray(value, dtype=float))
        rows, instants = np.array([robot]), np.array([at_s])
        told = self.degradations.alter(self.state, device, rows, values, instants)
        return float(told[0, 0]) if np.isscalar(value) else told[0].tolist()

    def go(self, speeds, from_s: float, to_s: float, device: str = "drive", robot: int = 0):
        """Return the ways that become of speeds, kept between two instants."""
        ways = np.array([speeds]) * (to_s - from_s)
        rows, instants = np.array([robot]), (np.array([from_s]), np.array([to_s]))
        told = self.degradations.move(
            self.state, device, rows, ways, from_s=instants[0], to_s=instants[1]
        )
        return told[0].tolist()
