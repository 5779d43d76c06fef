"""What the view gets of the selected robot's sensors, by hand-worked geometry."""

from __future__ import annotations

import base64
from pathlib import Path

import numpy as np
import pytest

from crs_cc.api.session import Session
from crs_cc.debug.world.edits import edit
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import load_world
from crs_cc.workbench.devices_in_view import devices_in_view
from crs_cc.workbench.world_data import world_data
from tests.device.robot import scout_with

INFRARED = '<infrared step="1in" half-angle="5deg"/>'
CAMERA = '<camera columns="4" field-of-view="360deg" direction="45deg" background="#010203"/>'
ROOT = Path(__file__).parents[2]
RADIUS_M = 8 * 0.0254


@pytest.fixture
def environment(tmp_path: Path) -> Environment:
    """A robot with a red pole 2 m ahead of its centre, and a wall 5 inches from its left side."""
    path = tmp_path / "poles.xml"
    definition = Path(scout_with(tmp_path, INFRARED, CAMERA)).name
    left_m = RADIUS_M + 5 * 0.0254
    path.write_text(
        f"""<world version="1"><area length="40m" width="40m" origin="centre"/>
        <cylinder x="2m" y="0" radius="10cm" colour="#ff0000" heat="8"/>
        <wall x1="-1m" y1="{left_m + 0.05}m" x2="1m" y2="{left_m + 0.05}m" thickness="10cm"/>
        <robot definition="{definition}" x="0" y="0"/></world>"""
    )
    return Environment(load_world(path), seed=1)


def test_nothing_is_shown_before_a_measurement(environment: Environment) -> None:
    found = devices_in_view(environment, range(1), 0)
    assert (found["camera"], found["heat"]) == ([], None)


def test_the_camera_the_infrared_ring_and_the_heat_sensor_are_shown(
    environment: Environment,
) -> None:
    for device in ("camera", "infrared", "heat"):
        environment.measure(device, np.array([0]))
    found = devices_in_view(environment, range(1), 0)
    behind, left, ahead, right = found["camera"]
    assert (behind, right) == (("#010203", None), ("#010203", None))
    assert ahead == ("#ff0000", pytest.approx(1.9, abs=0.003))
    assert left == ("#808080", pytest.approx(RADIUS_M + 5 * 0.0254, abs=0.003))
    assert found["infrared"][4] == pytest.approx(5.0, abs=0.05)  # of 16, the fourth looks left
    assert found["infrared"][0] == 15.0
    assert found["heats"] == {}
    assert found["heat"] == 8.0
    kind = world_data(environment.world, ["robot0"])["kinds"]
    (about,) = kind.values()
    assert about["infrared"] == {"step": 0.0254, "z": 0.2, "farthest": 15}
    assert about["camera"]["range"] == 10.0
    assert about["heat"] == 3.0


def test_changed_heats_are_reported(environment: Environment) -> None:
    edit(environment, "heat cylinder0 0")
    edit(environment, "heat robot0 2.5")
    assert devices_in_view(environment, range(1), 0)["heats"] == {"cylinder0": 0.0, "robot0": 2.5}


def test_a_robot_of_unknown_height_is_drawn_as_slender_as_a_scout() -> None:
    world = load_world(ROOT / "samples" / "swarm" / "foraging.xml")
    (kind,) = world_data(world, [world.robots[0].id])["kinds"].values()
    assert kind["radius"] == pytest.approx(0.06)
    assert kind["height"] == pytest.approx(0.35 * 0.06 / RADIUS_M)


def test_a_field_is_sent_as_shares_of_its_largest_amount() -> None:
    ants = ROOT / "samples" / "scout_c" / "ants"
    session = Session(ants / "ants.xml")
    session.run(10.0)
    environment = session.inner.environment
    (found,) = devices_in_view(environment, range(1), 0)["fields"]
    shares = np.frombuffer(base64.b64decode(found["data"]), np.uint8)
    shares = shares.reshape(found["rows"], found["columns"])
    amounts = environment.field("trail")
    assert found["most"] == pytest.approx(amounts.max(), rel=1e-5)
    row, column = np.unravel_index(amounts.argmax(), amounts.shape)
    squares = round(found["cell"] / 0.02)
    assert shares[row // squares, column // squares] == 255
    assert np.array_equal(shares > 0, environment.field_sketch("trail", 96)[0] > 0.0)
    assert 0 < np.count_nonzero(shares) < shares.size / 10
