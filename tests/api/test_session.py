"""A session from Python: the same run as on the command line, read and changed in SI units."""

from __future__ import annotations

import dataclasses
import json
import math
import re
from pathlib import Path

import numpy as np
import pytest
from lxml import etree

import crs_cc
from crs_cc.cli.main import main

WORLD = """<world version="1" seed="4" duration="3s"><area length="6m" width="5m"/>
  <robot x="1m" y="1m"/><robot x="4m" y="1m" heading="180deg"/>
  <box id="crate" x="2m" y="4m" length="40cm" width="40cm" mass="5kg" heat="10"/>
  <wall id="screen" x1="5m" y1="3m" x2="5m" y2="4m"/></world>"""
AHEAD = """#include "Nclient.h"
#include <stdio.h>
int main(void) { connect_robot(1); vm(100, 100, 0); printf("off\\n"); return 3; }
"""


@pytest.fixture
def session() -> crs_cc.Session:
    return crs_cc.Session(WORLD, AHEAD)


def test_the_run_is_that_of_the_command_line(capfd: pytest.CaptureFixture[str]) -> None:
    program, place = "samples/scout_c/mixed.c", "worlds/mixed.xml"
    options = ["--setup", "noisy", "--seed", "5", "--max-time", "4", "--json", "-q"]
    assert main(["run", program, place, *options]) == 0
    told = json.loads(capfd.readouterr().out)
    world = crs_cc.load_world(place, setup="noisy")
    session = crs_cc.Session(world, program, seed=5, duration_s=4.0)
    session.on("collision", lambda event: None)
    while session.step():
        assert session.robots["nomad"].sonar.shape == (16,)
        assert session.poses.shape == (5, 3)
    assert session.result().state_hash == told["state_hash"]
    other = crs_cc.Session(world, program, seed=6)
    assert other.run(until_s=4.0).state_hash != told["state_hash"]


def test_duration_and_seed_default_to_those_of_the_world() -> None:
    for given, expected in ((None, (3.0, 4)), (1.0, (1.0, 9))):
        session = crs_cc.Session(WORLD, AHEAD, duration_s=given, seed=None if given is None else 9)
        assert (session.duration_s, session.seed) == expected


def test_poses_of_movable_objects_are_those_of_now(session: crs_cc.Session) -> None:
    session.step()
    assert session.object_poses.tolist() == [[2.0, 4.0, 0.0]]
    session.move("crate", 3.0, 4.0, heading_rad=0.5)
    session.step()
    assert session.object_poses.tolist() == [[3.0, 4.0, 0.5]]


def test_a_run_ends_when_all_programs_have_ended(session: crs_cc.Session) -> None:
    result = session.run()
    assert [robot.exit_status for robot in result.robots] == [3, 3]
    assert session.is_over
    assert session.robots["robot1"].stdout == "off\n"


def test_arrays_over_all_robots_are_views_of_now() -> None:
    session = crs_cc.Session(WORLD, {"robot0": None, "robot1": AHEAD})
    session.robots["robot0"].drive(0.2, 0.2)
    assert not any(each.flags.writeable for each in (session.positions_m, session.headings_rad))
    before = session.poses
    session.step(20)
    robot = session.robots["robot0"]
    assert before[0].tolist() == [1.0, 1.0, 0.0]
    assert session.poses[0].tolist() == robot.pose.tolist()
    assert robot.pose[0] - before[0, 0] == pytest.approx(robot.odometry[0], abs=1e-4)
    assert robot.axis_speeds.tolist() == pytest.approx([0.2, 0.2])
    assert robot.axis_names == ("right", "left")


def test_readings_that_are_kept_stay_as_they_were() -> None:
    session = crs_cc.Session(WORLD)
    robot = session.robots["robot0"]
    robot.drive(0.3, 0.3)
    kept = []
    for _ in range(40):
        session.step()
        kept.append((robot.sonar, robot.measure("sonar"), robot.position_m, robot.axis_speeds))
    for arrays in zip(*kept, strict=True):
        assert len({array.tobytes() for array in arrays}) > 5


