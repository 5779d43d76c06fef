"""A driver of an environment, in place of a session."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.engine.step import Step
from crs_cc.sim.files import world_xml
from crs_cc.sim.files.world_xml import load_world, parse_world

INCH = 0.0254
SCOUT_RADIUS_M = 8 * INCH


def world_of(elements: str, size: str = 'length="10m" width="10m"', timestep: str = "50ms"):
    """Return a world of objects, written in XML."""
    text = f'<world version="1" timestep="{timestep}"><area {size}/>{elements}</world>'
    return parse_world(text.encode(), "test")


def open_world(elements: str = '<robot x="0" y="0"/>', timestep: str = "50ms"):
    """Return a wide world without edges, its origin at the centre."""
    return world_of(elements, 'length="2000m" width="2000m" origin="centre" edge="0"', timestep)


@dataclass
class Driver:
    """One environment and its robots' last replies."""

    environment: Environment
    steps: list[Step] = field(default_factory=list)

    @classmethod
    def of(cls, world, seed: int = 1) -> Driver:
        """Return a driver whose robots are all connected."""
        driver = cls(Environment(world, seed))
        for robot in range(len(world.robots)):
            driver.ask("CONNECT", robot=robot)
        return driver

    @property
    def state(self):
        return self.environment.state

    @property
    def sonar(self):
        return sonar_state(self.state)

    def post(self, name: str, *arguments: int, robot: int = 0, at_s: float = 0.0, data=b""):
        """Post a request; return the reply and the time at which the program continues."""
        messages = np.zeros(1, MESSAGE)
        messages["i"][0, : len(arguments)] = arguments
        messages["data"][0, : len(data)] = list(data)
        messages["size"] = len(data)
        clock_s = np.array([max(at_s, self.environment.time_s)])
        goes_on_s = self.environment.serve(CODES[name], np.array([robot]), messages, clock_s)
        return messages[0], float(goes_on_s[0])

    def ask(self, name: str, *arguments: int, robot: int = 0, at_s: float = 0.0, data=b""):
        """Post a request; return the `State` of its reply."""
        message, _ = self.post(name, *arguments, robot=robot, at_s=at_s, data=data)
        return told(message)

    def run(self, cycles: int) -> list[Step]:
        """Run cycles; return their records."""
        steps = [self.environment.step() for _ in range(cycles)]
        self.steps += steps
        return steps

    def run_s(self, time_s: float) -> list[Step]:
        """Run for a time, rounded to cycles."""
        return self.run(round(time_s / self.environment.timestep_s))


def told(message) -> np.ndarray:
    """Return the `State` of a reply."""
    return message["data"][:180].view("<i4").copy()


def own_world(
    folder,
    *changes: tuple[str, str],
    elements: str = "",
    timestep: str = "50ms",
    robot: str = "scout",
):
    """Return a wide world of robots with a changed known definition.

    In `elements`, `<robot` stands for such a robot; without `elements` there is one at the origin.
    """
    text = (Path(world_xml.__file__).parents[0] / "robots" / f"{robot}.xml").read_text()
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (folder / "own.xml").write_text(text)
    elements = (elements or '<robot x="0" y="0"/>').replace("<robot", '<robot definition="own.xml"')
    area = '<area length="2000m" width="2000m" origin="centre" edge="0"/>'
    path = folder / "world.xml"
    path.write_text(f'<world version="1" timestep="{timestep}">{area}{elements}</world>')
    return load_world(path)
