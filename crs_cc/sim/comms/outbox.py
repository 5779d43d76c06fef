"""The sender's side: messages wait until those before them have been sent.

Each robot has a transmitter for each channel. The transmission of message i, posted at p_i, begins
at

    b_i = max(p_i, b_(i-1) + (size_(i-1) + 12) / bandwidth)

The channel's queue bounds the number of messages that wait for their transmission: when it is full,
a further one replaces the oldest or is dropped itself. A robot has at most `MAX_MESSAGES`
messages here, including those whose transmission began in this cycle: further ones are dropped,
however fast the channel is, so that a program that sends in a loop cannot cause unbounded work.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int32Array, Int64Array, Records
from crs_cc.sim.comms.channels import Channels
from crs_cc.sim.comms.message_log import Fate, note
from crs_cc.sim.state.messages import PACKET, MessageState

MAX_MESSAGES: Final = 64


def post(messages: MessageState, channels: Channels, packets: Records) -> BoolArray:
    """Queue messages, at most one of each robot, posted at their `sent_s`.

    Args:
        messages: changed in place.
        channels: the channels.
        packets: the messages, k of them, of dtype `PACKET`; their numbers are filled in.

    Returns:
        which were not dropped, shape (k,).
    """
    senders: Int32Array = packets["sender"]
    channel: Int32Array = packets["channel"]
    packets["number"], packets["begins_s"] = messages.sent[senders], np.nan
    messages.sent[senders] += 1
    note(messages, Fate.SENT, packets, packets["sent_s"])
    held = np.bincount(messages.outbox["sender"], minlength=len(messages.sent))[senders]
    full = held >= MAX_MESSAGES
    limited = np.isfinite(channels.bandwidth_bps[channel]) & ~full
    if limited.any():
        full |= _make_room(messages, channels, packets, limited)
    note(messages, Fate.QUEUE, packets[full], packets["sent_s"][full])
    messages.outbox = np.concatenate([messages.outbox, packets[~full]])
    return np.asarray(~full)


def take_started(messages: MessageState, channels: Channels, end_s: float) -> Records:
    """Remove and return the messages whose transmission begins before a time, in that order."""
    if not len(messages.outbox):
        return np.zeros(0, PACKET)
    keys = _keys(messages.outbox, channels)
    by_s = np.full(messages.free_s.size, np.nextafter(end_s, 0.0))
    _begin(messages, channels, keys, by_s)
    gone = np.isfinite(messages.outbox["begins_s"])
    packets = messages.outbox[gone]
    messages.outbox = messages.outbox[~gone]
    order = np.lexsort([packets["number"], packets["sender"], packets["begins_s"]])
    return np.asarray(packets[order])


def clear(messages: MessageState, present: BoolArray, now_s: float) -> None:
    """Remove the unsent messages of robots that are not `present` in the world."""
    senders: Int32Array = messages.outbox["sender"]
    absent = ~present[senders]
    left = messages.outbox[absent]
    note(messages, Fate.ABSENT, left, np.full(len(left), now_s))
    messages.outbox = messages.outbox[~absent]


def _make_room(
    messages: MessageState, channels: Channels, packets: Records, which: BoolArray
) -> BoolArray:
    """Drop the oldest message if the channel requires it; return where the queue is still full."""
    box = messages.outbox
    keys, mine = _keys(box, channels), _keys(packets, channels)
    channel: Int32Array = packets["channel"]
    sent_s: FloatArray = packets["sent_s"]
    begins_s: FloatArray = box["begins_s"]
    by_s = np.full(messages.free_s.size, -np.inf)
    by_s[mine[which]] = sent_s[which]
    _begin(messages, channels, keys, by_s)
    waits = np.isnan(begins_s)
    waiting = np.bincount(keys[waits], minlength=messages.free_s.size)[mine]
    # A free transmitter has no queue.
    busy = messages.free_s.ravel()[mine] > sent_s
    full = which & busy & (waiting >= channels.queue[channel])
    drops = full & channels.drops_oldest[channel]
    if drops.any():
        waiting_rows = np.flatnonzero(waits & np.isin(keys, mine[drops]))
        found, first = np.unique(keys[waiting_rows], return_index=True)
        oldest = waiting_rows[first]
        time_s = by_s[found]
        note(messages, Fate.QUEUE, box[oldest], time_s)
        messages.outbox = np.delete(box, oldest)
    return np.asarray(full & ~drops)


def _keys(packets: Records, channels: Channels) -> Int64Array:
    """Return the transmitter of each message: robot * number of channels + channel."""
    sender: Int32Array = packets["sender"]
    channel: Int32Array = packets["channel"]
    return sender.astype(np.int64) * len(channels) + channel


def _begin(messages: MessageState, channels: Channels, keys: Int64Array, by_s: FloatArray) -> None:
    """Start the transmissions that are due.

    Args:
        messages: changed in place.
        channels: the channels.
        keys: the transmitter of each message in the outbox.
        by_s: the time limit by key, (robots * channels,).
    """
    box, free_s = messages.outbox, messages.free_s.ravel()
    duration_s = channels.duration_s(box)
    posted_s: FloatArray = box["sent_s"]
    begun_s: FloatArray = box["begins_s"]
    waiting = np.flatnonzero(np.isnan(begun_s) & (by_s[keys] > -np.inf))
    while len(waiting):
        mine, first = np.unique(keys[waiting], return_index=True)
        head = waiting[first]
        begins_s = np.maximum(posted_s[head], free_s[mine])
        soon = begins_s <= by_s[mine]
        if not soon.any():
            break
        head, mine, begins_s = head[soon], mine[soon], begins_s[soon]
        begun_s[head] = begins_s
        free_s[mine] = begins_s + duration_s[head]
        waiting = waiting[np.isnan(begun_s[waiting])]
