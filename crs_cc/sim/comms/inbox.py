"""The receiver's side: messages in transit, and the robots' inboxes.

An inbox holds `INBOX` messages; a message that arrives when it is full is lost. At most
`COMING_MOST` messages are in transit to one robot or in its inbox: further ones are lost at once,
as if the inbox were full.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Int64Array, Records
from crs_cc.sim.comms.message_log import Fate, note
from crs_cc.sim.geometry.cell_list import expand
from crs_cc.sim.state.messages import ARRIVED, COMING, GONE, MessageState

INBOX: Final = 64
COMING_MOST: Final = 256

_NONE: Final = np.zeros(0, dtype=np.intp)


class Transit:
    """Messages that set out in a cycle, collected until all have.

    Attributes:
        held: the number of messages in transit to each robot or in its inbox, (robots,).
    """

    def __init__(self, messages: MessageState) -> None:
        self._messages = messages
        self._packets, self._receptions = [messages.packets], [messages.receptions]
        self._count = len(messages.packets)
        left: BoolArray = messages.receptions["status"] != GONE
        receivers: Int32Array = messages.receptions["receiver"][left]
        self.held = np.bincount(receivers, minlength=len(messages.sent))

    def full(self) -> BoolArray:
        """Return which robots have the largest possible number of pending messages, (robots,)."""
        return np.asarray(self.held >= COMING_MOST)

    def add(self, packets: Records, coming: Records) -> None:
        """Add messages.

        Args:
            packets: the messages.
            coming: their receivers and arrival times, of dtype `RECEPTION`; `packet` is a row of
                `packets`. If there are too many, the last ones are lost.
        """
        receiver: Int32Array = coming["receiver"]
        more = np.bincount(receiver, minlength=len(self.held))
        if (self.held + more > COMING_MOST).any():
            many = self.held[receiver] + _rank(receiver) >= COMING_MOST
            late, coming = coming[many], coming[~many]
            note(self._messages, Fate.INBOX, packets[late["packet"]], late["arrives_s"],
                 late["receiver"])  # fmt: skip
            more = np.bincount(coming["receiver"], minlength=len(self.held))
        if not len(coming):
            return
        coming["packet"] += self._count
        self._packets.append(packets)
        self._receptions.append(coming)
        self._count += len(packets)
        self.held += more

    def set_out(self) -> None:
        """Put the messages in transit, by receiver and arrival time."""
        messages = self._messages
        if len(self._receptions) > 1:
            messages.packets = np.concatenate(self._packets)
            messages.receptions = np.concatenate(self._receptions)
        table = messages.receptions
        messages.receptions = table[np.lexsort([table["arrives_s"], table["receiver"]])]


class Inboxes:
    """The inboxes of all robots: finds their rows in the table of receptions.

    As the rows of a robot are sorted by arrival, those that it has taken come first, then those in
    its inbox, then those on their way. Where these begin is remembered as long as the table is the
    same one, so that the work for one message does not grow with the number of others.
    """

    def __init__(self) -> None:
        self._table: Records | None = None
        self._head: IndexArray = _NONE  # no row before it is left
        self._coming: IndexArray = _NONE  # no row before it is on its way
        self._end: IndexArray = _NONE

    def _rows(self, messages: MessageState) -> Records:
        """Return the receptions, after finding the rows of each robot."""
        table, robots = messages.receptions, len(messages.sent)
        if table is not self._table or len(self._end) != robots:
            self._table = table
            receiver = np.ascontiguousarray(table["receiver"])
            bounds = np.searchsorted(receiver, np.arange(robots + 1))
            self._head, self._coming = bounds[:-1].copy(), bounds[:-1].copy()
            self._end = bounds[1:]
            on_way: Int32Array = receiver[table["status"] == COMING]
            self._coming = self._end - np.bincount(on_way, minlength=robots)
        return table

    def _heads(self, messages: MessageState, rows: IndexArray) -> tuple[IndexArray, BoolArray]:
        """Return the first row that is left of each robot, (k,), and which robots have one."""
        table = self._rows(messages)
        status, head, end = table["status"], self._head[rows], self._end[rows]
        left = np.flatnonzero(head < end)
        while len(left := left[status[head[left]] == GONE]):
            head[left] += 1
            left = left[head[left] < end[left]]
        self._head[rows] = head
        return head, np.asarray(head < end)

    def deliver(self, messages: MessageState, rows: IndexArray, by_s: FloatArray) -> None:
        """Put the messages that have arrived by some time into the inboxes.

        Args:
            messages: changed in place.
            rows: the robots, in ascending order, k of them.
            by_s: the time of each, (k,).
        """
        table = self._rows(messages)
        first, end = self._coming[rows], self._end[rows]
        some = np.flatnonzero(first < end)
        some = some[table["arrives_s"][first[some]] <= by_s[some]]
        if not len(some):
            return
        rows, by_s, first = rows[some], by_s[some], first[some]
        owner, place = expand(first, end[some] - first)
        arrived = table["arrives_s"][place] <= by_s[owner]
        self._coming[rows] = first + np.bincount(owner[arrived], minlength=len(rows))
        arrived &= table["status"][place] == COMING
        owner, place = owner[arrived], place[arrived]
        fits = self.count(messages, rows)[owner] + _rank(owner) < INBOX
        table["status"][place] = np.where(fits, ARRIVED, GONE)
        came = table[place]
        fate = np.where(came["corrupted"], int(Fate.CORRUPTED), int(Fate.DELIVERED))
        fate = np.where(fits, fate, int(Fate.INBOX)).astype(np.int8)
        came_as: Int32Array = came["packet"]
        packets = messages.packets[came_as]
        note(messages, fate, packets, came["arrives_s"], came["receiver"])

    def count(self, messages: MessageState, rows: IndexArray) -> Int64Array:
        """Return the number of messages in the inboxes of robots, shape (k,)."""
        table, head = self._rows(messages), self._head[rows]
        owner, place = expand(head, np.maximum(self._coming[rows] - head, 0))
        inside = table["status"][place] == ARRIVED
        return np.bincount(owner[inside], minlength=len(rows))

    def take(
        self, messages: MessageState, rows: IndexArray
    ) -> tuple[IndexArray, Records, FloatArray]:
        """Take the first message of every inbox; return which have one, the messages and times."""
        head, left = self._heads(messages, rows)
        table = self._rows(messages)
        have = np.flatnonzero(left)
        have = have[table["status"][head[have]] == ARRIVED]
        taken = head[have]
        table["status"][taken] = GONE
        packet: Int32Array = table["packet"][taken]
        return have, messages.packets[packet], table["arrives_s"][taken]

    def first_s(self, messages: MessageState, rows: IndexArray) -> FloatArray:
        """Return when each robot's first message arrives or has arrived, infinite for none."""
        head, left = self._heads(messages, rows)
        first_s = np.full(len(rows), np.inf)
        first_s[left] = messages.receptions["arrives_s"][head[left]]
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
    """Remove messages that can no longer be received."""
    left = messages.receptions["status"] != GONE
    table = messages.receptions[left]
    kept, number = np.unique(table["packet"], return_inverse=True)
    if len(kept) == len(messages.packets) and left.all():
        return
    table["packet"] = number
    messages.receptions, messages.packets = table, messages.packets[kept]


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
