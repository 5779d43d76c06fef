"""The receiver's side: messages in transit, and the robots' inboxes.

An inbox holds `INBOX` messages; a message that arrives when it is full is lost. At most
`COMING_MOST` messages are in transit to one robot or in its inbox: further ones are lost at once,
as if the inbox were full.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array, Records
from crs_cc.sim.comms.message_log import Fate, note
from crs_cc.sim.geometry.cell_list import expand
from crs_cc.sim.state.messages import ARRIVED, COMING, GONE, MessageState

INBOX: Final = 64
COMING_MOST: Final = 256


def expect(messages: MessageState, packets: Records, coming: Records) -> None:
    """Add messages in transit; call `in_order` after the last ones.

    Args:
        messages: changed in place.
        packets: the messages.
        coming: their receivers and arrival times, of dtype `RECEPTION`; `packet` is a row of
            `packets`. If there are too many, the last ones are lost.
    """
    if not len(coming):
        return
    many = _held(messages)[coming["receiver"]] + _rank(coming["receiver"]) >= COMING_MOST
    if many.any():
        late = coming[many]
        note(messages, Fate.INBOX, packets[late["packet"]], late["arrives_s"], late["receiver"])
        coming = coming[~many]
        if not len(coming):
            return
    coming["packet"] += len(messages.packets)
    messages.packets = np.concatenate([messages.packets, packets])
    messages.receptions = np.concatenate([messages.receptions, coming])


def in_order(messages: MessageState) -> None:
    """Sort the messages in transit by receiver and arrival time."""
    table = messages.receptions
    messages.receptions = table[np.lexsort([table["arrives_s"], table["receiver"]])]


def full(messages: MessageState) -> BoolArray:
    """Return which robots have the largest possible number of pending messages, (robots,)."""
    return np.asarray(_held(messages) >= COMING_MOST)


def deliver(messages: MessageState, rows: IndexArray, by_s: FloatArray) -> None:
    """Put the messages that have arrived by some time into the inboxes.

    Args:
        messages: changed in place.
        rows: the robots, in ascending order, k of them.
        by_s: the time of each, (k,).
    """
    table = messages.receptions
    owner, place = _of(table, rows)
    arrived = (table["status"][place] == COMING) & (table["arrives_s"][place] <= by_s[owner])
    if not arrived.any():
        return
    inside = np.bincount(owner[table["status"][place] == ARRIVED], minlength=len(rows))
    owner, place = owner[arrived], place[arrived]
    fits = inside[owner] + _rank(owner) < INBOX
    table["status"][place] = np.where(fits, ARRIVED, GONE)
    came = table[place]
    fate = np.where(came["corrupted"], int(Fate.CORRUPTED), int(Fate.DELIVERED))
    fate = np.where(fits, fate, int(Fate.INBOX)).astype(np.int8)
    packets = messages.packets[came["packet"]]
    note(messages, fate, packets, came["arrives_s"], came["receiver"])


def count(messages: MessageState, rows: IndexArray) -> Int64Array:
    """Return the number of messages in the inboxes of robots, shape (k,)."""
    owner, place = _of(messages.receptions, rows)
    inside = messages.receptions["status"][place] == ARRIVED
    return np.bincount(owner[inside], minlength=len(rows))


def take(messages: MessageState, rows: IndexArray) -> tuple[IndexArray, Records, FloatArray]:
    """Remove the first message from each inbox that is not empty.

    Returns:
        which of the robots have one, the messages, and when they arrived.
    """
    table = messages.receptions
    owner, place = _of(table, rows)
    inside = np.flatnonzero(table["status"][place] == ARRIVED)
    have, first = np.unique(owner[inside], return_index=True)
    taken = place[inside[first]]
    table["status"][taken] = GONE
    found = table[taken]
    return have, messages.packets[found["packet"]], found["arrives_s"]


def first_s(messages: MessageState, rows: IndexArray) -> FloatArray:
    """Return the arrival time, past or future, of each robot's first message, infinite for none."""
    table = messages.receptions
    owner, place = _of(table, rows)
    first_s = np.full(len(rows), np.inf)
    left = table["status"][place] != GONE
    np.minimum.at(first_s, owner[left], table["arrives_s"][place[left]])
    return first_s


def clear(messages: MessageState, present: BoolArray) -> None:
    """Remove the messages to robots that are not `present` in the world."""
    table = messages.receptions
    absent = ~present[table["receiver"]]
    late = table[absent & (table["status"] == COMING)]
    packets = messages.packets[late["packet"]]
    note(messages, Fate.ABSENT, packets, late["arrives_s"], late["receiver"])
    table["status"][absent] = GONE


def tidy(messages: MessageState) -> None:
    """Remove messages that nobody can receive any more."""
    left = messages.receptions["status"] != GONE
    table = messages.receptions[left]
    kept, number = np.unique(table["packet"], return_inverse=True)
    if len(kept) == len(messages.packets) and left.all():
        return
    table["packet"] = number
    messages.receptions, messages.packets = table, messages.packets[kept]


def _held(messages: MessageState) -> IndexArray:
    """Return the number of messages in transit to each robot or in its inbox, (robots,)."""
    table = messages.receptions
    return np.bincount(table["receiver"][table["status"] != GONE], minlength=len(messages.sent))


def _of(table: Records, rows: IndexArray) -> tuple[IndexArray, IndexArray]:
    """Return the receptions of robots: the robot's index into `rows`, and the row of the table."""
    first = np.searchsorted(table["receiver"], rows, side="left")
    last = np.searchsorted(table["receiver"], rows, side="right")
    return expand(first, last - first)


def _rank(owner: npt.NDArray[np.integer]) -> IndexArray:
    """Return the number of equal elements before each one.

    >>> _rank(np.array([3, 1, 3, 3, 1])).tolist()
    [0, 0, 1, 2, 1]
    """
    order = np.argsort(owner, kind="stable")
    sorted_ = owner[order]
    place = np.arange(len(owner))
    starts = np.concatenate([[True], sorted_[1:] != sorted_[:-1]])[: len(owner)]
    rank = np.empty(len(owner), dtype=np.intp)
    rank[order] = place - np.maximum.accumulate(np.where(starts, place, 0))
    return rank
