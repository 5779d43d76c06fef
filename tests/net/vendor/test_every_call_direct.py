"""The same over a robot's line: each call prints what a program linked with Ndirect prints."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from crs_cc.core.host_system import open_terminal
from crs_cc.sim.files.world_xml import empty_world
from tests.net.vendor.ndirect import Ndirect, over_tcp, over_terminal, s16
from tests.net.vendor.served import Served, served
from tests.net.vendor.test_every_call import ORDER, POISON, overwritten

PRINTED = Path(__file__).parent / "printed"
N200, N150, SCOUT = 0, 1, 2

Call = tuple[str, Callable[[Ndirect], int]]


def u16s(*values: int) -> bytes:
    return struct.pack(f"<{len(values)}H", *values)


def s16s(*values: int) -> bytes:
    return b"".join(map(s16, values))


def mv(*modes: int) -> bytes:
    return b"".join(u16s(each) if at % 2 == 0 else s16(each) for at, each in enumerate(modes))


CALLS: tuple[Call, ...] = (
    ("ac(100, 100, 0)", lambda c: c.state_call(1, u16s(100, 100, 0))),
    ("sp(50, 50, 0)", lambda c: c.state_call(2, u16s(50, 50, 0))),
    ("pr(10, 10, 0)", lambda c: c.state_call(3, s16s(10, 10, 0))),
    ("pa(1, 1, 1)", lambda c: c.state_call(4, s16s(1, 1, 1)) if c.is_n200 else 0),
    ("vm(10, 10, 0)", lambda c: c.state_call(5, s16s(10, 10, 0))),
    ("st()", lambda c: c.state_call(9)),
    ("mv(MV_VM, 10, MV_VM, 10, MV_IGNORE, 0)", lambda c: c.state_call(43, mv(1, 10, 1, 10, 0, 0))),
    ("mv(MV_PA, 1, MV_VM, 1, MV_VM, 1)", lambda c: c.state_call(43, mv(6, 1, 1, 1, 1, 1))),
    ("mv(7,1,0,0,0,0)", lambda c: c.state_call(43, mv(7, 1, 0, 0, 0, 0))),
    ("st()", lambda c: c.state_call(9)),
    ("lp()", lambda c: c.state_call(10)),
    ("ws(1, 1, 0, 1)", lambda c: c.state_call(31, bytes((1, 1, 0, 1)))),
    ("ws(0,0,0,0)", lambda c: c.state_call(31, bytes(4))),
    ("dp(5, 6)", lambda c: c.state_call(12, s16s(5, 6))),
    ("da(7, 8)", lambda c: c.state_call(30, s16s(7, 8))),
    ("zr()", lambda c: c.state_call(13)),
    ("conf_sn(15, order)", lambda c: c.state_call(15, bytes((15, *ORDER)))),
    ("conf_ir(5, order)", lambda c: c.state_call(14, bytes((5, *ORDER))) if c.is_n200 else 0),
    ("conf_cp(1)", lambda c: c.conf_cp(1) if c.is_n200 else 0),
    (
        "conf_ls(51, 20, 20, 20, 4)",
        lambda c: c.state_call(17, bytes((35, 20, 20, 20, 0, 4))) if c.is_n200 else 0,
    ),
    ("conf_sg(50, 4, 30)", lambda c: c.state_call(28, bytes((50, 4, 30))) if c.is_n200 else 0),
    ("conf_tm(5)", lambda c: c.state_call(18, bytes((5,)))),
    ("ct()", lambda c: c.ct() if c.is_n200 else 0),
    ("init_sensors()", lambda c: c.ct() if c.is_n200 else 0),
    ("gs()", lambda c: c.state_call(7)),
    ("get_ir()", lambda c: c.get_ir() if c.is_n200 else 0),
    ("get_sn()", Ndirect.get_sn),
    ("get_rc()", lambda c: c.numbers(21, 34, 37)),
    ("get_rv()", lambda c: c.numbers(22, 38, 40)),
    ("get_ra()", Ndirect.get_ra),
    ("get_cp()", lambda c: c.get_cp() if c.is_n200 else 0),
    ("get_bp()", Ndirect.get_bp),
    ("get_ls()", lambda c: c.get_ls() if c.is_n200 else 0),
    ("get_sg()", lambda c: c.get_sg() if c.is_n200 else 0),
    ('tk("hello")', lambda c: c.state_call(11, b"hello\0") if c.is_n200 else 0),
    (
        "place_robot(100, 100, 0, 0)",
        lambda c: c.state_call(12, s16s(100, 100)) and c.state_call(30, s16s(0, 0)),
    ),
    (
        "conf_ser(0, 38400)",
        lambda c: 0 if c.is_n200 else c.state_call(35, bytes((0, *u16s(38400)))),
    ),
    ("posDataRequest(POS_SONAR)", lambda c: c.pos_data_request(2)),
    ("posDataRequest(256)", lambda c: c.pos_data_request(256)),
    ("posDataRequest(0)", lambda c: c.pos_data_request(0)),
)
"""The calls that send something to one of the robots."""

OURS = ("Nak", "get_ls()", "get_sg()", "compass calibration score")
"""Where the robot of the vendor's program answered something else, or has another compass."""


def lines(client: Ndirect) -> Iterator[str]:
    for name, call in CALLS:
        client.state, client.laser = [POISON] * 45, [POISON]
        result = call(client)
        yield from client.printed
        client.printed.clear()
        laser = "  laser" if client.laser[0] != POISON else ""
        yield f"{name:<22} {result:6} {''.join(overwritten(client.state))}{laser}"


def of_these(text: str) -> list[str]:
    """Return the lines of the calls that are made here, in their order."""
    names = tuple(name for name, _ in CALLS)
    found = [line.rstrip() for line in text.splitlines() if line.startswith(names)]
    return [line for line in found if not line.startswith(OURS)][: len(CALLS)]


def on_terminal(run: Served, model: int) -> Ndirect:
    return over_terminal(run.server.serve_terminal(0), model)


def on_port(run: Served, model: int) -> Ndirect:
    return over_tcp(run.server.serve_line(0, 0), model)


@pytest.mark.parametrize(
    ("robot", "model", "printed", "place"),
    [
        ("scout", SCOUT, "ndirect-2.7-scout.txt", on_terminal),
        ("nomad150", N150, "ndirect-2.7-scout.txt", on_terminal),
        ("nomad200", N200, "ndirect-2.7-n200.txt", on_terminal),
        ("nomad200", N200, "ndirect-2.7-n200.txt", on_port),
    ],
    ids=[
        "Scout on a terminal",
        "Nomad 150 on a terminal",
        "Nomad 200 on a terminal",
        "Nomad 200 over TCP",
    ],
)
def test_a_client_prints_the_same_as_the_vendors(
    robot: str, model: int, printed: str, place: Callable[[Served, int], Ndirect]
) -> None:
    if place is on_terminal:
        try:
            open_terminal()[2]()
        except OSError as error:
            pytest.skip(str(error))
    with served(empty_world(robot=robot)) as run:
        client = place(run, model)
        if place is on_port:
            assert client.read(10.0) == bytes((*[255] * 5, 1, 1, 51, 0, 0, 0))
        ours = [line.rstrip() for line in lines(client) if not line.startswith(OURS)]
    assert ours == of_these((PRINTED / printed).read_text())[: len(ours)]
