"""Frames, and values derived from them, as read from the messages of a recording."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.recording import topics
from crs_cc.recording.frames import FrameDecoder, is_group, is_key, quantized
from crs_cc.recording.mcap_records import Message
from crs_cc.recording.odometry import OdometryDecoder
from crs_cc.recording.odometry_prediction import OdometryPrediction

TimedFrame = tuple[int, FloatArray]
"""The time of a frame [ns], and its values [m, rad]."""


class FrameReader:
    """Reads where everything is, or where robots believe to be, from messages in their order.

    Attributes:
        topics: those of the messages that are needed.
    """

    def __init__(self, topic: str) -> None:
        """Read the frames of a topic."""
        self._topic = topic
        self.topics = tuple(dict.fromkeys((topics.FRAME.topic, topic)))
        self._frames, self._odometry = FrameDecoder(), OdometryDecoder()
        self._is_broken = True  # until the next key frame

    def frames(self, message: Message) -> list[TimedFrame]:
        """Return the frames in a message that are of the topic.

        Frames that cannot be decoded because one before them is lost are left out.
        """
        is_true = message.topic == topics.FRAME.topic
        try:
            found = self._true(message) if is_true else self._odometry_frames(message)
        except ValueError:
            if is_true:
                self._is_broken = True
                self._frames.reset()
            return []
        return found if message.topic == self._topic else []

    def _true(self, message: Message) -> list[TimedFrame]:
        if self._is_broken and not is_key(message.data):
            return []
        self._is_broken = False
        found = list(self._frames.frames(message.time_ns, message.data))
        if self._topic != topics.FRAME.topic:
            for number, (time_ns, values) in enumerate(found):
                first = number == 0 and is_key(message.data)
                self._odometry.note(time_ns, values, is_key=first)
        return found

    def _odometry_frames(self, message: Message) -> list[TimedFrame]:
        return list(self._odometry.frames(message.time_ns, message.data))


class OdometryPredictions:
    """The odometry that the groups of frames in a chunk lead to."""

    def __init__(self, messages: Sequence[Message]) -> None:
        """Take note of the messages of a chunk; nothing is decoded before it is asked for."""
        self._messages = messages
        self._made: dict[int, OdometryPrediction] = {}

    def of(self, begin_ns: int) -> OdometryPrediction:
        """Return the contents of the group with a timestamp; raise ValueError if there is none."""
        if begin_ns not in self._made:
            self._made[begin_ns] = self._prediction(begin_ns)
        return self._made[begin_ns]

    def _prediction(self, begin_ns: int) -> OdometryPrediction:
        true, estimates = list[TimedFrame](), list[TimedFrame]()
        reader = FrameReader(topics.ODOMETRY.topic)
        for message in self._messages:
            if message.topic == topics.ODOMETRY.topic:
                estimates += reader.frames(message)
            elif message.topic == topics.FRAME.topic:
                reader.frames(message)
                if message.time_ns == begin_ns and is_group(message.data):
                    true = list(FrameDecoder().frames(begin_ns, message.data))
        times_ns = {time_ns for time_ns, _ in true}
        known = [each for each in estimates if each[0] in times_ns]
        if not known or len({values.shape for _, values in known}) > 1:
            raise ValueError("the frames of readings are missing")
        return OdometryPrediction(
            np.array([time_ns for time_ns, _ in true]),
            quantized(np.array([values for _, values in true])),
            np.array([time_ns for time_ns, _ in known]),
            quantized(np.array([values for _, values in known])),
        )
