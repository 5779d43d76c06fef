"""The log of messages that pages list."""

from __future__ import annotations

from typing import Any

from crs_cc.recording.message_contents import MessageContents
from crs_cc.workbench import message_log
from crs_cc.workbench.message_log import MAX_SENT, MessageLog, recorded_rows

COLUMNS: dict[str, list[Any]] = {
    "time_s": [0.5, 0.6], "fate": ["sent", "shut"], "channel": [0, 0], "sender": [0, 0],
    "receiver": [-1, 1], "group": [-1, -1], "type": [7, 7], "bytes": [3, 3], "number": [0, 0],
}  # fmt: skip


def test_missing_messages_are_sent_in_pieces_and_later_ones_discarded() -> None:
    log = MessageLog()
    log.add(recorded_rows(COLUMNS, {"sent": 0, "shut": 7}, MessageContents()))
    assert [row[:5] for row in log.since(0)["rows"]] == [[0.5, 0, 0, 0, -1], [0.6, 7, 0, 0, 1]]
    assert log.since(1)["rows"][0][1] == 7
    assert log.since(2)["rows"] == []
    assert log.since(0)["fates"][7] == ["shut", "lost: link outage"]
    log.truncate(0.55)
    assert log.since(0)["end"] == 1


def test_the_log_is_bounded() -> None:
    log = MessageLog()
    row = recorded_rows(COLUMNS, {"sent": 0}, MessageContents())[0]
    log.add([row] * (message_log.MAX_ROWS + 1))
    found = log.since(0)
    assert found["first"] == message_log.MAX_ROWS // 2
    assert len(found["rows"]) == MAX_SENT
    assert found["end"] == message_log.MAX_ROWS + 1
