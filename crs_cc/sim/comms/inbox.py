"""The receiver's side: messages in transit, and the robots' inboxes.

An inbox holds `INBOX` messages; a message that arrives when it is full is lost. At most
`MAX_INCOMING` messages are in transit to one robot or in its inbox: further ones are lost at once,
as if the inbox were full.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import (
    BoolArray,
    FloatArray,
    IndexArray,
    Int32Array,
    Int64Array,
    Records,
    all_of,
    any_of,
)
from crs_cc.sim.comms.message_log import Fate, note
from crs_cc.sim.geometry.cell_list import expand
from crs_cc.sim.state.messages import ARRIVED, DONE, IN_TRANSIT, MessageState

INBOX: Final = 64
MAX_INCOMING: Final = 256

_SHORT: Final = 1 << 16
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
        left: BoolArray = messages.receptions["status"] != DONE
        receivers: Int32Array = messages.receptions["receiver"][left]
        self.held = np.bincount(receivers, minlength=len(messages.sent))

    def full(self) -> BoolArray:
        """Return which robots have the largest possible number of pending messages, (robots,)."""
        return np.asarray(self.held >= MAX_INCOMING)

    def add(self, packets: Records, coming: Records) -> None:
        """Add messages.

        Args:
            packets: the messages.
            coming: their receivers and arrival times, of dtype `RECEPTION`; `packet` is a row of
                `packets`. If there are too many, the last ones are lost.
        """
        receiver: Int32Array = coming["receiver"]
        more = np.bincount(receiver, minlength=len(self.held))
        if (self.held + more > MAX_INCOMING).any():
            many = self.held[receiver] + _rank(receiver) >= MAX_INCOMING
            late, coming = coming[many], coming[~many]
            note(self._messages, Fate.INBOX, packets, late["arrives_s"], late["receiver"],
                 which=late["packet"])  # fmt: skip
            more = np.bincount(coming["receiver"], minlength=len(self.held))
        if not len(coming):
            return
        coming["packet"] += self._count
        self._packets.append(packets)
        self._receptions.append(coming)
        self._count += len(packets)
        self.held += more

    def commit(self) -> None:
        """Put the messages in transit, by receiver and arrival time."""
        messages = self._messages
        if len(self._receptions) > 1:
            messages.packets = np.concatenate(self._packets)
            messages.receptions = np.concatenate(self._receptions)
        table = messages.receptions
        order = _order(table["receiver"], table["arrives_s"], len(messages.sent))
        messages.receptions = table.take(order)


class Inboxes:
    """The inboxes of all robots: finds their rows in the table of receptions.

    As the rows of a robot are sorted by arrival, those that it has taken come first, then those in
    its inbox, then those on their way. Where these begin is remembered as long as the table is the
    same one, with copies of its columns, so that the work for one message does not grow with the
    number of others.
    """

    def __init__(self) -> None:
        self._table: Records | None = None
        self._head: IndexArray = _NONE  # no row before it is left
        self._coming: IndexArray = _NONE  # no row before it is on its way
        self._end: IndexArray = _NONE
        self._arrives_s: FloatArray = np.zeros(0)
        self._packet: IndexArray = _NONE

    def _rows(self, messages: MessageState) -> Records:
        """Return the receptions, after finding the rows of each robot."""
        table, robots = messages.receptions, len(messages.sent)
        if table is not self._table or len(self._end) != robots:
            self._table = table
            receiver = table["receiver"].astype(np.intp)
            self._arrives_s = np.ascontiguousarray(table["arrives_s"])
            self._packet = table["packet"].astype(np.intp)
            self._end = np.cumsum(np.bincount(receiver, minlength=robots))
            self._head = np.concatenate([[0], self._end[:-1]])[:robots]
            on_way = np.bincount(receiver[table["status"] == IN_TRANSIT], minlength=robots)
            self._coming = self._end - on_way
        return table

    def _heads(self, messages: MessageState, rows: IndexArray) -> tuple[IndexArray, BoolArray]:
        """Return the first row that is left of each robot, (k,), and which robots have one."""
        status = self._rows(messages)["status"]
        head, end = self._head.take(rows), self._end.take(rows)
        is_left = head < end
        if all_of(is_left) and not any_of(status[head] == DONE):
            return head, is_left
        left = np.flatnonzero(is_left)
        while len(left := left[status[head[left]] == DONE]):
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
        first, end = self._coming.take(rows), self._end.take(rows)
        some = np.flatnonzero(first < end)
        if not len(some):
            return
        some = some[self._arrives_s[first[some]] <= by_s[some]]
        if not len(some):
            return
        rows, by_s, first = rows[some], by_s[some], first[some]
        owner, place = expand(first, end[some] - first)
        come = np.flatnonzero(self._arrives_s.take(place) <= by_s.take(owner))
        owner, place = owner.take(come), place.take(come)
        before = self.count(messages, rows)
        self._coming[rows] = first + np.bincount(owner, minlength=len(rows))
        came = table.take(place)
        coming = came["status"] == IN_TRANSIT
        if not all_of(coming):
            owner, place, came = owner[coming], place[coming], came[coming]
        more = np.bincount(owner, minlength=len(rows))
        rank = np.arange(len(owner)) + (before - np.cumsum(more) + more).take(owner)
        fits = rank < INBOX
        table["status"][place] = np.where(fits, ARRIVED, DONE)
        fate = np.where(came["corrupted"], int(Fate.CORRUPTED), int(Fate.DELIVERED))
        fate = np.where(fits, fate, int(Fate.INBOX)).astype(np.int8)
        note(messages, fate, messages.packets, came["arrives_s"], came["receiver"],
             which=self._packet.take(place))  # fmt: skip

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
        status = self._rows(messages)["status"]
        if all_of(left) and all_of(status[head] == ARRIVED):
            have, takers = np.arange(len(rows)), rows
        else:
            have = np.flatnonzero(left)
            have = have[status[head[have]] == ARRIVED]
            head, takers = head[have], rows[have]
        status[head] = DONE
        self._head[takers] = head + 1
        packets = messages.packets.take(self._packet.take(head))
        return have, packets, self._arrives_s.take(head)

    def first_s(self, messages: MessageState, rows: IndexArray) -> FloatArray:
        """Return when each robot's first message arrives or has arrived, infinite for none."""
        head, left = self._heads(messages, rows)
        if all_of(left):
            return self._arrives_s.take(head)
        first_s = np.full(len(rows), np.inf)
        first_s[left] = self._arrives_s[head[left]]
        return first_s


