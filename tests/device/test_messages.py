"""Messages between robots, from C.

Two or three robots stand in a row, 1 m from each other:

robot0 . robot1 . robot2
"""

import pytest

from tests.nclient.drive import drive

ROW = "".join(f'<robot x="{n}m" y="0"/>' for n in range(3))
PAIR = '<robot x="0" y="0"/><robot x="1m" y="0"/>'
SHOW = 'printf("%d %d %d %d %s\\n", m.from, m.to, m.type, m.size, m.data);'


def run(*programs: str, elements: str = PAIR, **options):
    declared = [f"struct crs_message m; int i; (void)m; (void)i; {text}" for text in programs]
    return drive(*declared, elements=elements, **options)


@pytest.mark.function("crs_send", "crs_receive")
def test_message_is_received_as_sent():
    done = run('crs_send(1, 7, "hello", 5);', f"crs_receive(&m, CRS_FOREVER); {SHOW}")
    assert done.output[1] == "0 1 7 5 hello\n"


def test_all_byte_values_are_transmitted_up_to_248_bytes():
    send = """
        char data[300];
        for (i = 0; i < 300; i++) data[i] = (char)(i * 7);
        printf("%d %d ", crs_send(1, 0, data, 249), crs_send(1, 0, data, -1));
        printf("%d\\n", crs_send(1, 0, data, 248));
    """
    receive = """
        crs_receive(&m, CRS_FOREVER);
        for (i = 0; i < 248 && m.data[i] == (char)(i * 7); i++) ;
        printf("%d %d %d\\n", m.size, i, m.data[248]);
    """
    done = run(send, receive)
    assert done.output == ["0 0 1\n", "248 248 0\n"]


def test_sending_to_unknown_robot_or_itself_is_refused():
    text = (
        'printf("%d %d %d", crs_send(2, 0, "", 0), crs_send(-1, 0, "", 0), crs_send(0, 0, 0, 0));'
    )
    assert run(text, "").output[0] == "0 0 0"


@pytest.mark.function("crs_broadcast")
def test_broadcast_reaches_all_in_range_except_sender():
    hear = f"crs_receive(&m, 500); {SHOW}"
    done = run(
        'crs_broadcast(3, "x", 1); printf("%d", crs_receive(&m, 300));', hear, hear, elements=ROW
    )
    assert done.output == ["0", "0 -1 3 1 x\n", "0 -1 3 1 x\n"]


@pytest.mark.function("crs_multicast", "crs_join_group", "crs_leave_group")
def test_group_messages_reach_members_until_they_leave():
    send = (
        'usleep(200000); crs_multicast(4, 1, "a", 1); usleep(200000); crs_multicast(4, 2, "b", 1);'
    )
    join = "crs_join_group(4);"
    hear = 'while (crs_receive(&m, 1000)) printf("%d group %d to %d ", m.type, m.group, m.to);'
    leave = f"{join} usleep(300000); crs_leave_group(4); {hear}"
    done = run(send, f"{join} {hear}", leave, elements=ROW)
    assert done.output[1:] == ["1 group 4 to -1 2 group 4 to -1 ", "1 group 4 to -1 "]


def test_groups_above_31_are_refused():
    text = (
        'printf("%d %d %d", crs_join_group(32), crs_leave_group(-1), crs_multicast(32, 0, "", 0));'
    )
    assert run(text, "").output[0] == "0 0 0"


@pytest.mark.function("crs_message_count")
def test_inbox_is_in_order_of_arrival():
    send = 'for (i = 0; i < 3; i++) crs_send(1, i, "", 0);'
    receive = """
        sleep(1);
        printf("%d:", crs_message_count());
        while (crs_receive(&m, 0)) printf(" %d", m.type);
        printf(" %d", crs_message_count());
    """
    assert run(send, receive).output[1] == "3: 0 1 2 0"


def test_receive_waits_up_to_its_timeout():
    receive = """
        struct timeval before, after;
        gettimeofday(&before, NULL);
        i = crs_receive(&m, 250);
        gettimeofday(&after, NULL);
        printf("%d %ld", i, (after.tv_usec - before.tv_usec) / 1000);
    """
    assert run(receive, "").output[0] == "0 251"  # 1 ms on the network


@pytest.mark.function("crs_use_channel", "crs_find_channel")
def test_message_uses_selected_channel():
    elements = f'{PAIR}<communication><channel name="pipe" delay="1s"/></communication>'
    send = """
        crs_broadcast(0, "", 0);
        printf("%d %d", crs_find_channel("pipe"), crs_find_channel("none"));
        crs_use_channel(crs_find_channel("pipe")); crs_broadcast(1, "", 0);
        crs_use_channel(CRS_LOCAL); crs_broadcast(2, "", 0);
        printf(" %d", crs_use_channel(99));
    """
    receive = 'while (crs_receive(&m, 2000)) printf("%d on %d, ", m.type, m.channel);'
    done = run(send, receive, elements=elements)
    assert done.output == ["3 -1 0", "0 on 0, 2 on 2, 1 on 3, "]


@pytest.mark.function("crs_my_number", "crs_robot_count", "crs_find_robot", "crs_robot_name")
def test_robot_number_and_names_can_be_looked_up():
    elements = '<robot id="anna" x="0" y="0"/><robot id="bert" x="1m" y="0"/>'
    text = """
        char name[20], cut[3];
        i = 1 - crs_my_number();
        crs_robot_name(i, name, sizeof name);
        crs_robot_name(i, cut, sizeof cut);
        printf("%d of %d, %s %s %d %d", crs_my_number(), crs_robot_count(), name, cut,
               crs_find_robot("bert"), crs_find_robot("carl"));
        printf(" %d", crs_robot_name(2, name, sizeof name));
    """
    done = run(text, text, elements=elements)
    assert done.output == ["0 of 2, bert be 1 -1 0", "1 of 2, anna an 1 -1 0"]


def test_message_has_send_and_arrival_times():
    elements = f'{PAIR}<communication><channel name="radio" delay="1s" jitter="0"/></communication>'
    show = 'crs_receive(&m, CRS_FOREVER); printf("%d %d", m.sent, m.arrived);'
    sent, arrived = map(
        int, run('sleep(1); crs_send(1, 0, "", 0);', show, elements=elements).output[1].split()
    )
    assert sent == pytest.approx(1001, abs=1)
    assert arrived - sent == pytest.approx(1001, abs=1)  # 12 bytes at 14.4 kB/s


def test_send_time_is_time_of_posting_despite_queueing():
    slow = '<channel name="radio" bandwidth="20B/s" delay="0s" jitter="0"/>'
    elements = f"{PAIR}<communication>{slow}</communication>"
    send = 'crs_send(1, 0, "12345678", 8); crs_send(1, 0, "12345678", 8);'
    show = 'crs_receive(&m, CRS_FOREVER); printf("%d %d ", m.sent, m.arrived);'
    first, first_here, second, second_here = map(
        int, run(send, show + show, elements=elements).output[1].split()
    )
    assert (first, second) == (1, 2)
    assert second_here - first_here == pytest.approx(1000, abs=1)  # 20 bytes at 20 B/s


def test_sending_in_a_loop_uses_bounded_memory_and_blocks_nobody():
    hostile = "while (1) crs_broadcast(0, m.data, 248);"
    done = run(
        f"memset(&m, 0, sizeof m); {hostile}", "sleep(2); return crs_message_count();", seconds=3.0
    )
    assert done.session.result().robots[1].exit_status == 64
    assert len(done.session.environment.state.messages.packets) <= 256
