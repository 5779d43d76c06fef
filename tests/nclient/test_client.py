"""The client library itself: connection, masks, State's side effects, packets, Ndirect."""

from __future__ import annotations

import pytest

from tests.nclient.drive import drive

NCLIENT = "Nclient version 2.7\nCopyright 1991-1998, Nomadic Technologies, Inc.\n"
NDIRECT = NCLIENT.replace("Nclient", "Ndirect")
NOMAD200 = '<robot definition="nomad200" x="0" y="0"/>'

DIRECTLY = 'connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400); freopen("out", "w", stdout);'
"""Connects under Ndirect, without its messages among the numbers."""


def numbers(calls, **options):
    """Return what the calls print, each as one number, in a connected program."""
    prints = "".join(f'printf("%ld ", (long)({call}));' for call in calls)
    return drive(f"connect_robot(1); {prints}", **options).numbers


def directly(calls, **options):
    """Return the same under Ndirect."""
    prints = "".join(f'fprintf(stderr, "%ld ", (long)({call}));' for call in calls)
    done = drive(f"{DIRECTLY} {prints}", client="ndirect", **options)
    return [float(word) for word in done.errors[0].removeprefix(NDIRECT).split()]


# -- connection ----------------------------------------------------------------------------------


@pytest.mark.function("connect_robot", "disconnect_robot")
def test_nclient_prints_greeting_once_with_server_port():
    done = drive("""
        printf("%d ", connect_robot(1));
        printf("%d ", disconnect_robot(1));
        printf("%d", connect_robot(7, MODEL_SCOUT2, "/dev/ttyUSB0", 38400));
    """)
    assert done.output[0] == "7019 1 7019"
    assert done.errors[0] == NCLIENT


@pytest.mark.function("connect_robot")
@pytest.mark.parametrize(
    ("arguments", "how", "what"),
    [
        ('"/dev/ttyS0", 38400', "serial", "38400 baud using /dev/ttyS0"),
        ('"COM1:", 9600', "serial", "9600 baud using COM1:"),
        ('"/dev/ttyUSB0", 0', "serial", "38400 baud using /dev/ttyUSB0"),
        ('"robbie", 0', "TCP/IP", "machine robbie on port 65001"),
        ('"", 7', "TCP/IP", "machine localhost on port 7"),
    ],
)
def test_ndirect_prints_connection_and_returns_true(arguments, how, what):
    done = drive(f'printf("%d", connect_robot(1, MODEL_SCOUT, {arguments}));', client="ndirect")
    assert done.output[0] == f"Robot <-> Host {how} communication setup\n({what})\n1"
    assert done.errors[0] == NDIRECT


def test_ndirect_corrects_invalid_speed():
    done = drive('connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 1200);', client="ndirect")
    assert done.errors[0] == f"{NDIRECT}Invalid baud rate 1200, using 38400\n"


def test_ndirect_connection_sets_line_speed():
    slow, fast = (
        drive(f"""
            struct timeval before, after;
            connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", {baud});
            gettimeofday(&before, NULL);
            gs();
            gettimeofday(&after, NULL);
            fprintf(stderr, "%ld", (long)(after.tv_usec - before.tv_usec));
        """, client="ndirect").errors[0].removeprefix(NDIRECT)
        for baud in (9600, 38400)
    )  # fmt: skip
    assert int(slow) - int(fast) == pytest.approx(54 * 10 * 1e6 * (1 / 9600 - 1 / 38400), abs=3)


def test_ndirect_reads_missing_arguments():
    done = drive("connect_robot(1);", client="ndirect")
    error = done.session.result().robots[0].error
    assert error is not None
    assert error.kind == "missing argument"
    assert "--client ndirect also needs model, device, and baud rate or port" in error.notes[0]


@pytest.mark.function("server_is_running", "create_robot", "real_robot", "simulated_robot")
def test_server_queries():
    done = drive("""
        printf("%d ", server_is_running());
        printf("%d %d %d", create_robot(2), real_robot(), simulated_robot());
    """)
    assert done.output[0] == "7019 7019 1 1"
    assert directly(["create_robot(2)", "real_robot()", "simulated_robot()"]) == [1, 1, 1]


@pytest.mark.function("set_server_machine_name", "set_serv_tcp_port", "quit_server")
def test_ended_server_does_not_answer():
    done = drive("""
        int quit, read, again;
        set_server_machine_name("procyon");
        set_serv_tcp_port(7020);
        printf("%d\\n", connect_robot(1));
        quit = quit_server();
        read = gs();
        printf("%d %d %ld\\n", quit, read, State[STATE_ERROR]);
        again = connect_robot(1);
        printf("%d %s %d\\n", again, SERVER_MACHINE_NAME, SERV_TCP_PORT);
        printf("%d\\n", vm(1, 1, 0));
    """)
    assert done.output[0].splitlines() == [
        "7020",
        "1 0 111",
        "failed to connect to server on machine procyon via tcp port #7020 ",
        "0 procyon 7020",
        "Not connected to any robot",
        "0",
    ]
    assert directly(["quit_server()", "gs()"]) == [1, 1]


