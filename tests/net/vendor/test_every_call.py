"""Every call of a client, before and after it connects, prints what the vendor's compiled one does.

`printed/` has what a program prints that is linked with the vendor's library and makes each call on
a `State` full of -777: what the call returns, and which elements it overwrites.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from crs_cc.sim.files.world_xml import empty_world
from tests.net.vendor.nclient import NUM_STATE, Nclient
from tests.net.vendor.served import served

PRINTED = Path(__file__).parent / "printed"
POISON = -777
ORDER = (0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8)
SQUARE = (4, 1000, 1000, 1100, 1000, 1100, 1100, 1000, 1100)
NOBODY_POINTS = "get_robot_conf(conf)"
NO_PACKETS = "special_request(sb, rb)"
NO_COLLISION = "motion_check("
OURS = (NOBODY_POINTS, NO_PACKETS, NO_COLLISION)
"""Where the server of the vendor's program answered something else: nobody points at our window,
our robot knows no user's packets, and there is nothing on the way."""

Call = tuple[str, Callable[[Nclient], int]]

CALLS: tuple[Call, ...] = (
    ("ac(100, 100, 0)", lambda c: c.state_call(10, 100, 100, 0)),
    ("sp(50, 50, 0)", lambda c: c.state_call(11, 50, 50, 0)),
    ("pr(10, 10, 0)", lambda c: c.state_call(13, 10, 10, 0)),
    ("pa(1, 1, 1)", lambda _: 0),
    ("vm(10, 10, 0)", lambda c: c.state_call(12, 10, 10, 0)),
    ("st()", lambda c: c.state_call(17)),
    ("mv(MV_VM, 10, MV_VM, 10, MV_IGNORE, 0)", lambda c: c.mv(1, 10, 1, 10, 0, 0)),
    ("mv(MV_PA, 1, MV_VM, 1, MV_VM, 1)", lambda c: c.mv(6, 1, 1, 1, 1, 1)),
    ("mv(7,1,0,0,0,0)", lambda c: c.mv(7, 1, 0, 0, 0, 0)),
    ("st()", lambda c: c.state_call(17)),
    ("lp()", lambda c: c.state_call(18)),
    ("ws(1, 1, 0, 1)", lambda c: c.state_call(39, 1, 1, 0, 1)),
    ("ws(0,0,0,0)", lambda c: c.state_call(39, 0, 0, 0, 0)),
    ("dp(5, 6)", lambda c: c.state_call(21, 5, 6)),
    ("da(7, 8)", lambda c: c.state_call(38, 7, 8)),
    ("zr()", lambda c: c.state_call(20)),
    ("conf_sn(15, order)", lambda c: c.state_call(23, 15, *ORDER)),
    ("conf_ir(5, order)", lambda c: c.state_call(22, 5, *ORDER)),
    ("conf_cp(1)", lambda c: c.state_call(24, 1)),
    ("conf_ls(51, 20, 20, 20, 4)", lambda c: c.conf_ls(51, 20, 20, 20, 4)),
    ("conf_sg(50, 4, 30)", lambda c: c.state_call(36, 50, 4, 30)),
    ("conf_tm(5)", lambda c: c.state_call(26, 5)),
    ("ct()", Nclient.ct),
    ("init_sensors()", Nclient.ct),
    ("gs()", lambda c: c.state_call(15)),
    ("get_ir()", lambda c: c.group(27, 1, 16, 1)),
    ("get_sn()", lambda c: c.group(28, 17, 32, 2)),
    ("get_rc()", lambda c: c.group(29, 34, 37, 0)),
    ("get_rv()", lambda c: c.group(30, 38, 40, 0)),
    ("get_ra()", lambda c: c.group(31, 38, 40, 0)),
    ("get_cp()", lambda c: c.group(32, 43, 43, 16)),
    ("get_bp()", lambda c: c.group(35, 33, 33, 4)),
    ("get_ls()", lambda c: c.scan(33)),
    ("get_sg()", lambda c: c.scan(37)),
    ('tk("hello")', lambda c: c.tk("hello")),
    ("add_obstacle(obs)", lambda c: c.tell(50, *SQUARE)),
    ("move_obstacle(obs, 10, 10)", lambda c: c.tell(52, *SQUARE, 10, 10)),
    ("delete_obstacle(obs)", lambda c: c.tell(51, *SQUARE)),
    ("place_robot(100, 100, 0, 0)", lambda c: c.tell(41, 100, 100, 0, 0)),
    ("get_rpx(rpx)", Nclient.get_rpx),
    ("predict_sensors(100, 100, 0, 0, st2, las)", lambda c: c.tell(42, 100, 100, 0, 0)),
    (
        "motion_check(0, 0., 0., 1., 1., 0., 0., 0., col)",
        lambda c: c.motion_check(0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0),
    ),
    (NOBODY_POINTS, lambda c: int(c.exchange(200) not in (None, 91))),
    ("draw_robot(1, 1, 0, 0, 1)", lambda c: c.tell(60, 1, 1, 0, 0, 1)),
    ("draw_line(0, 0, 1, 1, 1)", lambda c: c.tell(61, 0, 0, 1, 1, 1)),
    ("draw_arc(0, 0, 5, 5, 0, 900, 1)", lambda c: c.tell(62, 0, 0, 5, 5, 0, 900, 1)),
    ("draw_line(0, 0, 1, 1, 0)", lambda c: c.tell(61, 0, 0, 1, 1, 0)),
    ("draw_line(0,0,1,1,99)", lambda c: c.tell(61, 0, 0, 1, 1, 99)),
    ("draw_robot(0,0,0,0,0)", lambda c: c.tell(60, 0, 0, 0, 0, 0)),
    ("refresh_all()", lambda c: c.tell(150)),
    ("refresh_all_traces()", lambda c: c.tell(151)),
    ("refresh_client_graphics()", lambda c: c.tell(159)),
    ("posDataRequest(POS_SONAR)", lambda c: c.pos_data_request(2)),
    ("posDataCheck()", lambda c: c.mask[0]),
    ("posDataRequest(256)", lambda c: c.pos_data_request(256)),
    ("posDataCheck()", lambda c: c.mask[0]),
    ("posDataRequest(0)", lambda c: c.pos_data_request(0)),
    ("posSonarRingGet(pd)", lambda _: 1),
    ("posSonarGet(pd, 3)", lambda _: 1),
    ("posBumperGet(pd)", lambda _: 1),
    ("posTimeGet() >= 0", lambda c: int(c.board_ms >= 0)),
    ("voltCpuGet() > 2", lambda c: int((2 + 3 * c.cpu / 255) * 2.4 > 2)),
    (NO_PACKETS, lambda c: c.special_request(bytes((5, 0, 1, 2, 9)))),
    ("real_robot()", lambda c: c.tell(71)),
    ("simulated_robot()", lambda c: c.tell(74)),
    ("new_world()", lambda c: c.tell(53)),
    ("add_obstacle(obs)", lambda c: c.tell(50, *SQUARE)),
    ("add_obstacle(obs)", lambda c: c.tell(50, 11, *SQUARE[1:], *[0] * 14)),
)
CONNECTED = 'connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400) != 0'
ENDING: tuple[Call, ...] = (
    ("disconnect_robot(1)", Nclient.disconnect_robot),
    ("gs()", lambda c: c.state_call(15)),
    ("disconnect_robot(1)", Nclient.disconnect_robot),
    ('connect_robot(1, 2, "/dev/ttyS0", 38400) > 1', lambda c: int(c.connect_robot() > 1)),
    ("quit_server()", lambda c: c.tell(70)),
    ("gs()", lambda c: c.state_call(15)),
)
"""After the last of these the vendor's program is ended, as it writes to a closed connection."""


