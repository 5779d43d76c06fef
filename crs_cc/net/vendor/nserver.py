"""The Nserver's replies, request by request (vendor source `Nclient.c` 2.6.11 and 2.7).

The client looks at a reply's type only to recognise an error, and parses the rest by what it has
asked for; it notices neither missing nor additional elements. So each reply must have exactly the
elements that this client expects, which depends on what it has configured before.

>>> client = NserverClient(7019)
>>> opening = client.answer(Packet(102, (1, 4711)))
>>> next(opening).code == CODES["CONNECT"]
True
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Final, TypeAlias

from crs_cc.net.vendor import nserver_world as world
from crs_cc.net.vendor.configuration import Mask, firing_order, speak
from crs_cc.net.vendor.exchange import (
    Exchange,
    Request,
    make_request,
    numbers_in,
    read_laser,
    read_positions,
)
from crs_cc.net.vendor.nserver_packets import CONNECT, CREATE, DISCONNECT, Packet
from crs_cc.requests import CODES, NUM_STATE
from crs_cc.requests.request import BUMPER, COMPASS, INFRARED, LASER, SONAR

QUIT: Final = 70
_STATE, _REPLY, _ERROR = 80, 82, 91
_REFUSED: Final = 1
"""The number of the error when a request is refused; chosen by us, as in our own library."""

_SEGMENT_MODES: Final = frozenset({1, 33})
_POINT_MODES: Final = frozenset({19, 50, 51})
_FIRST_MODE, _SEGMENTS = 51, 33

_RINGS: Final = {INFRARED: 16, SONAR: 16, BUMPER: 1, LASER: 1, COMPASS: 1}
"""How many positions a reply has of each kind of sensor, in the order in which they follow."""

_LASER: Final = 42
_ALWAYS: Final = frozenset({0, 41, _LASER})
"""Elements of State that every reply renews: speed of the simulation, motor status, laser mode."""

_GROUPS: Final[dict[int, tuple[str, int, int, int, int]]] = {
    27: ("GET_IR", 83, 1, 16, INFRARED),
    28: ("GET_SN", 84, 17, 32, SONAR),
    29: ("GET_RC", 88, 34, 37, 0),
    30: ("GET_RV", 89, 38, 40, 0),
    32: ("GET_CP", 86, 43, 43, COMPASS),
    35: ("GET_BP", 87, 33, 33, BUMPER),
}
"""Requests for a part of State: name, type of the reply, first and last element, sensors."""

Elements: TypeAlias = Sequence[int]
Command: TypeAlias = tuple[int, Callable[[Elements], Request | None]]
"""The number of elements of a command, and the request that it makes; None if it rejects them."""


def _sizes(name: str) -> Callable[[Elements], Request]:
    """Return a command whose numbers lose their signs, as in the robot's own protocol."""
    return lambda elements: make_request(name, *map(abs, elements))


def _as_they_are(name: str) -> Callable[[Elements], Request]:
    return lambda elements: make_request(name, *elements)


def _bytes(name: str) -> Callable[[Elements], Request]:
    return lambda elements: make_request(name, *(each & 255 for each in elements))


def _mv(elements: Elements) -> Request | None:
    return make_request("MV", *elements) if all(0 <= each <= 5 for each in elements[::2]) else None


def _ws(elements: Elements) -> Request:
    return make_request("WS", *(int(each != 0) for each in elements[:3]), elements[3] & 255)


def _conf_ls(elements: Elements) -> Request:
    mode, threshold, width, points, averaged = elements
    return make_request(
        "CONF_LS", mode & 255, threshold & 255, width & 255, points & 0xFFFF, averaged & 255
    )


_COMMANDS: Final[dict[int, Command]] = {
    10: (3, _sizes("AC")),
    11: (3, _sizes("SP")),
    12: (3, _as_they_are("VM")),
    13: (3, _as_they_are("PR")),
    15: (0, _as_they_are("GS")),
    17: (0, _as_they_are("ST")),
    18: (0, _as_they_are("LP")),
    20: (0, _as_they_are("ZR")),
    21: (2, _as_they_are("DP")),
    22: (17, lambda all_: firing_order("CONF_IR", min(all_[0] & 255, 10), all_[1:])),
    23: (17, lambda all_: firing_order("CONF_SN", all_[0] & 255, all_[1:])),
    24: (1, _bytes("CONF_CP")),
    25: (5, _conf_ls),
    26: (1, _bytes("CONF_TM")),
    36: (3, _bytes("CONF_SG")),
    38: (2, _as_they_are("DA")),
    39: (4, _ws),
    43: (6, _mv),
}
"""The commands that are answered with all of State."""


