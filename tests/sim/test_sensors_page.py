"""Writes `docs/sensors.md` from the sensors' own files, the schema and the tables of devices.

What is said of a sensor stands at the head of its file. `--update-goldens` rewrites the page.
"""

from __future__ import annotations

import importlib
import inspect
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from crs_cc.robot_api.device import DEVICE_GROUPS
from crs_cc.sim.model.degradation import degradables
from tests.sim.test_world_format_page import Schema

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "sensors.md"


@dataclass(frozen=True)
class Row:
    """A sensor of the page.

    Attributes:
        title: what it is called.
        module: its file in `crs_cc.sim.devices`.
        element: its element in a robot definition; empty for none.
        reads: the C functions that read it.
        says: what else there is to say.
        degradation: its name in `degradables()`; empty for none.
    """

    title: str
    module: str
    element: str
    reads: tuple[str, ...]
    says: str
    degradation: str


ROWS = (
    Row(
        "Sonar", "sonar", "sonars", ("get_sn", "crs_sonar", "crs_sonar_mode", "sonarSensorCheck"),
        "Each sonar has a `<sensor>` of its own, with its place, direction and cone. `<mode>` in "
        "`<sonars>` names a way in which all of them can work, with range, beam, resolution and "
        "errors of its own: the first one is that of the start, `crs_sonar_mode(1)` chooses the "
        "second. A surface that sends back a share R of the sound (`sonar` of a material) is heard "
        "to R^(1/4) of the range, by the radar equation.",
        "sonar",
    ),
    Row(
        "Infrared ring", "infrared", "infrared", ("get_ir",),
        "`infrared` of a material takes the place of the definition's reflectance.", "infrared",
    ),
    Row("Laser", "laser", "laser", ("get_ls", "get_sg", "crs_laser"), "", "laser"),
    Row(
        "Camera", "camera", "camera", ("crs_camera", "crs_blobs"),
        "Colours are those of materials, and of robots (`colour`).", "camera",
    ),
    Row(
        "Heat sensor", "heat", "heat", ("crs_heat", "heatSensorCheck"),
        "`heat` and `spread` of a thing say how hot it is.", "heat",
    ),
    Row("GPS", "gps", "gps", ("crs_gps",), "", "gps"),
    Row("Compass", "compass", "compass", ("get_cp",), "", "compass"),
    Row("Inclinometer", "tilt", "inclinometer", ("crs_tilt",), "", "tilt"),
    Row("Light sensors", "light", "light-sensors", ("crs_get_light",), "", "light"),
    Row("Microphones", "sound", "microphones", ("crs_get_sound",), "", "sound"),
)  # fmt: skip

INTRODUCTION = """\
<!-- made by tests/sim/test_sensors_page.py of the sensors' files, robot.xsd and the tables of
     devices; edit there, then pytest --update-goldens -->

# Sensors

What sensors of robots tell, by which law, and how a control program asks for it. A robot has those
that its definition names; [crs-h.md](crs-h.md) has the functions of `crs.h`,
[robot-api.md](robot-api.md) the vendor's, [degradation.md](degradation.md) what can go wrong.
Bumpers are pressed by contacts, odometry is what the wheels turned; both are in `State`.

```sh
crs run samples/scout_c/follow_red.c worlds/gallery.xml --max-time 4 \\
  --plot docs/images/gallery.svg --plot-sensors
```

![What a robot hears and sees: beams up to their echoes, and lines in the colours of what is
there](images/gallery.svg)

`--plot-sensors` draws what sonars and cameras told last: here the far mode of the sonars, to whole
10 cm, and the camera's view of a red column, a stove, a curtain and the walls.

**When a sensor measures.** When it is asked, at most at its rate; in between it tells what it
measured last. Or by a timer of its own, whether anybody asks or not: with `period` in the
definition, or `crs_period(CRS_SENSOR_GPS, 200)` in the program, it measures at exact multiples of
its period, from where the robot is at that instant, and whoever asks is told the last reading.
`crs_age` tells how old that is. Sonars always fire in turn by their own timer (`conf_sn`).

**Errors.** Those that a sensor always has are in its definition; those that come and go in the
world's degradations. Every sensor of every robot has random numbers of its own.

| sensor | element | functions | readings | by a timer | degradation | sample |
| --- | --- | --- | --- | --- | --- | --- |
"""
READINGS = {
    "Sonar": ("whole inches up to 255 (`crs_sonar`: 0.1 in)", "always", "two_modes"),
    "Infrared ring": ("0 to 15", "yes", "slide"),
    "Laser": ("points, segments, or ranges: 0.1 in", "yes", "laser_door"),
    "Camera": ("0xRRGGBB, 0.1 in, 0.1 deg", "yes", "follow_red"),
    "Heat sensor": ("whole numbers", "yes", "warmer"),
    "GPS": ("0.1 in", "yes", "waypoints"),
    "Compass": ("0.1 deg", "yes", "by_compass"),
    "Inclinometer": ("0.1 deg", "yes", "climb"),
    "Light sensors": ("whole numbers", "yes", "vehicle/vehicle"),
    "Microphones": ("whole numbers, 0.1 deg", "yes", "call/seeker"),
}


