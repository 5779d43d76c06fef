"""A session is a function of programs, world and seed, and isolates failures of robots."""

from __future__ import annotations

import gc
import pickle
import subprocess
import weakref
from dataclasses import replace
from pathlib import Path

import pytest

from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import empty_world
from tests.commands import python
from tests.session.programs import HALL, LOOP, ROAM, build, run

STEPS = 60

AGAIN = """
import sys
import weakref
from dataclasses import replace
from pathlib import Path
from tests.session.programs import HALL, ROAM, build, run
folder = Path(sys.argv[1])
roam = build(folder, ROAM)
print(run(HALL, [roam, roam], 60, seed=5).session.state_hash())
"""


def test_the_same_run_has_the_same_hash_in_another_process(tmp_path: Path) -> None:
    roam = build(tmp_path, ROAM)
    here = run(HALL, [roam, roam], STEPS, seed=5).session.state_hash()
    found = subprocess.run(
        python("-c", AGAIN, tmp_path),
        capture_output=True,
        check=True,
        cwd=Path(__file__).parents[2],
    )
    assert found.stdout.decode().strip() == here


def test_the_state_hash_changes_with_each_step(tmp_path: Path) -> None:
    roam = build(tmp_path, ROAM)
    assert (
        run(HALL, [roam, roam], STEPS).session.state_hash()
        != run(HALL, [roam, roam], STEPS + 1).session.state_hash()
    )


def test_the_state_hash_covers_the_shadow_memory(tmp_path: Path) -> None:
    session = run(HALL, [build(tmp_path, ROAM)] * 2, 1).session
    before, program = session.state_hash(), session.fleet.snapshot(0)
    session.fleet.restore(0, replace(program, shadow_chunks=program.shadow_chunks + 1))
    assert session.state_hash() != before


def test_the_state_hash_covers_the_exit_status(tmp_path: Path) -> None:
    session = run(HALL, [build(tmp_path, "int main(void) { return 3; }\n")] * 2, 1).session
    before, snapshot = session.state_hash(), session.snapshot()
    session.restore(replace(snapshot, exit_status=(3, 4)))
    assert session.state_hash() != before


def test_an_endless_loop_leaves_the_other_robot_unchanged(tmp_path: Path) -> None:
    roam = build(tmp_path, ROAM)
    quiet = build(tmp_path, "int main(void) { return 0; }\n", "quiet.c")
    beside_quiet = run(HALL, [roam, quiet], STEPS)
    beside_loop = run(HALL, [roam, build(tmp_path, LOOP, "loop.c")], STEPS)
    assert beside_loop.written[0] == beside_quiet.written[0] != b""
    robots = [each.session.result().robots for each in (beside_quiet, beside_loop)]
    assert robots[0][0] == robots[1][0]
    assert [row[1].outcome for row in robots] == ["exited", "running"]


def test_a_failing_program_stops_its_robot_alone(tmp_path: Path) -> None:
    crash = build(tmp_path, "int main(void) {\n  int *p = 0;\n  return *p;\n}\n", "crash.c")
    both = run(HALL, [crash, build(tmp_path, ROAM)], 5)
    failed, running = both.session.result().robots
    assert failed.outcome == "failed"
    assert failed.error is not None
    assert failed.error.text.startswith("null pointer")
    assert failed.error.location.line == 3
    assert running.outcome == "running"
    assert running.commands > 0


def test_debug_and_run_density_do_the_same(tmp_path: Path) -> None:
    plain, debug = build(tmp_path, ROAM), build(tmp_path, ROAM, debug=True)
    first, second = run(HALL, [plain, plain], STEPS), run(HALL, [debug, debug], STEPS)
    assert first.written == second.written
    assert first.session.result().robots == second.session.result().robots


def test_processor_time_passes_while_a_program_computes(tmp_path: Path) -> None:
    source = "int main(void) { volatile int i; for (i = 0; i < 1000000; i++) ; return 0; }\n"
    done = run(empty_world(), [build(tmp_path, source)], 1000).session.result()
    assert done.robots[0].outcome == "exited"
    assert done.robots[0].time_s == pytest.approx(done.robots[0].fuel / 50e6, rel=1e-6)
    assert 0.02 < done.robots[0].time_s < 1.0


