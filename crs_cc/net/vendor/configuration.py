"""The settings common to both of the vendor's protocols: the mask, the order of sensors, speech.

>>> mask = Mask.of_nclient((255, 255, 255, 255, 255, 15, 2))
>>> mask.positions, mask.selects(43), sum(mask.content[1:])
(2, True, 43)
>>> Mask().selects(17), Mask().positions
(True, 0)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Self

from crs_cc.net.vendor.exchange import Exchange, Request, make_request

NUM_MASK: Final = 44
_END: Final = 255
_SENSORS: Final = 16
_HARMLESS: Final = bytes(
    ord("?") if each < 32 or 127 <= each < 160 else each for each in range(256)
)


@dataclass(frozen=True, slots=True)
class Mask:
    """The vendor's `Smask`: which elements of State replies renew.

    Attributes:
        content: one byte each; the first has the kinds of sensors whose positions follow. At
            first all elements are selected, and no positions.
    """

    content: bytes = bytes((0, *[1] * (NUM_MASK - 1)))

    @classmethod
    def of_nclient(cls, elements: Sequence[int]) -> Self:
        """Return it from the seven elements of Nclient's CT."""
        flags = [(each >> bit) & 1 for each in elements[:5] for bit in range(8)]
        flags += [(elements[5] >> bit) & 1 for bit in (1, 2, 3)]
        return cls(bytes((elements[6] & 255, *flags)))

    @classmethod
    def of_ndirect(cls, content: bytes) -> Self:
        """Return it from the seven bytes of Ndirect's CT, which do not have the motor status."""
        flags = [(each >> bit) & 1 for each in content[:5] for bit in range(8)]
        return cls(bytes((content[6] >> 1 & 31, *flags, 1, content[5] & 1, content[6] & 1)))

    def selects(self, element: int) -> bool:
        """Return whether replies renew an element of State."""
        return self.content[element] != 0

    @property
    def positions(self) -> int:
        """The kinds of sensors whose positions replies have, as the vendor's bits."""
        return self.content[0]


def firing_order(name: str, value: int, order: Sequence[int]) -> Request:
    """Return a request that sets the order of sensors, which ends before the first 255."""
    sensors = [each & 255 for each in order[:_SENSORS]]
    end = sensors.index(_END) if _END in sensors else len(sensors)
    return make_request(name, value, data=bytes(sensors[:end]))


def speak(text: bytes) -> Exchange[None]:
    """Print a text up to its null character as output of the robot's program, on one line.

    Control characters are replaced, as a client outside is not to rule the user's terminal.
    """
    text = text.partition(b"\0")[0][:247].translate(_HARMLESS)
    yield make_request("TK", data=text)
    yield make_request("WRITE", 1, data=text + b"\n")
