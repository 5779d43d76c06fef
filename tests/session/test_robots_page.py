"""Generate the table of `docs/robots.md` from the definitions, and test its examples.

`--update-goldens` rewrites the page.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.sim.files.world_xml import known_robots, load_robot
from crs_cc.sim.model.robot import RobotModel
from tests.sim.files.test_world_xml import SIM

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "robots.md"
TABLE = re.compile(r"(?<=<!-- table -->\n).*?(?=<!-- end -->)", re.DOTALL)
PROGRAM = """#include <unistd.h>
#include "Nclient.h"
int main(void) { connect_robot(1); vm(50, 50, 0); for (;;) { gs(); usleep(100000); } }
"""


def drive_of(model: RobotModel) -> str:
    drive = model.drive
    if drive.steering is None:
        return f"two wheels, {100 * drive.wheel_base_m:.1f} cm apart"
    return "synchro, with a turret" if drive.turret is not None else "synchro"


def sonars_of(model: RobotModel) -> str:
    ahead = [each.id for each in model.sonars if abs(each.direction_rad) < math.radians(20)]
    numbers = ", ".join(map(str, ahead))
    return f"{len(model.sonars)}, to {model.sonars[0].range_m:.1f} m; ahead: {numbers}"


def others_of(model: RobotModel) -> str:
    devices = {
        f"{len(model.bumpers)} bumpers": bool(model.bumpers),
        "infrared": model.infrared is not None,
        "compass": model.compass is not None,
        "laser": model.laser is not None,
        "heat": model.heat.range_m > 0.0,
    }
    return ", ".join(name for name, has in devices.items() if has) or "none"


def row(name: str) -> str:
    model = load_robot(SIM / "files" / "robots" / f"{name}.xml")
    cells = [
        f"`{name}`",
        f"{100 * model.radius_m:.1f} cm, {model.mass_kg:g} kg",
        drive_of(model),
        f"{model.drive.wheels.speed_limit:.2f} m/s",
        sonars_of(model),
        others_of(model),
    ]
    return f"| {' | '.join(cells)} |\n"


def table() -> str:
    head = "| name | radius, mass | drive | at most | sonars | other sensors |\n"
    return head + "| --- " * 6 + "|\n" + "".join(map(row, known_robots()))


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(), re.DOTALL)


def test_the_table_matches_the_definitions(check_golden: Callable[[Path, bytes], None]):
    check_golden(PAGE, TABLE.sub(lambda _: table(), PAGE.read_text()).encode())


def test_the_examples_on_the_page_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    definition, world = blocks("xml")
    Path("cart.xml").write_text(definition)
    assert len(definition.strip().splitlines()) <= 12
    Path("world.xml").write_text(world)
    Path("program.c").write_text(PROGRAM)
    assert main(["check", "cart.xml", "world.xml"]) == 0
    assert main(["run", "program.c", "world.xml", "--max-time", "3"]) == 0
    assert main(["run", "program.c", "--robot", "cart.xml", "--max-time", "1"]) == 0
    (example,) = blocks("python")
    names: dict[str, object] = {}
    exec(example, names)


def test_the_picture_exists():
    for name in re.findall(r"!\[[^]]*\]\(([^)]*)\)", PAGE.read_text()):
        assert (PAGE.parent / name).is_file()
