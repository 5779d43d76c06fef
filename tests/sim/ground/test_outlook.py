"""Height occlusion: low objects, plateaus, ramps, and the floor below.

A Scout's sonars are 11 in, 0.279 m, above the ground, and their cones open by 10 degrees to each
side. Its laser here is 0.30 m above the ground. Readings are from the shell, 8 in from the centre.

    side view:      o->  .  .  .  .  .  .  .  .  .  .
                   ( )        ___        |
                 ____________|low|_______|wall
"""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.ray_caster import RayCaster
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.scene import Scene
from tests.sim.driver import INCH, Driver, world_of

R = 8 * INCH
Z = 11 * INCH
BIG = 'length="30m" width="10m"'


def sees(elements: str, z_m: float, x_m: float = 1.0, direction: float = 0.0) -> float:
    """Return the distance that a thin beam measures from y = 5 m."""
    fan = Fan.of([(0.0, 0.0, 0.0, 0.0, 25.0)], z_m)
    world = world_of(elements + '<robot x="29m" y="1m"/>', BIG)
    rays = RayCaster(Scene(world), [fan])
    state = Environment(world, 1).state
    pose = np.array([[x_m, 5.0, math.radians(direction)]])
    return float(rays.distances_m(state, fan, pose, np.array([0]))[0, 0])


def sonar_m(elements: str, number: int = 0) -> float:
    """Return the distance that a sonar of a world's robot measures [m], infinite for no echo."""
    return float(Driver.of(world_of(elements, BIG)).sonar.echo_m[0, number])


BOX = '<box x="4m" y="5m" length="1m" width="1m" {}/>'
WALL = '<wall x1="9m" y1="0" x2="9m" y2="10m" thickness="20cm"/>'
PLATEAU = '<surface><plateau x="6m" y="5m" length="2m" width="4m" height="{}"/></surface>'
RAMP = '<surface><ramp x="6m" y="5m" length="4m" width="4m" to="1m" heading="{}"/></surface>'


def test_beam_passes_over_lower_objects():
    low = BOX.format('height="25cm"') + WALL
    assert sees(low, 0.24) == pytest.approx(2.5)
    assert sees(low, 0.26) == pytest.approx(7.9)
    assert sees(BOX.format("") + WALL, 9.0) == pytest.approx(2.5)  # as high as anything


@pytest.mark.parametrize("mass", ["", 'mass="3kg"'])
def test_beam_passes_over_low_cylinders(mass):
    low = f'<cylinder x="4m" y="5m" radius="50cm" height="25cm" {mass}/>' + WALL
    assert sees(low, 0.24) == pytest.approx(2.5)
    assert sees(low, 0.26) == pytest.approx(7.9)


def test_plateau_is_visible_only_from_below():
    assert sees(PLATEAU.format("40cm") + WALL, 0.3) == pytest.approx(4.0)
    assert sees(PLATEAU.format("20cm") + WALL, 0.3) == pytest.approx(7.9)
    assert sees(PLATEAU.format("40cm") + WALL, 0.3, x_m=6.0) == pytest.approx(2.9)


def test_beam_from_a_plateau_passes_over_low_objects():
    elements = (
        PLATEAU.format("40cm") + '<box x="8m" y="5m" length="40cm" width="1m" height="50cm"/>'
    )
    assert sees(elements + WALL, 0.05, x_m=6.0) == pytest.approx(1.8)
    assert sees(elements + WALL, 0.20, x_m=6.0) == pytest.approx(2.9)


def test_height_of_an_object_adds_to_that_of_the_plateau():
    elements = PLATEAU.format("20cm") + '<box x="6m" y="5m" length="1m" width="1m" height="20cm"/>'
    assert sees(elements + WALL, 0.35) == pytest.approx(4.5)
    assert sees(elements + WALL, 0.45) == pytest.approx(7.9)


def test_beam_hits_a_ramp_where_their_heights_are_equal():
    """0.25 for each metre from x = 4 m on: 0.3 m high at 5.2 m."""
    assert sees(RAMP.format("0") + WALL, 0.3) == pytest.approx(4.2)
    assert sees(RAMP.format("180deg") + WALL, 0.3) == pytest.approx(3.0)  # its high end
    assert sees(RAMP.format("90deg") + WALL, 0.3) == pytest.approx(3.0)  # a side, 0.5 m high


