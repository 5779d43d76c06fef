"""The messages of all robots: their requests, and the work at the end of a cycle."""

from __future__ import annotations

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Records, all_of
from crs_cc.requests import DATA_SIZE
from crs_cc.sim.comms import inbox, outages, outbox
from crs_cc.sim.comms.channel_model import ChannelModel
from crs_cc.sim.comms.channels import Channels
from crs_cc.sim.comms.inbox import Inboxes
from crs_cc.sim.devices.name_lookup import look_up, numbers_of
from crs_cc.sim.devices.request_context import RequestContext
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.model.communication import ANY
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.events import EventLog
from crs_cc.sim.state.messages import EVERYBODY, GROUPS, IN_TRANSIT, NO_GROUP, PACKET


class Messenger:
    """The communication of a world's robots; its mutable state is `MessageState`."""

    def __init__(self, world: WorldModel, seed: int) -> None:
        self._channels = Channels.of(world.communication)
        self._channel_model = ChannelModel(self._channels, seed)
        self._inboxes = Inboxes()
        self._robots = tuple(robot.id for robot in world.robots)
        self._channel_numbers = numbers_of(self._channels.names)
        self._robot_numbers = numbers_of(self._robots)
        self._posted: list[Records] = []  # in this cycle; for observers, not part of the state

    # -- requests of programs ----------------------------------------------------------------------

    def send(self, context: RequestContext) -> BoolArray:
        """Answer SEND: to a robot, to all, or to a group."""
        to, group, channel, size = (context[name] for name in ("to", "group", "channel", "size"))
        rows, messages = context.rows, context.state.messages
        good = (channel >= 0) & (channel < len(self._channels)) & (size >= 0) & (size <= DATA_SIZE)
        good &= (to >= EVERYBODY) & (to < len(self._robots)) & (to != rows)
        good &= (group >= NO_GROUP) & (group < GROUPS) & ((group == NO_GROUP) | (to == EVERYBODY))
        packets = np.zeros(int(good.sum()), PACKET)
        packets["sender"], packets["sent_s"] = rows[good], context.at_s[good]
        for name in ("to", "group", "type", "channel", "size"):
            packets[name] = context[name][good]
        used = np.arange(DATA_SIZE) < size[good, None]
        packets["data"] = np.where(used, context["content"][good], 0)
        good[good] = outbox.post(messages, self._channels, packets)
        self._posted.append(packets)
        return np.asarray(good)

    def take_posted(self) -> tuple[Records, ...]:
        """Return the messages posted since the last call, of dtype `PACKET`."""
        posted, self._posted = tuple(self._posted), []
        return posted

    def receive(self, context: RequestContext) -> BoolArray:
        """Answer RECEIVE when a message has arrived or the timeout has expired."""
        messages, rows = context.state.messages, context.rows
        self._inboxes.deliver(messages, rows, context.at_s)
        have, packets, arrived_s = self._inboxes.take(messages, rows)
        good = np.zeros(len(rows), dtype=np.bool_)
        good[have] = True
        which = slice(None) if len(have) == len(rows) else have
        for name in ("sender", "to", "group", "type", "channel", "sent_s", "size"):
            context.put(name, packets[name], which)
        context.put("arrived_s", arrived_s, which)
        context.put("content", packets["data"], which)
        return good

    def receive_ends_s(self, state: EnvState, rows: IndexArray) -> FloatArray:
        """Return when the waits for a message end, by current knowledge, shape (k,)."""
        first_s = self._inboxes.first_s(state.messages, rows)
        first_s = np.minimum(first_s, state.waits.until_s[rows])
        return np.asarray(np.maximum(first_s, state.drive.clock_s[rows]))

    def count(self, context: RequestContext) -> None:
        """Answer MESSAGE_COUNT."""
        messages = context.state.messages
        self._inboxes.deliver(messages, context.rows, context.at_s)
        context["messages"] = self._inboxes.count(messages, context.rows)

    def group(self, context: RequestContext) -> BoolArray:
        """Answer GROUP: join one, or leave it."""
        group, joins = context["group"], context["joins"]
        good = np.asarray((group >= 0) & (group < GROUPS))
        bit = np.uint32(1) << group[good].astype(np.uint32)
        rows, groups = context.rows[good], context.state.messages.groups
        groups[rows] = np.where(joins[good] != 0, groups[rows] | bit, groups[rows] & ~bit)
        return good

    def find_channel(self, context: RequestContext) -> BoolArray:
        """Answer CHANNEL: the number of a channel with a name, the name of one with a number."""
        return look_up(context, self._channel_numbers, np.full(len(context), ANY))

    def find_robot(self, context: RequestContext) -> BoolArray:
        """Answer ROBOT: the number of a robot with a name, the name of one with a number."""
        return look_up(context, self._robot_numbers, context.rows)

    def is_idle(self, state: EnvState) -> bool:
        """Return whether no message is queued or in transit."""
        messages = state.messages
        coming = messages.receptions["status"] == IN_TRANSIT
        return not (len(messages.outbox) or coming.any())

    def outages_s(self, state: EnvState) -> FloatArray:
        """Return the times from now on at which outages begin or end."""
        shuts = state.messages.shuts
        times_s = np.concatenate([shuts["at_s"], shuts["until_s"]])
        return np.asarray(times_s[times_s >= state.drive.clock_s.max(initial=0.0)])

    # -- the passage of time -----------------------------------------------------------------------

    def end_cycle(
        self,
        state: EnvState,
        constants: RobotConstants,
        log: EventLog,
        *,
        from_s: float,
        to_s: float,
    ) -> None:
        """End a cycle: transmit the messages sent in it, and put those that arrived into inboxes.

        Args:
            state: changed in place; the bodies have moved.
            constants: the objects of the world.
            log: receives the start and end of outages.
            from_s: start of the cycle.
            to_s: its end.
        """
        messages = state.messages
        if len(messages.shuts):
            names = self._robots
            outages.log_changes(messages, self._channels, names, from_s=from_s, to_s=to_s, log=log)
        if not all_of(state.presence.present):
            inbox.clear(messages, state.presence.present)
            outbox.clear(messages, state.presence.present, from_s)
        if len(messages.receptions):
            rows = np.arange(len(self._robots))
            self._inboxes.deliver(messages, rows, np.full(len(rows), np.nextafter(to_s, 0.0)))
        packets = outbox.take_started(messages, self._channels, to_s)
        if len(packets):
            self._channel_model.transmit(state, constants.scene, packets, to_s)
        if len(messages.packets):
            inbox.remove_finished(messages)


def wait(context: RequestContext) -> None:
    """Start to wait for a message: not at all for 0 ms, without limit below 0."""
    state, rows = context.state, context.rows
    wait_s = context["timeout_ms"] / 1000.0
    until_s = state.drive.clock_s[rows] + wait_s
    state.waits.until_s[rows] = np.where(wait_s < 0.0, np.inf, until_s)