class NserverClient:
    """One client of the server, and its configuration.

    Attributes:
        has_quit: whether it has ended the server, for itself.
    """

    def __init__(self, port: int) -> None:
        """Store the port that is sent to the client."""
        self.has_quit = False
        self._port = port
        self._mask = Mask()
        self._laser_mode = _FIRST_MODE
        self._state = [0] * NUM_STATE
        self._laser: list[int] = []
        self._readings = 0

    def answer(self, packet: Packet) -> Exchange[Packet | None]:
        """Return the exchange that answers a packet; it returns the reply, None for no reply."""
        kind, elements = packet.type, packet.elements
        if kind in _COMMANDS:
            return (yield from self._command(*_COMMANDS[kind], packet))
        if kind in _GROUPS:
            return (yield from self._group(*_GROUPS[kind]))
        own = self._others.get(kind)
        if own is not None:
            return (yield from own(elements))
        return (yield from world.answer(packet, partial(self._read_laser, is_predicted=True)))

    @property
    def _others(self) -> dict[int, Callable[[Elements], Exchange[Packet | None]]]:
        return {
            16: self._ct,
            19: self._tk,
            31: self._get_ra,
            33: self._get_ls,
            37: self._get_sg,
            QUIT: self._quit,
            CREATE: partial(self._connect, "CREATE"),
            CONNECT: partial(self._connect, "CONNECT"),
            DISCONNECT: self._disconnect,
            300: self._special,
        }

    # -- the connection --------------------------------------------------------------------------

    def _connect(self, name: str, elements: Elements) -> Exchange[Packet]:
        yield make_request(name, *elements[:1], 0)
        return Packet(_REPLY, (self._port,))

    def _disconnect(self, elements: Elements) -> Exchange[None]:
        yield make_request("DISCONNECT", *elements[:1])

    def _quit(self, _elements: Elements) -> Exchange[Packet]:
        yield make_request("QUIT_SERVER")
        self.has_quit = True
        return Packet(_REPLY)

    # -- State -----------------------------------------------------------------------------------

    def _command(
        self, count: int, ask: Callable[[Elements], Request | None], packet: Packet
    ) -> Exchange[Packet]:
        request = ask(packet.elements) if len(packet.elements) == count else None
        if request is None:
            return refusal()
        if request.code == CODES["CONF_LS"]:
            self._laser_mode = packet.elements[0]
        return (yield from self._ask_state(request))

    def _ct(self, elements: Elements) -> Exchange[Packet]:
        if len(elements) != 7:
            return refusal()
        self._mask = Mask.of_nclient(elements)
        return (yield from self._ask_state(make_request("CT", data=self._mask.content)))

    def _ask_state(self, request: Request) -> Exchange[Packet]:
        """Post a request, and reply with all of State, the laser's readings and positions."""
        reply = yield request
        if not reply["result"]:
            return refusal()
        for element, number in enumerate(numbers_in(reply)[: NUM_STATE - 1]):
            if element in _ALWAYS or self._mask.selects(element):
                self._state[element] = number
        if self._mask.selects(_LASER):
            self._readings = int(reply["i"][0])
            self._laser = yield from self._read_laser(self._readings)
        positions = yield from self._positions(self._mask.positions)
        laser = self._laser if self._mask.selects(_LASER) else self._kept_laser()
        return Packet(
            _STATE,
            (
                *self._state, self._readings, *laser, *positions,
                int(reply["f"][0]), int(reply["i"][1]), int(reply["i"][2]),
            ),
        )  # fmt: skip

    def _kept_laser(self) -> list[int]:
        """Return the readings of an earlier reply, as many numbers as the client now expects."""
        wanted = self._readings * self._laser_width
        return (self._laser + [0] * wanted)[:wanted]

    @property
    def _laser_width(self) -> int:
        """How many numbers the client reads for each of the laser's readings."""
        mode = self._laser_mode
        return 4 if mode in _SEGMENT_MODES else 2 if mode in _POINT_MODES else 1

    def _read_laser(self, count: int, *, is_predicted: bool = False) -> Exchange[list[int]]:
        return (yield from read_laser(count, self._laser_width, is_predicted=is_predicted))

    def _positions(self, kinds: int) -> Exchange[list[int]]:
        found: list[int] = []
        for kind, count in _RINGS.items():
            if kinds & kind:
                for each in (yield from read_positions(kind, count)):
                    found += each
        return found

    # -- groups ----------------------------------------------------------------------------------

    def _group(self, name: str, kind: int, first: int, last: int, sensor: int) -> Exchange[Packet]:
        reply = yield make_request(name)
        if not reply["result"]:
            return refusal()
        values = numbers_in(reply)[first : last + 1]
        if not sensor:
            return Packet(kind, tuple(values))
        positions = yield from self._positions(self._mask.positions & sensor)
        return Packet(kind, (*values, *positions, int(reply["f"][0])))

    def _get_ra(self, _elements: Elements) -> Exchange[Packet]:
        reply = yield make_request("GET_RA")
        return Packet(90, tuple(reply["i"][3:6].tolist())) if reply["result"] else refusal()

    def _get_ls(self, _elements: Elements) -> Exchange[Packet]:
        if self._laser_mode in _SEGMENT_MODES:
            self._laser_mode = _FIRST_MODE  # as the client does
        return (yield from self._scan("GET_LS"))

    def _get_sg(self, _elements: Elements) -> Exchange[Packet]:
        self._laser_mode = _SEGMENTS  # permanently: the code that restores it is never reached
        return (yield from self._scan("GET_SG"))

    def _scan(self, name: str) -> Exchange[Packet]:
        reply = yield make_request(name)
        if not reply["result"]:
            return refusal()
        count, board_ms = int(reply["i"][0]), int(reply["f"][0])
        readings = yield from self._read_laser(count)
        positions = yield from self._positions(self._mask.positions & LASER)
        return Packet(85, (count, *readings, *positions, board_ms))

    # -- others ----------------------------------------------------------------------------------

    def _tk(self, elements: Elements) -> Exchange[Packet]:
        # The client packs the characters in its own order, and then swaps each four of them.
        text = b"".join((each & 0xFFFFFFFF).to_bytes(4, "little") for each in elements[:64])
        yield from speak(text)
        return Packet(_REPLY)

    def _special(self, elements: Elements) -> Exchange[Packet]:
        content = bytes(each & 255 for each in elements)
        reply = yield make_request("SPECIAL", len(content), data=content)
        answer: Any = reply["data"][: int(reply["size"])]
        return Packet(_REPLY, tuple(answer.tolist())) if reply["result"] else refusal()


def refusal(code: int = _REFUSED) -> Packet:
    """Return the reply of a request that failed."""
    return Packet(_ERROR, (code,))
