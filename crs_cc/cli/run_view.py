"""`crs run --view`: pages that show a run while it advances by itself."""

from __future__ import annotations

import math
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

from crs_cc.cli.messages import say
from crs_cc.cli.start_view import FRAME_S, describe
from crs_cc.cli.view_address import announced
from crs_cc.workbench.attached_run import AttachedRun
from crs_cc.workbench.feed import Feed
from crs_cc.workbench.player import Player
from crs_cc.workbench.screen import Screen
from crs_cc.workbench.watcher import Watcher

if TYPE_CHECKING:
    from collections.abc import Callable

    from crs_cc.cli.load import Loaded
    from crs_cc.cli.run_options import RunOptions
    from crs_cc.debug.timeline.change import Change
    from crs_cc.session.session import Session
    from crs_cc.sim.engine.step import Step
    from crs_cc.workbench.pointing import Pointing
    from crs_cc.workbench.server import Front


class RunView:
    """Shows a run to pages, and stops it while they pause it."""

    def __init__(
        self, loaded: Loaded, options: RunOptions, seed: int, front: Front | None = None
    ) -> None:
        """Prepare to show a run, behind a front if there is one."""
        self._front = front
        world = loaded.world
        names = dict.fromkeys(path.name for row in loaded.sources for path in row)
        place = options.inputs.world
        title = ", ".join(names), "an empty world" if place is None else Path(place).name
        self._port = options.view or 0
        self._feed = Feed(describe("live", world, title, seed), max(FRAME_S, world.timestep_s))
        self._watcher = Watcher(self._feed)
        self._announced = ExitStack()
        self._player = Player(world.timestep_s, speed=options.speed)

    def begin(
        self,
        session: Session,
        has_ended: Callable[[], bool],
        changed: Callable[[Change], None],
        repeats_until_s: float,
    ) -> None:
        """Serve pages from the start of a session on.

        Args:
            session: the run.
            has_ended: returns whether the user has interrupted it.
            changed: is called with each change that pages make; calls `change`.
            repeats_until_s: up to when it is a recorded run again [s], which nothing may change.

        Raises:
            OSError: the port is in use.
        """
        self._session = session
        self._watcher.begin(session)
        self._player.has_ended = has_ended
        self._player.play()
        self._run = AttachedRun(session, self._watcher, changed, repeats_until_s)
        self._screen = Screen(self._run, self._feed, self._player, self._port, self._front)
        address = self._screen.server.address()
        if self._front is None:  # the front is announced where it is opened
            self._announced.enter_context(announced(self._screen.server.port, address))
        say(f"crs: open {address}")
        say(f"crs: view only: {self._screen.server.address('view')}")

    @property
    def pointing(self) -> Pointing:
        """Where programs ask the user for a pose."""
        return self._screen.pointing

    @property
    def is_wanted(self) -> bool:
        """Return whether commands of pages wait for the end of the timestep."""
        return self._player.has_jobs

    @property
    def speed(self) -> float:
        """The speed that pages have set: simulated by real time, infinite for no limit."""
        return self._player.speed

    def timesteps(self) -> int:
        """Wait while pages pause the run or it is too fast; return how far it may advance."""
        self._screen.tick()
        count = self._player.timesteps(lambda: self._session.time_s)
        return min(count, 1) if math.isfinite(self._player.speed) else count

    def wait_for(self, robots: str) -> None:
        """Show that the run is waiting for the hosts of robots; none when it continues."""
        self._screen.wait_for(robots)

    def step(self, step: Step) -> None:
        """Show what happened in a timestep."""
        self._watcher.step(step)

    def change(self, change: Change) -> None:
        """List a change to the run, of any origin."""
        self._run.note(change)

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Show the output of a program."""
        self._watcher.write(robot, stream, content)

    def close(self) -> None:
        """Show the end, and say good-bye to pages."""
        self._watcher.report_ends()
        self._watcher.show()
        self._player.pause()
        self._screen.publish()
        self._screen.server.close()
        self._announced.close()
