"""The sensor readings in the plot of a run."""

import math
from pathlib import Path

import numpy as np
import pytest

from crs_cc.plot.picture import Picture
from crs_cc.sim.engine.sensor_overlay import sights
from tests.device.robot import scout_with
from tests.nclient.drive import drive
from tests.sim.driver import SCOUT_RADIUS_M


def test_beams_end_at_their_echoes_and_lines_at_what_the_camera_sees(tmp_path: Path) -> None:
    """A red pole 1 m to the left of a robot that looks there, and nothing else."""
    camera = '<camera columns="3" field-of-view="6deg" forward="10cm"/>'
    robot = scout_with(tmp_path, camera)
    pole = '<cylinder x="1m" y="2.1m" radius="10cm" colour="red"/>'
    program = "struct crs_pixel row[3]; crs_camera(row, 3);"
    elements = f'<robot x="1m" y="1m" heading="90deg"/>{pole}'
    session = drive(program, robot=robot, elements=elements).session
    state, world = session.environment.state, session.environment.world_now
    beams = sights(state, world, session.time_s)
    (echo,) = [beam for beam in beams if not beam.colour]
    assert echo.outline[0] == pytest.approx([1.0, 1.0 + SCOUT_RADIUS_M])
    assert echo.outline[5] == pytest.approx([1.0, 2.0])  # the middle of its nine points
    lines = [beam for beam in beams if beam.colour]
    assert {line.colour for line in lines} == {"#ff0000"}
    assert len(lines) == 3
    start, end = lines[1].outline
    assert start == pytest.approx([1.0, 1.1])
    assert end == pytest.approx([1.0, 2.0], abs=0.002)
    left = lines[0].outline[1] - start
    assert math.atan2(left[1], left[0]) == pytest.approx(math.radians(92))
    later_s = session.time_s + 1.0
    assert not any(beam.colour for beam in sights(state, world, later_s))  # it may have driven on
    drawn = Picture("", "", world, [], sights=beams).render()
    assert drawn.count(b"#ff0000") >= 3
    assert np.isfinite(echo.outline).all()
