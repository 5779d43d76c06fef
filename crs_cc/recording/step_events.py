"""The events of a timestep, as plain data for messages in JSON."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from crs_cc.requests import CODES, REQUESTS
from crs_cc.sim.comms.message_log import Fate
from crs_cc.sim.engine.server.drawing import ERASING
from crs_cc.sim.engine.step import reply_values

if TYPE_CHECKING:
    from crs_cc.core.arrays import Records
    from crs_cc.sim.engine.step import Served, Step

_DECIMALS = 6
_DRAW, _REFRESH = CODES["DRAW"], CODES["REFRESH"]
_FATES = [fate.name.lower() for fate in Fate]


def events_of(step: Step) -> Iterator[dict[str, Any]]:
    """Yield the contacts and other events of a timestep, each with `time_s`, `kind` and `text`."""
    yield from _collisions(step)
    for event in step.events:
        yield {
            "time_s": event.time_s, "kind": event.kind, "robot": event.robot, "text": event.text
        }  # fmt: skip


def marks_of(served: Served) -> Iterator[dict[str, Any]]:
    """Yield events for the marks that programs drew or erased by a request."""
    if served.code == _DRAW:
        yield from _marks(served)
    elif served.code == _REFRESH:
        yield from _erasures(served)


def _erasures(served: Served) -> Iterator[dict[str, Any]]:
    """Yield events that erased all marks."""
    rows = zip(
        served.robots.tolist(),
        served.clock_s.tolist(),
        served.arguments[:, 0].tolist(),
        strict=True,
    )
    for robot, clock_s, part in rows:
        if part in ERASING and np.isfinite(clock_s):
            yield {
                "time_s": clock_s, "kind": "erasing", "robot": robot, "text": "erased all marks"
            }  # fmt: skip


def _collisions(step: Step) -> Iterator[dict[str, Any]]:
    contacts = step.contacts
    for robot, other, x_m, y_m in zip(
        contacts.robot.tolist(),
        contacts.other.tolist(),
        contacts.x_m.tolist(),
        contacts.y_m.tolist(),
        strict=True,
    ):
        yield {
            "time_s": step.time_s,
            "kind": "collision",
            "robot": robot,
            "text": f"touched {step.names[other]}",
            "x_m": round(x_m, _DECIMALS),
            "y_m": round(y_m, _DECIMALS),
        }


def _marks(served: Served) -> Iterator[dict[str, Any]]:
    """Yield the marks that programs drew."""
    rows = zip(
        served.robots.tolist(),
        served.clock_s.tolist(),
        served.arguments.tolist(),
        served.results.tolist(),
        strict=True,
    )
    for robot, clock_s, mark, result in rows:
        if result and np.isfinite(clock_s):
            yield {
                "time_s": clock_s, "kind": "drawing", "robot": robot, "text": "drew a mark",
                "mark": mark,
            }  # fmt: skip


def traffic_of(traffic: Records, posted: Sequence[Records]) -> dict[str, list[Any]]:
    """Return the outcomes of messages, by column, with the content of sent ones.

    Args:
        traffic: what became of messages, of dtype `TRAFFIC`.
        posted: the messages that were posted at the same time, of dtype `PACKET`.
    """
    contents = {
        (int(packet["sender"]), int(packet["number"])): packet["data"][: packet["size"]]
        for packets in posted
        for packet in packets
    }
    senders, numbers = traffic["sender"].tolist(), traffic["number"].tolist()
    is_sent = (traffic["fate"] == Fate.SENT).tolist()
    said = [
        contents.get((sender, number)) if new else None
        for sender, number, new in zip(senders, numbers, is_sent, strict=True)
    ]
    return {
        "time_s": traffic["time_s"].round(_DECIMALS).tolist(),
        "fate": [_FATES[fate] for fate in traffic["fate"].tolist()],
        **{
            name: traffic[name].tolist()
            for name in ("channel", "sender", "receiver", "group", "type")
        },
        "bytes": traffic["size"].tolist(),
        "number": numbers,
        "content": [None if each is None else each.tobytes().hex() for each in said],
    }


def readings_of(served: Served) -> dict[str, Any] | None:
    """Return a reading sent to programs that is not in `State`, a row for each; None for none."""
    rows = [row for row, result in enumerate(served.results.tolist()) if result]
    if not rows:
        return None
    return {
        "request": REQUESTS[served.code].name,
        "robot": served.robots[rows].tolist(),
        "time_s": served.clock_s[rows].round(_DECIMALS).tolist(),
        "values": [list(reply_values(served, row)) for row in rows],
    }