def overwritten(state: list[int]) -> Iterator[str]:
    """Yield the ranges of elements that are not poisoned any more."""
    first = None
    for element in range(NUM_STATE + 1):
        is_changed = element < NUM_STATE and state[element] != POISON
        if is_changed and first is None:
            first = element
        elif not is_changed and first is not None:
            yield f" {first}" if first == element - 1 else f" {first}-{element - 1}"
            first = None


def lines(client: Nclient, calls: tuple[Call, ...]) -> Iterator[str]:
    """Make calls, and yield what the vendor's program prints of each."""
    for name, call in calls:
        client.state, client.laser = [POISON] * NUM_STATE, [POISON]
        result = call(client)
        yield from client.printed
        client.printed.clear()
        error = f"  [44]={client.state[44]}" if client.state[44] != POISON else ""
        laser = "  laser" if client.laser[0] != POISON else ""
        yield f"{name:<22} {result:6} {''.join(overwritten(client.state))}{error}{laser}"
        if name.startswith("get_rpx") and result:
            yield f"  rpx {client.received[0]}"
        elif name.startswith("get_rpx"):
            yield "  rpx 0"


@pytest.mark.parametrize("is_wide", [False, True], ids=["32 bit", "64 bit"])
def test_a_client_prints_the_same_as_the_vendors(*, is_wide: bool) -> None:
    world = empty_world(robot="nomad200")
    expected = (PRINTED / "nclient-2.7.txt").read_text().splitlines()
    with served(world) as run:
        client = Nclient(run.server.serve_nserver(0), is_wide=is_wide)
        printed = ["before connect", *lines(client, (*CALLS, *ENDING[:1]))]
        connect: Call = (CONNECTED, lambda c: int(c.connect_robot() != 0))
        printed += lines(client, (connect, *CALLS, *ENDING))
    theirs = [text.rstrip() for text in expected if not text.startswith(OURS)]
    assert [text.rstrip() for text in printed if not text.startswith(OURS)] == theirs
    refused = [text for text in printed if text.startswith(OURS)]
    assert [text.split(")")[1].split()[0] for text in refused] == ["0"] * 6
