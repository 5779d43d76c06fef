"""The messages of the channel."""

from __future__ import annotations

import struct

import numpy as np

from crs_cc.recording.frames import encode
from crs_cc.workbench.messages import frame_message
from tests.workbench.channel_frames import frame_in


def test_a_frame_without_its_zero_planes_is_restored() -> None:
    frames = np.array([[[1.0, np.nan, 3.0], [0.0, 0.0, 0.0]]] * 2)
    frames[1, 0, 0] += 0.01
    for frame in encode(frames):
        sent = frame_message(2.5, frame)
        assert struct.unpack_from("<cd", sent) == (b"F", 2.5)
        assert frame_in(sent) == frame
    assert len(sent) == 25 + 3  # of the difference, the lowest bytes of x only
