"""Robots that clients drive, stepped by their requests, in a thread of the test."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from crs_cc.core.source import Diagnostics
from crs_cc.net.vendor.relay import RELAY
from crs_cc.net.vendor.server import Server
from crs_cc.net.vendor.switchboard import Switchboard
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.model.world import WorldModel


@dataclass
class Served:
    """A run whose robots are driven from outside."""

    session: Session
    board: Switchboard
    server: Server
    output: list[bytes] = field(default_factory=list)
    failed: list[BaseException] = field(default_factory=list)


@contextmanager
def served(world: WorldModel) -> Iterator[Served]:
    """Serve clients of all robots of a world; end when all have quit or the block ends."""
    relay = build_executable([RELAY], Diagnostics())
    output: list[bytes] = []
    board = Switchboard(range(len(world.robots)), world.timestep_s)
    session = Session(
        world,
        [relay] * len(world.robots),
        output=lambda _robot, _stream, content: output.append(content),
        read=board.read,
        waiting=board.waiting,
    )
    session.state.host.reply = board.reply
    run = Served(session, board, Server(board), output)
    run.server.loop.set_exception_handler(
        lambda _loop, context: run.failed.append(context.get("exception") or RuntimeError(context))
    )

    def steps() -> None:
        try:
            while session.step():
                pass
        except BaseException as error:  # for the test's thread
            run.failed.append(error)

    thread = threading.Thread(target=steps)
    thread.start()
    try:
        yield run
    finally:
        board.close()
        thread.join(30)
        run.server.close()
    assert not run.failed
    assert not thread.is_alive()
