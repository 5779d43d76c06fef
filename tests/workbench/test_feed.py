"""The data of a run is sent once to every page, and is bounded."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.workbench import feed as module
from crs_cc.workbench.clients import Client
from crs_cc.workbench.feed import MAX_OUTPUT, Feed


class LateServer:
    """Hands messages to pages only later, as the server's thread may do."""

    def __init__(self) -> None:
        self.sent, self.page_count = 0, 1
        self.late: list[tuple[int, str]] = []

    def broadcast(self, message: str) -> None:
        self.sent += 1
        self.late.append((self.sent, message))

    def broadcast_frame(self, time_s: float, values: FloatArray) -> None:
        """Frames that are missed are fetched in blocks."""

    def deliver(self, client: Client) -> None:
        for number, message in self.late:
            if number > client.since:
                client.put(message)


def taken(client: Client) -> list[dict[str, Any]]:
    found = []
    while (message := client.next_message()) is not None:
        assert isinstance(message, str)
        found.append(json.loads(message))
    return found


def test_a_page_that_connects_during_a_run_receives_everything_once() -> None:
    feed, server, client = Feed({}, 0.05), LateServer(), Client("view")
    feed.server = server  # type: ignore[assignment]
    feed.event(1.0, "collision", 0, "before")
    feed.greet(client)
    feed.event(2.0, "collision", 0, "after")
    server.deliver(client)
    hello, later = taken(client)
    assert [event[3] for event in hello["events"]] == ["before"]
    assert later["event"][3] == "after"


def test_pages_have_every_frame_while_the_run_is_stopped() -> None:
    feed, server, first, second = Feed({}, 0.05), LateServer(), Client("view"), Client("view")
    feed.server = server  # type: ignore[assignment]
    feed.greet(first)
    for number in range(30):
        feed.frame(number / 20, np.zeros((3, 1)))
    feed.greet(second)  # closes a block
    for number in range(30, 45):
        feed.frame(number / 20, np.zeros((3, 1)))
    feed.flush()
    server.deliver(first)
    server.deliver(second)
    (_, *blocks), (hello, *more) = taken(first), taken(second)
    spans = [each["block"] for each in blocks]
    assert [span[1] for span in spans[1:]] == [round(span[2] + 0.05, 9) for span in spans[:-1]]
    assert (spans[0][1], spans[-1][2]) == (0.0, 2.2)
    assert [*hello["blocks"], *(each["block"] for each in more)] == spans


def test_truncated_data_is_not_sent_again() -> None:
    feed, client = Feed({}, 0.05), Client("view")
    for time_s in (1.0, 2.0, 3.0):
        feed.event(time_s, "collision", 0, "")
        feed.write(time_s, 0, 1, b"x")
    feed.truncate(2.0)
    feed.greet(client)
    hello = taken(client)[0]
    assert [each[0] for each in hello["events"]] == [each[0] for each in hello["output"]] == [1, 2]
    assert hello["end_s"] == 2.0


def test_output_of_an_endless_program_is_bounded() -> None:
    feed, client = Feed({}, 0.05), Client("view")
    for number in range(12):
        feed.write(float(number), 0, 1, b"x" * (MAX_OUTPUT // 5))
    for number in range(module.MAX_EVENTS + 10):
        feed.event(float(number), "other", -1, "")
    feed.greet(client)
    hello = taken(client)[0]
    assert sum(len(each[3]) for each in hello["output"]) < MAX_OUTPUT
    assert hello["output"][-1][0] == 11
    assert len(hello["events"]) < module.MAX_EVENTS
