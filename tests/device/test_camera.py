"""`crs_camera` and `crs_blobs` from C: colours and ranges by hand-worked geometry, pages, noise."""

import math
from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import empty_world, load_robot
from tests.device.robot import scout_with
from tests.nclient.drive import drive
from tests.sim.driver import Driver

ROW = """
struct crs_pixel row[320];
int i, count = crs_camera(row, 320);
for (i = 0; i < count; i++)
    printf("%d %d\\n", row[i].colour, row[i].range);
"""
BLOBS = """
struct crs_blob blobs[320];
int i, count = crs_blobs(blobs, 320);
for (i = 0; i < count; i++)
    printf("%d %d %d %d\\n", blobs[i].angle, blobs[i].width, blobs[i].colour, blobs[i].range);
"""
RED, GREEN, BLUE = 0xFF0000, 0x00FF00, 0x0000FF
POLES = (
    '<robot x="0" y="0"/>'
    '<cylinder x="200in" y="0" radius="10in" colour="#ff0000"/>'
    '<cylinder x="0" y="100in" radius="10in" colour="#00ff00"/>'
    '<cylinder x="-100in" y="0" radius="10in" colour="#0000ff"/>'
)


def seen(tmp_path, camera: str, program: str = ROW, width: int = 2, **world):
    """Return what a camera reports, a row for each pixel or blob."""
    robot = scout_with(tmp_path, f"<camera {camera}/>")
    return np.array(drive(program, robot=robot, **world).numbers, dtype=int).reshape(-1, width)


@pytest.mark.function("crs_camera")
def test_columns_have_colour_and_range_from_left_to_right(tmp_path):
    """Four columns around: 135 degrees to the left, 45, then the same to the right."""
    camera = 'columns="4" field-of-view="360deg" range="10m" direction="45deg" background="#010203"'
    row = seen(tmp_path, camera, elements=POLES)
    assert row.tolist() == [
        [BLUE, 900],  # behind, at 180 degrees
        [GREEN, 900],  # to the left
        [RED, 1900],  # ahead
        [0x010203, -1],  # nothing to the right
    ]


def test_camera_sees_from_its_position_on_robot(tmp_path):
    """From 5 in ahead and 3 in left, a wall at x = 50 in, of 2 in, is 44 in away at its centre."""
    wall = '<robot x="0" y="0"/><wall x1="50in" y1="-2m" x2="50in" y2="2m" thickness="2in"/>'
    camera = 'columns="3" field-of-view="90deg" forward="5in" left="3in"'
    row = seen(tmp_path, camera, elements=wall)
    assert row[:, 0].tolist() == [0x808080] * 3
    assert row[:, 1].tolist() == [round(440 / math.cos(math.radians(30))), 440, 508]


def test_robot_is_seen_in_its_own_colour(tmp_path):
    elements = '<robot x="0" y="0"/><robot x="100in" y="0" colour="yellow"/>'
    robot = scout_with(tmp_path, '<camera columns="1" field-of-view="10deg"/>')
    assert drive(ROW, "return 0;", elements=elements, robot=robot).numbers == [0xFFFF00, 920]


def test_300_columns_are_returned_in_pages(tmp_path):
    """A wall across the view: the range of each column is that of its direction."""
    wall = '<robot x="0" y="0"/><wall x1="101in" y1="-9m" x2="101in" y2="9m" thickness="2in"/>'
    row = seen(tmp_path, 'columns="320" field-of-view="80deg"', elements=wall)
    angle = np.radians((159.5 - np.arange(320)) * 80 / 320)
    assert row[:, 1] == pytest.approx(1000 / np.cos(angle), abs=0.51)


