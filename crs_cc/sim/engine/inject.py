"""Messages that a user sends on behalf of a robot.

>>> from crs_cc.sim.comms.message_log import Fate
>>> from crs_cc.sim.engine.environment import Environment
>>> from crs_cc.sim.files.world_xml import empty_world
>>> environment = Environment(empty_world(), seed=1)
>>> inject(environment, "robot0", b"hello", kind=7)
>>> [(row["type"].item(), Fate(row["fate"]).name) for row in environment.step().traffic]
[(7, 'SENT'), (7, 'RANGE')]
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.suggest import unknown
from crs_cc.requests import CODES, DATA_SIZE, MESSAGE
from crs_cc.sim.state.messages import EVERYBODY, NO_GROUP

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment


def inject(
    environment: Environment,
    sender: str,
    content: bytes,
    receiver: str | None = None,
    *,
    channel: str = "radio",
    kind: int = 0,
) -> None:
    """Send a message now, as if the program of a robot had sent it.

    Args:
        environment: the world.
        sender: the sending robot.
        content: at most 248 bytes.
        receiver: the receiving robot; None for all others.
        channel: the channel.
        kind: the message's type, a number that the programs agree on.

    Raises:
        ValueError: it cannot be sent; the message is the reason.
    """
    if not -(2**31) <= kind < 2**31:
        raise ValueError(f"invalid type of a message {kind!r} (expected a 32-bit integer)")
    if len(content) > DATA_SIZE:
        raise ValueError(f"the message has {len(content)} bytes (maximum: {DATA_SIZE})")
    channels = [each.name for each in environment.world.communication.channels]
    if channel not in channels:
        raise ValueError(unknown("channel", channel, channels))
    names = [robot.id for robot in environment.world.robots]
    for name in (sender, receiver):
        if name is not None and name not in names:
            raise ValueError(unknown("robot", name, names))
    number = names.index(sender)
    to = EVERYBODY if receiver is None else names.index(receiver)
    if to == number:
        raise ValueError(f"{sender!r} cannot send a message to itself")
    request = np.zeros(1, MESSAGE)
    request["i"][0, :4] = to, NO_GROUP, kind, channels.index(channel)
    request["size"] = len(content)
    request["data"][0, : len(content)] = np.frombuffer(content, np.uint8)
    at_s = max(environment.time_s, float(environment.state.drive.clock_s[number]))
    environment.serve(CODES["SEND"], np.array([number]), request, np.array([at_s]))
    if not request["result"][0]:
        raise ValueError(f"{sender!r} cannot send the message")
