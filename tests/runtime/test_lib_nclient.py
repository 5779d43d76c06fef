"""The Nomadic client: the request, the use of the reply and the result of each call."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from crs_cc.requests import CODES, NUM_STATE
from tests.runtime.library_runner import Outcome, run

NAMES = {code: name for name, code in CODES.items()}
MODEL_SCOUT = 2
STATE_ERROR = 44
GREETING = b"Nclient version 2.7\nCopyright 1991-1998, Nomadic Technologies, Inc.\n"


class Robot:
    """Notes what was posted; answers with State[k] = 1000 * (number of the request) + k."""

    def __init__(self, result: int = 1) -> None:
        self.posted: list[tuple[str, list[int], bytes]] = []
        self._result = result

    def __call__(self, code: int, message: Any) -> None:
        data = message["data"][: message["size"]].tobytes()
        self.posted.append((NAMES[code], message["i"].tolist(), data))
        state = 1000 * (len(self.posted) - 1) + np.arange(NUM_STATE, dtype=np.int32)
        message["data"][: state.nbytes] = state.view(np.uint8)
        message["i"][:3] = MODEL_SCOUT if NAMES[code] == "CONNECT" else 0
        message["result"] = self._result


def command(calls: str, *, headers: str = "#include <Nclient.h>\n") -> tuple[Robot, Outcome]:
    """Return what happens when a connected program makes these calls."""
    robot = Robot()
    text = headers + "#include <stdio.h>\nint main() {\n    connect_robot(1);\n" + calls + "\n}\n"
    return robot, run(text, robot=robot)


CONNECTING = 2
"""Requests that `connect_robot` posts: CONNECT, and CT of `init_sensors`."""

CALLS = [
    ("ac(-300, 300, 0)", "AC", [300, 300, 0]),
    ("sp(200, -200, 0)", "SP", [200, 200, 0]),
    ("pr(-10, 20, 3)", "PR", [-10, 20, 3]),
    ("vm(100, -100, 0)", "VM", [100, -100, 0]),
    ("mv(MV_VM, 10, MV_PR, -20, MV_IGNORE, 0)", "MV", [1, 10, 2, -20, 0, 0]),
    ("st()", "ST", []),
    ("lp()", "LP", []),
    ("ws(2, 1, 0, 300)", "WS", [1, 1, 0, 44]),
    ("dp(5, -6)", "DP", [5, -6]),
    ("da(900, 0)", "DA", [900, 0]),
    ("zr()", "ZR", []),
    ("conf_tm(1000)", "CONF_TM", [232]),
    ("gs()", "GS", []),
    ("get_sn()", "GET_SN", []),
    ("sonarSensorCheck()", "GET_SN", []),
    ("scout_vm(100, 900)", "VM", [206, -6, 0]),
    ("scout_pr(-50, 900)", "PR", [56, -156, 0]),
    ("scout_ws(300)", "WS", [1, 1, 0, 44]),
]


@pytest.mark.parametrize("headers", ["#include <Nclient.h>\n", ""])
def test_each_call_posts_its_request(headers: str) -> None:
    """With the header, and as old programs call: without, so that nothing converts arguments."""
    constants = "" if headers else "#define MV_VM 1\n#define MV_PR 2\n#define MV_IGNORE 0\n"
    calls = "".join(f"    {call};\n" for call, _, _ in CALLS)
    robot, _ = command(calls + "    return 0;", headers=headers + constants)
    found = [
        (name, integers[: len(arguments)])
        for (name, integers, _), (_, _, arguments) in zip(
            robot.posted[CONNECTING:], CALLS, strict=True
        )
    ]
    assert found == [(name, arguments) for _, name, arguments in CALLS]


REFRESHED = [
    ("gs()", 0, 44),
    ("vm(0, 0, 0)", 0, 44),
    ("conf_tm(5)", 0, 44),
    ("get_sn()", 17, 32),
    ("get_bp()", 33, 33),
    ("get_rc()", 34, 37),
    ("get_rv()", 38, 40),
]


def test_each_reply_refreshes_its_part_of_state() -> None:
    printing = 'for (i = 0; i < NUM_STATE; i++) printf("%ld ", State[i]); printf("\\n");\n'
    calls = "".join(f"    {call}; {printing}" for call, _, _ in REFRESHED)
    headers = "#include <Nclient.h>\nstatic int i;\n"
    _, outcome = command(calls + "    return 0;", headers=headers)
    state = [1000 + k for k in range(NUM_STATE)]
    state[STATE_ERROR] = 0
    rows = [[int(word) for word in line.split()] for line in outcome.out.splitlines()]
    for number, ((call, first, last), row) in enumerate(
        zip(REFRESHED, rows, strict=True), CONNECTING
    ):
        state[first : last + 1] = [1000 * number + k for k in range(first, last + 1)]
        if last == STATE_ERROR:
            state[STATE_ERROR] = 0
        assert row == state, call


def test_connection() -> None:
    source = r"""
    #include <stdio.h>
    #include <string.h>
    #include <Nclient.h>
    int main(void)
    {
        printf("%d\n", vm(1, 1, 0));
        strcpy(SERVER_MACHINE_NAME, "here");
        SERV_TCP_PORT = 7020;
        printf("%d\n", connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400));
        printf("%d\n", disconnect_robot(1));
        printf("%d\n", get_sn());
        printf("%d\n", connect_robot(2));
        return 0;
    }
    """
    robot = Robot()
    outcome = run(source, robot=robot)
    lines = ["Not connected to any robot", "0", "7020", "1", "Not connected to any robot", "0"]
    assert outcome.out.decode().splitlines() == [*lines, "7020"]
    assert outcome.err == GREETING
    posted = [(name, row[0]) for name, row, _ in robot.posted if name != "CT"]
    assert posted == [("CONNECT", 1), ("DISCONNECT", 1), ("CONNECT", 2)]


def test_calls_fail_when_the_server_is_gone() -> None:
    source = r"""
    #include <stdio.h>
    #include <Nclient.h>
    int main(void)
    {
        int quit, read, again;
        connect_robot(1);
        quit = quit_server(), printf("%d %ld\n", quit, State[STATE_ERROR]);
        read = gs(), printf("%d %ld\n", read, State[STATE_ERROR]);
        again = connect_robot(1), printf("%d %ld\n", again, State[STATE_ERROR]);
        return gs();
    }
    """
    outcome = run(source, robot=Robot())
    assert outcome.out.decode().splitlines() == [
        "1 0",
        "0 111",
        "failed to connect to server on machine robot via tcp port #7019 ",
        "0 111",
        "Not connected to any robot",
    ]


@pytest.mark.parametrize(
    ("order", "sent"),
    [
        ("{0, 2, 15, 1, 255}", bytes([0, 2, 15, 1])),
        ("{255}", b""),
        ("{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0}", bytes(range(16))),
        (None, b""),
    ],
)
def test_the_firing_order_ends_at_255_or_sixteen(order: str | None, sent: bytes) -> None:
    declared = f"    int order[] = {order};\n" if order else "    int *order = 0;\n"
    robot, _ = command(declared + "    return conf_sn(15, order);")
    name, integers, data = robot.posted[CONNECTING]
    assert (name, integers[0], data) == ("CONF_SN", 15, sent)


def test_mv_sends_only_modes_0_to_5() -> None:
    robot, outcome = command("    return mv(MV_PA, 1, MV_VM, 1, MV_IGNORE, 0);")
    assert (len(robot.posted), outcome.status) == (CONNECTING, 0)


def test_programs_define_names_of_the_client_themselves() -> None:
    source = r"""
    #include <Nclient.h>
    #include <stdio.h>
    long State[NUM_STATE];
    # define RIGHT(trans, steer) (trans + (int)((float)steer*ROTATION_CONSTANT))
    # define scout_pr(trans, steer) pr(RIGHT(trans, steer), 77, 0)
    int scout_ws(int seconds) { return 7 * seconds; }
    int main(void)
    {
        connect_robot(1);
        scout_pr(1, 2);
        printf("%ld %d\n", State[0], scout_ws(6));
        return 0;
    }
    """
    robot = Robot()
    assert run(source, robot=robot).out == b"2000 42\n"
    assert robot.posted[CONNECTING][1][:2] == [1, 77]
