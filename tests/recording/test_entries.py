"""Entries: what is asked for of a long message, and what is refused."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from crs_cc.recording.entries import Entries, entries_of
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.recording import Recording
from crs_cc.recording.topics import OUTPUT


def test_a_chunk_has_one_message_per_json_topic(recorded: Path) -> None:
    """A message of its own for each line printed took more bytes than the lines."""
    recording = Recording(recorded)
    for chunk in recording.mcap.chunks:
        counts = Counter(each.topic for each in recording.mcap.messages(chunk))
        assert set(counts.values()) == {1}, counts
    recording.close()


def test_entries_of_an_interval_are_found_wherever_their_message_ends(recorded: Path) -> None:
    recording = Recording(recorded)
    known = list(recording.data("/crs/output"))
    assert [time_ns for time_ns, _ in known] == sorted(time_ns for time_ns, _ in known)
    for since_ns, until_ns in ((0, NS), (NS // 2, NS), (3 * NS, 4 * NS), (5 * NS, 9 * NS)):
        wanted = [each for each in known if since_ns <= each[0] <= until_ns]
        assert list(recording.data("/crs/output", since_ns, until_ns)) == wanted
        assert wanted
    recording.close()


@pytest.mark.parametrize(
    "message",
    [
        b"[]",
        b"{}",
        b'{"entries":{}}',
        b'{"entries":[[]]}',
        b'{"entries":[{"robot":1}]}',
        b'{"entries":[{"time_us":1.5}]}',
        b'{"entries":[{"time_us":-1}]}',
        b'{"entries":[{"time_us":9007199254740992}]}',
        b'{"entries":[',
        b"\xff",
    ],
)
def test_a_message_without_entries_is_rejected(message: bytes) -> None:
    with pytest.raises(ValueError, match=r"entr|Expecting|decode"):
        entries_of(message)


@pytest.mark.parametrize(
    "text", ["plain\n", 'a "quote" \\ \t', "\u00e4\u20ac\U0001f916\x00\x7f", ""]
)
def test_output_is_encoded_like_other_entries(text: str) -> None:
    for fields in ({"text": text}, {"base64": "aGk="}):
        one, other = Entries(), Entries()
        one.add(OUTPUT, 1_234_567_890, {"robot": 3, "stream": 2, **fields})
        other.add_text(OUTPUT, 1_234_567_890, (3, 2), fields)
        assert [*one.messages()] == [*other.messages()]
