"""Changes of the world in a few words."""

import math

import pytest

from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.edits import edit
from crs_cc.sim.model.degradation import Degradation
from tests.sim.driver import Driver, open_world, world_of

WORLD = (
    '<robot id="a" x="2m" y="2m"/><robot id="b" x="5m" y="5m"/>'
    '<box id="crate" x="8m" y="2m" length="1m" width="0.5m" mass="5kg"/>'
    '<wall id="screen" x1="4m" y1="0" x2="4m" y2="3m" thickness="10cm"/>'
)


@pytest.fixture
def driver() -> Driver:
    return Driver.of(world_of(WORLD))


def test_robots_and_objects_are_moved_in_various_units(driver) -> None:
    environment, state = driver.environment, driver.state
    assert edit(environment, "move a to 1 3") == "a is now at 1.000, 3.000 m, 0.0 deg"
    assert edit(environment, "move a to 100cm 50in -90") == "a is now at 1.000, 1.270 m, 270.0 deg"
    assert state.heading_rad[0] == -math.pi / 2
    assert edit(environment, "move a to 2 2").endswith("270.0 deg")  # it keeps its heading
    assert edit(environment, "turn b to 45deg") == "b now has heading 45.0 deg"
    assert (state.x_m[1], state.heading_rad[1]) == (5.0, math.pi / 4)
    assert edit(environment, "move crate to 8 8 90") == "crate is now at 8.000, 8.000 m, 90.0 deg"
    assert edit(environment, "turn crate to 0") == "crate now has heading 0.0 deg"
    assert state.bodies.position_m[2].tolist() == [8.0, 8.0]
    assert state.bodies.angle_rad[2] == 0.0


def test_devices_are_degraded_with_the_attributes_of_world_files(driver) -> None:
    environment = driver.environment
    assert edit(environment, "degrade a sonar.3 dead") == "a: sonar 3, dead (degradation0)"
    edit(environment, "degrade a drive.left gain=0.8 delay=200ms for 5s recovery 1s")
    edit(environment, "degrade b sonar stuck")
    edit(environment, "degrade b sonar.0 stuck 1.5m dropouts 0.25")
    assert environment.degradations.all() == (
        Degradation("a", "sonar", 3, dead=True, id="degradation0"),
        Degradation("a", "drive", 1, gain=0.8, delay_s=0.2, duration_s=5.0, recovery_s=1.0,
                    id="degradation1"),
        Degradation("b", "sonar", None, stuck="hold", id="degradation2"),
        Degradation("b", "sonar", 0, stuck=1.5, dropouts=0.25, id="degradation3"),
    )  # fmt: skip
    assert edit(environment, "heal b sonar.0") == "b no longer has degradation3"
    assert edit(environment, "heal a drive") == "a no longer has degradation1"
    assert edit(environment, "heal degradation2") == "b no longer has degradation2"
    assert edit(environment, "heal a") == "a no longer has degradation0"
    assert environment.degradations.all() == ()


def test_degradations_take_effect_immediately(driver) -> None:
    for _ in range(10):
        driver.environment.step()
    assert math.isfinite(driver.state.devices.sonar.echo_m[0, 0])
    edit(driver.environment, "degrade a sonar dead")
    for _ in range(30):
        driver.environment.step()
    assert not math.isfinite(driver.state.devices.sonar.echo_m[0, 0])
    assert math.isfinite(driver.state.devices.sonar.echo_m[1, 0])


def test_objects_and_robots_are_removed(driver) -> None:
    assert edit(driver.environment, "remove screen") == "screen is removed"
    assert edit(driver.environment, "remove b") == "b leaves the world at 0.050 s"
    driver.environment.step()
    assert driver.state.presence.present.tolist() == [True, False]
    assert "screen" not in driver.environment.names


