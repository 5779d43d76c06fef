"""Fixtures for tests of messages: worlds with robots that send and receive."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.comms.message_log import Fate
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.engine.step import Step
from tests.sim.driver import open_world

PAIR = '<robot id="a" x="0" y="0"/><robot id="b" x="2m" y="0"/>'
DT = 0.05


def talking(
    elements: str = PAIR,
    channel: str = "",
    *,
    shuts: str = "",
    seed: int = 1,
    timestep: str = "50ms",
) -> Talk:
    """Return a world of robots without walls, with a channel `test` with these attributes."""
    said = f'<communication><channel name="test" {channel}/>{shuts}</communication>'
    return Talk(Environment(open_world(f"{elements}{said}", timestep), seed))


@dataclass
class Talk:
    """An environment whose robots send on channel number 3."""

    environment: Environment
    channel: int = 3

    def __post_init__(self) -> None:
        self.steps: list[Step] = []

    @property
    def state(self):
        return self.environment.state.messages

    def post(self, code: str, robot: int, *arguments: int, at_s: float, data: bytes = b""):
        message = np.zeros(1, MESSAGE)
        message["i"][0, : len(arguments)] = arguments
        message["size"] = len(data)
        message["data"][0, : len(data)] = list(data)
        at = np.array([at_s])
        goes_on_s = self.environment.serve(CODES[code], np.array([robot]), message, at)
        return message[0], float(goes_on_s[0])

    def send(self, robot: int, to: int = -1, *, kind: int = 0, at_s=None, size: int = 0, group=-1):
        """Send a message of `size` bytes; return whether it was accepted."""
        at_s = self.environment.time_s if at_s is None else at_s
        data = bytes(range(size))
        reply, _ = self.post("SEND", robot, to, group, kind, self.channel, at_s=at_s, data=data)
        return bool(reply["result"])

    def receive(self, robot: int, *, at_s: float, wait_ms: int = 0):
        """Return what a robot receives, and when it resumes."""
        return self.post("RECEIVE", robot, wait_ms, at_s=at_s)

    def kinds(self, robot: int) -> list[int]:
        """Remove all messages from an inbox and return their types."""
        found = []
        while True:
            message, _ = self.receive(robot, at_s=self.environment.time_s)
            if not message["result"]:
                return found
            found.append(int(message["i"][3]))

    def run(self, cycles: int = 1) -> None:
        self.steps += [self.environment.step() for _ in range(cycles)]

    def fates(self, fate: Fate) -> np.ndarray:
        """Return the records with a fate so far."""
        records = np.concatenate([step.traffic for step in self.steps])
        return records[records["fate"] == fate]

    def many(self, count: int, sender: int = 0, to: int = 1, *, size: int = 0, each: int = 50):
        """Send many messages, some in each cycle, and receive those that arrive."""
        for first in range(0, count, each):
            for _ in range(min(each, count - first)):
                assert self.send(sender, to, size=size)
            self.run()
            self.state.receptions["status"] = 2
        self.run()
