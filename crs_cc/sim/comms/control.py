"""Control of communication outages in a running world, for programs that run worlds.

>>> from crs_cc.sim.engine.environment import Environment
>>> from crs_cc.sim.files.world_xml import empty_world
>>> environment = Environment(empty_world(), seed=1)
>>> environment.communication.shut(channel="radio", sender="robot0")
>>> [event.text for event in environment.step().events]
['radio from robot0 blocked']
>>> environment.communication.open(channel="radio", sender="robot0")
>>> [event.text for event in environment.step().events]
['radio from robot0 unblocked']
>>> environment.communication.counts("radio")[Fate.SENT]
0
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.suggest import unknown
from crs_cc.sim.comms.inbox import Inboxes
from crs_cc.sim.comms.message_log import Fate
from crs_cc.sim.comms.outages import reopen, shut
from crs_cc.sim.model.communication import ANY
from crs_cc.sim.state.messages import MessageState

if TYPE_CHECKING:
    from crs_cc.sim.state.running_world import RunningWorld


@dataclass(frozen=True, slots=True)
class Message:
    """A message that a robot has received.

    Attributes:
        sender: the name of the robot that sent it.
        content: its content, at most 248 bytes.
        kind: its type, a number that the programs agree on.
        channel: the name of the channel.
        sent_s: when it was sent [s].
        arrived_s: when it arrived [s].
    """

    sender: str
    content: bytes
    kind: int
    channel: str
    sent_s: float
    arrived_s: float


MAX_SHUTS: Final = 4096
"""Outages of a run; chosen by us."""


class CommunicationControl:
    """The communication links of a running world, to be changed between two steps."""

    def __init__(self, running: RunningWorld) -> None:
        """Create the control."""
        self._running = running

    @property
    def _state(self) -> MessageState:
        return self._running.state.messages

    @property
    def _time_s(self) -> float:
        return self._running.time_s

    @property
    def _channels(self) -> tuple[str, ...]:
        return tuple(channel.name for channel in self._running.world.communication.channels)

    @property
    def _robots(self) -> tuple[str, ...]:
        return tuple(robot.id for robot in self._running.world.robots)

    def shut(
        self,
        *,
        channel: str = "",
        sender: str = "",
        receiver: str = "",
        at_s: float | None = None,
        duration_s: float | None = None,
    ) -> None:
        """Shut a channel, a sender, a receiver, or the link given by a combination of these.

        Messages whose transmission begins there from then on are lost; others are delivered.

        Args:
            channel: the channel; by default all.
            sender: the sending robot; by default all.
            receiver: the receiving robot; by default all.
            at_s: when it begins; by default now, as for times in the past.
            duration_s: how long it lasts; by default until `open`.

        Raises:
            ValueError: the channel or robot does not exist.
        """
        begin_s = self._time_s if at_s is None else max(at_s, self._time_s)
        until_s = math.inf if duration_s is None else begin_s + duration_s
        if len(self._state.shuts) >= MAX_SHUTS:
            raise ValueError(f"too many outages (maximum: {MAX_SHUTS})")
        numbers = self._numbers(channel, sender, receiver)
        shut(self._state, *numbers, at_s=begin_s, until_s=until_s)

    def open(
        self,
        *,
        channel: str = "",
        sender: str = "",
        receiver: str = "",
        at_s: float | None = None,
    ) -> None:
        """End the outage of the same channel, sender and receiver, of `shut` or the world file.

        Args:
            channel: as for `shut`.
            sender: as for `shut`.
            receiver: as for `shut`.
            at_s: when it ends; by default now, and an outage that would begin later is cancelled.

        Raises:
            ValueError: the channel, the robot or the outage does not exist.
        """
        numbers = self._numbers(channel, sender, receiver)
        end_s = self._time_s if at_s is None else max(at_s, self._time_s)
        if not reopen(self._state, self._time_s, *numbers, at_s=end_s):
            raise ValueError("no such outage")

    def receive(self, robot: str) -> Message | None:
        """Take the first message out of the inbox of a robot, as its program would; None if empty.

        Raises:
            ValueError: the robot does not exist.
        """
        number = _number(robot, self._robots, "robot")
        have, packets, arrived_s = Inboxes().take(self._state, np.array([number]))
        if not len(have):
            return None
        packet = packets[0]
        return Message(
            self._robots[packet["sender"]],
            packet["data"][: packet["size"]].tobytes(),
            int(packet["type"]),
            self._channels[packet["channel"]],
            float(packet["sent_s"]),
            float(arrived_s[0]),
        )

    def outages(self) -> list[tuple[float, float, str, str, str]]:
        """Return the outages that are not over: begin and end [s], channel, sender, receiver.

        Names are empty for all; the end is infinite for never.
        """
        channels, robots = (*self._channels, ""), (*self._robots, "")  # the last is `ANY`
        return [
            (at_s, until_s, channels[channel], robots[sender], robots[receiver])
            for at_s, until_s, channel, sender, receiver in self._state.shuts.tolist()
            if until_s > max(at_s, self._time_s)
        ]

    def counts(self, channel: str) -> dict[Fate, int]:
        """Return the number of messages on a channel by their fate so far.

        `message_log.Monitor` also counts by sender and receiver.

        Raises:
            ValueError: the channel does not exist.
        """
        number = _number(channel, self._channels, "channel")
        counts = self._state.counts[number].tolist() if number != ANY else self._state.counts.sum(0)
        return {fate: int(counts[fate]) for fate in Fate}

    def _numbers(self, channel: str, sender: str, receiver: str) -> tuple[int, int, int]:
        return (
            _number(channel, self._channels, "channel"),
            _number(sender, self._robots, "robot"),
            _number(receiver, self._robots, "robot"),
        )


def _number(name: str, names: tuple[str, ...], kind: str) -> int:
    """Return the number of the channel or robot with a name, `ANY` for no name.

    Raises:
        ValueError: there is none with this name.
    """
    if not name:
        return ANY
    if name not in names:
        raise ValueError(unknown(kind, name, names))
    return names.index(name)