def test_charge_heat_and_links_are_changed() -> None:
    driver = Driver.of(
        open_world('<robot x="0" y="0" definition="nomad150"/><robot x="3m" y="0"/>')
    )
    environment = driver.environment
    edit(environment, "charge robot0 12.5%")
    assert environment.charges(0)[1] == 0.125
    assert edit(environment, "heat robot1 7") == "robot1 now has a heat of 7"
    assert driver.state.heat.left[1] == 7.0
    assert edit(environment, "shut radio from robot0") == "radio from robot0 is now blocked"
    assert edit(environment, "shut to robot1") == "every channel to robot1 is now blocked"
    assert edit(environment, "open radio from robot0") == "radio from robot0 is now unblocked"
    assert edit(environment, "shut all") == "every link is now blocked"
    assert [each.text for each in environment.step().events][-1].endswith("blocked")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "missing change (expected move, turn, remove, degrade"),
        ("jump a", "'jump' is not a change of the world (expected move, turn"),
        ("move", "expected: move NAME to X Y [HEADING]"),
        ("move a 1 2", "expected: move NAME to X Y [HEADING]"),
        ("move c to 1 2", "unknown robot or movable object 'c' (known: a, b, crate)"),
        ("move screen to 1 2", "'screen' cannot be moved (movable: a, b, crate"),
        ("move a to 5 5", "cannot move 'a': it would overlap 'b'"),
        ("move a to 99 5", "cannot move 'a': it would overlap the edge of the world"),
        ("move a to nan 5", "'nan' is not a length (expected a number and one of m, cm"),
        ("move a to 1 2 north", "'north' is not an angle (expected a number and one of deg, rad"),
        ("turn a 90", "expected: turn NAME to HEADING"),
        ("degrade a sonar.3", "expected: degrade ROBOT DEVICE[.ELEMENT] FAULT..."),
        ("degrade c sonar dead", "unknown robot 'c' (known: a, b)"),
        (
            "degrade a sonra dead",
            "device: unknown device 'sonra' (known: altitude, antennae, arm",
        ),
        ("degrade a sonar.16 dead", "element: unknown '16' of sonar (known: 0 to 15)"),
        ("degrade a compass dead", "the robot has no compass"),
        ("degrade a sonar loud", "unknown fault 'loud' (known: bias, gain"),
        ("degrade a sonar noise", "'noise' needs a value"),
        ("degrade a sonar dead yes", "'dead' takes no value"),
        ("degrade a sonar noise 5kg", "noise: '5kg' is not a length (expected a number"),
        ("degrade a sonar dropouts 2", "dropouts must be a number from 0 to 1, not 2.0"),
        ("heal a", "no degradation of a"),
        ("heal a sonar.3", "no degradation of a sonar.3"),
        ("heal degradation7", "unknown robot 'degradation7' (known: a, b)"),
        ("remove edge-north", "unknown object 'edge-north' (known: screen, crate)"),
        ("charge a 120", "'120' is not a state of charge (expected 0 to 100 percent)"),
        ("heat crate -1", "heat must not be negative"),
        ("heat moon 1", "unknown object 'moon' (known: a, b, crate"),
        ("shut smoke", "unknown channel 'smoke' (known: "),
        ("shut", "expected: shut [CHANNEL] [from ROBOT] [to ROBOT]"),
        ("shut radio near a", "expected: shut [CHANNEL] [from ROBOT] [to ROBOT]"),
        ("open radio", "no such outage"),
        ("move a to " + "1 " * 99, "a change has at most 40 words"),
    ],
)
def test_invalid_changes_are_rejected_without_effect(driver, text, message) -> None:
    before = driver.environment.hash()
    with pytest.raises(DebugError) as caught:
        edit(driver.environment, text)
    assert str(caught.value).startswith(message)
    assert "\n" not in str(caught.value)
    assert driver.environment.hash() == before


def test_absent_robots_cannot_be_changed() -> None:
    driver = Driver.of(world_of('<robot x="2m" y="2m"/><robot x="5m" y="5m" join="9s"/>'))
    for text in ("move robot1 to 1 1", "turn robot1 to 90", "charge robot1 50"):
        with pytest.raises(DebugError, match="robot 'robot1' is not in the world"):
            edit(driver.environment, text)