def overview() -> Iterator[str]:
    """Gives the lines of the table."""
    for row in ROWS:
        reading, timer, sample = READINGS[row.title]
        functions = ", ".join(f"`{name}`" for name in row.reads)
        name = sample.rpartition("/")[2]
        link = f"[{name}](../samples/scout_c/{sample}.c)" if sample else ""
        cells = [
            f"[{row.title}](#{row.title.lower().replace(' ', '-')})", f"`<{row.element}>`",
            functions, reading, timer, f"`{row.degradation}`", link,
        ]  # fmt: skip
        yield f"| {' | '.join(cells)} |"


def section(row: Row, schema: Schema) -> Iterator[str]:
    """Gives what the page says of one sensor."""
    module = importlib.import_module(f"crs_cc.sim.devices.{row.module}")
    text = inspect.getdoc(module) or ""
    yield f"\n## {row.title}\n"
    yield paragraphs(text.split("\n\n", 1)[1])
    if row.says:
        yield f"\n{row.says}"
    element = schema.named["{http://www.w3.org/2001/XMLSchema}complexType", row.element]
    yield f"\n`<{row.element}>` in a robot definition:\n"
    yield "| attribute | what it is | if not given | |\n| --- | --- | --- | --- |"
    for attribute in schema.parts(element, "attribute"):
        yield schema.row(attribute, attribute.get("use") == "required")
    device = degradables()[row.degradation]
    yield f"\nDegradation `{device.name}`: {device.title}; without a value: {device.nothing}."


def paragraphs(text: str) -> str:
    """Gives the text of a docstring as Markdown, each paragraph in one line."""
    parts = [part for part in text.strip("\n").split("\n\n") if part.strip()]
    return "\n\n".join(
        part if re.search(r"^(- | )", part, re.MULTILINE) else " ".join(part.split())
        for part in parts
    )


def test_every_function_that_reads_a_sensor_is_on_the_page() -> None:
    sensors = next(group for group in DEVICE_GROUPS if group.title == "Sensors")
    told = {name for row in ROWS for name in row.reads}
    aside = {"crs_period", "crs_age"}
    assert {function.name for function in sensors.functions} - told <= aside


def test_the_page_is_as_the_sensors(check_golden: Callable[[Path, bytes], None]) -> None:
    schema = Schema("robot.xsd")
    lines = [INTRODUCTION.rstrip("\n"), *overview()]
    lines += [line for row in ROWS for line in section(row, schema)]
    check_golden(PAGE, ("\n".join(lines) + "\n").encode())


@pytest.mark.parametrize("name", re.findall(r"\]\(([^)#]+)\)", INTRODUCTION.replace("\n", " ")))
def test_what_the_page_names_is_there(name: str) -> None:
    assert (PAGE.parent / name).exists()
