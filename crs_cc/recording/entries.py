"""Events as entries in JSON: a message has those of an interval.

A message has 31 bytes of header in its chunk and 16 in the chunk's index, which is more than most
entries have.

>>> from crs_cc.recording.topics import EVENT
>>> gathered = Entries()
>>> gathered.add(EVENT, 1_500_000_000, {"kind": "left", "robot": 3})
44
>>> size = gathered.add(EVENT, 1_200_000_000, {"kind": "joined", "robot": 4})
>>> ((channel, time_ns, data),) = gathered.messages()
>>> channel.topic, time_ns, data.decode()[:60]
('/crs/event', 1500000000, '{"entries":[{"time_us":1200000,"kind":"joined","robot":4},{"')
>>> [(time_ns, entry["robot"]) for time_ns, entry in entries_of(data)]
[(1200000000, 4), (1500000000, 3)]
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any, Final

from crs_cc.recording.mcap_records import NS, Channel

SPAN_NS: Final = 120 * NS
"""A message's time is that of its last entry; the others are at most this much earlier."""

_US: Final = 1000  # nanoseconds
_COMPACT: Final = json.JSONEncoder(separators=(",", ":"))
_quoted: Final = json.encoder.encode_basestring_ascii  # which `encode` calls
_Entry = tuple[int, bytes]  # its time [us] and its JSON


class Entries:
    """The entries that are still to be written.

    Attributes:
        are_new: whether any were added since `take_unsaved`.
    """

    def __init__(self) -> None:
        """Create an empty collection."""
        self._found: dict[Channel, list[_Entry]] = {}
        self._saved_counts: dict[Channel, int] = {}
        self.are_new = False

    def add(self, channel: Channel, time_ns: int, data: Mapping[str, Any]) -> int:
        """Add an entry; return its size [bytes]."""
        time_us = round(time_ns / _US)
        content = _COMPACT.encode({"time_us": time_us, **data}).encode()
        self.put(channel, time_us, content)
        return len(content) + 1

    def add_text(
        self, channel: Channel, time_ns: int, stream: tuple[int, int], fields: Mapping[str, str]
    ) -> None:
        """Add an entry for a robot's output to a stream, faster than `add`."""
        time_us, (robot, number) = round(time_ns / _US), stream
        strings = ",".join([f'"{name}":{_quoted(text)}' for name, text in fields.items()])
        content = f'{{"time_us":{time_us},"robot":{robot},"stream":{number},{strings}}}'
        self.put(channel, time_us, content.encode())

    def put(self, channel: Channel, time_us: int, content: bytes) -> None:
        """Add an entry that is already JSON."""
        self._found.setdefault(channel, []).append((time_us, content))
        self.are_new = True

    def messages(self) -> Iterator[tuple[Channel, int, bytes]]:
        """Yield a message of each channel, with its time."""
        for channel, found in self._by_channel():
            yield channel, *_message(found)

    def take_unsaved(self) -> Iterator[tuple[str, int, bytes]]:
        """Yield the entries that were added since the last call, with topics and times [us]."""
        self.are_new = False
        for channel, found in self._by_channel():
            begin = self._saved_counts.get(channel, 0)
            self._saved_counts[channel] = len(found)
            for time_us, content in found[begin:]:
                yield channel.topic, time_us, content

    def _by_channel(self) -> list[tuple[Channel, list[_Entry]]]:
        """Return the entries in an order that does not depend on when they were added."""
        return sorted(self._found.items(), key=lambda each: each[0].topic)


def _message(found: list[_Entry]) -> tuple[int, bytes]:
    """Return the time [ns] and the content of a message."""
    ordered = sorted(found, key=lambda each: each[0])
    content = b",".join([each for _, each in ordered])
    return ordered[-1][0] * _US, b'{"entries":[' + content + b"]}"


def entries_of(message: bytes) -> list[tuple[int, dict[str, Any]]]:
    """Return the entries in a message, each with its time [ns].

    Raises:
        ValueError: the message is invalid.
        RecursionError: it is nested too deeply.
    """
    content = json.loads(message)
    entries = content.get("entries") if isinstance(content, dict) else None
    if not isinstance(entries, list):
        raise ValueError("a message has no entries")  # noqa: TRY004 - the file is wrong
    found = []
    for entry in entries:
        time_us = entry.pop("time_us", None) if isinstance(entry, dict) else None
        if type(time_us) is not int or not 0 <= time_us < 2**53:
            raise ValueError("an entry has no valid time_us")
        found.append((time_us * _US, entry))
    return found
