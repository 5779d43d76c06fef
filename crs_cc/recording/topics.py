"""The channels of a recording.

Messages in JSON have entries, see `crs_cc.recording.entries`; `docs/recordings.md` describes all.
"""

from __future__ import annotations

from typing import Final

from crs_cc.recording.mcap_records import Channel

FORMAT_VERSION: Final = 6
"""Increased when a reader of today could not read what is written then."""

RUN: Final = "crs.run"
ROSTER: Final = "crs.roster."
RESULT: Final = "crs.result"
"""Names of metadata: the run, its robots and objects over time, and its result."""


def _entries(topic: str) -> Channel:
    return Channel(topic, "json")


FRAME: Final = Channel("/crs/frame", "crs.frame")
ODOMETRY: Final = Channel("/crs/odometry", "crs.frame")
STATE: Final = Channel("/crs/state", "crs.state")
READING: Final = _entries("/crs/reading")
EVENT: Final = _entries("/crs/event")
MESSAGE: Final = _entries("/crs/message")
OUTPUT: Final = _entries("/crs/output")
INPUT: Final = _entries("/crs/input")
HASH: Final = _entries("/crs/hash")
FIELD: Final = _entries("/crs/field")

TOPICS: Final = {
    channel.topic: channel
    for channel in (FRAME, ODOMETRY, STATE, READING, EVENT, MESSAGE, OUTPUT, INPUT, HASH, FIELD)
}
