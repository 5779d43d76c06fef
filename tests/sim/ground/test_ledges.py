"""Ledges: plateaus and ramps that block bodies from below, and from which bodies fall.

.................          A plateau of 0.3 m, x 2 to 4 m, y 2 to 4 m;
.      ____      .         most robots come along y = 3 m.
.  o->|    |     .
.     |____|     .
.................
"""

import pytest

from tests.sim.driver import INCH, SCOUT_RADIUS_M, Driver, own_world, world_of

PLATEAU = '<surface><plateau x="3" y="3" length="2" width="2" height="{}"/></surface>'


def approach(elements: str, speed: int = 300, seconds: float = 6.0, robot: int = 0) -> Driver:
    driver = Driver.of(world_of(elements))
    driver.ask("VM", speed, speed, robot=robot)
    driver.run_s(seconds)
    return driver


def test_plateau_blocks_like_a_wall_from_below():
    driver = approach(PLATEAU.format("30cm") + '<robot x="1" y="3"/>')
    assert driver.state.x_m[0] == pytest.approx(2 - SCOUT_RADIUS_M, abs=0.005)
    assert driver.state.devices.bumper.pressed[0]
    assert driver.state.collisions[0] == 1
    contacts = [step.contacts for step in driver.steps if len(step.contacts.other)]
    assert driver.steps[0].names[contacts[0].other[0]] == "(ground)"


def test_wheels_climb_steps_up_to_the_limit():
    for height, gets_up in [("19mm", True), ("21mm", False)]:
        driver = approach(PLATEAU.format(height) + '<robot x="1" y="3"/>')
        assert bool(driver.state.x_m[0] > 2) is gets_up


def test_step_limit_is_set_by_the_definition(tmp_path):
    elements = PLATEAU.format("5cm") + '<robot x="1" y="3"/>'
    for step, gets_up in [("4cm", False), ("6cm", True)]:
        world = own_world(tmp_path, ("<drive ", f'<drive step="{step}" '), elements=elements)
        driver = Driver.of(world)
        driver.ask("VM", 300, 300)
        driver.run_s(5.0)
        assert bool(driver.state.x_m[0] > 2) is gets_up


def test_robot_falls_off_a_plateau_at_unchanged_speed():
    driver = approach(PLATEAU.format("30cm") + '<robot x="3" y="3"/>', seconds=4.0)
    assert driver.state.x_m[0] == pytest.approx(3 + (30 * 4 - 22.5) * INCH, abs=0.02)
    assert driver.state.collisions[0] == 0
    said = [event for step in driver.steps for event in step.events]
    assert [(event.kind, event.text, event.robot) for event in said] == [("fall", "fell 0.30 m", 0)]
    assert said[0].time_s == pytest.approx((1 / INCH + 22.5) / 30, abs=0.06)


def test_fallen_robot_cannot_return():
    driver = approach(PLATEAU.format("30cm") + '<robot x="3" y="3"/>', seconds=3.0)
    driver.ask("VM", -300, -300)
    driver.run_s(5.0)
    assert driver.state.x_m[0] == pytest.approx(4 + SCOUT_RADIUS_M, abs=0.005)


def test_plateau_is_accessible_by_a_ramp_but_not_from_its_side():
    """A ramp from x = 0.5 to 2 m that ends at the plateau's edge, 1 m wide."""
    surface = PLATEAU.format("30cm").replace(
        "</surface>", '<ramp x="1.25" y="3" length="1.5" width="1" to="30cm"/></surface>'
    )
    up = approach(surface + '<robot x="0.25" y="3"/>', speed=150, seconds=14.0)
    assert up.state.x_m[0] > 3.0
    assert up.state.collisions[0] == 0
    side = approach(surface + '<robot x="1.75" y="1" heading="90"/>')
    assert side.state.y_m[0] == pytest.approx(2.5 - SCOUT_RADIUS_M, abs=0.005)
    low = approach(surface + '<robot x="0.55" y="1" heading="90"/>')
    assert low.state.y_m[0] > 3.5


def test_steep_ramp_blocks_from_below_and_can_be_left(tmp_path):
    """40 degrees, where the definition allows 30; from its top a robot rolls off."""
    surface = '<surface><ramp x="2" y="3" length="1" width="2" to="84cm"/></surface>'
    driver = approach(surface + '<robot x="0.5" y="3"/>')
    assert driver.state.x_m[0] == pytest.approx(1.5 - SCOUT_RADIUS_M, abs=0.005)
    driver = Driver.of(world_of(surface + '<robot x="2" y="3"/>'))
    driver.ask("LP")
    driver.run_s(2.0)
    assert driver.state.x_m[0] < 1.0


def test_plateau_blocks_a_box_only_from_below():
    box = '<box x="{}" y="3" length="40cm" width="40cm" mass="2kg"/><robot x="{}" y="3"/>'
    below = approach(PLATEAU.format("10cm") + box.format(1.6, 1.0))
    assert below.state.bodies.position_m[1, 0] == pytest.approx(1.8, abs=0.01)
    above = approach(PLATEAU.format("10cm") + box.format(3.6, 3.0), speed=200, seconds=8.0)
    assert above.state.bodies.position_m[1, 0] > 4.2
    assert above.state.x_m[0] > 4.0


def test_box_slides_down_a_steep_ramp_and_stops_on_the_floor():
    """From the height h of its centre it slides on for (h - mu x) / mu, x being the ramp's rest."""
    surface = '<surface><ramp x="3" y="3" length="2" width="2" from="1.4m" to="0"/></surface>'
    box = '<box x="3" y="3" length="20cm" width="20cm" mass="2kg"/><robot x="9" y="9"/>'
    driver = Driver.of(world_of(surface + box))
    driver.run_s(6.0)
    x_m, y_m = driver.state.bodies.position_m[1]
    assert x_m == pytest.approx(4.0 + (0.7 - 0.4 * 1.0) / 0.4, rel=0.1)
    assert y_m == pytest.approx(3.0, abs=1e-6)
    assert not driver.state.bodies.velocity_mps[1].any()
