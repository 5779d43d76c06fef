"""Names and internet addresses of the computers on a network.

Robots are numbered from 10.0.0.1, in the world's order. The computer on which crs runs is `host`,
192.168.0.1; the others of the real network that a run can reach follow it.

>>> from ipaddress import IPv4Address
>>> addresses = Addresses(lambda: ["robot0", "robot1"], lambda: ("logger",))
>>> [str(IPv4Address(addresses.find(name, robot=0))) for name in ("robot1", "logger")]
['10.0.0.2', '192.168.0.2']
>>> addresses.name(ROBOTS + 1, robot=1), addresses.find("nobody", robot=0)
('robot0', None)
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

ROBOTS: Final = 10 << 24
"""The network of the robots, 10.0.0.0/8, one for private use (RFC 1918)."""

HOST: Final = 192 << 24 | 168 << 16 | 1
"""192.168.0.1, the computer on which crs runs."""

ANY: Final = 0
LOOPBACK: Final = 127 << 24 | 1
BROADCAST: Final = (0xFFFFFFFF, ROBOTS | 0xFFFFFF)

HOST_NAME: Final = "host"
_OWN_NAMES: Final = ("", "localhost", "robot")
"""A program's own computer; the last is what `gethostname` returns."""


class Addresses:
    """Who is on the network."""

    def __init__(
        self, robots: Callable[[], Sequence[str]], machines: Callable[[], Sequence[str]]
    ) -> None:
        """Store the functions that return the robots' names, and those of other computers."""
        self._robots = robots
        self._machines = machines

    def own(self, robot: int) -> int:
        """Return a robot's address."""
        return ROBOTS + robot + 1

    def is_own(self, address: int, robot: int) -> bool:
        """Return whether an address is one of a robot's."""
        return address in (ANY, self.own(robot)) or address >> 24 == LOOPBACK >> 24

    def robot(self, address: int, sender: int) -> int | None:
        """Return the robot that has an address, as another one sees it; None if none has."""
        if self.is_own(address, sender):
            return sender
        number = address - ROBOTS - 1
        return number if 0 <= number < len(self._robots()) else None

    def machine_name(self, address: int) -> str:
        """Return the name of a computer of the real network; empty if there is none."""
        names = (HOST_NAME, *self._machines())
        return names[address - HOST] if 0 <= address - HOST < len(names) else ""

    def find(self, name: str, robot: int) -> int | None:
        """Return the address of a name, as a robot's program sees it; None if it is unknown."""
        for first, names in (
            (ROBOTS + 1, self._robots()),
            (HOST, (HOST_NAME, *self._machines())),
        ):
            if name in names:
                return first + list(names).index(name)
        if name in _OWN_NAMES:
            return LOOPBACK if name == "localhost" else self.own(robot)
        return None

    def name(self, address: int, robot: int) -> str:
        """Return the name of an address, empty if it is unknown."""
        if address >> 24 == LOOPBACK >> 24:
            return "localhost"
        found, names = self.robot(address, robot), self._robots()
        if found is not None:
            return names[found]
        return self.machine_name(address)
