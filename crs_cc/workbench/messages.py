r"""The channel between the page and the run: the format of its messages.

The page sends JSON: `{"id": 7, "command": "seek", "time_s": 12.5}`, see the table of commands. It
receives JSON with a `type`, or bytes: a letter for the kind, and the content. An answer has the
`id` of its command and either a `value` or an `error`.

>>> answer(7, {"time_s": 12.5})
'{"type":"answer","id":7,"value":{"time_s":12.5}}'
>>> block_message(3, b"...")
b'B\x03\x00\x00\x00...'
"""

from __future__ import annotations

import json
import struct
from typing import Any, Final

import numpy as np

from crs_cc.recording.frames import HEAD

VERSION: Final = 3
"""The version of the channel. A page of another version reloads itself."""

PROTOCOL: Final = "crs.1"
"""The name of the WebSocket subprotocol."""

MAX_BYTES: Final = 64 * 1024
"""The maximum size of a message of the page."""

_FRAME: Final = struct.Struct("<cd")
_PRESENT: Final = struct.Struct("<Q")
_BLOCK: Final = struct.Struct("<cI")


def message(kind: str, /, **fields: Any) -> str:
    """Return a message for the page; numbers that JSON does not have become null."""
    return plain_text({"type": kind, **fields})


def answer(number: int, value: Any = None) -> str:
    """Return the answer to a command."""
    return plain_text({"type": "answer", "id": number, "value": value})


def refusal(number: int, error: str) -> str:
    """Return the answer to a command that failed."""
    return plain_text({"type": "answer", "id": number, "error": error})


def frame_message(time_s: float, frame: bytes) -> bytes:
    """Return the message of a frame.

    It has the format of a recording, but planes of zeros are omitted, such as the upper bytes of
    differences. A number before the planes has a bit for each that is present, from the lowest on.
    """
    rows = HEAD.unpack_from(frame)[-1]
    planes = np.frombuffer(frame, np.uint8, offset=HEAD.size).reshape(-1, max(1, rows))
    is_there = planes.any(axis=1)
    bits = sum(1 << plane for plane in np.flatnonzero(is_there).tolist())
    head = _FRAME.pack(b"F", time_s) + frame[: HEAD.size] + _PRESENT.pack(bits)
    return head + planes[is_there].tobytes()


def block_message(number: int, block: bytes) -> bytes:
    """Return the message of a block of frames."""
    return _BLOCK.pack(b"B", number) + block


def page_message(page: str) -> bytes:
    """Return the message of a run as one page."""
    return b"P" + page.encode()


def recording_message(content: bytes) -> bytes:
    """Return the message of a run as a recording."""
    return b"R" + content


def plain_text(content: dict[str, Any]) -> str:
    """Return JSON; numbers that it does not have become null."""
    try:
        return json.dumps(content, separators=(",", ":"), allow_nan=False)
    except ValueError:
        return json.dumps(_plain(content), separators=(",", ":"))


def _plain(value: Any) -> Any:
    """Return a value with null for numbers that are not finite."""
    if isinstance(value, float):
        return value if abs(value) < float("inf") else None
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    return value
