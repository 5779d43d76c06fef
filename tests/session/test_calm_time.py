"""Calm time, in which programs and a kernel take turns, changes nothing that anybody could notice.

Each test runs the same programs in the same world with and without it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.turns import RECORD
from crs_cc.session import calm_programs
from crs_cc.session.build import build_executable
from crs_cc.sim import files
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.kernels.calm import RECORD_SIZE
from crs_cc.sim.kernels.program import executable
from crs_cc.sim.model.degradation import Degradation
from crs_cc.sim.model.world import Pose, WorldModel
from tests.session.both_ways import (
    CalmObserver,
    Observer,
    compare,
    compare_results,
    frame_of,
    start,
)
from tests.session.programs import build

ROOT = Path(__file__).parents[2]

PROGRAMS = {
    "reads": """
#include <Nclient.h>
int main(void) { connect_robot(1); for (;;) { get_sn(); vm(60, 40, 0); get_rc(); } }
""",
    "anything": """
#include <Nclient.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
int main(int argc, char **argv)
{
    volatile unsigned x = 1;
    unsigned n, k;
    connect_robot(1);
    srand(atoi(argv[1]));
    for (;;) {
        n = rand() % 7;
        switch (rand() % 16) {
        case 0: usleep(1000 * (rand() % 90)); break;
        case 1: for (k = 0; k < n * 20000; k++) x = x * 3 + 1; break;
        case 2: get_sn(); printf("%ld %ld\\n", State[STATE_SONAR_0], State[STATE_SONAR_9]); break;
        case 3: pr(20, 30, 0); if (n < 3) ws(1, 1, 0, 2); break;
        case 4: vm(900, 50, 0); break;
        case 5: conf_tm(1); break;
        case 6: st(); break;
        case 7: lp(); gs(); break;
        case 8: conf_sn(n, (int[16]){0, 4, 8, 255}); break;
        case 9: gs(); printf("%ld\\n", State[STATE_CONF_X]); break;
        case 10: get_rv(); get_bp(); break;
        default: get_sn(); vm(rand() % 120 - 40, rand() % 120 - 40, 0); get_rc(); break;
        }
    }
}
""",
    "drives": """
#include <Nclient.h>
#include <stdlib.h>
int main(int argc, char **argv)
{
    unsigned n;
    connect_robot(1);
    srand(atoi(argv[1]));
    for (;;) {
        int left = rand() % 120 - 50, right = rand() % 120 - 50;
        for (n = rand() % 40; n; n--) { vm(left, right, 0); gs(); }
    }
}
""",
    "sleeps": """
#include <Nclient.h>
#include <unistd.h>
int main(void) { connect_robot(1); for (;;) sleep(1); }
""",
    "waits": """
#include <Nclient.h>
#include <stdlib.h>
int main(int argc, char **argv)
{
    connect_robot(1);
    srand(atoi(argv[1]));
    conf_tm(rand() % 3);
    sp(40, 40, 0);
    for (;;) {
        int way = rand() % 300 - 150;
        pr(way, rand() % 2 ? way : -way, 0);
        ws(1, 1, 0, rand() % 3 ? 200 : 1);
        gs();
        if (rand() % 8 == 0)
            st();
    }
}
""",
    "tells": """
#include <Nclient.h>
#include "crs.h"
#include <stdio.h>
#include <stdlib.h>
int main(int argc, char **argv)
{
    struct crs_message message;
    int i;
    connect_robot(1);
    srand(atoi(argv[1]));
    for (;;) {
        vm(rand() % 90, rand() % 90, 0);
        if (crs_receive(&message, 100 * (rand() % 20)))
            printf("%d %d %d\\n", message.from, message.sent, message.arrived);
        for (i = rand() % 25; i; i--)
            gs();
        if (rand() % 4 == 0)
            crs_broadcast(7, "here", 4);
    }
}
""",
    "ends": """
