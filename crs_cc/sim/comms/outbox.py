"""The sender's side: messages wait until those before them have been sent.

Each robot has a sender of its own for each channel. Message i, posted at p_i, begins to be sent at

    b_i = max(p_i, b_(i-1) + (size_(i-1) + 12) / bandwidth)

While messages wait whose transmission has not begun, at most as many as the channel's queue holds,
a further one drops the oldest of them or is dropped itself. At most `MOST` messages of a robot lie
here at all, those included that have begun to be sent in this cycle: further ones are dropped,
however fast the channel is, so that a program that sends in a loop keeps nobody busy.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int64Array, Records
from crs_cc.sim.comms.channels import Channels
from crs_cc.sim.comms.message_log import Fate, note
from crs_cc.sim.state.messages import PACKET, MessageState

MOST: Final = 64


def post(messages: MessageState, channels: Channels, packets: Records) -> BoolArray:
    """Enqueue messages, at most one of each robot, at the times `sent_s`.

    Args:
        messages: changed in place.
        channels: the channels.
        packets: the messages, k of them, of dtype `PACKET`; gives them their numbers.

    Returns:
        which were not dropped, shape (k,).
    """
    senders = packets["sender"]
    packets["number"], packets["begins_s"] = messages.sent[senders], np.nan
    messages.sent[senders] += 1
    note(messages, Fate.SENT, packets, packets["sent_s"])
    held = np.bincount(messages.outbox["sender"], minlength=len(messages.sent))[senders]
    full = held >= MOST
    limited = np.isfinite(channels.bandwidth_bps[packets["channel"]]) & ~full
    if limited.any():
        full |= _make_room(messages, channels, packets, limited)
    note(messages, Fate.QUEUE, packets[full], packets["sent_s"][full])
    messages.outbox = np.concatenate([messages.outbox, packets[~full]])
    return np.asarray(~full)


def depart(messages: MessageState, channels: Channels, end_s: float) -> Records:
    """Dequeue and return what begins to be sent before the end of a cycle, in that order."""
    if not len(messages.outbox):
        return np.zeros(0, PACKET)
    keys = messages.outbox["sender"].astype(np.int64) * len(channels) + messages.outbox["channel"]
    by_s = np.full(messages.free_s.size, np.nextafter(end_s, 0.0))
    _begin(messages, channels, keys, by_s)
    gone = np.isfinite(messages.outbox["begins_s"])
    packets = messages.outbox[gone]
    messages.outbox = messages.outbox[~gone]
    order = np.lexsort([packets["number"], packets["sender"], packets["begins_s"]])
    return np.asarray(packets[order])


def clear(messages: MessageState, present: BoolArray, now_s: float) -> None:
    """Drop what robots that are not in the world had not sent; `present` says which are."""
    absent = ~present[messages.outbox["sender"]]
    left = messages.outbox[absent]
    note(messages, Fate.ABSENT, left, np.full(len(left), now_s))
    messages.outbox = messages.outbox[~absent]


def _make_room(
    messages: MessageState, channels: Channels, packets: Records, which: BoolArray
) -> BoolArray:
    """Drop the oldest where the channel says so; return where there is still no room."""
    box, count = messages.outbox, len(channels)
    keys = box["sender"].astype(np.int64) * count + box["channel"]
    mine = packets["sender"].astype(np.int64) * count + packets["channel"]
    by_s = np.full(messages.free_s.size, -np.inf)
    by_s[mine[which]] = packets["sent_s"][which]
    _begin(messages, channels, keys, by_s)
    waits = np.isnan(box["begins_s"])
    waiting = np.bincount(keys[waits], minlength=messages.free_s.size)[mine]
    # Nobody waits behind a sender that is free.
    busy = messages.free_s.ravel()[mine] > packets["sent_s"]
    full = which & busy & (waiting >= channels.queue[packets["channel"]])
    drops = full & channels.drops_oldest[packets["channel"]]
    if drops.any():
        waiting_rows = np.flatnonzero(waits & np.isin(keys, mine[drops]))
        found, first = np.unique(keys[waiting_rows], return_index=True)
        oldest = waiting_rows[first]
        time_s = by_s[found]
        note(messages, Fate.QUEUE, box[oldest], time_s)
        messages.outbox = np.delete(box, oldest)
    return np.asarray(full & ~drops)


def _begin(messages: MessageState, channels: Channels, keys: Int64Array, by_s: FloatArray) -> None:
    """Start to send the messages whose turn comes.

    Args:
        messages: changed in place.
        channels: the channels.
        keys: robot times channels plus channel of each message in the outbox.
        by_s: until when, by key, (robots times channels,).
    """
    box, free_s = messages.outbox, messages.free_s.ravel()
    duration_s = channels.duration_s(box)
    waiting = np.flatnonzero(np.isnan(box["begins_s"]) & (by_s[keys] > -np.inf))
    while len(waiting):
        mine, first = np.unique(keys[waiting], return_index=True)
        head = waiting[first]
        begins_s = np.maximum(box["sent_s"][head], free_s[mine])
        soon = begins_s <= by_s[mine]
        if not soon.any():
            break
        head, mine, begins_s = head[soon], mine[soon], begins_s[soon]
        box["begins_s"][head] = begins_s
        free_s[mine] = begins_s + duration_s[head]
        waiting = waiting[np.isnan(box["begins_s"][waiting])]
