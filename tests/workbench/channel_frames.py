"""Frames of the channel, decoded as the page does it."""

from __future__ import annotations

import struct

_HEAD, _PRESENT = slice(9, 17), 17


def frame_in(message: bytes) -> bytes:
    """Return the frame in a message, with the planes of zeros that the channel leaves out."""
    head, (present,) = message[_HEAD], struct.unpack_from("<Q", message, _PRESENT)
    rows, left = int.from_bytes(head[4:], "little"), message[_PRESENT + 8 :]
    planes = b""
    for plane in range(4 * head[1]):
        is_there = present >> plane & 1
        planes += left[:rows] if is_there else bytes(rows)
        left = left[rows:] if is_there else left
    assert not left
    return head + planes
