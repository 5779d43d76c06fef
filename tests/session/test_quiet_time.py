"""Skipping quiet time changes nothing that anybody could notice.

Each test runs the same programs in the same world with and without quiet time skipped.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.session.trace import Trace
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import load_world, parse_world
from crs_cc.sim.model.world import Pose, WorldModel
from tests.session.programs import build

ROOT = Path(__file__).parents[2]
STEPS = 160

PROGRAMS = {
    "idle": """
#include <Nclient.h>
#include <unistd.h>
int main(void) { connect_robot(1); for (;;) sleep(1000); }
""",
    "computes": """
#include <Nclient.h>
int main(void) { volatile unsigned n = 0; connect_robot(1); for (;;) n = n * 3 + 1; }
""",
    "prints": """
#include <Nclient.h>
#include <stdio.h>
#include <unistd.h>
int main(int argc, char **argv)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 100; i++) {
        printf("%s %d\\n", argv[1], i);
        usleep(37000 * (1 + i % 5));
    }
    return 4;
}
""",
    "unconnected": "int main(void) { volatile int n; for (n = 0; n < 9999999; n++) ; return 3; }",
    "fails": "int main(void) { volatile int n = 9999999; while (n) n--; return 1 / n; }",
    "waits for messages": """
#include <Nclient.h>
#include <crs.h>
#include <stdio.h>
#include <unistd.h>
int main(void)
{
    struct crs_message message;
    int i;
    connect_robot(1);
    for (i = 0; ; i++) {
        if ((i + crs_my_number()) % 3 == 0) {
            sleep(1);
            crs_broadcast(i, "hello", 5);
        } else if (crs_receive(&message, 700 + 1000 * crs_my_number()))
            printf("%d %d\\n", i, message.type);
        else
            printf("%d\\n", i);
    }
}
""",
    "measures by timers": """
#include <Nclient.h>
#include <crs.h>
#include <stdio.h>
#include <unistd.h>
int main(void)
{
    int ranges[16], i;
    connect_robot(1);
    crs_period(CRS_SENSOR_COMPASS, 470);
    for (i = 0; ; i++) {
        usleep(999000);
        get_cp();
        crs_sonar(ranges, 16);
        printf("%d %d %ld\\n", crs_age(CRS_SENSOR_COMPASS), ranges[3], State[STATE_COMPASS]);
    }
}
""",
    "anything": """
