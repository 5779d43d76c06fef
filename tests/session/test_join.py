"""Robots that join and leave while a session runs.

In the yard `home` stands in the west and drives about there; `gate`, in the east, is where others
come in.

    +-------------------------------------+
    |                                     |
    |  home >                       < gate|
    |                                     |
    +-------------------------------------+
"""

from __future__ import annotations

import pickle
from dataclasses import replace
from pathlib import Path

import pytest

from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.run_edits import edit_run
from crs_cc.runtime.executable import Executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import load_robot, parse_world
from crs_cc.sim.model.world import Pose, Robot
from tests.session.programs import LOOP, ROAM, build

GATE = 'id="guest" x="19m" y="2m" heading="180deg"'


def yard(guest: str = "", robots: str = ""):
    """Return the yard, with a guest if it has attributes."""
    text = f"""<world version="1"><area length="20m" width="4m"/>
    <robot id="home" x="1m" y="2m"/>{robots}
    {f"<robot {GATE} {guest}/>" if guest else ""}</world>"""
    return parse_world(text.encode(), "yard")


GUEST = yard('join="0s"').robots[1]


@pytest.fixture(scope="module")
def roam(tmp_path_factory: pytest.TempPathFactory) -> Executable:
    return build(tmp_path_factory.mktemp("roam"), ROAM)


def begun(world, roam: Executable, seed: int = 3) -> Session:
    return Session(world, [roam] * len(world.robots), seed)


def run_to(session: Session, time_s: float) -> Session:
    while session.time_s < time_s - 1e-9:
        session.step()
    return session


def test_an_admitted_robot_equals_one_that_joins_at_that_time(roam: Executable):
    at_its_time = run_to(begun(yard('join="1s"'), roam), 3.0)
    session = run_to(begun(yard('join="100s"'), roam), 1.0)
    before = session.snapshot()
    assert edit_run(session, "join guest") == "guest joins"
    assert run_to(session, 3.0).state_hash() == at_its_time.state_hash()
    session.restore(before)
    assert run_to(session, 3.0).result().robots[1].outcome == "absent"


def test_a_robot_that_is_delayed_is_one_that_joins_later(roam: Executable):
    at_its_time = run_to(begun(yard('join="1s"'), roam), 1.0)
    session = begun(yard('join="0s"'), roam)
    assert edit_run(session, "delay guest") == "not in the world until 'join': guest"
    assert session.result().robots[1].outcome == "absent"
    run_to(session, 1.0)
    edit_run(session, "join guest")
    assert session.state_hash() == at_its_time.state_hash()
    assert run_to(session, 3.0).state_hash() == run_to(at_its_time, 3.0).state_hash()
    with pytest.raises(DebugError, match="only at the start of a run"):
        edit_run(session, "delay home")


def test_an_admitted_robot_waits_while_its_start_is_occupied(roam: Executable):
    other = '<robot id="other" x="19m" y="2m" leave="1s"/>'
    session = begun(yard('join="100s"', other), roam)
    assert edit_run(session, "join guest") == "guest joins; not before there is room: guest"
    assert run_to(session, 0.95).result().robots[2].joined_s is None
    assert run_to(session, 2.0).result().robots[2].joined_s == 1.0


def test_present_and_departed_robots_are_not_admitted(roam: Executable):
    session = begun(yard('join="0s"'), roam)
    with pytest.raises(ValueError, match="'guest' has already joined"):
        session.state.admit_robots([1])
    session.remove_robot("guest")
    with pytest.raises(ValueError, match="'guest' has already left"):
        session.state.admit_robots([1])
    with pytest.raises(ValueError, match="no robot number 7"):
        session.state.admit_robots([7])


def test_a_robot_joins_at_its_time(roam: Executable):
    session = run_to(begun(yard('join="1s"'), roam), 0.95)
    assert session.result().robots[1].outcome == "absent"
    assert session.result().robots[1].joined_s is None
    run_to(session, 3.0)
    guest = session.result().robots[1]
    assert (guest.outcome, guest.joined_s, guest.left_s) == ("running", 1.0, None)
    assert guest.distance_m > 0.2
    assert 0 < session.state.fuel[1] < session.state.fuel[0]


