"""A robot's replies on its serial line, command by command (vendor source `Ndirect.c` 2.7).

Robots without a `ct` always send the same part of State. A Nomad 200 sends what its client has
selected. Commands that a robot does not know get a packet without data, which the client takes for
a success.

>>> robot = LineRobot()
>>> opening = robot.open()
>>> next(opening).message["i"].tolist()[:2]
[1, 0]
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Final, TypeAlias

from crs_cc.net.vendor.configuration import Mask, firing_order, speak
from crs_cc.net.vendor.exchange import (
    Exchange,
    Request,
    make_request,
    numbers_in,
    read_laser,
    read_positions,
)
from crs_cc.net.vendor.line_packets import LinePacket, encode, number, s16, s32, u16, u32
from crs_cc.requests.request import BUMPER, COMPASS, INFRARED, LASER, SONAR

NOMAD_200, SCOUT = 0, 2
"""Models as CONNECT replies them (`Nclient.h` 1.29); a Nomad 150 is 1."""

_NAK: Final = encode(8)
_CP: Final = 16
_SEGMENT: Final = 4
_INFRARED, _SONAR, _BUMPER, _X, _SPEEDS, _MOTORS, _COMPASS = 1, 17, 33, 34, 38, 41, 43
_LASER: Final = 42
_POSITIONS: Final = {INFRARED: 16, SONAR: 16, BUMPER: 1, LASER: 1, COMPASS: 1}

_FIXED: Final = Mask(bytes([0] * 17 + [1] * 25 + [0, 1]))
"""What robots send whose mask is fixed: all but infrared, laser and positions."""

_SEGMENT_MODES: Final = frozenset({1, 33})
_PROCESSED: Final = 35
"""The mode on the line that a client calls 51."""

_TURNING: Final = 2
_WRAP: Final = 3600  # tenths of a degree

Data: TypeAlias = bytes
Command: TypeAlias = tuple[int, Callable[[Data], Request]]
"""The size of the data of a command, and the request that it makes."""


def _magnitudes(name: str) -> Callable[[Data], Request]:
    return lambda data: make_request(name, *(data[at] | data[at + 1] << 8 for at in (0, 2, 4)))


def _signed(name: str) -> Callable[[Data], Request]:
    return lambda data: make_request(name, *_numbers(data))


def _numbers(data: Data) -> list[int]:
    return [number(data[at : at + 2]) for at in range(0, len(data), 2)]


def _bytes(name: str) -> Callable[[Data], Request]:
    return lambda data: make_request(name, *data)


def _mv(data: Data) -> Request:
    """Move each axis in a mode of its own; ignore the modes that no robot knows."""
    found = _numbers(data)
    return make_request("MV", *(0 if place % 2 == 0 and not 0 <= each <= 5 else each
                          for place, each in enumerate(found)))  # fmt: skip


def _ws(data: Data) -> Request:
    return make_request("WS", *(int(each != 0) for each in data[:3]), data[3])


def _conf_ls(data: Data) -> Request:
    mode = 51 if data[0] == _PROCESSED else data[0]
    return make_request("CONF_LS", mode, data[1], data[2], data[3] | data[4] << 8, data[5])


_COMMANDS: Final[dict[int, Command]] = {
    1: (6, _magnitudes("AC")),
    2: (6, _magnitudes("SP")),
    3: (6, _signed("PR")),
    5: (6, _signed("VM")),
    7: (0, _bytes("GS")),
    9: (0, _bytes("ST")),
    10: (0, _bytes("LP")),
    12: (4, _signed("DP")),
    13: (0, _bytes("ZR")),
    15: (17, lambda data: firing_order("CONF_SN", data[0], data[1:])),
    18: (1, _bytes("CONF_TM")),
    30: (4, _signed("DA")),
    31: (4, _ws),
    43: (12, _mv),
}
"""The commands of every robot that are answered with State."""

_COMMANDS_OF_NOMAD_200: Final[dict[int, Command]] = {
    14: (17, lambda data: firing_order("CONF_IR", min(data[0], 10), data[1:])),
    17: (6, _conf_ls),
    28: (3, _bytes("CONF_SG")),
}
_COMMANDS_OF_OTHERS: Final[dict[int, Command]] = {
    35: (3, lambda data: make_request("CONF_SER", data[0], data[1] | data[2] << 8)),
}


class LineRobot:
    """A robot as its line shows it.

    Attributes:
        model: its model, known when the line has been opened.
    """

    def __init__(self) -> None:
        self.model = SCOUT
        self._mask = _FIXED
        self._has_segments = False

    def open(self) -> Exchange[bool]:
        """Connect to the robot; return whether it could be."""
        reply = yield make_request("CONNECT", 1, 0)
        self.model = int(reply["i"][0])
        self._mask = Mask() if self.model == NOMAD_200 else _FIXED
        return bool(reply["result"])

    def greeting(self) -> bytes:
        """Return the robot's first packet over TCP: the contents of a Nomad 200's replies."""
        if self.model != NOMAD_200:
            return b""
        content = self._mask.content
        parts = (content[1:9], content[9:17], content[17:25], content[25:33], content[33:41])
        others = int(self._mask.selects(_COMPASS)), int(self._mask.selects(_LASER))
        last = others[1] | self._mask.positions << 1
        return bytes((*map(_packed, parts), others[0], last, 51, 0, 0, 0))

    def answer(self, packet: LinePacket) -> Exchange[bytes]:
        """Return the exchange that answers a packet; it returns the reply as bytes."""
        is_nomad_200 = self.model == NOMAD_200
        commands = _COMMANDS | (_COMMANDS_OF_NOMAD_200 if is_nomad_200 else _COMMANDS_OF_OTHERS)
        if packet.type in commands:
            size, ask = commands[packet.type]
            if len(packet.data) != size:
                return _NAK
            if packet.type == 17:
                self._has_segments = packet.data[0] in _SEGMENT_MODES
            return (yield from self._state(packet.type, ask(packet.data)))
        own = self._own.get(packet.type)
        if own is None and is_nomad_200:
            own = self._own_of_nomad_200.get(packet.type)
        return _NAK if own is None else (yield from own(packet.data))

    @property
    def _own(self) -> dict[int, Callable[[Data], Exchange[bytes]]]:
        return {
            20: self._get_sn, 21: self._get_rc, 22: self._get_rv, 23: self._get_ra,
            27: self._get_bp, 128: _special,
        }  # fmt: skip

    @property
    def _own_of_nomad_200(self) -> dict[int, Callable[[Data], Exchange[bytes]]]:
        return {
            4: self._pa, 6: self._ct, 11: self._tk, _CP: _conf_cp, 19: self._get_ir,
            24: self._get_cp, 25: self._get_ls, 29: self._get_sg,
        }  # fmt: skip

    # -- State -----------------------------------------------------------------------------------

    def _state(self, kind: int, request: Request) -> Exchange[bytes]:
        """Post a request, and reply with the part of State that the mask selects."""
        reply = yield request
        if not reply["result"]:
            return _NAK
        state, mask = numbers_in(reply), self._mask
        data = _nibbles([state[at] for at in range(_INFRARED, _SONAR) if mask.selects(at)])
        data += yield from self._blocks(INFRARED, _INFRARED)
        data += _bytes_of([state[at] for at in range(_SONAR, _BUMPER) if mask.selects(at)])
        data += yield from self._blocks(SONAR, _SONAR)
        if mask.selects(_BUMPER):
            data += self._bumper(state[_BUMPER])
            data += yield from self._blocks(BUMPER, _BUMPER)
        data += b"".join(s16(state[at]) for at in range(_X, _MOTORS) if mask.selects(at))
        if mask.selects(_COMPASS):
            data += s16(state[_COMPASS])
            data += yield from self._blocks(COMPASS, _COMPASS)
        if mask.selects(_LASER):
            data += yield from self._laser(int(reply["i"][0]), has_segments=self._has_segments)
            data += yield from self._blocks(LASER, _LASER)
        voltages = bytes((int(reply["i"][1]) & 255, int(reply["i"][2]) & 255))
        return encode(kind, data + bytes((state[_MOTORS] & 255,)) + _time(reply) + voltages)

    def _blocks(self, kind: int, first: int, *, is_whole: bool = False) -> Exchange[bytes]:
        """Return the positions of one kind of sensor, if they are selected."""
        if not self._mask.positions & kind:
            return b""
        found = yield from read_positions(kind, _POSITIONS[kind])
        kept = [each for number_, each in enumerate(found)
                if is_whole or self._mask.selects(first + number_)]  # fmt: skip
        return b"".join(map(_block, kept))

    def _laser(self, count: int, *, has_segments: bool) -> Exchange[bytes]:
        """Return the laser's segments, four numbers each.

        A robot sends its points as the pixels of its camera, whose calibration we do not know; so
        there are none.
        """
        if not has_segments:
            return u16(0)
        found = yield from read_laser(count, _SEGMENT)
        return u16(count) + b"".join(map(s16, found))

    def _bumper(self, bits: int) -> bytes:
        order: Any = "little" if self.model == SCOUT else "big"
        return (bits & 0xFFFFFF).to_bytes(3, order)

    # -- groups ----------------------------------------------------------------------------------

    def _get_ir(self, _data: Data) -> Exchange[bytes]:
        reply = yield make_request("GET_IR")
        return (yield from self._sensors(19, reply, _nibbles(_part(reply, 1, 16)), INFRARED, 1))

    def _get_sn(self, _data: Data) -> Exchange[bytes]:
        reply = yield make_request("GET_SN")
        return (yield from self._sensors(20, reply, _bytes_of(_part(reply, 17, 32)), SONAR, 17))

    def _get_cp(self, _data: Data) -> Exchange[bytes]:
        reply = yield make_request("GET_CP")
        data = b"".join(map(u16, _part(reply, _COMPASS, _COMPASS)))
        return (yield from self._sensors(24, reply, data, COMPASS, _COMPASS))

    def _get_bp(self, _data: Data) -> Exchange[bytes]:
        reply = yield make_request("GET_BP")
        data = b"".join(map(self._bumper, _part(reply, _BUMPER, _BUMPER)))
        return (yield from self._sensors(27, reply, data, BUMPER, _BUMPER))

    def _sensors(
        self, kind: int, reply: Any, data: bytes, sensor: int, first: int
    ) -> Exchange[bytes]:
        if not reply["result"]:
            return _NAK
        blocks = yield from self._blocks(sensor, first, is_whole=True)
        return encode(kind, data + blocks + _time(reply))

    def _get_rc(self, _data: Data) -> Exchange[bytes]:
        reply = yield make_request("GET_RC")
        return _numbers_reply(21, reply, _part(reply, _X, _SPEEDS - 1))

    def _get_rv(self, _data: Data) -> Exchange[bytes]:
        reply = yield make_request("GET_RV")
        return _numbers_reply(22, reply, _part(reply, _SPEEDS, _MOTORS - 1))

    def _get_ra(self, _data: Data) -> Exchange[bytes]:
        reply = yield make_request("GET_RA")
        return _numbers_reply(23, reply, reply["i"][3:6].tolist())

    def _get_ls(self, _data: Data) -> Exchange[bytes]:
        """Reply with no points, see `_laser`; the client reads the list twice."""
        reply = yield make_request("GET_LS")
        blocks = yield from self._blocks(LASER, _LASER, is_whole=True)
        once = u16(0) + blocks + _time(reply)
        return encode(25, once + once) if reply["result"] else _NAK

    def _get_sg(self, _data: Data) -> Exchange[bytes]:
        reply = yield make_request("GET_SG")
        if not reply["result"]:
            return _NAK
        data = yield from self._laser(int(reply["i"][0]), has_segments=True)
        blocks = yield from self._blocks(LASER, _LASER, is_whole=True)
        return encode(29, data + blocks + _time(reply))

    # -- others ----------------------------------------------------------------------------------

    def _ct(self, data: Data) -> Exchange[bytes]:
        if len(data) != 7:
            return _NAK
        self._mask = Mask.of_ndirect(data)
        return (yield from self._state(6, make_request("CT", data=self._mask.content)))

    def _pa(self, data: Data) -> Exchange[bytes]:
        """Turn steering and turret to angles; the distance since its start is not known."""
        if len(data) != 6:
            return _NAK
        reply = yield make_request("GET_RC")
        if not reply["result"]:
            return _NAK
        now = _part(reply, _X + 2, _X + 3)
        _, *wanted = _numbers(data)
        ways = [_way(to, at) for to, at in zip(wanted, now, strict=True)]
        request = make_request("MV", 0, 0, _TURNING, ways[0], _TURNING, ways[1])
        return (yield from self._state(4, request))

    def _tk(self, data: Data) -> Exchange[bytes]:
        yield from speak(data)
        return (yield from self._state(11, make_request("GS")))


def _conf_cp(data: Data) -> Exchange[bytes]:
    """Configure the compass; the score of its calibration is perfect."""
    if len(data) != 1:
        return _NAK
    reply = yield make_request("CONF_CP", *data)
    return encode(_CP, bytes(3)) if reply["result"] else _NAK


def _special(data: Data) -> Exchange[bytes]:
    reply = yield make_request("SPECIAL", len(data), data=data)
    answer = reply["data"][: int(reply["size"])].tobytes()
    return encode(128, u16(len(answer) + 2) + answer) if reply["result"] else _NAK


def _numbers_reply(kind: int, reply: Any, values: Sequence[int]) -> bytes:
    return encode(kind, b"".join(map(s16, values))) if reply["result"] else _NAK


def _part(reply: Any, first: int, last: int) -> list[int]:
    return numbers_in(reply)[first : last + 1]


def _time(reply: Any) -> bytes:
    return u32(int(reply["f"][0]))


def _nibbles(values: Sequence[int]) -> bytes:
    """Return readings of four bits, two to a byte, the first in the low half."""
    padded = [*values, 0]
    return bytes((padded[at] & 15) | (padded[at + 1] & 15) << 4 for at in range(0, len(values), 2))


def _bytes_of(values: Sequence[int]) -> bytes:
    return bytes(min(max(each, 0), 255) for each in values)


def _packed(flags: bytes) -> int:
    return sum((flag != 0) << bit for bit, flag in enumerate(flags))


def _block(record: Sequence[int]) -> bytes:
    return b"".join(map(s32, record[:7])) + b"".join(map(u32, record[7:]))


def _way(angle: int, origin: int) -> int:
    """Return the shorter way to an angle [0.1 deg]."""
    way = (angle - origin) % _WRAP
    return way - _WRAP if way > _WRAP // 2 else way
