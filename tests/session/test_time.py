"""A program's time: its instructions on the host, its commands on the link."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from crs_cc.requests import SYSTEM_CALL
from crs_cc.runtime.executable import Executable
from crs_cc.session.session import Session
from crs_cc.sim.engine.step import Step
from crs_cc.sim.files.world_xml import empty_world
from crs_cc.sim.model.world import Pose, WorldModel
from tests.session.programs import build, run

COUNT = """#include <stdio.h>
#include <time.h>
int main(void)
{
    volatile long i;
    for (i = 0; i < 1000000; i++)
        ;
    printf("%ld\\n", (long)clock());
}
"""
ASK = """#include <stdio.h>
#include <sys/time.h>
#include "Nclient.h"
int main(void)
{
    struct timeval before, after;
    int i;
    connect_robot(1);
    gettimeofday(&before, 0);
    for (i = 0; i < 100; i++)
        gs();
    gettimeofday(&after, 0);
    printf("%ld\\n", (after.tv_sec - before.tv_sec) * 1000000 + after.tv_usec - before.tv_usec);
}
"""


def printed(world: WorldModel, folder: Path, source: str) -> int:
    """Return the number that a program prints [microseconds]."""
    return int(run(world, [build(folder, source)], 1000).written[0].split()[-1])


def with_host(speed_hz: float) -> WorldModel:
    world = empty_world()
    (robot,) = world.robots
    model = replace(robot.model, host_speed_hz=speed_hz)
    return replace(world, robots=(replace(robot, model=model),))


def test_a_host_of_twice_the_speed_needs_half_the_time(tmp_path: Path) -> None:
    slow, fast = (printed(with_host(speed_hz), tmp_path, COUNT) for speed_hz in (1e7, 2e7))
    assert slow == pytest.approx(2 * fast, rel=0.001)
    assert slow > 1_000_000 / 10  # at least one instruction each time round


def test_reading_the_state_takes_transmission_time_for_its_bytes(tmp_path: Path) -> None:
    used = printed(empty_world(), tmp_path, ASK) / 100
    assert used == pytest.approx((6 + 48) * 10 / 38400 * 1e6, rel=0.02)


def test_an_ideal_link_takes_no_time(tmp_path: Path) -> None:
    assert printed(empty_world().with_ideal_link(), tmp_path, ASK) / 100 < 60  # computing alone


LOOP = """#include <crs_request.h>
#include "Nclient.h"
int main(void)
{
    struct __crs_message message = {0};
    connect_robot(1);
    for (;;)
        __crs_request(CALL, &message);
}
"""


@pytest.mark.parametrize(
    ("request_name", "is_ideal"),
    [("LASER_PAGE", False), ("POS_DATA", False), ("CONNECT", False), ("GS", True)],
)
def test_a_request_off_the_link_costs_the_time_of_a_system_call(
    request_name: str, is_ideal: bool, tmp_path: Path
) -> None:
    trace = Requests()
    world = with_host(5e7)
    if is_ideal:
        world = world.with_ideal_link()
    program = build(tmp_path, LOOP.replace("CALL", f"CRS_{request_name}"))
    session = Session(world, [program], trace=trace)
    session.step()
    assert 0 < trace.served <= world.timestep_s * 5e7 / SYSTEM_CALL


TELL_TIME = """#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>
int main(int argc, char **argv)
{
    struct timespec now;
    int i, own = atoi(argv[1]);
    for (i = 0; i < 5; i++) {
        usleep((i % 2 ? 7001 : 2003) * own);
        clock_gettime(CLOCK_REALTIME, &now);
        printf("%ld %ld %ld\\n", (long)now.tv_sec, now.tv_nsec, (long)clock());
    }
    return 0;
}
"""


def test_time_requests_served_together_are_answered_as_if_alone(tmp_path: Path) -> None:
    program = build(tmp_path, TELL_TIME)
    own = [["p", str(number)] for number in (1, 2, 3, 3)]
    alone = [written([row], program)[0] for row in own]
    assert written(own, program) == alone
    assert len(set(alone)) == 3


def written(arguments: list[list[str]], program: Executable) -> list[bytes]:
    """Return what the programs of as many robots write."""
    output = [b""] * len(arguments)

    def write(robot: int, _stream: int, content: bytes) -> None:
        output[robot] += content

    (robot,) = empty_world().robots
    robots = tuple(
        replace(robot, id=f"r{number}", start=Pose(number, 0.0)) for number in range(len(arguments))
    )
    world = replace(empty_world(), robots=robots)
    session = Session(world, [program] * len(arguments), arguments=arguments, output=write)
    while session.step():
        pass
    return output


class Requests:
    """Counts the requests that robots answer."""

    def __init__(self) -> None:
        self.served = 0

    def step(self, step: Step) -> None:
        """Count those of a timestep."""
        self.served += len(step.served)