def test_join_times_are_rounded_up_to_a_timestep(roam: Executable):
    session = run_to(begun(yard('join="0.51s" leave="0.98s"'), roam), 2.0)
    guest = session.result().robots[1]
    assert guest.joined_s == pytest.approx(0.55)
    assert guest.left_s == pytest.approx(1.0)


def test_a_robot_leaves_and_keeps_its_result(roam: Executable):
    session = run_to(begun(yard('leave="2s"'), roam), 2.0)
    left = session.result().robots[1]
    assert (left.outcome, left.joined_s, left.left_s) == ("left", 0.0, 2.0)
    assert left.exit_status is None
    assert left.time_s == 2.0
    run_to(session, 4.0)
    assert session.result().robots[1] == left
    assert session.state.running == 1


@pytest.mark.parametrize("join_s", [0.0, 0.05, 1.0, 2.35])
def test_joining_by_world_file_and_by_call_is_equivalent(roam: Executable, join_s: float):
    by_file = begun(yard(f'join="{join_s}s" leave="3s"'), roam)
    by_call = run_to(begun(yard(), roam), join_s)
    assert by_call.add_robot(GUEST, roam) == 1
    run_to(by_file, join_s)
    for session in (by_file, by_call):
        run_to(session, 3.0)
    by_call.remove_robot("guest")
    assert by_file.state_hash() == by_call.state_hash()
    for session in (by_file, by_call):
        run_to(session, 3.5)
    assert by_file.result().robots == by_call.result().robots
    assert by_file.state_hash() == by_call.state_hash()


def test_noise_depends_on_the_robots_number(roam: Executable):
    text = """<world version="1"><area length="20m" width="4m"/>
    <robot id="home" x="1m" y="2m" setup="noisy"/></world>"""
    alone = parse_world(text.encode(), "yard", setup="noisy")
    both = replace(alone, robots=(*alone.robots, replace(GUEST, model=alone.robots[0].model)))
    by_file = run_to(begun(replace(both), roam), 1.5)
    by_call = begun(alone, roam)
    by_call.add_robot(both.robots[1], roam)
    assert by_file.state_hash() == run_to(by_call, 1.5).state_hash()


def test_a_robot_joining_far_away_does_not_affect_the_others(roam: Executable):
    alone, visited = begun(yard(), roam), begun(yard('join="1s" leave="2s"'), roam)
    results = [run_to(session, 4.0).result().robots[0] for session in (alone, visited)]
    assert results[0] == results[1]


def test_an_absent_robot_does_not_take_part(roam: Executable):
    """Home drives east through the place where another one joins later, and back, unhindered."""
    straight = """#include "Nclient.h"
    int main(void) { connect_robot(1); vm(200, 200, 0); ws(1, 1, 0, 9); return 0; }
    """
    crossing = parse_world(
        b"""<world version="1"><area length="20m" width="4m"/>
        <robot id="home" x="1m" y="2m"/><robot id="late" x="2m" y="2m" join="60s"/></world>""",
        "yard",
    )
    path = Path(roam.name)
    program = build(path.parent, straight, "straight.c")
    there = run_to(begun(crossing, program), 7.0).result().robots[0]
    alone = run_to(begun(yard(), program), 7.0).result().robots[0]
    assert there == alone
    assert there.collisions == 0


def test_a_robot_waits_until_its_place_is_free(roam: Executable):
    """The sitter is at the gate until it leaves; the guest, due before, joins then."""
    world = yard('join="0.5s"', '<robot id="sitter" x="18.8m" y="2m" leave="1.5s"/>')
    idle = build(Path(roam.name).parent, LOOP, "idle.c")
    session = run_to(Session(world, [roam, idle, roam]), 2.0)
    sitter, guest = session.result().robots[1:]
    assert sitter.left_s == guest.joined_s == 1.5


