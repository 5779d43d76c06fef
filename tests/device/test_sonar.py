"""`crs_sonar` and `crs_sonar_mode` from C: modes of sonars, and the effect of surfaces."""

from pathlib import Path

import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import empty_world, load_robot, parse_world
from tests.device.robot import scout_with
from tests.nclient.drive import drive
from tests.sim.driver import INCH, SCOUT_RADIUS_M, Driver

MODES = (
    '<mode name="LF" range="10m" half-angle="15deg" resolution="10cm"/>'
    '<mode name="HF" range="2m" half-angle="5deg" resolution="1mm"/>'
)
ASK = 'crs_sonar(ranges, 16); printf("%d %d\\n", ranges[0], ranges[1]);'
TURNS = "sleep(2);"  # all sixteen have fired


def with_modes(folder: Path, modes: str = MODES) -> str:
    """Write the definition of a Scout whose sonars have modes; return its path."""
    path = Path(scout_with(folder))
    old = '<sonars order="0 2 15 1 14 3 13 4 12 5 11 6 10 7 9 8" noise="0in"/>'
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, f"{old[:-2]}>{modes}</sonars>"))
    return str(path)


def far_m(x_m: float) -> float:
    """Return the object's x for a distance from the shell."""
    return x_m + SCOUT_RADIUS_M


@pytest.mark.function("crs_sonar", "crs_sonar_mode")
def test_far_mode_has_longer_range_and_fine_mode_higher_resolution(tmp_path):
    """A pole 7.34 m ahead, at the left a nearer one, 1.2345 m from sonar 1."""
    program = f"""
    int ranges[16];
    {ASK}
    printf("%d\\n", crs_sonar_mode(1));
    {TURNS} {ASK}
    printf("%d\\n", crs_sonar_mode(0));
    {TURNS} {ASK}
    """
    near_m = far_m(1.2345) + 0.1
    x_m, y_m = near_m * 0.9238795, near_m * 0.3826834
    elements = (
        f'<robot x="0" y="0"/><cylinder x="{far_m(7.34) + 0.1}m" y="0" radius="10cm"/>'
        f'<cylinder x="{x_m}m" y="{y_m}m" radius="10cm"/>'
    )
    told = drive(program, elements=elements, robot=with_modes(tmp_path)).numbers
    tenth = INCH / 10
    coarse, fine = round(7.3 / tenth), round(1.235 / tenth)
    assert told == [
        *(coarse, round(1.2 / tenth), 1),
        *(-1, pytest.approx(fine, abs=1), 1),
        *(coarse, round(1.2 / tenth)),
    ]


def test_beam_width_is_that_of_mode(tmp_path):
    """A pole 1 m away, 10 degrees off the axis: in a cone of 15 degrees, not in one of 5."""
    elements = '<robot x="0" y="0"/><cylinder x="1.188m" y="0.174m" radius="1cm"/>'
    program = f"int ranges[16]; {ASK} crs_sonar_mode(1); {TURNS} {ASK}"
    wide, _, narrow, _ = drive(program, elements=elements, robot=with_modes(tmp_path)).numbers
    assert wide > 0
    assert narrow == -1


@pytest.mark.parametrize("mode", [-1, 2, 2**31 - 1])
def test_unknown_modes_are_refused(tmp_path, mode):
    driver = Driver.of(empty_world(robot=with_modes(tmp_path)))
    assert driver.post("SONAR_MODE", mode)[0]["result"] == 0
    assert driver.post("SONAR_MODE", 1)[0]["result"] == 1
    assert driver.state.devices.sonar.mode.tolist() == [1]


def test_robot_without_modes_has_one_mode_and_robot_without_sonars_none(tmp_path):
    driver = Driver.of(empty_world())
    assert driver.post("SONAR_MODE", 0)[0]["result"] == 1
    assert driver.post("SONAR_MODE", 1)[0]["result"] == 0
    path = Path(scout_with(tmp_path))
    text = path.read_text()
    start, end = text.index("  <sensor>"), text.rindex("</sensor>") + len("</sensor>")
    text = text[:start] + text[end:]
    order = text.index('order="') + len('order="')
    path.write_text(text[:order] + text[text.index('"', order) :])
    assert drive("int range; return crs_sonar(&range, 1);", robot=str(path)).status == 0


@pytest.mark.parametrize(
    ("share", "away_m", "is_heard"),
    [
        (1.0, 6.4, True),
        (0.0625, 3.2, True),  # a sixteenth of the power: half of the 255 in that a Scout hears
        (0.0625, 3.3, False),
        (0.0016, 1.25, True),  # a fifth: 1.295 m
        (0.0016, 1.33, False),
        (0.0, 0.1, False),
    ],
)
@pytest.mark.parametrize(
    "obj",
    [
        '<wall x1="{x}m" y1="-3m" x2="{x}m" y2="3m" thickness="20cm" sonar="{share}"/>',
        '<cylinder x="{x}m" y="0" radius="10cm" sonar="{share}"/>',
        '<box x="{x}m" y="0" length="20cm" width="20cm" sonar="{share}"/>',
    ],
)
def test_range_scales_with_fourth_root_of_reflected_power(obj, share, away_m, is_heard):
    elements = '<robot x="0" y="0"/>' + obj.format(x=far_m(away_m) + 0.1, share=share)
    message, _ = _driver(elements).post("SONAR_RANGES", 0)
    assert (message["data"][:4].view("<i4")[0] >= 0) == is_heard


def test_curtain_hides_objects_behind_it():
    curtain = '<wall x1="3m" y1="-3m" x2="3m" y2="3m" thickness="2cm" sonar="0"/>'
    wall = '<wall x1="4m" y1="-3m" x2="4m" y2="3m"/>'
    for elements, is_heard in ((wall, True), (curtain + wall, False)):
        message, _ = _driver('<robot x="0" y="0"/>' + elements).post("SONAR_RANGES", 0)
        assert (message["data"][:4].view("<i4")[0] >= 0) == is_heard


def _driver(elements: str) -> Driver:
    area = 'length="2000m" width="2000m" origin="centre" edge="0"'
    text = f'<world version="1"><area {area}/>{elements}</world>'
    return Driver.of(parse_world(text.encode(), "test"))


@pytest.mark.parametrize(
    ("mode", "wrong"),
    [
        ('<mode name="LF" range="0m"/>', "mode, range: '0m' must be greater than 0"),
        ('<mode name="LF" half-angle="90deg"/>', "mode, half-angle: must be less than 90deg"),
        ('<mode name="LF"/><mode name="LF"/>', "duplicate mode 'LF'"),
    ],
)
def test_invalid_mode_is_reported_once(tmp_path, mode, wrong):
    with pytest.raises(WorldError, match=wrong) as error:
        load_robot(Path(with_modes(tmp_path, mode)))
    assert str(error.value).count("error:") == 1


def test_snapshot_contains_mode(tmp_path):
    driver = Driver.of(empty_world(robot=with_modes(tmp_path)))
    driver.post("SONAR_MODE", 1)
    snapshot = driver.environment.snapshot()
    driver.post("SONAR_MODE", 0)
    driver.environment.restore(snapshot)
    assert driver.state.devices.sonar.mode.tolist() == [1]
