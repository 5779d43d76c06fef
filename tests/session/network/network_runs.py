"""Runs of programs that talk to each other."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import parse_world

HERE = Path(__file__).parent


class NetworkRun:
    """A run of a program in each robot, and what they have written.

    Attributes:
        session: the run.
        written: the output of each program.
    """

    def __init__(
        self, *commands: Sequence[str], communication: str = "", timestep: str = "50ms"
    ) -> None:
        """Start programs, each a source in this folder and its arguments, in robot0, robot1, ..."""
        robots = "".join(
            f'<robot id="robot{n}" x="{n + 1}m" y="2m"/>' for n in range(len(commands))
        )
        text = f'<world version="1" timestep="{timestep}"><area length="8m" width="4m"/>'
        world = parse_world(f"{text}{communication}{robots}</world>".encode(), "net.xml")
        self.written = written = [bytearray() for _ in commands]
        self.session = Session(
            world,
            [build_executable([HERE / name], Diagnostics()) for name, *_ in commands],
            arguments=commands,
            output=lambda robot, _stream, content: written[robot].extend(content),
        )

    def finish(self, *, at_once: int = 1000, most: int = 5000) -> list[str]:
        """Run to the end; return what each program has written."""
        while self.session.timesteps < most and self.session.advance(at_once):
            pass
        assert not self.session.state.running, self.written
        return [text.decode() for text in self.written]


def served_clients(clients: int = 1, rounds: int = 1, communication: str = "") -> NetworkRun:
    """Return a run of the server of commands in robot0, with clients."""
    client = ["client.c", "robot0", "7000", str(rounds)]
    server = ["server.c", "7000", str(clients)]
    return NetworkRun(server, *[client] * clients, communication=communication)
