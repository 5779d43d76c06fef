"""Robots refuse requests for missing devices: all requests, all robots."""

from pathlib import Path

import pytest

from crs_cc.requests import REQUESTS
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files import world_xml
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.registry import devices
from tests.sim.driver import Driver

ROBOTS = sorted((Path(world_xml.__file__).parents[0] / "robots").glob("*.xml"))
BARE = """<robot-definition version="1" name="bare"><body radius="10cm" mass="3kg"/>
    <drive wheel-base="20cm" speed-limit="1m/s" acceleration-limit="1m/s2" speed="1m/s"
           acceleration="1m/s2"/></robot-definition>"""

HAS = {
    **{
        device.name: lambda model, name=device.name: model.device(name) is not None
        for device in devices()
    },
}

REQUIRED = {"heat": 'range="3m"'}
"""Attributes that have no default."""

WITH = {"LIGHT": (9,), "SOUND": (9,)}
"""Arguments of the requests to devices."""

ASKED = (
    ("sonar", "GET_SN"), ("sonar", "CONF_SN", 15), ("sonar", "SONAR", 1),
    ("bumper", "GET_BP"),
    ("infrared", "GET_IR"), ("infrared", "CONF_IR"), ("compass", "GET_CP"),
    ("compass", "CONF_CP", 1), ("laser", "CONF_LS", 51), ("laser", "CONF_SG"), ("laser", "GET_LS"),
    ("laser", "GET_SG"), ("laser", "LASER_PAGE"), ("laser", "READINGS", 3),
    ("camera", "READINGS", 1),
    *(
        (device.name, request.name, *WITH.get(request.name, ()))
        for device in devices() for request in device.requests
    ),
    ("heat", "HEAT"), ("heat", "SENSE_HEAT"), ("tag", "TAG"), ("tag", "TAKE_HEAT"),
    *((device, request, number)
      for request in ("PERIOD", "AGE")
      for device, number in (
          (each.name, each.number) for each in devices() if each.number is not None
      )),
)  # fmt: skip

FIRST = {"laser": ("CONF_LS", 51), "carrier": ("TAKE_ITEM",)}
"""What devices need before requests other than this one are good."""

PLACES = '<source x="0" y="0" radius="50m"/><nest x="0" y="0" radius="50m"/>'

COUNTS = {"READINGS", "LASER_PAGE"}
"""Requests whose result is a count."""

OF_ALL = {
    "CONNECT", "DISCONNECT", "AC", "SP", "PR", "VM", "MV", "ST", "LP", "WS", "DP", "DA", "ZR",
    "CONF_TM", "GS", "GET_RC", "GET_RV", "CT", "GET_RA", "POS_DATA", "TK", "CONF_SER",
    "PLACE_ROBOT", "ADD_OBSTACLE", "DELETE_OBSTACLE", "MOVE_OBSTACLE", "NEW_WORLD", "GET_RPX",
    "PREDICT", "MOTION_CHECK", "GET_CONF", "REAL_ROBOT", "SIMULATED_ROBOT", "DRAW", "REFRESH",
    "QUIT_SERVER", "CREATE", "SPECIAL", "SEND", "RECEIVE", "MESSAGE_COUNT", "GROUP", "CHANNEL",
    "ROBOT", "FIELD",
}  # fmt: skip
"""Requests that concern no single device."""


@pytest.fixture(scope="module")
def driver(tmp_path_factory) -> Driver:
    """All known robots, a bare one, and a Nomad 200 with a device of each kind."""
    folder = tmp_path_factory.mktemp("robots")
    (folder / "bare.xml").write_text(BARE)
    nomad = next(path for path in ROBOTS if path.stem == "nomad200").read_text()
    lacks = [each.element for each in devices() if f"<{each.element}" not in nomad]
    registered = "".join(
        f"<{element} {REQUIRED.get(element, '')}/>" for element in lacks if element
    )
    (folder / "full.xml").write_text(
        nomad.replace("<computer-battery", f"{registered}<computer-battery")
    )
    names = [*(path.stem for path in ROBOTS), "bare.xml", "full.xml"]
    robots = "".join(
        f'<robot definition="{name}" x="{2 * place}m" y="0"/>' for place, name in enumerate(names)
    )
    area = '<area length="99m" width="99m" origin="centre"/>'
    (folder / "world.xml").write_text(
        f'<world version="1">{area}<field name="trail"/>{PLACES}{robots}</world>'
    )
    return Driver.of(load_world(folder / "world.xml"))


def test_every_request_has_a_device_or_none():
    asked = {name for _, name, *_ in ASKED}
    assert not asked & OF_ALL
    robots = {row.name for row in REQUESTS.values() if row.server not in ("host", "network")}
    assert asked | OF_ALL == robots


def test_every_device_is_present_and_missing_on_some_robot(driver):
    models = [robot.model for robot in driver.environment.world.robots]
    for has in HAS.values():
        assert {has(model) for model in models} == {True, False}


@pytest.mark.parametrize("asked", ASKED, ids=lambda asked: "-".join(map(str, asked[1:])))
def test_requests_for_missing_devices_are_refused_without_effect(driver, asked):
    device, name, *arguments = asked
    environment: Environment = driver.environment
    for robot, each in enumerate(environment.world.robots):
        if HAS[device](each.model):
            if device == "laser":
                driver.post("CONF_LS", 51, robot=robot)
            result = driver.post(name, *arguments, robot=robot)[0]["result"]
            assert result == 1 or name in COUNTS, each.model.name
        else:
            before = environment.hash()
            assert driver.post(name, *arguments, robot=robot)[0]["result"] == 0, each.model.name
            environment.state.commands[robot] -= 1
            assert environment.hash() == before


def test_order_with_missing_sonar_is_refused(driver):
    """An AmigoBot has eight."""
    ids = [robot.model.name for robot in driver.environment.world.robots]
    amigo = next(place for place, name in enumerate(ids) if "amigo" in name.lower())
    for order, result in ((bytes([0, 7]), 1), (bytes([0, 8]), 0), (bytes([255, 8]), 1)):
        assert driver.post("CONF_SN", 15, robot=amigo, data=order)[0]["result"] == result
