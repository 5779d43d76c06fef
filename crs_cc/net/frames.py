"""The layout of the messages of a round in memory: header, fixed fields, and changes of rows.

Messages are received where the kernel reads changes, and sent from where it packs them. So the
header and the fixed fields have space in front of changes, which are aligned to words. The kernel
reads and writes the fixed fields, see `kernels/main.c`; `Channel` does so with the header.
"""

from __future__ import annotations

import struct
from typing import Final

from crs_cc.net.channel import HEAD_BYTES

GRANT: Final = struct.Struct("<Qd?3x")
"""Number of the grant, end of the cycle [s], whether an answer is expected; changes follow."""

RAN: Final = struct.Struct("<QI")
"""Number of the grant, number of rounds; changes follow."""

GRANT_FRONT: Final = HEAD_BYTES + GRANT.size
RAN_FRONT: Final = HEAD_BYTES + RAN.size
"""The size of header and fixed fields [bytes]."""

FRONT_WORDS: Final = 5
"""The space in front of changes [words of 8 bytes]."""