def test_sleep_takes_simulated_time_and_no_fuel(tmp_path: Path) -> None:
    source = "#include <unistd.h>\nint main(void) { usleep(2500000); return 7; }\n"
    recorded = run(empty_world(), [build(tmp_path, source)], 1000)
    robot = recorded.session.result().robots[0]
    assert robot.exit_status == 7
    assert robot.time_s == pytest.approx(2.5, abs=0.01)
    assert recorded.session.timesteps == 51


def test_a_command_takes_transmission_time_on_the_link(tmp_path: Path) -> None:
    source = """
    #include "Nclient.h"
    int main(void) { int i; connect_robot(1); for (i = 0; i < 100; i++) gs(); return 0; }
    """
    robot = run(empty_world(), [build(tmp_path, source)], 1000).session.result().robots[0]
    assert 1.2 < robot.time_s < 2.0


def test_an_unknown_request_is_refused(tmp_path: Path) -> None:
    source = """
    #include "crs_request.h"
    int main(void) { struct __crs_message m; return __crs_request(999, &m) == -1 ? 3 : 4; }
    """
    robot = run(empty_world(), [build(tmp_path, source)], 5).session.result().robots[0]
    assert robot.exit_status == 3


def test_a_snapshot_resumes_in_a_fresh_session(tmp_path: Path) -> None:
    roam = build(tmp_path, ROAM)
    first = run(HALL, [roam, roam], STEPS, seed=3).session
    snapshot = pickle.loads(pickle.dumps(first.snapshot()))
    second = run(HALL, [roam, roam], 7, seed=3).session
    second.restore(snapshot)
    assert second.state_hash() == first.state_hash()
    for session in (first, second):
        for _ in range(STEPS):
            session.step()
    assert second.state_hash() == first.state_hash()
    assert second.result() == first.result()


TALK = """
#include "crs.h"
int main(void)
{
    struct crs_message message;
    int n, heard = 0;

    for (n = 0; n < 6; n++) {
        crs_broadcast(n, &heard, sizeof heard);
        while (crs_receive(&message, 130 + 50 * crs_my_number()))
            heard = 3 * heard + message.type + message.data[0];
    }
    return heard & 255;
}
"""


def test_messages_in_transit_and_waiting_programs_are_in_a_snapshot(
    tmp_path: Path,
) -> None:
    talk = build(tmp_path, TALK)
    first = run(HALL, [talk, talk], 5, seed=3).session
    assert first.environment.state.waits.code.any()
    second = run(HALL, [talk, talk], 2, seed=3).session
    second.restore(pickle.loads(pickle.dumps(first.snapshot())))
    for session in (first, second):
        while session.step():
            pass
    assert second.state_hash() == first.state_hash()
    assert second.result() == first.result()


CALLS = """
#include "Nclient.h"
#include <unistd.h>
static void think(int n)
{
    for (;;)
        n++;
}
int main(void)
{
    sleep(1);
    connect_robot(1);
    pr(1000, 1000, 0);
    ws(1, 1, 0, 1);
    think(3);
}
"""


def test_the_current_call_of_a_running_program_is_known(tmp_path: Path) -> None:
    program = build(tmp_path, CALLS)
    session = run(HALL, [program, program], 0).session
    assert session.state.current_call(1) is None
    assert session.result().robots[1].robot_call_s is None
    stands = []
    for until_s in (0.5, 1.5, 5):
        while session.time_s < until_s:
            session.step()
        call = session.state.current_call(1)
        assert call is not None
        assert call.location is not None
        stands.append((call.function, call.location.line, session.result().robots[1].robot_call_s))
    assert stands[0] == ("main", 11, None)
    assert stands[1] == ("main", 14, pytest.approx(1.5))  # it waits for the robot
    assert stands[2][0] == "think"
    called_s = stands[2][2]
    assert called_s is not None
    assert 2 < called_s < 2.5


def test_a_session_needs_one_program_for_each_robot() -> None:
    with pytest.raises(ValueError, match="0 programs for 1 robots"):
        Session(empty_world(), [])


def test_a_session_that_nobody_uses_is_freed_without_a_collection(tmp_path: Path) -> None:
    """With it go its fleet and its programs, which may be large."""
    session = Session(HALL, [build(tmp_path, ROAM)] * 2)
    session.advance(STEPS)
    fleet = weakref.ref(session.fleet)
    gc.disable()
    try:
        del session
        assert fleet() is None
    finally:
        gc.enable()
