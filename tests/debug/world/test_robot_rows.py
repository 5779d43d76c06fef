"""A robot as rows: what is true of it, in words and units."""

from pathlib import Path

import pytest

from crs_cc import compile_c
from crs_cc.debug.world.robot_rows import HEADINGS, robot_rows, summary
from crs_cc.debug.world.rows import lines
from crs_cc.runtime.testing import counting_program
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import empty_world
from crs_cc.sim.model.degradation import Degradation
from tests.device.robot import scout_with
from tests.sim.driver import open_world, world_of

DRIVES = """
#include "Nclient.h"
int main(void) {
    connect_robot(1);
    ac(100, 100, 0);
    sp(100, 100, 0);
    pr(200, 200, 0);
    ws(1, 1, 0, 60);
    return 7;
}
"""


@pytest.fixture(scope="module")
def drives(tmp_path_factory):
    path: Path = tmp_path_factory.mktemp("drives") / "drives.c"
    path.write_text(DRIVES)
    return compile_c(path)


def rows_of(session: Session, robot: int = 0) -> dict[str, str]:
    return {row.name: row.text for row in robot_rows(session, robot)}


def after(session: Session, steps: int) -> Session:
    for _ in range(steps):
        session.step()
    return session


def test_rows_of_a_robot_that_drives_and_waits(drives) -> None:
    # 20 in with 10 in/s2 and 10 in/s: 1 s of ramp (5 in), 1 s of cruise (10 in), 1 s of brake.
    session = after(Session(open_world().with_ideal_link(), [drives], seed=1), 30)
    rows = rows_of(session)
    assert rows["pose"] == "0.254, 0.000 m, 0.0 deg"
    assert rows["odometry"] == rows["pose"]
    assert rows["connected"] == "yes"
    assert rows["command"] == "pr, timestep 31 of 61"  # it came a moment after 0
    assert rows["program"].endswith(
        "drives.c: the robot drives while ws waits for right and left to stop, "
        "at most until 60.000 s"
    )
    assert rows["driven"] == "0.254 m, 0 collisions"
    (right, left) = next(row for row in robot_rows(session, 0) if row.name == "command").children
    assert right.text == left.text == "0.254 m/s, 0.254 m since the command of 0.508 m"
    assert rows_of(after(session, 60))["program"].endswith("drives.c: exited with 7")
    assert rows_of(session)["command"] == "none runs"


def test_rows_of_a_program_on_the_link_and_of_an_absent_robot(drives) -> None:
    world = world_of('<robot x="2m" y="2m"/><robot x="5m" y="5m" join="9s"/>')
    session = after(Session(world, [drives, drives], seed=1), 1)
    name = session.fleet.executable(0).name
    assert summary(session, 0)[:3] == ("0", "robot0", name)
    assert summary(session, 0)[3].startswith("stands while pr waits for the link until 0.")
    assert summary(session, 1) == (
        "1", "robot1", name, "has not joined", "0.000 s", "-", "-", "-"
    )  # fmt: skip
    assert len(HEADINGS) == len(summary(session, 1))
    assert [row.name for row in robot_rows(session, 1)] == ["robot", "program", "clock"]


def test_rows_have_contacts_and_degradations(drives) -> None:
    wall = '<wall id="screen" x1="2.3m" y1="0" x2="2.3m" y2="4m" thickness="10cm"/>'
    session = Session(world_of(f'<robot x="2m" y="2m"/>{wall}'), [drives], seed=1)
    session.environment.degradations.add(Degradation("robot0", "sonar", 3, dead=True))
    session.environment.degradations.add(Degradation("robot0", "drive", 1, gain=0.5, onset_s=99.0))
    rows = rows_of(after(session, 60))
    assert rows["touches"] == "screen"
    assert rows["bumpers"] == "bumper 0 (ahead)"
    assert rows["sonar"].startswith("nearest ")
    assert rows["degradations"] == "1 of 2 active"
    shown = list(lines(robot_rows(session, 0)))
    assert "  degradation0  sonar 3, dead (acts)" in shown
    assert "  degradation1  drive left, gain 0.5 (waits)" in shown
    assert any(line.startswith("  3 at 67.5 deg") and line.endswith("no echo") for line in shown)


def test_a_program_without_a_robot_call_runs() -> None:
    session = Session(open_world(), [counting_program(rounds=10**9)], seed=1)
    session.step()
    assert summary(session, 0)[3:5] == ("runs", "0.050 s")


SENSES = """
#include "crs.h"
int main(void) {
    int pitch, roll;
    crs_tilt(&pitch, &roll);
    crs_light(7);
    return 0;
}
"""


def test_rows_show_the_devices_of_a_robot(tmp_path) -> None:
    (tmp_path / "senses.c").write_text(SENSES)
    robot = scout_with(tmp_path, "<inclinometer/><gps/><lamp/>")
    session = Session(empty_world(robot=robot), [compile_c(tmp_path / "senses.c")], seed=1)
    rows = rows_of(after(session, 5))
    assert (rows["tilt"], rows["gps"], rows["lamp"]) == ("pitch 0deg, roll 0deg", "no reading", "7")
    assert "light" not in rows
