"""A program on a robot's line, written from a description of the vendor's Ndirect 2.7."""

from __future__ import annotations

import os
import select
import socket
import struct
from collections.abc import Callable

NUM_STATE = 45
NAK = 8
FIXED = [0] * 17 + [1] * 25 + [0, 1]
ALL = [0] + [1] * 43


def s16(value: int) -> bytes:
    magnitude = abs(value)
    return bytes((magnitude % 256, (magnitude // 256 + (128 if value < 0 else 0)) & 255))


def number(content: bytes) -> int:
    magnitude = content[0] + 256 * (content[1] & 127)
    return -magnitude if content[1] & 128 else magnitude


class Ndirect:
    """Attributes: `state` and `laser` are as that library fills them."""

    def __init__(self, model: int, read: Callable[[float], bytes], write: Callable[[bytes], int]):
        self.is_n200, self.is_scout = model == 0, model == 2
        self.mask = list(ALL if self.is_n200 else FIXED)
        self.read, self.write = read, write
        self.state, self.laser = [0] * NUM_STATE, [0]
        self.positions: list[list[int]] = []
        self.board_ms = 0
        self.printed: list[str] = []

    # -- packets ---------------------------------------------------------------------------------

    def send(self, kind: int, data: bytes = b"") -> None:
        body = b"\x01" + struct.pack("<HB", len(data) + 2, kind) + data
        self.write(body + bytes((sum(body) & 255, 0x5C)))

    def receive(self) -> tuple[int, bytes]:
        """Return type and data of a packet; raise TimeoutError if none comes."""
        content = b""
        while len(content) < 3 or len(content) < struct.unpack_from("<H", content, 1)[0] + 4:
            more = self.read(10.0)
            if not more:
                raise TimeoutError
            content += more
        assert content[0] == 1
        assert content[-1] == 0x5C
        assert content[-2] == sum(content[:-2]) & 255
        assert len(content) == struct.unpack_from("<H", content, 1)[0] + 4
        return content[3], content[4:-2]

    def exchange(self, kind: int, data: bytes = b"") -> bytes | None:
        """Return the data of the reply; None after a NAK."""
        self.send(kind, data)
        reply, content = self.receive()
        if reply == NAK:
            self.printed.append("Nak")
            return None
        assert reply == kind
        return content

    # -- replies ---------------------------------------------------------------------------------

    def state_call(self, kind: int, data: bytes = b"") -> int:
        content = self.exchange(kind, data)
        if content is not None:
            rest = self._take_state(content)
            assert rest == b""
        return 1

    def _take_state(self, content: bytes) -> bytes:
        self.positions = []
        infrared = [at for at in range(1, 17) if self.mask[at]]
        size = (len(infrared) + 1) // 2
        for place, at in enumerate(infrared):
            self.state[at] = content[place // 2] >> 4 * (place % 2) & 15
        content = self._take_blocks(content[size:], 1, len(infrared))
        sonars = [at for at in range(17, 33) if self.mask[at]]
        for place, at in enumerate(sonars):
            self.state[at] = content[place]
        content = self._take_blocks(content[len(sonars) :], 2, len(sonars))
        if self.mask[33]:
            self.state[33] = int.from_bytes(content[:3], "little" if self.is_scout else "big")
            content = self._take_blocks(content[3:], 4, 1)
        for at in range(34, 41):
            if self.mask[at]:
                self.state[at], content = number(content), content[2:]
        if self.mask[43]:
            self.state[43], content = number(content), content[2:]
            content = self._take_blocks(content, 16, 1)
        if self.mask[42]:
            content = self._take_segments(content)
            content = self._take_blocks(content, 8, 1)
        self.state[41] = content[0]
        self.board_ms = struct.unpack_from("<I", content, 1)[0]
        return content[7:]

    def _take_blocks(self, content: bytes, kind: int, count: int) -> bytes:
        for _ in range(count if self.mask[0] & kind else 0):
            self.positions.append(list(struct.unpack_from("<9I", content)))
            content = content[36:]
        return content

    def _take_segments(self, content: bytes) -> bytes:
        count, end = struct.unpack_from("<H", content)[0], 2
        numbers = []
        for _ in range(4 * count):
            numbers.append(number(content[end:]))
            end += 2
        self.laser = [count, *numbers]
        return content[end:]

    def group(self, kind: int, take: Callable[[bytes], None]) -> int:
        content = self.exchange(kind)
        if content is not None:
            take(content)
        return 1

    def get_sn(self) -> int:
        def take(content: bytes) -> None:
            self.state[17:33] = content[:16]
            assert len(content) == 16 + 4 + (36 * 16 if self.mask[0] & 2 else 0)

        return self.group(20, take)

    def get_ir(self) -> int:
        def take(content: bytes) -> None:
            self.state[1:17] = [content[at // 2] >> 4 * (at % 2) & 15 for at in range(16)]
            assert len(content) == 8 + 4

        return self.group(19, take)

    def get_bp(self) -> int:
        def take(content: bytes) -> None:
            self.state[33] = int.from_bytes(content[:3], "little" if self.is_scout else "big")
            assert len(content) == 3 + 4

        return self.group(27, take)

    def get_cp(self) -> int:
        def take(content: bytes) -> None:
            self.state[43] = struct.unpack_from("<H", content)[0]
            assert len(content) == 2 + 4

        return self.group(24, take)

    def numbers(self, kind: int, first: int, last: int) -> int:
        def take(content: bytes) -> None:
            assert len(content) == 2 * (last - first + 1)
            for at in range(first, last + 1):
                self.state[at] = number(content[2 * (at - first) :])

        return self.group(kind, take)

    def get_ra(self) -> int:
        return self.group(23, lambda _content: None)

    def get_ls(self) -> int:
        def take(content: bytes) -> None:
            assert content == content[: len(content) // 2] * 2
            self.laser = [struct.unpack_from("<H", content)[0]]

        return self.group(25, take)

    def get_sg(self) -> int:
        def take(content: bytes) -> None:
            assert len(self._take_segments(content)) == 4

        return self.group(29, take)

    def conf_cp(self, mode: int) -> int:
        content = self.exchange(16, bytes((mode,)))
        if content is not None:
            x, y, z = content
            self.printed.append(f"compass calibration score x: {x} y: {y} z: {z}")
        return 1

    def ct(self) -> int:
        packed = [
            sum((self.mask[1 + 8 * i + bit] > 0) << bit for bit in range(8)) for i in range(5)
        ]
        last = int(self.mask[43] > 0) | (self.mask[0] & 31) << 1
        return self.state_call(6, bytes((*packed, int(self.mask[42] > 0), last)))

    def pos_data_request(self, kinds: int) -> int:
        if self.is_n200:
            self.mask[0] = kinds & 255
            self.ct()
        return 1


def over_terminal(name: str, model: int) -> Ndirect:
    place = os.open(name, os.O_RDWR | os.O_NOCTTY)

    def read(wait_s: float) -> bytes:
        return os.read(place, 4096) if select.select([place], [], [], wait_s)[0] else b""

    return Ndirect(model, read, lambda content: os.write(place, content))


def over_tcp(port: int, model: int) -> Ndirect:
    client = socket.create_connection(("127.0.0.1", port), timeout=10)

    def read(wait_s: float) -> bytes:
        client.settimeout(wait_s)
        return client.recv(4096)

    return Ndirect(model, read, client.send)
