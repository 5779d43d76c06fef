"""How the messages of a round stand in a memory: a head, some numbers, and changes of rows.

They are received where changes are read, and sent from where they are packed. So in front of
changes there is room for the rest, with changes at a multiple of the size of a word. What stands
there is read and written by the kernel, see `kernels/main.c`, but for the head.
"""

from __future__ import annotations

import struct
from typing import Final

from crs_cc.net.channel import HEAD_BYTES

GRANT: Final = struct.Struct("<Qd?3x")
"""Number of the grant, end of the cycle [s], whether the answer is wanted; changes follow."""

RAN: Final = struct.Struct("<QI")
"""Number of the grant, rounds; changes follow."""

GRANT_FRONT: Final = HEAD_BYTES + GRANT.size
RAN_FRONT: Final = HEAD_BYTES + RAN.size
"""What stands in front of changes [bytes]."""

FRONT_WORDS: Final = 5
"""Room in front of changes [words of 8 bytes]."""
