"""Pictures, scans and their pages are the same for robots that ask together and one by one."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import load_world

CAMERA, LASER = 1, 3
DRIVE = """<drive wheel-base="34cm" speed-limit="1m/s" acceleration-limit="2m/s2" speed="1m/s"
acceleration="2m/s2"/><bumpers><ring switches="8"/></bumpers><sonars order=""/>"""
KINDS = (  # laser and camera with other numbers of points and columns; one robot lacks both
    """<laser points="70" field-of-view="180deg" range="6m" mode="51"/>
    <camera columns="40" range="8m" background="silver"/>""",
    """<laser points="9" field-of-view="90deg" range="2m" noise="1cm" mode="33"/>
    <camera columns="7" range="3m"/>""",
    """<laser points="130" field-of-view="360deg" range="6m" mode="0"/>""",
    "",
)
PAGES = (0, 31, 62, 8, -1, 2**31 - 1)


def environment_of(folder: Path) -> Environment:
    """Return a world in which eight robots of four kinds stand among coloured boxes."""
    robots = []
    for number, devices in enumerate(KINDS):
        (folder / f"r{number}.xml").write_text(
            f'<robot-definition version="1" name="r{number}"><body radius="20cm" mass="10kg"/>'
            f"{DRIVE}{devices}</robot-definition>"
        )
    for number in range(8):
        x_m, heading = 1 + 1.1 * number, 37 * number
        robots.append(
            f'<robot x="{x_m}m" y="{2 + number % 3}m" heading="{heading}deg"'
            f' definition="r{number % 4}.xml"/>'
        )
    boxes = "".join(
        f'<box x="{1 + 2 * column}m" y="{row}m" length="30cm" width="20cm"/>'
        for column in range(5) for row in (1, 6)
    )  # fmt: skip
    text = f'<world version="1"><area length="10m" width="7m"/>{boxes}{"".join(robots)}</world>'
    (folder / "world.xml").write_text(text)
    environment = Environment(load_world(folder / "world.xml"), 1)
    posted(environment, "CONNECT", np.arange(8), ())
    return environment


def posted(
    environment: Environment, code: str, robots: np.ndarray, arguments: tuple[int, ...]
) -> list[bytes]:
    """Post a request of some robots at once; return their replies."""
    messages = np.zeros(len(robots), MESSAGE)
    messages["i"][:, : len(arguments)] = arguments
    messages["data"] = 0xAA  # what the program left there
    environment.serve(CODES[code], robots, messages, np.full(len(robots), environment.time_s))
    return [message.tobytes() for message in messages]


@pytest.mark.parametrize(
    ("request_", "page", "sensor"),
    [
        (("CAMERA", 0), "READINGS", CAMERA), (("CAMERA", 1), "READINGS", CAMERA),
        (("LASER",), "READINGS", LASER), (("GET_LS",), "LASER_PAGE", None),
        (("GET_SG",), "LASER_PAGE", None),
    ],
)  # fmt: skip
def test_robots_get_together_what_each_gets_alone(tmp_path, request_, page, sensor):
    together, alone = environment_of(tmp_path), environment_of(tmp_path)
    code, *arguments = request_
    asked = [(code, tuple(arguments))]
    asked += [(page, (first,) if sensor is None else (sensor, first)) for first in PAGES]
    for code, arguments in asked:
        replies = posted(together, code, np.arange(8), arguments)
        assert len(set(replies)) > 1 or arguments[-1:] in ((-1,), (2**31 - 1,))
        for robot in range(8):
            assert posted(alone, code, np.array([robot]), arguments) == [replies[robot]]
    assert together.hash() == alone.hash()
