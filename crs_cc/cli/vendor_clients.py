"""Programs linked with the vendor's client libraries that control the robots of a run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.messages import say
from crs_cc.cli.pace import Pace
from crs_cc.core.loopback import LOOPBACK
from crs_cc.core.suggest import unknown
from crs_cc.core.units import m_to_tenths_inch
from crs_cc.net.vendor.relay import RELAY
from crs_cc.net.vendor.server import Server
from crs_cc.net.vendor.switchboard import Switchboard

if TYPE_CHECKING:
    from pathlib import Path

    from crs_cc.cli.vendor_options import VendorOptions
    from crs_cc.net.vendor.switchboard import Configuration
    from crs_cc.session.session import Session
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.pointing import Pointing

_EVERYWHERE: Final = "0.0.0.0"  # noqa: S104 - the user has insisted


class _Window:
    """The simulator's window, to which programs ask the user to point."""

    def __init__(self, pointing: Pointing, names: Sequence[str]) -> None:
        self._pointing, self._names = pointing, names

    def ask(self, robot: int, answer: Callable[[Configuration], None]) -> None:
        """Ask for a configuration of a robot."""

        def convert(pose: tuple[float, float, float]) -> None:
            x_m, y_m, heading_deg = pose
            heading = round(heading_deg * 10) % 3600
            x, y = (round(float(m_to_tenths_inch(each))) for each in (x_m, y_m))
            answer((x, y, heading, heading))

        say(f"crs: the program of {self._names[robot]} asks for a pose: click in the page")
        self._pointing.ask(robot, convert)

    def forget(self, robot: int) -> None:
        """Ask no more."""
        self._pointing.forget(robot)


class VendorClients:
    """Serves these clients, and is the standard input of their robots' programs."""

    def __init__(
        self,
        options: VendorOptions,
        world: WorldModel,
        sources: Sequence[Sequence[Path]],
        speed: float,
    ) -> None:
        """Prepare to serve.

        Args:
            options: what is served.
            world: the world.
            sources: each robot's C files.
            speed: the multiple of real time; infinite if time goes by requests.

        Raises:
            click.UsageError: a robot is not one that is driven from outside.
        """
        self._options, self._pace = options, Pace(speed)
        self._names = [robot.id for robot in world.robots]
        relays = [number for number, files in enumerate(sources) if RELAY in files]
        self._board = Switchboard(relays, world.timestep_s, self._clock)
        self._server: Server | None = None
        first = self._names[0] if self._names else ""
        self._ports = [(name or first, port) for name, port in options.tcp_robots]
        self._check([*options.terminals, *(name for name, _ in self._ports)])

    def begin(
        self, session: Session, pointing: Pointing | None, must_not_wait: Callable[[], bool]
    ) -> None:
        """Open the ports, and say which.

        Args:
            session: the run.
            pointing: asks the user for poses for programs; None without a page.
            must_not_wait: returns whether the timestep must end without waiting for clients.

        Raises:
            OSError: a port is in use.
        """
        self._session = session
        state = session.state  # its arrays are new when robots are added
        self._board.begin(lambda robot: float(state.clock_s[robot]), must_not_wait)
        session.state.host.reply = self._board.reply
        if pointing is not None:
            self._board.pointing = _Window(pointing, self._names)
        self._pace.restart()
        host = _EVERYWHERE if self._options.insecure else LOOPBACK
        self._server = Server(self._board, self._left_s, host)
        if self._options.insecure:
            say("crs: INSECURE: the vendor's protocols have no password: anyone who reaches a port "
                "can drive its robot")  # fmt: skip
        self._open_lines(self._server, host)
        if self._options.nserver is not None:
            opened = self._server.serve_nserver(self._options.nserver)
            say(f"crs: Nserver is on port {opened} of {host}")

    def _open_lines(self, server: Server, host: str) -> None:
        """Open the lines of single robots."""
        for name in self._options.terminals:
            place = server.serve_terminal(self._names.index(name))
            say(f"crs: {name} is on {place}")
        for name, port in self._ports:
            opened = server.serve_line(port, self._names.index(name))
            say(f"crs: {name} is on port {opened} of {host}")

    def _check(self, names: Sequence[str]) -> None:
        """Check that robots can have lines.

        Raises:
            click.UsageError: one cannot, or is named twice.
        """
        for name in names:
            if name not in self._names:
                raise click.UsageError(f"{unknown('robot', name, self._names)}.")
            if self._names.index(name) not in self._board.robots:
                raise click.UsageError(f"'{name}' has a program: it cannot be controlled.")
            if names.count(name) > 1:
                raise click.UsageError(f"'{name}' has only one line.")

    @property
    def _clock(self) -> Pace | None:
        """The clock that time goes by; None if it goes by requests."""
        return self._pace if self._pace.is_limited else None

    def _left_s(self, simulated_s: float) -> float:
        """Return the real time until a simulated time [s]."""
        return self._pace.left_s(simulated_s)

    def set_speed(self, speed: float) -> None:
        """Keep to a multiple of real time; if it is infinite, time goes by requests."""
        if speed != self._pace.speed:
            pace = Pace(speed)
            pace.restart(self._session.time_s)
            self._pace = pace  # at once, since clients are served in a thread of their own
            self._board.clock = self._clock

    def waiting(self, robot: int, clock_s: float) -> tuple[int, float]:
        """Return the available input of a program, and how long a read waits [s]."""
        if robot not in self._board.robots:
            return 0, 0.0
        return self._board.waiting(robot, clock_s)

    def read(self, robot: int, size: int) -> bytes:
        """Return the next bytes of a program's input."""
        return self._board.read(robot, size) if robot in self._board.robots else b""

    def close(self) -> None:
        """Close the connections of all clients."""
        self._board.close()
        if self._server is not None:
            self._server.close()