@pytest.mark.function("gs", "vm", "get_sn", "special_request", "disconnect_robot")
def test_requests_without_connection_do_nothing():
    done = drive("""
        unsigned char packet[8] = {8}, answer[248];
        int results = gs() + vm(50, 50, 0) + get_sn() + special_request(packet, answer)
            + disconnect_robot(1) + get_rpx((long *)answer) + draw_line(0, 0, 1, 1, 1);
        printf("%d %ld\\n", results, State[STATE_ERROR]);
        sleep(1);
    """)
    assert done.output[0] == "Not connected to any robot\n" * 7 + "0 111\n"
    assert done.x_in[-1] == 0.0


@pytest.mark.function("disconnect_robot")
def test_robot_continues_after_disconnection():
    done = drive("connect_robot(1); ac(1000, 1000, 0); vm(50, 50, 0); disconnect_robot(1);"
                 " sleep(4);")  # fmt: skip
    assert 15 < done.x_in[-1] < 25
    assert directly(["disconnect_robot(1)", "gs()"]) == [1, 1]


# -- State and the mask --------------------------------------------------------------------------

CHANGED = """
    static int changed(int from, int to)
    {
        int i, count = 0;
        for (i = from; i <= to; i++) count += State[i] != -7;
        for (i = 0; i < NUM_STATE; i++) State[i] = -7;
        return count;
    }
"""
"""Counts the entries that were refreshed since the last call."""

REFRESHING = [
    *("ac(9, 9, 0)", "sp(9, 9, 0)", "pr(0, 0, 0)", "vm(0, 0, 0)", "mv(1, 0, 1, 0, 0, 0)", "st()"),
    *("lp()", "ws(1, 1, 1, 1)", "dp(0, 0)", "da(0, 0)", "zr()", "conf_sn(15, order)"),
    *("conf_tm(5)", "conf_ser(0, 38400)", "ct()", "init_sensors()", "gs()", "connect_robot(1)"),
]


@pytest.mark.function("ac", "sp", "pr", "vm", "mv", "st", "lp", "ws", "dp", "da", "zr", "conf_sn")
@pytest.mark.function("conf_tm", "conf_ser", "ct", "init_sensors", "gs", "connect_robot")
def test_commands_with_state_reply_refresh_all_of_state():
    calls = "".join(
        f'changed(0, 44); {call}; printf("%d ", changed(0, 44));' for call in REFRESHING
    )
    done = drive(f"""
        #include <stdio.h>
        #include "Nclient.h"
        {CHANGED}
        int main(void)
        {{
            int order[16] = {{0, 255}};
            connect_robot(1);
            {calls}
            return 0;
        }}
    """)
    assert done.numbers == [45] * len(REFRESHING)


@pytest.mark.function("get_sn", "get_bp", "get_rc", "get_rv", "get_ra", "tk", "get_state")
@pytest.mark.parametrize(
    ("call", "first", "last"),
    [
        ("get_sn()", 17, 32),
        ("get_bp()", 33, 33),
        ("get_rc()", 34, 37),
        ("get_rv()", 38, 40),
        ("get_ra()", 38, 40),
        ('tk("hello")', 45, 44),
        ("get_state(copy)", 45, 44),
    ],
)
def test_reading_group_refreshes_nothing_else(call, first, last):
    done = drive(f"""
        int i;
        long copy[NUM_STATE];
        connect_robot(1);
        for (i = 0; i < NUM_STATE; i++) State[i] = -7;
        {call};
        printf("\\n");
        for (i = 0; i < NUM_STATE; i++) if (State[i] != -7) printf("%d ", i);
    """)
    refreshed = done.output[0].partition("\n")[2].split()
    assert refreshed == [str(i) for i in range(first, last + 1)]


@pytest.mark.function("ct", "init_mask", "init_sensors", "get_mask", "set_mask")
def test_mask_takes_effect_when_sent():
    done = drive("""
        int mask[NUM_MASK], i;
        connect_robot(1);
        get_mask(mask);
        printf("%d %d %d\\n", mask[0], mask[1], mask[43]);
        Smask[SMASK_CONF_X] = 0;
        State[STATE_CONF_X] = State[STATE_CONF_Y] = 77;
        gs(), printf("%ld %ld\\n", State[STATE_CONF_X], State[STATE_CONF_Y]);
        ct(), get_mask(mask), printf("%d\\n", mask[SMASK_CONF_X]);
        State[STATE_CONF_X] = State[STATE_CONF_Y] = 77;
        gs(), printf("%ld %ld\\n", State[STATE_CONF_X], State[STATE_CONF_Y]);
        get_rc(), printf("%ld\\n", State[STATE_CONF_X]);
        for (i = 0; i < NUM_MASK; i++) mask[i] = 0;
        set_mask(mask), printf("%d", Smask[SMASK_CONF_Y]);
        get_mask(mask), printf(" %d\\n", mask[SMASK_CONF_Y]);
        init_mask(), printf("%d %d", Smask[0], Smask[43]);
        get_mask(mask), printf(" %d\\n", mask[SMASK_CONF_X]);
        init_sensors(), get_mask(mask), printf("%d\\n", mask[SMASK_CONF_X]);
    """)
    assert done.output[0].splitlines() == [
        "0 1 1", "0 0", "0", "0 0", "0", "0 1", "0 1 0", "1",
    ]  # fmt: skip


