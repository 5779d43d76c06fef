"""The screen in the browser: a run, its player, and the pages that look at it.

Pages send commands; each is a row of the table `commands.TABLE`. The server's thread checks who may
send it and what is in it, and the thread of the run carries it out between two pieces of the run.
So nothing here needs a lock, and what a user does has its place in the history of the run.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.workbench.clients import Client
from crs_cc.workbench.commands import TABLE
from crs_cc.workbench.comparing import broadcast_runs
from crs_cc.workbench.messages import answer, message, refusal
from crs_cc.workbench.other_runs import OtherRuns
from crs_cc.workbench.pointing import Pointing
from crs_cc.workbench.server import Front, Server

if TYPE_CHECKING:
    from crs_cc.workbench.command import Command
    from crs_cc.workbench.exact_comparison import ExactComparison
    from crs_cc.workbench.feed import Feed
    from crs_cc.workbench.player import Player
    from crs_cc.workbench.run import Run

MAX_WAITING: Final = 200
"""Commands that wait for the run at most; chosen by us."""

_STATUS_S: Final = 0.2
_SHARE: Final = 0.05  # of the time that the table may take
_STATE_S: Final = 0.1  # pages move on by themselves meanwhile


class Screen:
    """Shows a run to pages, and carries out their commands.

    Attributes:
        run: the run.
        feed: what is known of it.
        player: controls when it continues.
        server: serves the pages.
        robot: the selected robot.
        pointing: poses for which programs have asked the user.
        others: recorded runs to compare with.
        exact: a comparison of variables that has been begun.
        waits: the robots whose hosts the run waits for, as text.
    """

    def __init__(
        self, run: Run, feed: Feed, player: Player, port: int = 0, front: Front | None = None
    ) -> None:
        """Serve pages on a port, 0 for any that is free, or behind a front.

        Raises:
            OSError: the port is in use.
        """
        self.run, self.feed, self.player = run, feed, player
        self.robot = 0
        self.pointing = Pointing()
        self.others = OtherRuns()
        self.exact: ExactComparison | None = None
        self.is_busy = False
        self.waits = ""
        self._waiting = 0
        self._newest: dict[str, int] = {}
        self._told_s = self._table_s = 0.0
        self._panel = ""
        feed.description["can"] = sorted(run.can)
        self.server = Server(self, port, front=front)
        feed.server = self.server

    def play(self) -> None:
        """Run and stop as requested by pages, until the player has ended."""
        self.publish()
        while count := self.player.timesteps(lambda: self.run.time_s):
            may_go_on = self.run.advance(count)
            if not may_go_on:
                self.player.pause()
                self.stopped()
                self.publish()
                continue
            if self.player.span is not None and self.run.time_s >= self.player.span[1]:
                self.run.seek(self.player.span[0])
                self.player.restart()
            self.tick()

    # -- messages to pages -----------------------------------------------------------------------

    def tick(self) -> None:
        """Report the progress of a running run, at a limited rate."""
        now_s = time.monotonic()
        if now_s - self._told_s >= _STATE_S:
            self._told_s = now_s
            self.server.broadcast_latest("state", self._state())
        if now_s >= self._table_s and self.server.page_count:
            self.server.broadcast_latest("status", self._status())
            self._send_panel()
            cost_s = time.monotonic() - now_s
            self._table_s = now_s + max(_STATUS_S, cost_s / _SHARE)

    def stopped(self) -> None:
        """Select the robot that the run has stopped for."""
        if self.run.halt.robot >= 0:
            self.robot = self.run.halt.robot

    def publish(self) -> None:
        """Send the current position of the run to all pages."""
        if not self.player.is_playing:
            self.feed.flush()
        self.server.broadcast_latest("state", self._state())
        self.server.broadcast_latest("status", self._status())
        self._send_panel()
        position = None if self.player.is_playing else self.run.where()
        if position is not None:
            self.server.broadcast_latest(
                "position", message("position", t=self.run.time_s, **position)
            )

    def _state(self) -> str:
        player, halt = self.player, self.run.halt
        return message(
            "state",
            t=self.run.time_s,
            end=self.feed.end_s,
            playing=player.is_playing and not self.waits,
            busy=self.is_busy or bool(self.waits),
            waits=self.waits,
            speed=None if math.isinf(player.speed) else player.speed,
            rate=round(player.rate, 3),
            span=player.span,
            robot=self.robot,
            asks=self.pointing.robots,
            halt={"reason": halt.reason, "text": halt.text, "robot": halt.robot},
        )

    def _status(self) -> str:
        return message("status", **self.run.status(is_playing=self.player.is_playing))

    def _announce_robots(self) -> None:
        """Announce added robots to pages."""
        world = self.run.new_world()
        if world is not None:
            self.feed.description["world"] = world
            self.server.broadcast(message("world", world=world))

    def _send_panel(self) -> None:
        """Send the contents of the control panel, if they have changed."""
        found = self.run.panel()
        text = "" if found is None else message("panel", **found)
        if text and text != self._panel:
            self._panel = text
            self.server.broadcast_latest("panel", text)

    @contextmanager
    def working(self) -> Iterator[None]:
        """Report the start of a command that may take long, and then its result."""
        before = self.run.halt, self.run.time_s
        self.is_busy = True
        self.server.broadcast_latest("state", self._state())
        try:
            yield
        finally:
            self.is_busy = False
            self.run.refresh()
            if (self.run.halt, self.run.time_s) != before:  # or else it answers about another robot
                self.stopped()
            self._announce_robots()

    def wait_for(self, robots: str) -> None:
        """Report that the run is waiting for the hosts of robots; none when it continues."""
        if robots != self.waits:
            self.waits = robots
            self._told_s = 0.0
        self.tick()

    # -- what pages ask for; in the server's thread ----------------------------------------------

    def greet(self, client: Client) -> None:
        """Send a page that has connected all that it must know."""
        self.feed.greet(client)
        self._panel = ""  # the new page does not have it
        self.player.submit(self.publish)
        self.player.submit(lambda: broadcast_runs(self))

    def receive(self, client: Client, command: dict[str, Any]) -> None:
        """Check a command and carry it out, at once or between two pieces of the run."""
        number, name = command["id"], command["command"]
        row = TABLE.get(name)
        error = self._refused(client, name, row)
        if error or row is None:
            client.put(refusal(number, error))
            return
        if row.at_once:
            for part in self._result(row, command):
                client.put(part)
            return
        self._waiting += 1
        self._newest[name] = number
        self.player.submit(self._job(client, row, command))

    def _refused(self, client: Client, name: str, row: Command | None) -> str:
        """Return why a command is not carried out; empty if it is."""
        if row is None:
            return unknown("command", name[:40], list(TABLE))
        if row.controls and client.role != "control":
            return "this page is view-only: open the address with the token for control"
        if row.needs and row.needs not in self.run.can:
            return f"'{name}' is not possible here: {WHY_NOT[row.needs]}"
        if self._waiting >= MAX_WAITING:
            return "the run is busy: too many commands are pending"
        return ""

    def _job(self, client: Client, row: Command, command: dict[str, Any]) -> Callable[[], None]:
        def do() -> None:
            self._waiting -= 1
            if row.name == "seek" and self._newest[row.name] != command["id"]:
                self.server.send(client, answer(command["id"]))  # a later one makes it vain
                return
            for part in self._result(row, command):
                self.server.send(client, part)
            if not row.asks:
                self.publish()

        return do

    def _result(self, row: Command, command: dict[str, Any]) -> list[str | bytes]:
        """Carry out a command; return the messages of its answer."""
        number = command["id"]
        try:
            value = row(self, command)
        except (DebugError, ValueError) as error:
            return [refusal(number, str(error))]
        except Exception as error:  # ours; the run must not be lost by it
            wrong = " ".join(f"{type(error).__name__}: {error}".split())
            return [refusal(number, f"internal error: {wrong}; please report it")]
        return [value, answer(number)] if isinstance(value, bytes) else [answer(number, value)]


WHY_NOT: Final = {
    "play": "it runs by itself",
    "seek": "it only goes forward; times already shown can be viewed",
    "change": "it cannot be changed",
    "debug": "it was not started by crs view, which compiles programs so that they can be stepped",
}
"""Why some runs cannot do something."""
