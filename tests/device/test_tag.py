"""`crs_tag` from C: nearby objects lose their heat."""

import re
from pathlib import Path

import pytest

from crs_cc.sim.files import world_xml
from tests.nclient.drive import drive


@pytest.mark.function("crs_tag")
def test_tag_removes_heat_in_range_and_returns_count():
    """A Scout's range is 3 m: it removes the heat of two of the three, and then of none."""
    elements = '<robot x="0" y="0"/>' + "".join(
        f'<cylinder x="{x}m" y="0" radius="20cm" heat="5"/>' for x in (1, -2, 4)
    )
    ask = 'int heat; crs_heat(&heat); printf("%d %d ", heat, crs_tag()); printf("%d ", crs_tag());'
    show = 'crs_heat(&heat); printf("%d\\n", heat);'
    assert drive(ask + show, elements=elements).numbers == [10, 2, 0, 0]


@pytest.mark.function("crs_tag")
def test_robot_without_tagging_returns_error_and_removes_nothing(tmp_path):
    scout = (Path(world_xml.__file__).parents[0] / "robots" / "scout.xml").read_text()
    (tmp_path / "cold.xml").write_text(re.sub("<heat [^>]*/>", "", scout))
    elements = '<robot x="0" y="0"/><cylinder x="1m" y="0" radius="20cm" heat="5"/>'
    done = drive('printf("%d\\n", crs_tag());', elements=elements, robot=str(tmp_path / "cold.xml"))
    assert done.numbers == [-1]
    assert done.session.environment.state.heat.left.tolist() == [0.0, 5.0]
