"""Ground from an image: heights and slopes between its pixels, cliffs, and beams.

row of pixels, 1 m each:    0  .25  .5  .75  1   1   1   0      rises by 0.25 from 0.5 to 4.5 m,
and drops between 6.5 and 7.5 m
"""

import math

import numpy as np
import pytest
from PIL import Image

from crs_cc.core.errors import WorldError
from crs_cc.sim.devices.ray_caster import RayCaster
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.terrain import Terrain
from crs_cc.sim.model.ground import Ground, HeightMap
from crs_cc.sim.model.mass_properties import GRAVITY_MPS2
from tests.sim.driver import SCOUT_RADIUS_M, Driver

PROFILE = [0, 64, 128, 191, 255, 255, 255, 0]
RISE = 0.25


def write(
    folder, picture: np.ndarray, rest: str = "", height: str = "1m", robot: str = 'x="2" y="2"'
):
    """Write a world of 8 by 4 m with an image of 1 m pixels, and return its path."""
    Image.fromarray(picture.astype(np.uint8)).save(folder / "ground.png")
    path = folder / "w.xml"
    path.write_text(
        '<world version="1"><area length="8m" width="4m"/><surface>'
        f'<heightmap image="ground.png" resolution="1m" height="{height}"/></surface>'
        f"<robot {robot}/>{rest}</world>"
    )
    return path


def hill(folder, rest: str = "", robot: str = 'x="2" y="2"'):
    return load_world(write(folder, np.tile(PROFILE, (4, 1)), rest, robot=robot))


def test_heights_and_slopes_are_bilinear_between_pixels(tmp_path):
    terrain = Terrain(hill(tmp_path).surface)
    x_m, y_m = np.array([0.2, 0.5, 1.5, 3.0, 5.5, 7.0, 9.0]), np.full(7, 1.7)
    heights = [0.0, 0.0, 64 / 255, (128 + 191) / 510, 1.0, 0.5, 0.0]
    assert terrain.height_m(x_m, y_m) == pytest.approx(heights)
    rises = terrain.gradient(x_m, y_m)
    assert rises[:, 0] == pytest.approx([0, 64 / 255, 64 / 255, 63 / 255, 0, -1, 0])
    assert not rises[:, 1].any()


def test_slopes_are_the_derivatives_of_heights():
    rng = np.random.default_rng(3)
    ground = HeightMap(1.0, -2.0, 0.5, 7, tuple(rng.uniform(0, 1, 35).tolist()))
    terrain, step = Terrain(Ground((), ground)), 1e-6
    x, y = rng.uniform(1.3, 4.2, 200), rng.uniform(-1.7, 0.2, 200)
    along_x = (terrain.height_m(x + step, y) - terrain.height_m(x - step, y)) / (2 * step)
    along_y = (terrain.height_m(x, y + step) - terrain.height_m(x, y - step)) / (2 * step)
    gradient = terrain.gradient(x, y)
    assert np.abs(gradient[:, 0] - along_x).max() < 1e-6
    assert np.abs(gradient[:, 1] - along_y).max() < 1e-6


def test_top_row_has_the_largest_y(tmp_path):
    rows = np.array([[255, 255], [0, 0], [0, 0], [0, 0]])
    terrain = Terrain(load_world(write(tmp_path, rows)).surface)
    height_m = terrain.height_m(np.array([1.0, 1.0]), np.array([3.5, 0.5]))
    assert height_m.tolist() == [1.0, 0.0]


def test_limp_robot_rolls_downhill(tmp_path):
    driver = Driver.of(hill(tmp_path, robot='x="4" y="2"'))
    driver.ask("LP")
    driver.run_s(1.0)
    a = math.atan(64 / 255)
    expected_m = (GRAVITY_MPS2 * math.sin(a) - 0.3 * math.cos(a)) / 2 * math.cos(a)
    assert 4 - driver.state.x_m[0] == pytest.approx(expected_m, rel=0.03)


def test_cliff_blocks_only_from_below(tmp_path):
    """The drop is as steep as 45 degrees, which a Scout does not climb, and begins at 7.5 m."""
    robot = 'x="7.75" y="2" heading="180"'
    driver = Driver.of(hill(tmp_path, robot=robot))
    driver.ask("VM", 100, 100)
    driver.run_s(3.0)
    assert driver.state.x_m[0] == pytest.approx(7.5 + SCOUT_RADIUS_M, abs=0.06)
    driver = Driver.of(hill(tmp_path, robot='x="5.5" y="2"'))
    driver.ask("VM", 200, 200)
    driver.run_s(6.0)
    assert driver.state.x_m[0] == pytest.approx(8 - SCOUT_RADIUS_M, abs=0.01)


def test_beam_hits_the_first_pixel_above_it(tmp_path):
    """0.4 m: the pixel of 0.5 m begins at 2 m; a beam from above hits only the edge."""
    world = hill(tmp_path)
    fan = Fan.of([(0.0, 0.0, 0.0, 0.0, 9.0)], 0.4)
    rays, state = RayCaster(Scene(world), [fan]), Driver.of(world).state
    poses = np.array([[0.4, 2.0, 0.0], [5.2, 2.0, 0.0], [7.9, 2.0, math.pi]])
    seen_m = rays.distances_m(state, fan, poses, np.array([0, 0, 0]))[:, 0]
    assert seen_m == pytest.approx([1.6, 2.8, 0.9])


@pytest.mark.parametrize(
    ("size", "wrong"),
    [((1, 4), "2 to 128 pixels per side"), ((129, 4), "2 to 128 pixels per side")],
)
def test_image_of_invalid_size_is_rejected(tmp_path, size, wrong):
    path = write(tmp_path, np.zeros(size))
    with pytest.raises(WorldError, match=wrong):
        load_world(path)


def test_invalid_image_is_rejected(tmp_path):
    path = write(tmp_path, np.zeros((4, 4)))
    (tmp_path / "ground.png").write_bytes(b"P6 1 1 255 abc")
    with pytest.raises(WorldError, match="not a PNG file"):
        load_world(path)


def test_snapshot_on_hills_replays_to_the_same_bits(tmp_path):
    robots = "".join(f'<robot x="{1 + n}" y="1" heading="{60 + 20 * n}"/>' for n in range(6))
    boxes = "".join(
        f'<box x="{1.5 + n}" y="2.5" length="30cm" width="30cm" mass="2kg"/>' for n in range(5)
    )
    driver = Driver.of(hill(tmp_path, robots + boxes, robot='x="0.5" y="3.4"'))
    for robot in range(7):
        driver.ask("VM", 200, 190 - 5 * robot, robot=robot)
    driver.run(40)
    snapshot = driver.environment.snapshot()
    driver.run(40)
    first = driver.environment.hash()
    driver.environment.restore(snapshot)
    driver.run(40)
    assert driver.environment.hash() == first