@pytest.mark.function("get_state", "get_laser", "posDataRequest", "posDataCheck")
def test_copies_contain_requested_values():
    done = drive("""
        long state[NUM_STATE];
        int laser[2 * NUM_LASER + 1] = {9};
        connect_robot(1);
        printf("%d %d ", get_state(state), get_laser(laser));
        printf("%d ", state[STATE_SONAR_3] == State[STATE_SONAR_3] && laser[0] == Laser[0]);
        printf("%d ", posDataRequest(POS_SONAR | POS_BUMPER));
        printf("%d %d %d ", posDataCheck(), POS_SONAR_P, POS_LASER_P);
        printf("%d %d", posDataRequest(0xFFFF), posDataRequest(POS_NONE));
    """)
    assert done.numbers == [1, 1, 1, 1, 6, 1, 0, 1, 1]


@pytest.mark.function("get_ir", "get_cp", "get_ls", "get_sg", "conf_ir", "conf_cp", "conf_ls")
@pytest.mark.function("conf_sg", "ct", "init_sensors", "pa")
def test_ndirect_scout_reports_less():
    unknown = [
        *("get_ir()", "get_cp()", "get_ls()", "get_sg()", "conf_ir(0, NULL)", "conf_cp(1)"),
        *("conf_ls(51, 20, 20, 20, 4)", "conf_sg(50, 4, 30)", "ct()", "init_sensors()"),
        "pa(1, 1, 1)",
    ]
    assert directly(unknown) == [0] * len(unknown)
    assert directly([*unknown[:-1], "Smask[43]"], elements=NOMAD200) == [1] * len(unknown)


def test_ndirect_scout_has_fixed_mask():
    done = drive(f"""
        int mask[NUM_MASK], i;
        {DIRECTLY}
        get_mask(mask);
        for (i = 0; i < NUM_MASK; i++) if (!mask[i]) fprintf(stderr, "%d ", i);
        fprintf(stderr, "%ld", State[STATE_ERROR]);
    """, client="ndirect")  # fmt: skip
    words = done.errors[0].removeprefix(NDIRECT).split()
    assert words == [*(str(i) for i in range(17)), "42", "0"]


DUMMIES = [
    *("add_obstacle(obs)", "add_Obs(obs)", "delete_obstacle(obs)", "delete_Obs(obs)"),
    *("move_obstacle(obs, 1, 1)", "move_Obs(obs, 1, 1)", "new_world()", "get_robot_conf(obs)"),
    *("predict_sensors(0, 0, 0, 0, obs, (int *)obs)", "draw_robot(0, 0, 0, 0, 1)"),
    *("draw_line(0, 0, 1, 1, 1)", "draw_arc(0, 0, 1, 1, 0, 9, 1)", "refresh_all()"),
    *("refresh_all_traces()", "refresh_actual_trace()", "refresh_encoder_trace()"),
    *("refresh_all_sensors()", "refresh_bumper_sensor()", "refresh_infrared_sensor()"),
    *("refresh_sonar_sensor()", "refresh_laser_sensor()", "refresh_client_graphics()"),
    *("place_robot(0, 0, 0, 0)", "posDataRequest(POS_SONAR)"),
]


def test_ndirect_has_no_simulator():
    done = drive(f"""
        long obs[NUM_STATE] = {{3, 0, 0, 10, 0, 0, 10}};
        double collide[3];
        int all = 1;
        {DIRECTLY}
        {"".join(f"all &= {call};" for call in DUMMIES)}
        fprintf(stderr, "%d %d ", all, motion_check(0, 0, 0, 9, 9, 0, 0, 0, collide));
        fprintf(stderr, "%d ", get_rpx(obs));
        fprintf(stderr, "%ld %d", obs[0], posDataCheck());
    """, client="ndirect")  # fmt: skip
    assert done.errors[0].removeprefix(NDIRECT).split() == ["1", "0", "0", "-1", "0"]
    assert not len(done.session.environment.state.contacts_before)


@pytest.mark.function("dp", "sp")
@pytest.mark.parametrize(
    ("given", "arrives"),
    [(300, 300), (-300, -300), (32767, 32767), (40000, -7232), (-40000, 7232)],
)
def test_ndirect_truncates_numbers_to_16_bits(given, arrives):
    assert directly([f"dp({given}, 0)", "State[STATE_CONF_X]"]) == [1, arrives]
    assert numbers([f"dp({given}, 0)"]) == [1]