def test_a_robot_blocked_until_its_leave_time_never_joins(roam: Executable):
    world = yard('join="0.5s" leave="1s"', '<robot id="sitter" x="18.8m" y="2m"/>')
    idle = build(Path(roam.name).parent, LOOP, "idle.c")
    guest = run_to(Session(world, [roam, idle, roam]), 2.0).result().robots[2]
    assert (guest.outcome, guest.joined_s, guest.left_s) == ("absent", None, 1.0)


def test_a_run_continues_until_all_robots_have_joined(roam: Executable):
    """The run ends when no program runs and the last robot's place stays occupied."""
    quiet = build(Path(roam.name).parent, "int main(void) { return 0; }\n", "quiet.c")
    session = Session(yard('join="1s"'), [quiet, quiet])
    steps = 1
    while session.step():
        steps += 1
    assert steps == 21
    assert session.result().robots[1].outcome == "exited"
    blocked = Session(
        yard('join="1s"', '<robot id="sitter" x="18.8m" y="2m"/>'), [quiet, quiet, quiet]
    )
    while blocked.step():
        assert blocked.time_s < 2.0
    assert blocked.result().robots[2].outcome == "absent"


def test_joins_and_leaves_are_events(roam: Executable):
    heard = []

    class Ear:
        def step(self, step) -> None:
            heard.extend(step.events)

    session = Session(yard('join="0.5s" leave="1s"'), [roam, roam], trace=Ear())
    run_to(session, 1.0)
    session.remove_robot(0)
    assert not session.step()
    said = [(event.time_s, event.kind, event.text, event.robot) for event in heard]
    assert said == [
        (0.5, "join", "joined", 1),
        (1.0, "leave", "left", 1),
        (1.0, "leave", "left", 0),
    ]


def test_snapshots_work_across_joins_and_leaves(roam: Executable):
    """Back before the guest, forward again, and into a session that never knew of it."""
    session = run_to(begun(yard(), roam), 0.5)
    before = session.snapshot()
    session.add_robot(GUEST, roam, ["guest", "now"])
    hashes = {}
    snapshots = {}
    for time_s in (0.5, 1.0, 1.5):
        run_to(session, time_s)
        if time_s == 1.5:
            session.remove_robot("guest")
        snapshots[time_s], hashes[time_s] = session.snapshot(), session.state_hash()
    end = run_to(session, 2.0).state_hash()
    session.restore(before)
    assert len(session.result().robots) == 1
    assert session.add_robot(GUEST, roam, ["guest", "now"]) == 1
    assert session.state_hash() == hashes[0.5]
    for other in (session, begun(yard(), roam)):
        for time_s in (1.0, 1.5, 0.5):
            other.restore(pickle.loads(pickle.dumps(snapshots[time_s])))
            assert other.state_hash() == hashes[time_s]
        run_to(other, 1.5).remove_robot("guest")
        assert run_to(other, 2.0).state_hash() == end


def test_many_robots_join_and_leave(roam: Executable):
    """A queue at the gate: each comes in where the one before has left."""
    session = begun(yard(), roam)
    for number in range(12):
        session.add_robot(replace(GUEST, id=f"guest{number}"), roam)
        run_to(session, session.time_s + 0.1)
        session.remove_robot(f"guest{number}")
    outcomes = [robot.outcome for robot in session.result().robots]
    assert outcomes == ["running"] + ["left"] * 12
    assert [robot.joined_s for robot in session.result().robots[1:4]] == pytest.approx(
        [0.0, 0.1, 0.2]
    )


