"""The channels of a recording.

Messages in JSON have the fields that their schemas list; `docs/recordings.md` describes all.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, Final

from crs_cc.recording.mcap_records import Channel

FORMAT_VERSION: Final = 3
"""Increased when a reader of today could not read what is written then."""

RUN: Final = "crs.run"
ROSTER: Final = "crs.roster."
RESULT: Final = "crs.result"
"""Names of metadata: what was run, who was there from when on, and how it ended."""


_COMPACT: Final = json.JSONEncoder(separators=(",", ":"))


def as_json(data: Mapping[str, Any]) -> bytes:
    """Return the content of a message in JSON."""
    return _COMPACT.encode(data).encode()


def _json(topic: str, name: str, **fields: str) -> Channel:
    properties = {field: {"type": kind} for field, kind in fields.items()}
    schema = {"title": name, "type": "object", "properties": properties}
    return Channel(topic, "json", name, "jsonschema", json.dumps(schema).encode())


FRAME: Final = Channel("/crs/frame", "crs.frame", "crs.Frame")
ODOMETRY: Final = Channel("/crs/odometry", "crs.frame", "crs.Frame")
STATE: Final = Channel("/crs/state", "crs.state", "crs.State")
READING: Final = _json(
    "/crs/reading", "crs.Reading",
    request="string", robot="array", time_s="array", values="array",
)  # fmt: skip
EVENT: Final = _json("/crs/event", "crs.Event", kind="string", robot="integer", text="string")
MESSAGE: Final = _json(
    "/crs/message", "crs.Message",
    time_s="array", fate="array", channel="array", sender="array", receiver="array", group="array",
    type="array", bytes="array", number="array",
)  # fmt: skip
OUTPUT: Final = _json(
    "/crs/output", "crs.Output", robot="integer", stream="integer", text="string", base64="string"
)
INPUT: Final = _json(
    "/crs/input", "crs.Input", kind="string", robot="integer", text="string", base64="string",
    position="array", patches="array",
)  # fmt: skip
HASH: Final = _json(
    "/crs/hash", "crs.Hash", timesteps="array", digest="array", output="array", state="array"
)

TOPICS: Final = {
    channel.topic: channel
    for channel in (FRAME, ODOMETRY, STATE, READING, EVENT, MESSAGE, OUTPUT, INPUT, HASH)
}

HASH_DIGITS: Final = 16
"""So many hexadecimal digits of a hash are recorded: enough to see that a run is another one."""