def test_readings_are_in_metres_and_nothing_is_measured_for_them(session: crs_cc.Session) -> None:
    before = session.state_hash()
    robot = session.robots["robot1"]
    assert robot.sensors == ("bumper", "heat", "sonar")
    assert robot.sonar[0] == pytest.approx(3.0 - 2 * robot.model.radius_m, abs=0.03)
    assert robot.bumper.shape == (24,)
    assert np.isnan(robot.heat).all()
    assert session.state_hash() == before
    assert robot.measure("heat").tolist() == [0.0]
    assert "sonar" in dir(robot)
    with pytest.raises(AttributeError, match="unknown sensor 'lidar'"):
        robot.lidar  # noqa: B018
    with pytest.raises(ValueError, match="unknown sensor 'lidar'"):
        robot.measure("lidar")


def test_an_error_inside_of_a_property_is_not_taken_for_an_unknown_sensor(
    session: crs_cc.Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(type(session.inner.environment), "charges")
    with pytest.raises(AttributeError, match="charges"):
        session.robots["robot0"].charge  # noqa: B018


def test_events_call_functions_which_may_change_the_world(session: crs_cc.Session) -> None:
    seen: list[crs_cc.WorldEvent] = []
    session.on("collision", seen.append)
    session.on("exit", seen.append)
    session.on("collision", lambda event: session.move("crate", 5.0, 0.6))
    session.move("crate", 1.6, 1.0)
    session.run()
    assert [event.kind for event in seen] == ["exit", "exit"]  # the programs end at once
    session = crs_cc.Session(WORLD, {"robot0": None, "robot1": None})
    session.on("bumper", seen.append)
    session.on("collision", lambda event: session.remove("crate"))
    session.move("crate", 1.6, 1.0)
    session.robots["robot0"].drive(0.3, 0.3)
    session.run()
    assert {event.kind for event in seen[2:]} == {"bumper-pressed", "bumper-released"}
    assert seen[0].text == "robot0 exited with status 3"
    with pytest.raises(ValueError, match="unknown event kind 'crash'"):
        session.on("crash", print)


def test_a_world_is_changed_while_it_runs() -> None:
    session = crs_cc.Session(WORLD, {"robot0": None, "robot1": None})
    session.step()
    session.move("robot1", 4.0, 2.0, math.pi / 2)
    session.set_heat("crate", 30.0)
    name = session.degrade("robot0", "drive", "left", dead=True)
    session.degrade("robot0", "sonar", 3, bias=0.5)
    assert [each.element for each in session.degradations.all()] == [1, 3]
    session.robots["robot0"].drive(0.2, 0.2)
    session.step(10)
    assert session.robots["robot0"].heading_rad > 0.1  # the left wheel is dead
    assert session.robots["robot1"].pose.tolist() == pytest.approx([4.0, 2.0, math.pi / 2])
    session.heal(name)
    session.heal("robot0")
    assert session.degradations.all() == ()
    scout = session.robots["robot0"].model
    number = session.add(crs_cc.Robot("third", scout, crs_cc.Pose(3.0, 3.0)), AHEAD)
    session.step(5)
    session.remove("third")
    assert session.result().robots[number].exit_status == 3
    assert not session.robots["third"].is_present
    session.set_charge("robot1", 0.5)
    assert session.robots["robot1"].charge == pytest.approx(0.5)
    assert session.edit("turn robot1 to 90") == "robot1 now has heading 90.0 deg"


def test_messages_are_sent_as_programs_send_them() -> None:
    listens = """#include <crs.h>
    #include <stdio.h>
    int main(void) { struct crs_message m; while (crs_receive(&m, CRS_FOREVER))
      printf("%d %d %.*s\\n", m.from, m.type, m.size, m.data); }"""
    session = crs_cc.Session(WORLD, {"robot0": None, "robot1": listens})
    session.message("robot0", "hello", "robot1", kind=7)
    session.step(2)
    session.message("robot0", b"all")
    session.communication.shut(channel="radio")
    session.step(2)
    assert session.robots["robot1"].stdout == "0 7 hello\n"
    session.communication.open(channel="radio")
    session.message("robot0", "again")
    session.step(4)
    assert session.robots["robot1"].stdout.splitlines()[-1] == "0 0 again"


def test_python_receives_the_messages_to_a_robot_that_it_steers() -> None:
    tells = """#include <crs.h>
    int main(void) { crs_send(0, 7, "hello", 5); crs_broadcast(8, "all", 3); return 0; }"""
    session = crs_cc.Session(WORLD, {"robot0": None, "robot1": tells})
    robot = session.robots["robot0"]
    assert robot.receive() is None
    session.step(4)
    first, second = robot.receive(), robot.receive()
    assert first is not None
    assert second is not None
    assert (first.sender, first.content, first.kind, first.channel) == (
        "robot1",
        b"hello",
        7,
        "radio",
    )
    assert 0.0 <= first.sent_s <= first.arrived_s <= session.time_s
    assert second.content == b"all"
    assert robot.receive() is None
    with pytest.raises(ValueError, match="robot1 runs a program, which receives"):
        session.robots["robot1"].receive()


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (lambda run: run.move("robot9", 1.0, 1.0), "unknown robot or movable object 'robot9'"),
        (lambda run: run.move("screen", 1.0, 1.0), "unknown robot or movable object 'screen'"),
        (lambda run: run.move("robot0", 4.0, 1.0), "it would overlap 'robot1'"),
        (lambda run: run.move("robot0", math.nan, 1.0), "a coordinate must be finite, not nan"),
        (lambda run: run.remove("robot9"), "robot9"),
        (lambda run: run.edit("move robot0 1 1"), "expected: move NAME to X Y"),
        (lambda run: run.degrade("robot9", "sonar", dead=True), "unknown robot 'robot9'"),
        (lambda run: run.degrade("robot0", "radar", dead=True), "unknown device 'radar'"),
        (lambda run: run.degrade("robot0", "sonar", "x", dead=True), "unknown element 'x'"),
        (lambda run: run.degrade("robot0", "sonar", size=1), "unknown fault 'size'"),
        (lambda run: run.heal("robot0"), "no degradation of robot0"),
        (lambda run: run.set_heat("stove", 1.0), "unknown object 'stove'"),
        (lambda run: run.set_heat("crate", -1.0), "invalid heat -1.0 (expected 0 or more)"),
        (lambda run: run.set_charge("robot0", 2.0), "invalid state of charge 2.0"),
        (lambda run: run.message("robot0", "x" * 249), "249 bytes (maximum: 248)"),
        (lambda run: run.message("robot0", "x", "robot0"), "cannot send a message to itself"),
        (lambda run: run.message("robot0", "x", channel="tv"), "unknown channel 'tv'"),
        (lambda run: run.message("robot0", "x", kind=2**40), "invalid type of a message"),
        (lambda run: run.robots["robot0"].drive(1.0), "expected 2 finite numbers"),
        (lambda run: run.robots["robot0"].drive(1.0, 1.0), "robot0 runs a program"),
        (lambda run: run.step(-1), "timesteps must be 0 or more, not -1"),
        (lambda run: run.run(until_s=math.nan), "until_s must be a number, not nan"),
        (lambda run: run.restore(crs_cc.Session().snapshot()), "of a session with another world"),
        (lambda run: run.restore(5), "restore takes a Snapshot, not int"),
    ],
)
def test_an_invalid_change_is_one_error_without_effect(
    session: crs_cc.Session, change: object, expected: str
) -> None:
    before = session.state_hash()
    with pytest.raises((TypeError, ValueError), match=re.escape(expected)):
        change(session)
    assert session.state_hash() == before


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ((WORLD, [AHEAD]), "1 programs for 2 robots (expected one each)"),
        ((WORLD, {"robot2": AHEAD}), "unknown robot 'robot2' (known: robot0, robot1)"),
        (("no/such.xml", AHEAD), "no/such.xml: error: cannot be read: No such file"),
        ((WORLD, "no/such.c"), "no/such.c: error: no such file"),
        (
            (WORLD, "int main(void) { return x; }"),
            "program.c:1:25: error: use of undeclared identifier 'x'",
        ),
        (("<world/>", AHEAD), "world:1: error: missing attribute 'version'"),
        ((5, AHEAD), "a world must be a path, XML text or a WorldModel, not int"),
        ((WORLD, 5), "programs must be a program, a list or a dictionary, not int"),
        ((WORLD, [["a.c", "b.c"], AHEAD]), "robot0: a program of several files is what compile_c"),
        ((WORLD, [5, AHEAD]), "a program must be a path or C source text, not int"),
    ],
)
def test_wrong_input_of_a_session_is_one_clear_error(
    arguments: tuple[object, ...], expected: str
) -> None:
    with pytest.raises((TypeError, ValueError, crs_cc.CrsError), match=re.escape(expected)):
        crs_cc.Session(*arguments)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ({"arguments": "fast"}, "arguments must be a list, such as arguments=['fast']"),
        ({"client": "nclint"}, "unknown client 'nclint' (known: nclient, ndirect)"),
        ({"stdin": 1}, "stdin must be bytes or text, not int"),
        ({"files": {"map.txt": None}}, "map.txt must be bytes or text, not NoneType"),
    ],
)
def test_wrong_options_of_a_session_are_one_clear_error(
    options: dict[str, object], expected: str
) -> None:
    with pytest.raises((TypeError, ValueError), match=re.escape(expected)):
        crs_cc.Session(WORLD, AHEAD, **options)


