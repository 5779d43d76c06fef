"""Worlds with robots that have grippers, and queries of what they hold.

The palm is at the shell, 8 inches (20.32 cm) from the robot's centre; the fingers are 10 cm long,
20 cm apart when they are open, and close in 1 s.
"""

from __future__ import annotations

from pathlib import Path

from crs_cc.sim.files.world_xml import load_world
from tests.device.robot import scout_with
from tests.sim.driver import Driver

GRIPPER = '<gripper reach="10cm" opening="20cm" closing="1s" max-mass="5kg"/>'
OPEN, CLOSE = 0, 1


def gripping(folder: Path, elements: str, area: str, *devices: str) -> Driver:
    """Return a world whose Scouts have grippers, or other devices."""
    scout_with(folder, *(devices or (GRIPPER,)))
    elements = elements.replace("<robot ", '<robot definition="scout-with.xml" ')
    path = folder / "world.xml"
    path.write_text(f'<world version="1"><area {area}/>{elements}</world>')
    return Driver.of(load_world(path))


def tell(driver: Driver, robot: int = 0) -> list[int]:
    """Return the distance of the fingers [0.1 in], the beam, and the weight [g]."""
    message, _ = driver.post("GET_GRIPPER", robot=robot)
    return message["i"][:3].tolist()


def kinds(steps) -> list[str]:
    """Return the kinds of the events in steps."""
    return [event.kind for step in steps for event in step.events]


def place(driver: Driver, obj: int = 0):
    """Return x and y [m] of a pushable object."""
    bodies = driver.state.bodies
    return bodies.position_m[len(driver.state.heading_rad) + obj]
