"""A client of the Nserver, written from a description of the vendor's Nclient 2.7 and not from it.

It sends what that sends, and fills `state` from replies as that does.
"""

from __future__ import annotations

import contextlib
import socket
import struct

ERROR, IPC_ERROR = 91, 111
NUM_STATE = 45


class Nclient:
    def __init__(self, port: int, *, is_wide: bool = False, pid: int = 4711) -> None:
        self.port, self.is_wide, self.pid = port, is_wide, pid
        self.state = [0] * NUM_STATE
        self.laser: list[int] = []
        self.mask = [0] + [1] * 43
        self.used_mask = 0
        self.laser_mode = 51
        self.positions: list[list[int]] = []
        self.board_ms = self.cpu = self.motor = 0
        self.printed: list[str] = []
        self.received: list[int] = []
        self._socket: socket.socket | None = None

    # -- packets ---------------------------------------------------------------------------------

    def packet(self, kind: int, *elements: int) -> bytes:
        header = struct.pack(">HH", kind, len(elements))
        if not self.is_wide or not elements:
            return header + b"".join(struct.pack(">i", each) for each in elements)
        body = b"".join(struct.pack(">i", each) + bytes(4) for each in elements)
        return (header + bytes(4) + body)[: 4 + 8 * len(elements)]

    def send(self, kind: int, *elements: int) -> None:
        assert self._socket is not None
        self._socket.sendall(self.packet(kind, *elements))

    def _receive(self, size: int) -> bytes:
        assert self._socket is not None
        content = b""
        while len(content) < size:
            more = self._socket.recv(size - len(content))
            if not more:
                raise ConnectionError
            content += more
        return content

    def exchange(self, kind: int, *elements: int) -> int | None:
        """Return the type of the reply, whose elements are in `received`; None without one."""
        if self._socket is None:
            self.printed.append("Not connected to any robot")
            return None
        try:
            self.send(kind, *elements)
            reply, count = struct.unpack(">HH", self._receive(4))
            step = 8 if self.is_wide else 4
            content = self._receive(step * count)
        except OSError:
            return None
        self.received = [
            struct.unpack_from(">i", content, place)[0] for place in range(0, len(content), step)
        ]
        return int(reply)

    def ask(self, kind: int, *elements: int) -> bool:
        """Return whether there is a reply that is not an error."""
        reply = self.exchange(kind, *elements)
        if reply is None:
            self.state[44] = IPC_ERROR
        elif reply == ERROR:
            self.state[44] = self.received[0]
        return reply not in (None, ERROR)

    def tell(self, kind: int, *elements: int) -> int:
        """Return 1 if there is any reply."""
        if self.exchange(kind, *elements) is None:
            self.state[44] = IPC_ERROR
            return 0
        return 1

    # -- replies ---------------------------------------------------------------------------------

    def _laser_numbers(self, count: int) -> int:
        if self.laser_mode in (1, 33):
            return 4 * count
        return 2 * count if self.laser_mode in (19, 50, 51) else count

    def _take_laser(self, at: int) -> int:
        count = self.received[at]
        end = at + 1 + self._laser_numbers(count)
        self.laser = [count, *self.received[at + 1 : end]]
        return end

    def _take_positions(self, at: int, kinds: int) -> int:
        for kind, count in ((1, 16), (2, 16), (4, 1), (8, 1), (16, 1)):
            for _ in range(count if kinds & kind else 0):
                self.positions.append(self.received[at : at + 9])
                at += 9
        return at

    def state_call(self, kind: int, *elements: int) -> int:
        if not self.ask(kind, *elements):
            return 0
        self.state = [*self.received[:44], 0]
        at = self._take_laser(45)
        self.positions = []
        at = self._take_positions(at, self.used_mask)
        self.board_ms, self.cpu, self.motor = self.received[at : at + 3]
        assert len(self.received) == at + 3
        return 1

    def group(self, kind: int, first: int, last: int, sensor: int) -> int:
        if not self.ask(kind):
            return 0
        count = last - first + 1
        self.state[first : last + 1] = self.received[:count]
        if sensor:
            self.positions = []
            at = self._take_positions(count, self.used_mask & sensor)
            self.board_ms = self.received[at]
            assert len(self.received) == at + 1
        return 1

    def scan(self, kind: int) -> int:
        if kind == 37:
            self.laser_mode = 33
        elif self.laser_mode in (1, 33):
            self.laser_mode = 51
        if not self.ask(kind):
            return 0
        at = self._take_positions(self._take_laser(0), self.used_mask & 8)
        assert len(self.received) == at + 1
        return 1

    # -- calls -----------------------------------------------------------------------------------

    def connect_robot(self, robot: int = 1) -> int:
        self.laser_mode = 51
        self._socket = socket.create_connection(("127.0.0.1", self.port), timeout=30)
        self.ask(102, robot, self.pid)
        port = self.received[0]
        if port:
            self.mask = [0] + [1] * 43
            self.ct()
        return port

    def disconnect_robot(self, robot: int = 1) -> int:
        if self._socket is None:
            self.printed.append("Not connected to any robot")
            self.state[44] = IPC_ERROR
            return 0
        with contextlib.suppress(OSError):
            self.send(103, robot, self.pid)
        self.vanish()
        return 1

    def vanish(self) -> None:
        assert self._socket is not None
        self._socket.close()
        self._socket = None

    def ct(self) -> int:
        flags = [int(each > 0) for each in self.mask]
        packed = [sum(flags[1 + 8 * i + bit] << bit for bit in range(8)) for i in range(5)]
        self.used_mask = self.mask[0] & 255
        last = int(self.used_mask != 0) | flags[41] << 1 | flags[42] << 2 | flags[43] << 3
        return self.state_call(16, *packed, last, self.used_mask)

    def pos_data_request(self, kinds: int) -> int:
        self.mask[0] = kinds
        self.ct()
        return 1

    def mv(self, *modes: int) -> int:
        return self.state_call(43, *modes) if all(0 <= each <= 5 for each in modes[::2]) else 0

    def conf_ls(self, *numbers: int) -> int:
        done = self.state_call(25, *numbers)
        if self._socket is not None:
            self.laser_mode = numbers[0]
        return done

    def tk(self, text: str) -> int:
        content = text.encode("latin-1") + b"\0"
        content += bytes(-len(content) % 4)
        return self.tell(19, *struct.unpack(f"<{len(content) // 4}i", content))

    def get_rpx(self) -> int:
        return int(self.ask(75))

    def motion_check(self, *numbers: float) -> int:
        kind, a1, a2, a3, a4, *rest = numbers
        angular = 100 if kind == 0 else 1e6
        scaled = [a1 * 100, a2 * 100, a3 * angular, a4 * angular, *(100 * each for each in rest)]
        reply = self.exchange(400, int(kind), *map(int, scaled))
        if reply is None:
            self.state[44] = IPC_ERROR
            return 0
        return self.received[0]

    def special_request(self, packet: bytes) -> int:
        return int(self.ask(300, *packet))