def test_text_is_standard_input_and_the_contents_of_files() -> None:
    """Text was accepted, and failed when the program read it."""
    copies = """#include <stdio.h>
    int main(void) { int c; FILE *f = fopen("in", "r"); while ((c = getchar()) != EOF) putchar(c);
    while ((c = fgetc(f)) != EOF) putchar(c); return 0; }"""
    session = crs_cc.Session(None, copies, stdin="a\n", files={"in": "b"}, duration_s=math.inf)
    assert session.duration_s is None
    session.run()
    assert session.robots["robot0"].stdout == "a\nb"


def test_numbers_as_text_are_refused_by_name(session: crs_cc.Session) -> None:
    with pytest.raises(TypeError, match="a coordinate must be a number, not '1'"):
        session.move("robot0", "1", 2.0)
    with pytest.raises(TypeError, match="heat must be a number, not '1'"):
        session.set_heat("crate", "1")
    with pytest.raises(TypeError, match="share must be a number, not '1'"):
        session.set_charge("robot0", "1")


def test_part_of_a_timestep_is_refused(session: crs_cc.Session) -> None:
    for timesteps in (1.5, math.nan, "3"):
        with pytest.raises(TypeError, match="timesteps must be an integer, not "):
            session.step(timesteps)
    assert session.timesteps == 0


