"""The messages of the channel."""

from __future__ import annotations

import struct

import numpy as np

from crs_cc.recording.frames import encode
from crs_cc.workbench.messages import frame_message


def test_a_frame_without_its_planes_of_zeros_is_whole_again() -> None:
    """As `withZeros` of the page does it: a bit for each plane that is there."""
    frames = np.array([[[1.0, np.nan, 3.0], [0.0, 0.0, 0.0]]] * 2)
    frames[1, 0, 0] += 0.01
    for frame in encode(frames):
        sent = frame_message(2.5, frame)
        assert struct.unpack_from("<cd", sent) == (b"F", 2.5)
        head, (present,) = sent[9:17], struct.unpack_from("<Q", sent, 17)
        planes, rest = b"", sent[25:]
        for plane in range(4 * 2):
            is_there = present >> plane & 1
            planes += rest[:3] if is_there else bytes(3)
            rest = rest[3:] if is_there else rest
        assert (head + planes, rest) == (frame, b"")
    assert len(sent) == 25 + 3  # of the difference, the lowest bytes of x only