#include <Nclient.h>
#include <stdio.h>
int main(int argc, char **argv)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 40; i++) { vm(30, 30, 0); gs(); }
    printf("%ld\\n", State[STATE_CONF_X]);
    return argv[1][3] == '1' ? 1 / (i - 40) : 3;
}
""",
}

BOX = '<box id="box" x="4m" y="2m" length="0.5m" width="0.5m" mass="5kg"/>'
HALL = f'<area length="8m" width="5m"/>{BOX}'
ROBOTS = """<robot id="a" x="1m" y="2m" {0}/><robot id="b" x="3m" y="3.2m" heading="200deg" {0}/>
<robot id="c" x="6.5m" y="2m" heading="180deg" {0}/>"""
WORLDS = {
    "one robot": HALL + '<robot id="a" x="1m" y="2m"/>',
    "three robots": HALL + ROBOTS.format(""),
    "odd timestep": HALL + ROBOTS.format(""),
    "errors": HALL + ROBOTS.format('definition="loud.xml"'),
    "comings and goings": HALL + ROBOTS.format("")
    + '<robot id="d" x="2m" y="1m" join="1.53s" leave="4.1s"/>',
    "sonars fail": HALL + ROBOTS.format("")
    + '<degradation robot="a" device="sonar" element="3" onset="2.2s" duration="1s" noise="0.2m"/>',
    "goals": HALL + ROBOTS.format("") + """
<goal id="near" robots="c"><approach object="box" distance="1.8m"/></goal>
<goal id="ways"><visit><place x="6.1m" y="2.1m" radius="9cm"/><place x="2.5m" y="3m" radius="9cm"/>
</visit></goal>
<goal id="back" after="ways" within="14s"><reach x="2.4m" y="3.2m" radius="9cm" stay="0.3s"/></goal>
<goal id="all" robots="a b"><reach x="2m" y="2.6m" radius="1.3m" stay="0.6s"/></goal>
<goal id="wall" robots="a"><approach object="edge-west" distance="1.2m" stay="1s"/></goal>
<goal id="late" after="near" within="7s"><reach x="7m" y="1m" radius="50cm"/></goal>
<goal id="clean" within="2s"><no-collision/></goal>
<goal id="quiet" robots="c"><no-collision until="back"/></goal>
""",
    "bring": HALL + ROBOTS.format("")
    + '<goal><bring objects="box" x="4m" y="2m" radius="1m" stay="1.5s"/></goal>',
    "places": HALL + """<robot id="a" x="1m" y="2m"/>
<goal><reach x="2m" y="1m" radius="0.5m" stay="0.4s"/></goal>
<goal><bring objects="box" x="1m" y="4m" radius="0.5m" stay="0.4s"/></goal>
""",
    "cover": HALL + ROBOTS.format("") + '<goal><cover share="0.02" cell="10cm"/></goal>',
    "follow": HALL + ROBOTS.format("")
    + '<goal><follow target="b" least="1m" most="2m" share="0.3"/></goal>',
}  # fmt: skip
STEPS = {"waits": 240, "tells": 300}
STATUSES = {
    "goals": ["met", "met", "met", "met", "met", "failed", "met", "met"],
    "bring": ["met"],
    "cover": ["met"],
}
TIMESTEPS = {"odd timestep": "37ms"}


def world_of(name: str, folder: Path) -> WorldModel:
    scout = (Path(files.__file__).parent / "robots" / "scout.xml").read_text()
    loud = scout.replace(' noise="0in"', ' noise="2cm" dropouts="0.03" crosstalk="0.05"')
    (folder / "loud.xml").write_text(loud.replace('"408Wh" power="5W"', '"0.03Wh" power="3W"'))
    timestep = TIMESTEPS.get(name, "50ms")
    file = folder / "world.xml"
    file.write_text(f'<world version="1" timestep="{timestep}">{WORLDS[name]}</world>')
    return load_world(file)


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Executable]:
    """Return a function that builds one of `PROGRAMS`, once for all worlds."""
    folder = tmp_path_factory.mktemp("programs")
    return cache(lambda name: build(folder, PROGRAMS[name], f"{name}.c"))


@pytest.mark.parametrize("world", WORLDS)
def test_states_and_answers_are_the_same_in_every_world(
    world: str, program: Callable[[str], Executable], tmp_path: Path
) -> None:
    model = world_of(world, tmp_path)
    passed = compare(model, [program("anything")] * len(model.robots), 100)
    assert passed > 5 or world in ("comings and goings", "sonars fail", "cover", "follow")


@pytest.mark.parametrize(("world", "calm"), [("goals", 100), ("bring", 200), ("cover", 0)])
def test_goals_are_met_and_fail_in_the_same_timestep(
    world: str, calm: int, program: Callable[[str], Executable], tmp_path: Path
) -> None:
    model = world_of(world, tmp_path)
    passed, result = compare_results(model, [program("drives")] * 3, 300)
    assert passed >= calm
    assert [goal.status for goal in result.goals] == STATUSES[world]


@pytest.mark.parametrize("name", ["reads", "ends", "waits", "tells"])
def test_states_and_answers_are_the_same_for_every_program(
    name: str, program: Callable[[str], Executable], tmp_path: Path
) -> None:
    model = world_of("three robots", tmp_path)
    assert compare(model, [program(name)] * 3, STEPS.get(name, 60)) > 20


def test_answers_that_take_no_time_on_the_link_are_the_same(tmp_path: Path) -> None:
    """They cost their programs the instructions of a system call."""
    source = """