@pytest.mark.parametrize(("most", "told"), [(0, 0), (1, 1), (40, 40), (100, 64), (-5, 0)])
def test_result_is_limited_to_buffer_size(tmp_path, most, told):
    program = f"""
    struct crs_pixel row[101];
    memset(row, 7, sizeof row);
    printf("%d\\n", crs_camera(row, {most}));
    printf("%d\\n", row[{max(told, 0)}].range == 0x07070707);
    """
    robot = scout_with(tmp_path, '<camera columns="64"/>')
    assert drive(program, robot=robot).numbers == [told, 1]


@pytest.mark.function("crs_blobs")
def test_blobs_have_angle_width_colour_and_nearest_range(tmp_path):
    """Columns of 1 degree, at half degrees: the red pole covers 2.87 degrees on each side.

    At half a degree it is 200 cos 0.5 - sqrt(10^2 - (200 sin 0.5)^2) = 190.15 in away.
    """
    found = seen(tmp_path, 'columns="60"', BLOBS, width=4, elements=POLES)
    assert found.tolist() == [[0, 60, RED, 1901]]


def test_blobs_are_ordered_from_left_and_split_by_colour(tmp_path):
    """Seen from 100 in, a screen of two halves, 20 in each, 11.31 degrees to each side."""
    elements = (
        '<robot x="0" y="0"/>'
        '<box x="101in" y="10in" length="2in" width="20in" colour="lime"/>'
        '<box x="101in" y="-10in" length="2in" width="20in" colour="blue"/>'
    )
    found = seen(tmp_path, 'columns="60"', BLOBS, width=4, elements=elements)
    assert found[:, 2].tolist() == [GREEN, BLUE]
    assert found[:, :2].tolist() == [[55, 110], [-55, 110]]
    assert found[:, 3] == pytest.approx([1000, 1000], abs=1)


def test_robot_without_camera_sees_nothing():
    assert drive("struct crs_pixel row[1]; return crs_camera(row, 1);").status == 0
    assert drive("struct crs_blob blob[1]; return crs_blobs(blob, 1);").status == 0


def test_previous_picture_is_returned_between_two_pictures(tmp_path):
    wall = '<robot x="0" y="0"/><wall x1="100in" y1="-2m" x2="100in" y2="2m"/>'
    ask = 'crs_camera(row, 1); printf("%d\\n", row[0].range);'
    program = f"struct crs_pixel row[1]; connect_robot(1); vm(100, 100, 0); {ask} usleep(300000);"
    robot = scout_with(tmp_path, '<camera columns="1" rate="1Hz"/>')
    now, same, later = drive(f"{program} {ask} sleep(1); {ask}", robot=robot, elements=wall).numbers
    assert now == same > later


def test_noise_grows_with_square_of_distance(tmp_path):
    """320 columns on a ring of 2 m around the camera, 20 pictures, a deviation of 4 cm there."""
    robot = scout_with(tmp_path, '<camera columns="320" field-of-view="360deg" noise="1cm"/>')
    poles = "".join(
        f'<cylinder x="{2.01 * math.cos(a)}m" y="{2.01 * math.sin(a)}m" radius="1cm"/>'
        for a in (math.radians(n * 0.3) for n in range(1200))
    )
    loop = (
        "for (n = 0; n < 20; n++) { crs_camera(row, 320); usleep(40000); for (i = 0; i < 320; i++)"
    )
    program = f'struct crs_pixel row[320]; int i, n; {loop} printf("%d\\n", row[i].range); }}'
    ranges = np.array(drive(program, robot=robot, elements=f'<robot x="0" y="0"/>{poles}').numbers)
    assert ranges.std() * 0.00254 == pytest.approx(0.04, rel=0.04)  # 6,400: 0.9% standard error
    assert ranges.mean() * 0.00254 == pytest.approx(2.0, abs=0.003)


@pytest.mark.parametrize(
    ("attribute", "wrong"),
    [
        ('columns="321"', "camera, columns: '321' is not an integer from 1 to 320"),
        ('columns="0"', "camera, columns: '0' is not an integer from 1 to 320"),
        ('field-of-view="361deg"', "camera, field-of-view: must be 360deg or less"),
        ('background="reddish"', "camera, background: unknown colour 'reddish'"),
        ('range="0m"', "camera, range: '0m' must be greater than 0"),
    ],
)
def test_invalid_definition_is_reported(tmp_path, attribute, wrong):
    with pytest.raises(WorldError, match=wrong):
        load_robot(Path(scout_with(tmp_path, f"<camera {attribute}/>")))


