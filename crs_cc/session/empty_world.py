"""The world of a run without a world file, cached after the first use."""

from __future__ import annotations

from crs_cc.session.device_library import device_sources
from crs_cc.sim.files.known_robots import known_robots
from crs_cc.sim.model.world import WorldModel
from crs_cc.toolchain import cache
from crs_cc.toolchain.fingerprint import WORLDS


def empty_world(setup: str, robot: str) -> WorldModel:
    """Return the empty world with one robot.

    A robot's definition outside of this package may change at any time, and is always read.

    Args:
        setup: the robot's setup, such as `noisy`; empty for none.
        robot: the kind of robot: a built-in name, or the path of a definition file.

    Raises:
        WorldError: the robot's definition cannot be read, or has no such setup.
    """
    name = cache.key("empty world", cache.version(WORLDS), device_sources(), setup, robot)
    is_known = robot in known_robots()
    world = cache.load(name, WorldModel) if is_known else None
    if world is None:
        from crs_cc.sim.files import world_xml

        world = world_xml.empty_world(setup, robot)
        if is_known:
            cache.store(name, world)
    return world