#include <Nclient.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
int main(int argc, char **argv)
{
    static int order[16] = {0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};
    volatile unsigned x = 1;
    unsigned n, k;
    connect_robot(1);
    srand(atoi(argv[1]));
    for (;;) {
        n = rand() % 7;
        switch (rand() % 9) {
        case 0: usleep(1000 * (rand() % 900)); break;
        case 1: for (k = 0; k < n * 200000; k++) x = x * 3 + 1; break;
        case 2: get_sn(); printf("%ld %ld\\n", State[STATE_SONAR_0], State[STATE_SONAR_9]); break;
        case 3: pr(100, 60, 0); ws(1, 1, 0, 20); break;
        case 4: order[5] = n > 3 ? 255 : 5; conf_sn(rand() % 20, order); break;
        case 5: printf("%u\\n", x); usleep(1000 * (rand() % 2500)); break;
        case 6: vm(50, -50, 0); conf_tm(1); sleep(2 + n / 2); break;
        case 7: st(); sleep(n); get_rc(); printf("%ld\\n", State[STATE_CONF_X]); break;
        case 8: lp(); gs(); printf("%ld\\n", State[STATE_SONAR_3]); break;
        }
    }
}
""",
}

HALL = '<area length="8m" width="5m"/><box x="4m" y="2m" length="0.5m" width="0.5m" mass="5kg"/>'
ROBOTS = """<robot id="a" x="1m" y="2m" {0}/><robot id="b" x="3m" y="3.2m" heading="200deg" {0}/>
<robot id="c" x="6.5m" y="2m" heading="180deg" {0}/>"""

WORLDS = {
    "one robot": HALL + '<robot id="a" x="1m" y="2m"/>',
    "no box": '<area length="3m" width="3m"/><robot id="a" x="1m" y="2m"/>',
    "one noisy robot": HALL + '<robot id="a" x="1m" y="2m" setup="noisy"/>',
    "three robots": HALL + ROBOTS.format(""),
    "crosstalk": HALL + ROBOTS.format('setup="noisy"'),
    "odd timestep": HALL + ROBOTS.format('setup="noisy"'),
    "another robot": HALL + '<robot id="a" x="1m" y="2m" definition="pioneer2dx" setup="noisy"/>',
    "a robot at a wall": HALL + '<robot id="a" x="0.2032m" y="2m"/>',
    "comings and goings": HALL + ROBOTS.format("")
    + '<robot id="d" x="2m" y="1m" join="2.53s" leave="6.1s" setup="noisy"/>'
    '<communication><shut at="3s" until="4.02s"/></communication>',
    "sonars fail": HALL + ROBOTS.format('setup="noisy"')
    + '<degradation robot="a" device="sonar" element="3" onset="2.2s" duration="3s" noise="0.2m"/>'
    '<degradation robot="c" device="sonar" dropouts="0.3"/>',
    "goals": HALL + ROBOTS.format("") + '<goal><reach x="1m" y="2m" radius="9cm" stay="3s"/></goal>'
    '<goal id="b0" robots="b"><reach x="3m" y="3.2m" radius="1m" stay="2.3s"/></goal>'
    '<goal after="b0"><follow target="a" most="3m" share="0.4"/></goal>'
    '<goal within="4.1s"><follow target="c" most="4m" share="0.8"/></goal>'
    '<goal within="5s"><reach x="6m" y="4m" radius="10cm"/></goal><goal><no-collision/></goal>',
    "wheels fail": HALL + ROBOTS.format("")
    + '<degradation robot="b" device="drive" element="right" gain="0.5" onset="3s" bias="1cm/s"/>',
}  # fmt: skip
TIMESTEPS = {"odd timestep": "37ms"}


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Executable]:
    """Return a function that builds one of `PROGRAMS`, once for all worlds."""
    folder = tmp_path_factory.mktemp("programs")
    return cache(lambda name: build(folder, PROGRAMS[name], f"{name}.c"))


@dataclass
class Run:
    """A session with what its programs wrote, and the number of its timesteps that were skipped."""

    session: Session
    written: list[tuple[int, int, bytes]]
    skipped: list[int]


def start(world: WorldModel, programs: list[Executable], *, skips: bool) -> Run:
    written: list[tuple[int, int, bytes]] = []
    skipped: list[int] = []
    arguments = [["program", str(robot)] for robot in range(len(programs))]
    session = Session(
        world, programs, 5, arguments=arguments, output=lambda *piece: written.append(piece)
    )
    session.environment.skips_quiet_time = skips
    skip = session.environment.skip

    def count(cycles: int) -> None:
        skipped.append(cycles)
        skip(cycles)

    session.environment.skip = count  # type: ignore[method-assign]
    return Run(session, written, skipped)


def world_of(name: str) -> WorldModel:
    timestep = TIMESTEPS.get(name, "50ms")
    text = f'<world version="1" timestep="{timestep}">{WORLDS[name]}</world>'
    return parse_world(text.encode(), name)


def compare(world: WorldModel, programs: list[Executable], steps: int = STEPS) -> int:
    """Compare runs that are looked at every few timesteps, and seldom.

    Returns:
        the number of timesteps that were skipped in the last of them.
    """
    whole = start(world, programs, skips=False)
    hashes, can_continue = {}, True
    places = {*looks(4, steps), *looks(steps, steps)}
    while can_continue and whole.session.timesteps < steps:
        can_continue = whole.session.step()
        if whole.session.timesteps in places or not can_continue:
            hashes[whole.session.timesteps] = whole.session.state_hash()
    assert not whole.skipped
    last = whole.session.timesteps
    for longest in (4, steps):
        run = start(world, programs, skips=True)
        for step in looks(longest, last):
            while run.session.timesteps < step:
                goes_on = run.session.advance(step - run.session.timesteps)
                assert goes_on or run.session.timesteps == last
            assert run.session.state_hash() == hashes[step], step
        assert goes_on == can_continue
        assert run.written == whole.written
        assert run.session.result() == whole.session.result()
    return sum(run.skipped)


def looks(longest: int, steps: int) -> Iterator[int]:
    """Yield timesteps at random distances, and the last."""
    chance, step = random.Random(longest), 0
    while step < steps:
        step = min(steps, step + chance.randint(1, longest))
        yield step


@pytest.mark.parametrize("world", WORLDS)
def test_states_and_output_are_the_same_in_every_world(
    world: str, program: Callable[[str], Executable]
) -> None:
    model = world_of(world)
    skipped = compare(model, [program("anything")] * len(model.robots))
    assert (skipped > 0) == (world != "wheels fail")


@pytest.mark.parametrize("name", PROGRAMS)
def test_states_and_output_are_the_same_for_every_program(
    name: str, program: Callable[[str], Executable]
) -> None:
    assert compare(world_of("crosstalk"), [program(name)] * 3, 80) > 0


def test_a_program_alone_runs_the_same(program: Callable[[str], Executable]) -> None:
    assert compare(world_of("one noisy robot"), [program("computes")], 80) > 0


def test_different_programs_share_quiet_time(program: Callable[[str], Executable]) -> None:
    programs = [program(name) for name in ("prints", "computes", "waits for messages", "idle")]
    assert compare(world_of("comings and goings"), programs) > 0


@pytest.mark.parametrize("sample", ["sonar_ages.c", "mission.c", "behaviours.c", "turret.c"])
def test_samples_run_the_same(sample: str) -> None:
    program = build_executable([ROOT / "samples" / "scout_c" / sample], Diagnostics())
    world = load_world(ROOT / "worlds" / "pair.xml")
    compare(world, [program] * len(world.robots), 60)


def test_contacts_are_never_skipped(program: Callable[[str], Executable]) -> None:
    assert compare(world_of("a robot at a wall"), [program("idle")], 20) == 0


def test_most_of_an_idle_run_is_skipped(program: Callable[[str], Executable]) -> None:
    run = start(world_of("one robot"), [program("idle")], skips=True)
    run.session.advance(1000)
    while run.session.timesteps < 1000:
        run.session.advance(1000 - run.session.timesteps)
    assert sum(run.skipped) > 990
    assert len(run.skipped) < 5


def test_many_skipped_timesteps_give_the_same_state(program: Callable[[str], Executable]) -> None:
    hashes = []
    for skips in (False, True):
        run = start(world_of("crosstalk"), [program("idle")] * 3, skips=skips)
        while run.session.timesteps < 1600:
            run.session.advance(1600 - run.session.timesteps)
        hashes.append(run.session.state_hash())
    assert hashes[0] == hashes[1]


def test_a_snapshot_of_skipped_time_continues_as_the_run_does(
    program: Callable[[str], Executable],
) -> None:
    world = world_of("crosstalk")
    programs = [program("anything")] * 3
    run, other = (start(world, programs, skips=skips) for skips in (True, False))
    for step in looks(20, STEPS):
        while run.session.timesteps < step:
            run.session.advance(step - run.session.timesteps)
        while other.session.timesteps < step:
            other.session.step()
        kept, plain = run.session.snapshot(), other.session.snapshot()
        assert kept.environment.physics.cycles == plain.environment.physics.cycles
        assert kept.environment.physics.room_m == plain.environment.physics.room_m
        run.session.restore(plain)
        other.session.restore(kept)
        assert run.session.state_hash() == other.session.state_hash()


def test_restoring_a_snapshot_forgets_what_was_skipped(
    program: Callable[[str], Executable],
) -> None:
    run = start(world_of("one robot"), [program("idle")], skips=True)
    run.session.advance(4)
    kept, before = run.session.snapshot(), run.session.state_hash()
    for _ in range(9):
        run.session.advance(50)
    run.session.restore(kept)
    assert run.session.state_hash() == before


def test_a_change_from_outside_ends_quiet_time(program: Callable[[str], Executable]) -> None:
    hashes = []
    for skips in (False, True):
        session = start(world_of("one robot"), [program("idle")], skips=skips).session
        for change in range(3):
            while session.timesteps < 30 * (change + 1):
                session.advance(30 * (change + 1) - session.timesteps)
            if change == 0:
                session.environment.teleport("a", Pose(2.0, 1.0, 0.5))
            if change == 1:
                session.environment.remove_obstacle(session.environment.pushables[0])
        hashes.append(session.state_hash())
    assert hashes[0] == hashes[1]


def test_a_listener_hears_of_every_timestep(program: Callable[[str], Executable]) -> None:
    lines = {True: [], False: []}
    for skips, found in lines.items():
        trace = Trace(found.append, ["a"])
        session = Session(world_of("one robot"), [program("prints")], 5, trace=trace)
        session.environment.skips_quiet_time = skips
        while session.timesteps < 50:
            session.advance(50)
    assert lines[True] == lines[False]
    assert len(lines[True]) >= 50


def test_a_session_ends_when_its_last_program_has_ended(tmp_path: Path) -> None:
    program = build(tmp_path, "int main(void) { return 3; }")
    session = start(world_of("one robot"), [program], skips=True).session
    assert not session.advance(100)
    assert session.timesteps == 1
    for step in range(2, 6):
        assert not session.advance(100)
        assert session.timesteps == step


def test_time_is_not_quiet_while_a_robot_drives(tmp_path: Path) -> None:
    source = "#include <Nclient.h>\nint main(void) { connect_robot(1); vm(50, 50, 0); for (;;) ; }"
    run = start(world_of("one robot"), [build(tmp_path, source)], skips=True)
    for _ in range(10):
        run.session.step()
    environment: Environment = run.session.environment
    assert environment.quiet_until() == environment.cycle
    assert not run.skipped
