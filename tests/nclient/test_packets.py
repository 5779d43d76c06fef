"""User-defined packets, compared with hand-made bytes, and the arm that accepts them."""

from __future__ import annotations

import struct

import pytest

from tests.nclient.drive import drive

DUMP = 'for (i = 0; i < index; i++) printf("%d ", buffer[i]);'


def packed(calls):
    """Return the bytes that calls write to a buffer, and their return values."""
    done = drive(f"""
        unsigned char buffer[64] = {{0}};
        unsigned short index;
        int i;
        {calls}
        {DUMP}
    """)
    return [int(number) for number in done.numbers]


@pytest.mark.function("init_send_buffer", "stuff_send_buffer_header")
@pytest.mark.function("stuffchar", "stuff2byteint", "stuff4byteint")
@pytest.mark.function("stuffuchar", "stuff2byteuint", "stuff4byteuint", "stuffdouble")
def test_numbers_are_packed_little_endian_with_separate_sign():
    given, *found = packed("""
        init_send_buffer(&index);
        stuffchar(-5, buffer, &index);
        stuff2byteint(-258, buffer, &index);
        stuff4byteint(-65536, buffer, &index);
        stuffuchar(200, buffer, &index);
        stuff2byteuint(0xABCD, buffer, &index);
        stuff4byteuint(0x89ABCDEF, buffer, &index);
        stuffdouble(-1.5, buffer, &index);
        printf("%d ", stuff_send_buffer_header(index, 7, 42, buffer));
    """)
    expected = [26, 0, 7, 42, 0x85, 0x02, 0x81, 0, 0, 1, 0x80, 200, 0xCD, 0xAB]
    assert found == [*expected, 0xEF, 0xCD, 0xAB, 0x89, *struct.pack("<d", -1.5)]
    assert given == 26


@pytest.mark.function("stuffchar", "stuff2byteint", "stuff4byteint", "init_send_buffer")
def test_packing_functions_return_new_index():
    assert packed("""
        printf("%d ", init_send_buffer(&index));
        printf("%d ", stuffchar(1, buffer, &index));
        printf("%d ", stuff2byteint(1, buffer, &index));
        printf("%d ", stuff4byteint(1, buffer, &index));
        printf("%d ", stuffdouble(1, buffer, &index));
        index = 0;
    """) == [4, 5, 7, 11, 19]


@pytest.mark.function("init_receive_buffer", "extract_receive_buffer_header")
@pytest.mark.function("extractchar", "extract2byteint", "extract4byteint", "extractdouble")
@pytest.mark.function("extractuchar", "extract2byteuint", "extract4byteuint")
def test_unpacking_inverts_packing():
    content = [0x85, 0x02, 0x81, 0, 0, 1, 0x80, 200, 0xCD, 0xAB, 0xEF, 0xCD, 0xAB, 0x89]
    content += struct.pack("<d", -1.5)
    done = drive(f"""
        unsigned char buffer[] = {{44, 1, 7, 42, {", ".join(map(str, content))}}};
        unsigned char serial, type;
        unsigned short index, length;
        printf("%d ", extract_receive_buffer_header(&length, &serial, &type, buffer));
        printf("%d %d %d ", length, serial, type);
        printf("%d ", init_receive_buffer(&index));
        printf("%d ", extractchar(buffer, &index));
        printf("%d ", extract2byteint(buffer, &index));
        printf("%ld ", extract4byteint(buffer, &index));
        printf("%d ", extractuchar(buffer, &index));
        printf("%d ", extract2byteuint(buffer, &index));
        printf("%lu ", extract4byteuint(buffer, &index));
        printf("%g ", extractdouble(buffer, &index));
        printf("%d", index);
    """)
    assert done.numbers == [
        300, 300, 7, 42, 4, -5, -258, -65536, 200, 0xABCD, 0x89ABCDEF, -1.5, 26,
    ]  # fmt: skip


@pytest.mark.function("stuff2byteint", "extract2byteint", "stuff4byteint", "extract4byteint")
@pytest.mark.parametrize(
    ("size", "ctype", "least"), [(2, "short", -32767), (4, "long", -(2**31) + 1)]
)
def test_limits_are_packed_and_unpacked(size, ctype, least):
    done = drive(f"""
        unsigned char buffer[16];
        unsigned short index = 4;
        stuff{size}byteint({least}, buffer, &index);
        stuff{size}byteint({-least}, buffer, &index);
        index = 4;
        printf("%ld ", (long)extract{size}byteint(buffer, &index));
        printf("%ld ", (long)extract{size}byteint(buffer, &index));
    """)
    assert done.numbers == [least, -least]


@pytest.mark.function("special_request", "arm_mv", "arm_ws", "arm_zr")
def test_user_packets_are_refused():
    done = drive("""
        unsigned char send[300] = {44, 1, 0, 1}, receive[300] = {9};
        long left = 5;
        connect_robot(1);
        printf("%d ", special_request(send, receive));
        printf("%d %ld ", receive[0], State[STATE_ERROR]);
        printf("%ld %ld %ld ", arm_zr(ZR_CHECK), arm_mv(1, 2, 3, 4), arm_ws(1, 1, 1000, NULL));
        printf("%ld ", arm_ws(1, 1, 1000, &left));
        printf("%ld", left);
    """)
    assert done.numbers == [0, 9, 1, 0, 0, 0, 0, 0]


def test_long_packet_is_truncated():
    done = drive("""
        static unsigned char send[0xFFFF] = {0xFF, 0xFF}, receive[300];
        connect_robot(1);
        special_request(send, receive);
    """)
    assert done.output[0] == "Data + protocol bytes exceeding 65535, truncating\n"
