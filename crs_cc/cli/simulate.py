"""What `crs run` does: load, make a session, step it to its end, and tell what came of it."""

from __future__ import annotations

import json
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from crs_cc.cli.interrupt import Interrupt
from crs_cc.cli.load import Loaded, load
from crs_cc.cli.messages import as_data, is_terminal, say, show
from crs_cc.cli.output import ProgramOutput, ProgressLine, read_line
from crs_cc.cli.plot import Picture, Trip
from crs_cc.cli.summary import Run, as_json, exit_status, print_summary
from crs_cc.cli.tracks import Tracks
from crs_cc.errors import CrsError
from crs_cc.session.session import Session
from crs_cc.session.trace import Trace
from crs_cc.source import Diagnostics

if TYPE_CHECKING:
    from crs_cc.cli.run import RunOptions


def simulate(options: RunOptions) -> int:
    """Runs the programs in the world, shows what was asked for, and gives the exit status.

    Raises:
        CrsError: whatever kept the run from starting, or ended it.
        click.UsageError: a robot has no program, or the picture cannot be written.
    """
    try:
        return _simulate(options)
    except CrsError as error:
        if options.as_json:
            messages = [as_data(message) for message in error.diagnostics]
            data = {"exit_status": error.exit_status, "diagnostics": messages}
            click.echo(json.dumps(data, indent=2))
        raise


def _simulate(options: RunOptions) -> int:
    diagnostics = Diagnostics()
    loaded = load(options, diagnostics)
    if not options.quiet:
        show(diagnostics.messages)
    runner = Runner(loaded, options)
    run = runner.run()
    if options.plot is not None:
        _write(options.plot, runner.picture(run).render())
    _report(run, options)
    return exit_status(run)


class Runner:
    """Steps a session to its end, and keeps what its picture needs.

    Attributes:
        session: the session.
        tracks: where the robots went.
    """

    def __init__(self, loaded: Loaded, options: RunOptions) -> None:
        self._loaded = loaded
        self._options = options
        talks = not (options.quiet or options.trace_requests)
        self._progress = ProgressLine(sys.stderr if talks and is_terminal(sys.stderr) else None)
        self._output = ProgramOutput(
            [robot.id for robot in loaded.world.robots],
            sys.stderr.buffer if options.as_json else sys.stdout.buffer,
            sys.stderr.buffer,
            self._progress,
        )
        self._interrupt = Interrupt()
        self._started_s = time.monotonic()
        self.tracks = Tracks()
        self.session = Session(
            loaded.world,
            loaded.executables,
            seed=options.seed,
            arguments=loaded.arguments,
            output=self._output.write,
            read=self._read,
            trace=Trace(say) if options.trace_requests else None,
        )

    def run(self) -> Run:
        """Steps until all programs have ended, time is up, or Ctrl-C."""
        with self._interrupt:
            try:
                self._step_to_end()
            except KeyboardInterrupt:  # while waiting for input
                self._interrupt.requested = True
            finally:
                self._progress.clear()
                self._output.close()
        return Run(
            self.session.result(),
            str(self._options.inputs.world or ""),
            self._options.seed,
            time.monotonic() - self._started_s,
            self._interrupt.requested,
        )

    def _step_to_end(self) -> None:
        end_s = self._options.max_time_s
        self._look()
        while not self._interrupt.requested and self.session.step():
            self._look()
            self._output.flush()
            if self._progress.is_due():
                self._progress.draw(self._progress_text())
            if end_s is not None and self.session.time_s >= end_s - 1e-9:
                return

    def _look(self) -> None:
        """Keeps what the picture needs."""
        if self._options.plot is None:
            return
        environment = self.session.environment
        self.tracks.add(environment.state.x_m, environment.state.y_m)

    def _read(self, _robot: int, size: int) -> bytes:
        self._progress.clear()
        self._output.flush()
        with self._interrupt.waiting():
            return read_line(size)

    def _progress_text(self) -> str:
        simulated_s, wall_s = self.session.time_s, time.monotonic() - self._started_s
        robots = len(self._loaded.world.robots)
        return (
            f"{simulated_s:.1f} s simulated, {simulated_s / max(wall_s, 1e-9):.1f} x real time, "
            f"{self.session.running} of {robots} running"
        )

    def picture(self, run: Run) -> Picture:
        """Gives the picture of the finished run."""
        state = self.session.environment.state
        world = self._loaded.world
        self.tracks.end(state.x_m, state.y_m)
        trips = [
            Trip(robot, self.tracks.path(number), float(state.heading_rad[number]))
            for number, robot in enumerate(world.robots)
        ]
        programs = dict.fromkeys(robot.program for robot in run.result.robots)
        title = f"{', '.join(programs)} in {run.world or 'an empty world'}"
        collisions = sum(robot.collisions for robot in run.result.robots)
        subtitle = (
            f"{run.result.simulated_s:.2f} s simulated, seed {run.seed}, {collisions} collisions"
        )
        return Picture(title, subtitle, world, trips, self.tracks.contacts)


def _write(path: Path, picture: bytes) -> None:
    try:
        path.write_bytes(picture)
    except OSError as error:
        raise click.UsageError(f"cannot write '{path}': {error.strerror}.") from None


def _report(run: Run, options: RunOptions) -> None:
    """Says what came of the run, as far as anybody wants to know."""
    several = len(run.result.robots) > 1
    for robot in run.result.robots:
        if robot.error is not None:
            text = f"[{robot.id}] {robot.error.text}" if several else robot.error.text
            show([replace(robot.error, text=text)])
    if options.as_json:
        click.echo(as_json(run))
    wanted = options.summary
    if wanted is None:
        wanted = is_terminal(sys.stderr) and not options.as_json
    if wanted and not options.quiet:
        print_summary(run)