#include <Nclient.h>
#include <unistd.h>
int main(void) { connect_robot(1); sp(40, 30, 0); for (;;) { vm(40, 30, 0); usleep(7001); } }
"""
    world = world_of("three robots", tmp_path).with_ideal_link()
    assert compare(world, [build(tmp_path, source)] * 3, 60) > 20


def test_a_robot_that_runs_into_a_wall_does_the_same(tmp_path: Path) -> None:
    program = build(tmp_path, PROGRAMS["reads"].replace("60, 40", "200, 195"))
    assert compare(world_of("one robot", tmp_path), [program], 250) > 100


def test_most_of_wander_is_calm() -> None:
    program = build_executable([ROOT / "samples" / "scout_c" / "wander.c"], Diagnostics())
    assert compare(load_world(ROOT / "worlds" / "room.xml"), [program], 250) > 200


def test_checked_kernels_do_the_same(
    program: Callable[[str], Executable], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    checked = executable(checked=True)
    monkeypatch.setattr(calm_programs, "executable", lambda **_: checked)
    assert compare(world_of("errors", tmp_path), [program("anything")] * 3, 60) > 0


@pytest.mark.parametrize("world", ["one robot", "places"])
def test_a_change_from_outside_is_noticed(
    world: str, program: Callable[[str], Executable], tmp_path: Path
) -> None:
    hashes = []
    for is_allowed in (True, False):
        session, _ = start(world_of(world, tmp_path), [program("reads")], Observer())
        session.calm.is_allowed = is_allowed
        for name, place in (("a", Pose(2.0, 1.0)), ("a", Pose(6.0, 4.0)), ("box", Pose(1.0, 4.0))):
            for end in (session.timesteps + 20, session.timesteps + 40):
                while session.timesteps < end:
                    session.advance(end - session.timesteps, calmly=True)
                if end % 40:
                    session.environment.teleport(name, place)
        hashes.append((session.state_hash(), session.timesteps, session.result().goals))
    assert hashes[0] == hashes[1]


@pytest.mark.parametrize("name", ["reads", "sleeps"])
def test_a_degradation_by_a_control_that_was_kept_is_noticed(
    name: str, program: Callable[[str], Executable], tmp_path: Path
) -> None:
    hashes = []
    for is_calm in (True, False):
        session, _ = start(world_of("one robot", tmp_path), [program(name)], Observer())
        session.calm.is_allowed = session.environment.skips_quiet_time = is_calm
        control = session.environment.degradations
        for end in (20, 40):
            while session.timesteps < end:
                session.advance(end - session.timesteps, calmly=True)
            control.add(Degradation("a", "sonar", bias=0.3))
        hashes.append(session.state_hash())
    assert hashes[0] == hashes[1]


def test_a_program_that_traps_ends_alone(tmp_path: Path) -> None:
    deep = """
#include <Nclient.h>
int main(int argc, char **argv)
{
    connect_robot(1);
    for (int i = 0; ; i++) { get_sn(); if (i == 20 && argv[1][3] == '1') *(int *)-9 = 1; }
}
"""
    file = tmp_path / "wild.c"
    file.write_text(deep)
    program = build_executable([file], Diagnostics(), checked=False)
    assert compare(world_of("three robots", tmp_path), [program] * 3, 40) > 5


def test_an_observer_is_told_of_the_calm_timesteps_before_the_last_one(tmp_path: Path) -> None:
    source = """
#include <Nclient.h>
#include <unistd.h>
int main(void) { connect_robot(1); vm(60, 60, 0); sleep(1); gs(); st(); sleep(2); return 0; }
"""
    observer = CalmObserver()
    session, _ = start(world_of("one robot", tmp_path), [build(tmp_path, source)], observer)
    while session.advance(1000, calmly=True):
        pass
    last = frame_of(session)
    assert any((frame == last).all() for frame in observer.frames.values())
    assert not session.calm.passages


def test_the_kernels_records_are_those_of_programs() -> None:
    assert RECORD.itemsize == RECORD_SIZE * 8