SCOUT = crs_cc.load_robot("scout")
ROOM = crs_cc.load_world(WORLD)


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"timestep_s": -0.05}, "world, timestep: '-0.05s' must be greater than 0"),
        ({"robots": ()}, "no robot in the world"),
        ({"robots": (crs_cc.Robot("x", SCOUT, crs_cc.Pose(math.nan, 1.0)),)}, "'nanm' is not a"),
        ({"robots": (crs_cc.Robot("x", SCOUT, crs_cc.Pose(9.0, 1.0)),)}, "not completely inside"),
        ({"robots": ROOM.robots[:1] * 2}, "duplicate id 'robot0'"),
        ({"robots": (crs_cc.Robot("x", "scout", crs_cc.Pose(1.0, 1.0)),)}, "as of load_robot"),
        ({"boxes": (crs_cc.Box("b", (1.0, 1.0), 0.1, 0.1),)}, "a value has the wrong type"),
        ({"boxes": (crs_cc.Box("b", crs_cc.Pose(3.0, 2.0), -1.0, 0.1),)}, "must be greater than 0"),
        ({"goals": (crs_cc.Goal("g", crs_cc.Cool(())),)}, "goal 'g' would be read with other"),
        ({"goals": (crs_cc.Goal("g", crs_cc.Cover(1.0, 1.0), points=1 / 3),)}, "points=0.333333"),
        ({"area": crs_cc.Area(-1.0, 0.0, 9.0, 9.0)}, "the area must begin at 0, 0, or be centred"),
    ],
)
def test_a_world_made_in_python_is_checked_as_its_file_would_be(
    changes: dict[str, object], expected: str
) -> None:
    for use in (crs_cc.Session, crs_cc.Env, crs_cc.world_xml):
        with pytest.raises((TypeError, ValueError, crs_cc.WorldError), match=re.escape(expected)):
            use(dataclasses.replace(ROOM, **changes))


