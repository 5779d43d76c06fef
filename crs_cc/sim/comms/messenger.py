"""The messages of all robots: what answers their requests, and what a cycle's end does."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Records
from crs_cc.requests import CODES, DATA_SIZE
from crs_cc.sim.comms import inbox, outages, outbox
from crs_cc.sim.comms.channel_model import Air
from crs_cc.sim.comms.channels import Channels
from crs_cc.sim.model.communication import ANY
from crs_cc.sim.state.messages import EVERYBODY, GROUPS, NO_GROUP, PACKET

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import Answer, RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


class Messenger:
    """What carries messages; everything that changes is in `MessageState`.

    Attributes:
        answers: what answers each request, by code.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        self._channels = Channels.of(world.communication)
        self._air = Air(self._channels, seed)
        self._robots = tuple(robot.id for robot in world.robots)
        self.answers: dict[int, Answer] = {
            CODES["SEND"]: self.send,
            CODES["RECEIVE"]: self.receive,
            CODES["MESSAGE_COUNT"]: self.count,
            CODES["GROUP"]: self.group,
            CODES["CHANNEL"]: self.find_channel,
            CODES["ROBOT"]: self.find_robot,
        }

    # -- what programs ask -------------------------------------------------------------------------

    def send(self, asked: RequestContext) -> BoolArray:
        """Answers SEND: to a robot, to all, or to a group."""
        to, group, kind, channel = asked.messages["i"][:, :4].T
        size = asked.messages["size"]
        good = (channel >= 0) & (channel < len(self._channels)) & (size >= 0) & (size <= DATA_SIZE)
        good &= (to >= EVERYBODY) & (to < len(self._robots)) & (to != asked.rows)
        good &= (group >= NO_GROUP) & (group < GROUPS) & ((group == NO_GROUP) | (to == EVERYBODY))
        packets = np.zeros(int(good.sum()), PACKET)
        packets["sender"], packets["sent_s"] = asked.rows[good], asked.at_s[good]
        packets["to"], packets["group"], packets["type"] = to[good], group[good], kind[good]
        packets["channel"], packets["size"] = channel[good], size[good]
        used = np.arange(DATA_SIZE) < size[good, None]
        packets["data"] = np.where(used, asked.messages["data"][good], 0)
        good[good] = outbox.post(asked.state.messages, self._channels, packets)
        return np.asarray(good)

    def receive(self, asked: RequestContext) -> BoolArray:
        """Answers RECEIVE, when a message has come or the time is up."""
        messages = asked.state.messages
        inbox.let_in(messages, asked.rows, asked.at_s)
        have, packets, arrived_s = inbox.take(messages, asked.rows)
        replies = asked.messages[have]
        for place, name in enumerate(("sender", "to", "group", "type", "channel")):
            replies["i"][:, place] = packets[name]
        replies["f"][:, 0], replies["f"][:, 1] = packets["sent_s"], arrived_s
        replies["size"], replies["data"] = packets["size"], packets["data"]
        asked.messages[have] = replies
        good = np.zeros(len(asked.rows), dtype=np.bool_)
        good[have] = True
        return good

    def count(self, asked: RequestContext) -> None:
        """Answers MESSAGE_COUNT."""
        inbox.let_in(asked.state.messages, asked.rows, asked.at_s)
        asked.messages["i"][:, 0] = inbox.count(asked.state.messages, asked.rows)

    def group(self, asked: RequestContext) -> BoolArray:
        """Answers GROUP: joins one, or leaves it."""
        group, joins = asked.messages["i"][:, :2].T
        good = np.asarray((group >= 0) & (group < GROUPS))
        bit = np.uint32(1) << group[good].astype(np.uint32)
        rows, groups = asked.rows[good], asked.state.messages.groups
        groups[rows] = np.where(joins[good] != 0, groups[rows] | bit, groups[rows] & ~bit)
        return good

    def find_channel(self, asked: RequestContext) -> BoolArray:
        """Answers CHANNEL: the number of a channel with a name, the name of one with a number."""
        return _look_up(asked.messages, self._channels.names, np.full(len(asked.rows), ANY))

    def find_robot(self, asked: RequestContext) -> BoolArray:
        """Answers ROBOT: the number of a robot with a name, the name of one with a number."""
        return _look_up(asked.messages, self._robots, asked.rows)

    # -- what time does ----------------------------------------------------------------------------

    def end_cycle(
        self,
        state: EnvState,
        constants: RobotConstants,
        log: EventLog,
        *,
        from_s: float,
        to_s: float,
    ) -> None:
        """Ends a cycle: what was sent in it goes on its way, what arrived in it is let in.

        Args:
            state: changed in place; the bodies are where they got to.
            constants: what stands where.
            log: takes what is shut and opened.
            from_s: when the cycle began.
            to_s: when it ends.
        """
        messages = state.messages
        if len(messages.shuts):
            names = self._robots
            outages.tell(messages, self._channels, names, from_s=from_s, to_s=to_s, log=log)
        if not state.presence.present.all():
            inbox.clear(messages, state.presence.present)
            outbox.clear(messages, state.presence.present, from_s)
        if len(messages.receptions):
            rows = np.arange(len(self._robots))
            inbox.let_in(messages, rows, np.full(len(rows), np.nextafter(to_s, 0.0)))
        packets = outbox.depart(messages, self._channels, to_s)
        if len(packets):
            self._air.carry(state, constants.scene, packets, to_s)
        if len(messages.packets):
            inbox.tidy(messages)


def wait(state: EnvState, _constants: RobotConstants, rows: IndexArray, messages: Records) -> None:
    """Begins to wait for a message: i[0] ms long, not at all for 0, without an end below 0."""
    wait_s = messages["i"][:, 0] / 1000.0
    until_s = state.drive.clock_s[rows] + wait_s
    state.waits.until_s[rows] = np.where(wait_s < 0.0, np.inf, until_s)


def heard_s(state: EnvState, rows: IndexArray) -> FloatArray:
    """Gives when the waits for a message end, as far as is known, shape (k,)."""
    first_s = np.minimum(inbox.first_s(state.messages, rows), state.waits.until_s[rows])
    return np.asarray(np.maximum(first_s, state.drive.clock_s[rows]))


def _look_up(messages: Records, names: tuple[str, ...], own: IndexArray) -> BoolArray:
    """Finds what has a name, or else a number, -1 for one's own; writes both, and how many are."""
    good = np.zeros(len(messages), dtype=np.bool_)
    for row, mine in enumerate(own.tolist()):
        size, number = int(messages["size"][row]), int(messages["i"][row, 0])
        if size:
            wanted = messages["data"][row, : max(0, size)].tobytes().decode("utf-8", "replace")
            number = names.index(wanted) if wanted in names else ANY
        elif number == ANY:
            number = mine
        good[row] = 0 <= number < len(names)
        text = names[number].encode()[:DATA_SIZE] if good[row] else b""
        messages["i"][row, :2] = number if good[row] else ANY, len(names)
        messages["size"][row] = len(text)
        messages["data"][row, : len(text)] = list(text)
    return good