def test_beam_tilts_with_the_robot_on_a_ramp():
    """Up the ramp it stays above it; down the ramp it hits the floor, 0.8 / 0.25 m away."""
    assert sees(RAMP.format("0") + WALL, 0.3, x_m=6.0) == pytest.approx(2.9)
    assert sees(RAMP.format("0"), 0.3, x_m=6.0, direction=180) == pytest.approx(0.8 / 0.25)
    assert sees(RAMP.format("0"), 0.3, x_m=6.0, direction=90) == pytest.approx(5.0)


def test_sonar_cone_reaches_lower_objects_at_a_distance():
    """The lower side of its cone is z - d tan 10 deg high at a distance d from the centre."""
    box = '<robot x="1m" y="5m"/><box x="{}m" y="5m" length="20cm" width="2m" height="10cm"/>'
    # So tops at 10 cm are met from d = (z - 0.1) / tan 10 deg = 1.017 m on.
    assert sonar_m(box.format(1 + 1.0 + 0.1)) > 5.0
    assert sonar_m(box.format(1 + 1.04 + 0.1)) == pytest.approx(1.04 - R, abs=0.01)


def test_sonar_ignores_the_ground_under_its_robot():
    assert sonar_m('<robot x="1m" y="5m"/>') > 6.0
    assert sonar_m(PLATEAU.format("40cm") + '<robot x="6m" y="5m"/>') == pytest.approx(math.inf)


def test_sonar_hears_a_plateau_ahead():
    elements = PLATEAU.format("40cm") + '<robot x="3m" y="5m"/>'
    assert sonar_m(elements) == pytest.approx(2.0 - R, abs=1e-6)


def test_robot_touching_a_ledge_reads_0():
    driver = Driver.of(world_of(PLATEAU.format("40cm") + '<robot x="4m" y="5m"/>', BIG))
    driver.ask("VM", 200, 200)
    driver.run_s(5.0)
    assert driver.state.x_m[0] == pytest.approx(5 - R, abs=0.005)
    driver.run_s(1.0)
    assert driver.sonar.echo_m[0, 0] < 0.01


def test_flat_worlds_skip_height_occlusion():
    world = world_of('<robot x="1m" y="5m"/>' + BOX.format(""), BIG)
    assert Environment(world, 1)._data.rays._outlook is None


@pytest.mark.parametrize("ground", [PLATEAU.format("30cm"), RAMP.format("0deg")])
def test_block_size_changes_no_bit_of_sonars_at_different_heights(ground, monkeypatch):
    kinds = ("scout", "nomad200", "amigobot")
    robots = [
        f'<robot definition="{kind}" x="{x}m" y="{y}m" heading="{40 * x}deg"/>'
        for x, kind in enumerate(kinds * 2, start=1)
        for y in (2, 7)
    ]
    low = [f'<box x="{x}m" y="9m" length="1m" width="1m" height="{x}0cm"/>' for x in range(1, 8)]
    world = world_of(ground + WALL + "".join(robots + low), BIG)

    def echoes_m():
        driver = Driver.of(world)
        driver.run(20)
        return driver.sonar.echo_m

    whole = echoes_m()
    assert 0.1 < np.isfinite(whole).mean() < 0.9
    monkeypatch.setattr("crs_cc.sim.geometry.cell_list.PAIRS_IN_BLOCK", 1)
    assert np.array_equal(whole, echoes_m())


def test_each_object_at_a_height_echoes_by_its_own_material():
    objects = '<material name="soft" sonar="0"/><robot x="5m" y="5m"/>'
    for x_m, material in ((3, 'material="soft"'), (7, "")):
        objects += f'<cylinder x="{x_m}m" y="5m" radius="20cm" height="50cm" {material}/>'
    echo_m = Driver.of(world_of(objects, BIG)).sonar.echo_m[0]
    assert echo_m[0] == pytest.approx(1.8 - R, abs=0.05)
    assert echo_m[8] > 3.0
