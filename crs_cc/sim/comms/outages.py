"""Outages: channels, senders, receivers and pairs that are blocked for some time.

Each outage is a row of `MessageState.shuts`. A message is lost if its transmission begins at or
after the start of a row that matches it, and before its end. An outage set while the world runs
starts with the current cycle, or later.
"""

from __future__ import annotations

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records
from crs_cc.sim.comms.channels import Channels
from crs_cc.sim.model.communication import ANY
from crs_cc.sim.state.events import EventLog
from crs_cc.sim.state.messages import SHUT, MessageState


def shut(
    messages: MessageState,
    channel: int,
    sender: int,
    receiver: int,
    *,
    at_s: float,
    until_s: float = np.inf,
) -> None:
    """Start an outage at a time, now or later."""
    row = np.array([(at_s, until_s, channel, sender, receiver)], SHUT)
    messages.shuts = np.concatenate([messages.shuts, row])


def reopen(
    messages: MessageState, now_s: float, channel: int, sender: int, receiver: int, *, at_s: float
) -> bool:
    """End the outage with these numbers at a time, now or later; return whether there was one."""
    rows = messages.shuts
    from_s: FloatArray = rows["at_s"]
    until_s: FloatArray = rows["until_s"]
    same: BoolArray = rows["channel"] == channel
    same &= rows["sender"] == sender
    same &= rows["receiver"] == receiver
    same &= until_s > np.maximum(from_s, now_s)
    until_s[same] = np.maximum(from_s, at_s)[same]
    return bool(same.any())


def is_shut(
    messages: MessageState, packets: Records, packet: IndexArray, receiver: IndexArray
) -> BoolArray:
    """Return which messages are lost to an outage.

    Args:
        messages: has the outages.
        packets: the messages, of dtype `PACKET`.
        packet: row among them of each pair of message and receiver, shape (k,).
        receiver: the receiver of each.

    Returns:
        shape (k,).
    """
    found = np.zeros(len(packet), dtype=np.bool_)
    if not len(messages.shuts) or not len(packet):
        return found
    begins_s: FloatArray = packets["begins_s"]
    channel: Int32Array = packets["channel"]
    rows = messages.shuts
    starts_s: FloatArray = rows["at_s"]
    ends_s: FloatArray = rows["until_s"]
    rows = rows[(starts_s <= begins_s.max()) & (ends_s > begins_s.min())]
    for at_s, until_s, on, sender, to in rows.tolist():
        meant = (begins_s >= at_s) & (begins_s < until_s)
        meant &= (on == ANY) | (channel == on)
        meant &= (sender == ANY) | (packets["sender"] == sender)
        found |= meant[packet] & ((to == ANY) | (receiver == to))
    return found


def log_changes(
    messages: MessageState,
    channels: Channels,
    robots: tuple[str, ...],
    *,
    from_s: float,
    to_s: float,
    log: EventLog,
) -> None:
    """Log the outages that started and ended between two times."""
    rows = messages.shuts
    starts_s: FloatArray = rows["at_s"]
    ends_s: FloatArray = rows["until_s"]
    changed = (starts_s >= from_s) & (starts_s < to_s)
    changed |= (ends_s >= from_s) & (ends_s < to_s)
    for row in rows[changed].tolist():
        for time_s, change in zip(row[:2], ("blocked", "unblocked"), strict=True):
            if from_s <= time_s < to_s and row[0] < row[1]:
                log.say(time_s, "message", f"{_name(row[2:], channels, robots)} {change}")


def _name(row: tuple[int, int, int], channels: Channels, robots: tuple[str, ...]) -> str:
    """Return the description of an outage's link.

    >>> from crs_cc.sim.model.communication import Communication
    >>> _name((0, 1, ANY), Channels.of(Communication()), ("a", "b"))
    'radio from b'
    """
    channel, sender, receiver = row
    words = ["all channels" if channel == ANY else channels.names[channel]]
    words += [f"from {robots[sender]}"] if sender != ANY else []
    words += [f"to {robots[receiver]}"] if receiver != ANY else []
    return " ".join(words)
