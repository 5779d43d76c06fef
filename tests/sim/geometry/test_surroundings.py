"""The object that a beam hits: by hand, and by the position of the hit point."""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.ray_caster import RayCaster
from crs_cc.sim.geometry.rays import NO_THING, Fan
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable
from crs_cc.sim.model.world import Wall
from crs_cc.sim.state.env_state import EnvState
from tests.sim.driver import open_world
from tests.sim.geometry.test_rays import crowd


def looked(world, fan):
    """Return the distances along all robots' beams, and the names of the objects hit."""
    scene, state = Scene(world), EnvState.at_start(world)
    count = len(world.robots)
    rays = RayCaster(scene, [fan])
    distance_m, obj = rays.seen(state, fan, scene.start[:count], np.arange(count))
    assert np.array_equal(
        distance_m, rays.distances_m(state, fan, scene.start[:count], np.arange(count))
    )
    return distance_m, obj, scene


def test_beams_name_the_nearest_object():
    """The robot R has beams ahead, to the left, back, to the right, and past the pole.

                 crate
                   |
    other -------- R ------ pole ------ | wall
                   |
                nothing
    """
    world = open_world(
        '<robot x="0" y="0"/><robot id="other" x="-3m" y="0"/>'
        '<wall id="wall" x1="4m" y1="-1m" x2="4m" y2="1m"/>'
        '<cylinder id="pole" x="2m" y="0" radius="0.1m"/>'
        '<box id="crate" x="0" y="2m" length="0.5m" width="0.5m" mass="5kg"/>'
    )
    beams = [(0.0, 0.0, turn * math.pi / 2, 0.0, 5.0) for turn in range(4)]
    past_pole = (0.0, 0.0, math.atan2(0.5, 4), 0.0, 5.0)
    distance_m, obj, scene = looked(world, Fan.of([*beams, past_pole]))
    names = [scene.names[number] if number >= 0 else "" for number in obj[0]]
    assert names == ["pole", "crate", "other", "", "wall"]
    assert obj[0, 3] == NO_THING
    assert distance_m[0, :3] == pytest.approx([1.9, 1.75, 3 - 8 * 0.0254])


def test_beam_that_starts_inside_an_object_hits_it():
    """The sensor is 21 cm ahead of the robot's centre, and half a cm deep in the box."""
    world = open_world(
        '<robot x="0" y="0"/><cylinder x="-1m" y="0" radius="0.1m"/>'
        '<box id="box" x="0.705m" y="0" length="1m" width="1m"/>'
    )
    distance_m, obj, scene = looked(world, Fan.of([(0.21, 0.0, 0.0, 0.0, 5.0)]))
    assert (distance_m[0, 0], scene.names[obj[0, 0]]) == (0.0, "box")


@pytest.mark.parametrize("robots", [3, 150])
def test_hit_point_is_on_the_named_object(robots):
    """A few robots, for which all shapes are tested; and many, for which they are filtered."""
    world = crowd(robots, seed=robots)
    beams = [(0.1, 0.0, math.tau / 40 * number, 0.0, 4.0) for number in range(40)]
    distance_m, obj, scene = looked(world, Fan.of(beams))
    assert np.array_equal(np.isfinite(distance_m), obj != NO_THING)
    x_m, y_m, heading = scene.start[: len(world.robots)].T[:, :, None]
    way = heading + np.array([beam[2] for beam in beams])
    x_m = x_m + 0.1 * np.cos(heading) + distance_m * np.cos(way)
    y_m = y_m + 0.1 * np.sin(heading) + distance_m * np.sin(way)
    solids = (*world.robots, *scene.pushables, *scene.fixed_solids)
    is_wall = np.array([isinstance(solid, Wall) for solid in solids])
    seen = (obj != NO_THING) & (distance_m > 0.0)
    seen &= ~is_wall[np.where(seen, obj, 0)]
    assert seen.sum() > 20 * len(world.robots) / 3
    elements = ShapeTable.of(scene)
    poses = np.concatenate([scene.start, elements.fixed])
    off_m = elements.distance_m(poses, obj[seen], x_m[seen], y_m[seen])
    assert np.abs(off_m).max() < 1e-7


def test_beams_see_objects_at_their_current_poses():
    """A robot measures a crate, which stays for two cycles, then moves away, back, and turns."""
    world = open_world(
        '<robot x="0" y="0"/><box x="2m" y="0" length="1m" width="1m" mass="5kg"/>'
        '<cylinder x="0" y="9m" radius="0.1m" mass="5kg"/>'
    )
    scene, state = Scene(world), EnvState.at_start(world)
    fan, own = Fan.of([(0.0, 0.0, 0.0, 0.0, 5.0)]), np.array([0])
    rays, seen = RayCaster(scene, [fan]), []
    for x_m in (2.0, 2.0, 3.0, 2.0):
        state.bodies.position_m[1, 0] = x_m
        seen.append(float(rays.distances_m(state, fan, scene.start[:1], own)[0, 0]))
        state.cycle += 1
    state.bodies.angle_rad[1] = math.pi / 4
    seen.append(float(rays.distances_m(state, fan, scene.start[:1], own)[0, 0]))
    assert seen == pytest.approx([1.5, 1.5, 2.5, 1.5, 2 - math.sqrt(0.5)])
