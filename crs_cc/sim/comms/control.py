"""Who shuts and opens the ways of messages while a world runs: for programs that run worlds.

>>> from crs_cc.sim.engine.environment import Environment
>>> from crs_cc.sim.files.world_xml import empty_world
>>> environment = Environment(empty_world(), seed=1)
>>> environment.communication.shut(channel="radio", sender="robot0")
>>> [event.text for event in environment.step().events]
['radio from robot0 shut']
>>> environment.communication.open(channel="radio", sender="robot0")
>>> [event.text for event in environment.step().events]
['radio from robot0 opened']
>>> environment.communication.counts("radio")[Fate.SENT]
0
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from crs_cc.core.suggest import unknown
from crs_cc.sim.comms.message_log import Fate
from crs_cc.sim.comms.outages import reopen, shut
from crs_cc.sim.model.communication import ANY

if TYPE_CHECKING:
    from crs_cc.sim.state.messages import MessageState
    from crs_cc.sim.state.running_world import Running


class CommunicationControl:
    """The ways of messages in a world that runs, between two of its steps."""

    def __init__(self, running: Running) -> None:
        """Makes one.

        Args:
            running: the world; its state is changed.
        """
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

    def shut(self, *, channel: str = "", sender: str = "", receiver: str = "") -> None:
        """Shuts a channel, a sender, a receiver, or what those named have in common.

        From now on, messages are lost that begin to be transmitted there; others go on.

        Raises:
            ValueError: there is no such channel or robot.
        """
        shut(self._state, self._time_s, *self._numbers(channel, sender, receiver))

    def open(self, *, channel: str = "", sender: str = "", receiver: str = "") -> None:
        """Opens what was shut in the same words, by `shut` or in the world file.

        Raises:
            ValueError: there is no such channel or robot, or nothing that was shut so.
        """
        if not reopen(self._state, self._time_s, *self._numbers(channel, sender, receiver)):
            raise ValueError("nothing is shut that was shut in these words")

    def counts(self, channel: str) -> dict[Fate, int]:
        """Return the counts of each fate of the messages on a channel so far.

        A `messages.traffic.Monitor` counts pairs of robots, too.

        Raises:
            ValueError: there is no such channel.
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
    """Return the number of something with a name, `ANY` for no name.

    Raises:
        ValueError: there is no such thing.
    """
    if not name:
        return ANY
    if name not in names:
        raise ValueError(unknown(kind, name, names))
    return names.index(name)