def clear(messages: MessageState, present: BoolArray) -> None:
    """Remove the messages to robots that are not `present` in the world."""
    absent = ~present[messages.receptions["receiver"]]
    if not absent.any():
        return
    table = messages.receptions = messages.receptions.copy()
    late = table[absent & (table["status"] == IN_TRANSIT)]
    note(messages, Fate.ABSENT, messages.packets, late["arrives_s"], late["receiver"],
         which=late["packet"])  # fmt: skip
    table["status"][absent] = DONE


def remove_finished(messages: MessageState) -> None:
    """Remove messages that can no longer be received."""
    left = np.flatnonzero(messages.receptions["status"] != DONE)
    packet = messages.receptions["packet"][left]
    is_kept = np.zeros(len(messages.packets), dtype=np.bool_)
    is_kept[packet] = True
    kept = np.flatnonzero(is_kept)
    if len(kept) == len(messages.packets) and len(left) == len(messages.receptions):
        return
    table = messages.receptions.take(left)
    table["packet"] = (np.cumsum(is_kept) - 1)[packet]
    messages.receptions, messages.packets = table, messages.packets.take(kept)


def _order(receiver: npt.NDArray[np.integer], arrives_s: FloatArray, robots: int) -> IndexArray:
    """Return the order by receiver, and then by arrival, of rows in the order in which they came.

    >>> _order(np.array([1, 0, 1, 1]), np.array([2.0, 1.0, 1.0, 1.0]), 2).tolist()
    [1, 2, 3, 0]
    """
    # numpy sorts integers of 16 bits by their digits.
    key = receiver.astype(np.uint16 if robots <= _SHORT else np.int32)
    arrives_s = np.ascontiguousarray(arrives_s)
    if (arrives_s[1:] >= arrives_s[:-1]).all():
        return np.argsort(key, kind="stable")
    by_time = np.argsort(arrives_s, kind="stable")
    return by_time.take(np.argsort(key.take(by_time), kind="stable"))


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
