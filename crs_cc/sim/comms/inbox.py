"""The receiver's side: messages on their way, and the inboxes that they come into.

An inbox holds `INBOX` messages; what arrives when it is full is lost. No more than `COMING_MOST`
messages are on their way to one robot or in its inbox: further ones are lost at once, as if it had
been full.
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
    """Takes over what is on its way from now on; when that is all, `in_order` must follow.

    Args:
        messages: changed in place.
        packets: the messages.
        coming: where they go and when they arrive, of dtype `RECEPTION`; `packet` is a row of
            `packets`. In the order of which the last are lost where there are too many.
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
    """Sort what is on its way by receiver and arrival."""
    table = messages.receptions
    messages.receptions = table[np.lexsort([table["arrives_s"], table["receiver"]])]


def full(messages: MessageState) -> BoolArray:
    """Return which robots have the most messages that can be on their way and in their inbox."""
    return np.asarray(_held(messages) >= COMING_MOST)


def let_in(messages: MessageState, rows: IndexArray, by_s: FloatArray) -> None:
    """Put what has arrived by an instant into inboxes.

    Args:
        messages: changed in place.
        rows: whose, rising, k of them.
        by_s: the instant of each, (k,).
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
    """Take the first message out of each inbox that is not empty.

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
    """Return when the first message of each robot has arrived or will, infinite for none."""
    table = messages.receptions
    owner, place = _of(table, rows)
    first_s = np.full(len(rows), np.inf)
    left = table["status"][place] != GONE
    np.minimum.at(first_s, owner[left], table["arrives_s"][place[left]])
    return first_s


def clear(messages: MessageState, present: BoolArray) -> None:
    """Drop all messages to robots that are not in the world; `present` says which are."""
    table = messages.receptions
    absent = ~present[table["receiver"]]
    late = table[absent & (table["status"] == COMING)]
    packets = messages.packets[late["packet"]]
    note(messages, Fate.ABSENT, packets, late["arrives_s"], late["receiver"])
    table["status"][absent] = GONE


def tidy(messages: MessageState) -> None:
    """Delete what nobody can receive any more."""
    left = messages.receptions["status"] != GONE
    table = messages.receptions[left]
    kept, number = np.unique(table["packet"], return_inverse=True)
    if len(kept) == len(messages.packets) and left.all():
        return
    table["packet"] = number
    messages.receptions, messages.packets = table, messages.packets[kept]


def _held(messages: MessageState) -> IndexArray:
    """Return how many messages are on their way to each robot, or in its inbox, (robots,)."""
    table = messages.receptions
    return np.bincount(table["receiver"][table["status"] != GONE], minlength=len(messages.sent))


def _of(table: Records, rows: IndexArray) -> tuple[IndexArray, IndexArray]:
    """Return the receptions of robots: number of the robot among `rows`, and row of the table."""
    first = np.searchsorted(table["receiver"], rows, side="left")
    last = np.searchsorted(table["receiver"], rows, side="right")
    return expand(first, last - first)


def _rank(owner: npt.NDArray[np.integer]) -> IndexArray:
    """Return how many equal numbers come before each.

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