def test_a_robot_of_another_model_joins(roam: Executable, tmp_path: Path):
    nomad = load_robot(Path(__file__).parents[2] / "crs_cc/sim/files/robots/nomad200.xml")
    session = run_to(begun(yard(), roam), 0.5)
    session.add_robot(replace(GUEST, model=nomad), roam)
    session.add_robot(replace(GUEST, id="third", start=Pose(17.0, 1.0)), roam)
    middle = session.snapshot()
    end = run_to(session, 2.0).state_hash()
    session.restore(middle)
    assert run_to(session, 2.0).state_hash() == end


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"id": "home"}, "its id is in use"),
        ({"id": "edge-east"}, "the prefix edge- is reserved"),
        ({"id": "obstacle-1"}, "the prefix obstacle- is reserved"),
        ({"id": ""}, "letters, digits"),
        ({"id": "a b"}, "letters, digits"),
        ({"start": Pose(1.2, 2.0)}, "it would overlap 'home'"),
        ({"start": Pose(0.1, 2.0)}, "it would overlap the edge of the world"),
        ({"start": Pose(99.0, 2.0)}, "it would overlap the edge of the world"),
        ({"start": Pose(float("nan"), 2.0)}, "not finite"),
        ({"start": Pose(9.0, 2.0, float("inf"))}, "not finite"),
        ({"start": Pose(9.0, 2.0, 1e300)}, "too large"),
        ({"heat": float("nan")}, "its heat must be"),
        ({"heat": float("inf")}, "its heat must be"),
        ({"heat": -1.0}, "its heat must be"),
        ({"spread_m": float("nan")}, "its heat must be"),
        ({"spread_m": 0.0}, "its heat must be"),
        ({"join_s": float("nan")}, "not finite"),
        ({"join_s": float("inf")}, "not finite"),
        ({"leave_s": 1.0}, "it leaves before it joins"),
        ({"leave_s": float("nan")}, "it leaves before it joins"),
        ({"join_s": 5.0, "leave_s": 4.0}, "it leaves before it joins"),
    ],
)
def test_a_robot_in_an_invalid_place_is_rejected(roam: Executable, changes, reason: str):
    session = run_to(begun(yard(), roam), 1.0)
    before = session.state_hash()
    with pytest.raises(ValueError, match=reason):
        session.add_robot(replace(GUEST, **changes), roam)
    assert session.state_hash() == before
    assert len(session.result().robots) == 1


def test_only_a_present_robot_can_leave(roam: Executable):
    session = begun(yard('join="5s"'), roam)
    for robot in ("nobody", 2, -1):
        with pytest.raises(ValueError, match=r"unknown robot|no robot number"):
            session.remove_robot(robot)
    session.remove_robot("guest")
    with pytest.raises(ValueError, match="has already left"):
        session.remove_robot(1)
    run_to(session, 6.0)
    assert session.result().robots[1].outcome == "absent"


def test_an_added_robot_can_wait_for_its_time(roam: Executable):
    session = run_to(begun(yard(), roam), 0.5)
    robot: Robot = replace(GUEST, join_s=1.0, leave_s=1.5)
    assert session.add_robot(robot, roam) == 1
    assert session.result().robots[1].outcome == "absent"
    run_to(session, 2.0)
    guest = session.result().robots[1]
    assert (guest.joined_s, guest.left_s) == (1.0, 1.5)


def test_a_waiting_robot_that_leaves_is_not_answered(roam: Executable):
    """The guest waits in `ws` when it leaves."""
    source = """#include "Nclient.h"
    int main(void) { connect_robot(1); pr(99, 99, 0); ws(1, 1, 0, 20); return 3; }
    """
    waits = build(Path(roam.name).parent, source, "waits.c")
    session = Session(yard('leave="0.5s"'), [roam, waits])
    run_to(session, 0.5)
    left = session.result().robots[1]
    assert (left.outcome, left.exit_status, left.time_s) == ("left", None, 0.5)
    run_to(session, 3.0)
    assert session.result().robots[1] == left


def test_a_program_that_ends_before_its_robot_leaves_has_exited(roam: Executable):
    quiet = build(Path(roam.name).parent, "int main(void) { return 4; }\n", "quiet.c")
    guest = run_to(Session(yard('leave="0.5s"'), [roam, quiet]), 1.0).result().robots[1]
    assert (guest.outcome, guest.exit_status, guest.left_s) == ("exited", 4, 0.5)