PLACED = """
<sensor><id>0</id><type>camera</type><position>
  <x-relative>5in</x-relative><y-relative>3in</y-relative><z-relative>10in</z-relative>
  <range>4m</range><radius>4m</radius><dir-relative>{}</dir-relative>
</position></sensor>"""


def placed(tmp_path, *places: str, camera: str = "<camera columns='3'/>") -> Path:
    """Write the definition of a Scout whose camera is placed by `<sensor>`; return its path."""
    path = Path(scout_with(tmp_path, camera))
    text = path.read_text()
    start = text.index("  <sensor>")
    path.write_text(text[:start] + "".join(places) + text[start:])
    return path


def test_report_sensor_element_places_camera(tmp_path):
    """A cone as wide as it is long to each side is 90 degrees; 1.570796 rad is to the left."""
    camera = load_robot(placed(tmp_path, PLACED.format("1.570796"))).device("camera")
    assert camera.field_of_view_rad == pytest.approx(math.pi / 2)
    assert camera.direction_rad == pytest.approx(math.pi / 2, abs=1e-6)
    assert (camera.range_m, camera.x_m, camera.y_m) == pytest.approx((4.0, 0.127, 0.0762))
    assert (camera.columns, camera.z_m) == (3, pytest.approx(0.254))
    wall = '<robot x="0" y="0"/><wall x1="-2m" y1="51in" x2="2m" y2="51in" thickness="2in"/>'
    row = np.array(drive(ROW, robot=str(tmp_path / "scout-with.xml"), elements=wall).numbers)
    slanted = 470 / math.cos(math.radians(30))
    assert row[1::2] == pytest.approx([slanted, 470, slanted], abs=0.6)


@pytest.mark.parametrize(
    ("places", "camera", "wrong"),
    [
        (1, "", "missing <camera>"),
        (2, "<camera/>", "duplicate camera"),
    ],
)
def test_invalid_camera_placement_is_reported(tmp_path, places, camera, wrong):
    path = placed(tmp_path, *[PLACED.format("0")] * places, camera=camera)
    with pytest.raises(WorldError, match=wrong):
        load_robot(path)


def test_unknown_sensor_type_is_refused_with_list_of_types(tmp_path):
    path = placed(tmp_path, PLACED.format("0").replace(">camera<", ">gps<"))
    with pytest.raises(WorldError, match="invalid value 'gps'; expected sonar or camera"):
        load_robot(path)


def test_pictures_are_reproduced_from_snapshot(tmp_path):
    robot = scout_with(tmp_path, '<camera columns="8" noise="1cm"/>')
    driver = Driver.of(empty_world(robot=robot))
    driver.post("CAMERA")
    driver.run(3)
    snapshot = driver.environment.snapshot()
    hashes = []
    for _ in range(2):
        driver.environment.restore(snapshot)
        driver.post("CAMERA")
        driver.run(2)
        hashes.append(driver.environment.hash())
    assert hashes[0] == hashes[1]


def test_degraded_column_has_other_range_and_dead_one_background(tmp_path):
    wall = '<robot id="me" x="0" y="0"/><wall x1="2.05m" y1="-9m" x2="2.05m" y2="9m"/>'
    faults = (
        '<degradation robot="me" device="camera" element="0" bias="1m"/>'
        '<degradation robot="me" device="camera" element="2" dead="yes"/>'
    )
    camera = 'columns="3" field-of-view="3deg" background="#00000a"'
    row = seen(tmp_path, camera, elements=wall + faults)
    assert row.tolist() == [[0x808080, 1181], [0x808080, 787], [10, -1]]