def test_snapshots_go_back(session: crs_cc.Session) -> None:
    session.step(5)
    snapshot, there = session.snapshot(), session.state_hash()
    session.step(5)
    session.restore(snapshot)
    assert session.state_hash() == there
    same = crs_cc.Session(WORLD, AHEAD)
    same.restore(snapshot)
    assert same.state_hash() == there
    with pytest.raises(ValueError, match="another seed"):
        crs_cc.Session(WORLD, AHEAD, seed=5).restore(snapshot)
    with pytest.raises(ValueError, match="other programs"):
        crs_cc.Session(WORLD, AHEAD.replace("3", "4")).restore(snapshot)


def test_events_and_the_picture_go_back_with_the_session() -> None:
    """The picture kept the undone future, an end was not told again, and robots added since failed.

    A robot that was added after the snapshot made the next timestep a ValueError of numpy.
    """
    ends = "#include <unistd.h>\nint main(void) { usleep(400000); return 0; }"
    session = crs_cc.Session(WORLD, {"robot0": None, "robot1": ends})
    told: list[float] = []
    session.on("exit", lambda event: told.append(event.time_s))
    session.robots["robot0"].drive(0.3, 0.3)
    session.step(4)
    snapshot, before = session.snapshot(), session.svg()
    session.add(crs_cc.Robot("third", SCOUT, crs_cc.Pose(1.0, 3.0)))
    session.step(20)
    session.restore(snapshot)
    assert session.svg() == before
    session.step(20)
    assert len(told) == 2
    assert told[0] == told[1]


def test_notebooks_show_a_small_picture(session: crs_cc.Session) -> None:
    session.run()
    html = session._repr_html_()
    etree.fromstring(html)
    assert len(html) < 12_000
    assert 'width="' not in html.partition(">")[0]
    assert repr(session) == "<Session of world: 2 robots, 0.05 s>"
    assert repr(session.robots) == "<robots robot0, robot1>"
    assert repr(session.robots["robot0"]).startswith("<robot robot0 at 1.")
    with pytest.raises(KeyError, match="unknown robot 'robot7'"):
        session.robots["robot7"]


def test_source_text_is_compiled_once_and_named_in_errors() -> None:
    failed = crs_cc.Session(None, "int main(void)\n{ return *(int *)0; }").run().robots[0].error
    assert failed is not None
    assert str(failed.location).startswith("program.c:2")
    first, second = crs_cc.compile_c(AHEAD), crs_cc.compile_c(AHEAD)
    assert first.machine_code == second.machine_code
    assert (first.name, first.command) == ("program.c", "program")
    assert repr(first) == "Executable(name='program.c', command='program')"  # no machine code
    with pytest.raises(ValueError, match="source text must be the only argument"):
        crs_cc.compile_c(AHEAD, "other.c")
    with pytest.raises(crs_cc.CompileError, match=r"^program\.c:2:2: error: "):
        crs_cc.compile_c("int main(void) {\n}}\n")


def test_folders_and_the_root_are_paths_as_text(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The form that the error message recommends was an AttributeError."""
    monkeypatch.chdir(tmp_path)
    Path("include").mkdir()
    Path("include/seven.h").write_text("#define SEVEN 7\n")
    text = '#include "seven.h"\nint main(void) { return SEVEN; }'
    program = crs_cc.compile_c(text, include_paths=["include"], root=str(tmp_path))
    assert crs_cc.Session(None, program).run().robots[0].exit_status == 7
    with pytest.raises(TypeError, match=re.escape("such as include_paths=['include']")):
        crs_cc.compile_c(text, include_paths="include")
    with pytest.raises(TypeError, match="unknown option 'diagnostics'"):
        crs_cc.compile_c(text, diagnostics=[])


def test_the_program_of_a_world_is_a_file_even_if_its_path_looks_like_source_text(
    tmp_path: Path,
) -> None:
    folder = tmp_path / "course;{1}"
    folder.mkdir()
    (folder / "five.c").write_text("int main(void) { return 5; }")
    world = WORLD.replace('<robot x="1m"', '<robot program="five.c" x="1m"')
    (folder / "room.xml").write_text(world)
    session = crs_cc.Session(folder / "room.xml")
    added = crs_cc.Robot("third", SCOUT, crs_cc.Pose(1.0, 3.0), program=str(folder / "five.c"))
    session.add(added)
    session.step()
    assert [session.robots[name].result.exit_status for name in ("robot0", "third")] == [5, 5]
