"""Run programs: load them, create a session, step it to its end, and report the results."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.captured_output import CapturedOutput
from crs_cc.cli.exit_status import SYSTEM
from crs_cc.cli.export_run import export_run, is_exported, with_recording
from crs_cc.cli.inputs import is_animation
from crs_cc.cli.interrupt import Interrupt
from crs_cc.cli.load import Loaded, load
from crs_cc.cli.messages import as_data, is_terminal, say, show, show_before_run
from crs_cc.cli.open_real_network import open_real_network
from crs_cc.cli.pace import Pace, progress_text
from crs_cc.cli.program_output import ProgramOutput, ProgressLine
from crs_cc.cli.report import show_reports
from crs_cc.cli.run_hints import RunHints
from crs_cc.cli.save_files import discarded_warning, missed_warning, save_all
from crs_cc.cli.summary import Run, as_json, exit_status
from crs_cc.cli.typed_input import OwnInput, Script, read_script
from crs_cc.cli.written_file import written_file
from crs_cc.core.errors import CrsError
from crs_cc.core.source import Diagnostic, Diagnostics, Location
from crs_cc.session.session import Listener, Session
from crs_cc.sim.engine.step import Step
from crs_cc.sim.model.world import WorldModel

if TYPE_CHECKING:
    from crs_cc.cli.live_map import LiveMap
    from crs_cc.cli.real_network import RealNetwork
    from crs_cc.cli.remote_hosts import RemoteHosts
    from crs_cc.cli.run_changes import RunChanges
    from crs_cc.cli.run_options import RunOptions
    from crs_cc.cli.run_plot import RunPlot
    from crs_cc.cli.run_view import RunView
    from crs_cc.cli.vendor_clients import VendorClients
    from crs_cc.debug.timeline.change import Change
    from crs_cc.recording.recorder import Recorder
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.diagnosis.lost_blocks import LostBlocks

_AT_ONCE_S: Final = 5.0
"""Simulated time between two looks at interrupts: a program computes less than a second for it."""

_UNLIMITED: Final = 2**30
_ROUNDING: Final = 1e-6  # [timesteps]


def simulate(options: RunOptions) -> int:
    """Run the programs in the world, report the results, and return the exit status.

    Raises:
        CrsError: the run cannot start, or has failed.
        click.UsageError: a robot has no program.
        OSError: the results or the picture cannot be written.
    """
    try:
        return _simulate(options)
    except CrsError as error:
        if options.as_json:
            messages = [as_data(message) for message in error.diagnostics]
            data = {"exit_status": error.exit_status, "diagnostics": messages}
            import json

            click.echo(json.dumps(data, indent=2))
        raise


def _simulate(options: RunOptions) -> int:
    diagnostics = Diagnostics()
    with with_recording(options) as run:
        loaded = load(run, diagnostics)
        if not run.quiet:
            show_before_run(diagnostics.messages)
        return run_loaded(loaded, run, diagnostics)


def run_loaded(
    loaded: Loaded,
    options: RunOptions,
    diagnostics: Diagnostics,
    remote_hosts: RemoteHosts | None = None,
) -> int:
    """Run programs that are loaded, report the results, and return the exit status.

    Args:
        loaded: the world and the programs.
        options: how to run them.
        diagnostics: what was found when they were loaded.
        remote_hosts: where they run, if not here.
    """
    runner = Runner(loaded, options, remote_hosts)
    run = runner.run()
    hints = [] if options.quiet else options.compiler.warnings.select(list(runner.hints.at_end()))
    _report(run, options, [*diagnostics.messages, *runner.hints.found, *hints])
    show(hints)
    is_kept = _save_files(runner.session, run, options)
    runner.report_recording()
    runner.draw(run)
    if is_exported(options):
        export_run(options)
    if remote_hosts is not None:
        remote_hosts.close()
    return exit_status(run) if is_kept else SYSTEM


class Runner:
    """Steps a session to its end, and collects the data of the plot."""

    def __init__(
        self, loaded: Loaded, options: RunOptions, remote_hosts: RemoteHosts | None = None
    ) -> None:
        self._loaded = loaded
        self._hosts = remote_hosts
        self._options = options
        world = loaded.world
        self._seed = options.seed if options.seed is not None else world.seed or 0
        self._end_s = options.max_time_s or world.duration_s
        self._live = _live_map(options)
        talks = not (options.quiet or options.trace or self._live)
        self._progress = ProgressLine(sys.stderr if talks and is_terminal(sys.stderr) else None)
        self._output = ProgramOutput(
            [robot.id for robot in world.robots],
            sys.stderr.buffer if options.as_json else sys.stdout.buffer,
            sys.stderr.buffer,
            self._progress,
        )
        self._interrupt = Interrupt()
        self._changes = _changes(options, world)
        self._real_network: RealNetwork | None = None
        self._pace = Pace(options.speed if options.view is None else math.inf)  # a view has its own
        self._captured = CapturedOutput(len(world.robots)) if options.as_json else None
        self._started_s = time.monotonic()
        self._plot = _plot(options)
        self._trace = _trace(options.trace, world) if options.trace else None
        self._clients = _vendor_clients(loaded, options)
        self._input = self._source_of_input()
        self._recorder = _recorder(loaded, options, self._seed)
        self._view = _run_view(loaded, options, self._seed, remote_hosts)
        self.session = Session(
            world,
            loaded.executables,
            seed=self._seed,
            arguments=loaded.arguments,
            output=self._write,
            read=self._read,
            files=loaded.files,
            client=options.client,
            # A recording has what was read, not when it could be.
            waiting=self._waiting,
            trace=self if self._trace or self._plot or self._live or self._view else None,
            observer=self._recorder,
            threads=options.threads,
            fleet=None if remote_hosts is None else remote_hosts.fleet,
        )
        self.hints = RunHints(self.session)

    def _source_of_input(self) -> Script | OwnInput | RemoteHosts | VendorClients:
        if self._options.input:
            return read_script(self._options.input)
        return self._clients or self._hosts or OwnInput()

    def run(self) -> Run:
        """Step until all programs have ended, time is up, or Ctrl-C."""
        with self._interrupt:
            try:
                self._begin()
                self._step_to_end()
            except KeyboardInterrupt:  # while waiting for input
                self._interrupt.requested = True
            finally:
                self._progress.clear()
                self._output.close()
                for each in (self._clients, self._real_network, self._view):
                    if each is not None:
                        each.close()
                if self._live is not None:
                    self._live.draw(self.session, self._progress_text())
                    self._live.close()
                self.session.close()
        result = self.session.result()
        if self._recorder is not None:
            self._recorder.finish(result)
        if self._changes is not None:
            self._changes.report()
        return Run(
            result,
            str(self._options.inputs.world or ""),
            self._seed,
            time.monotonic() - self._started_s,
            self._interrupt.requested,
            tuple(self._current_calls()),
            self._captured,
            tuple(self._lost_blocks()),
        )

    def _begin(self) -> None:
        """Start the view, the clients and the connections of the run."""
        if self._hosts is not None:
            self._hosts.begin(self.session, lambda: self._interrupt.requested)
        if self._recorder is not None:
            self._recorder.begin(self.session)
        if self._view is not None:
            repeats_until_s = 0.0 if self._hosts is None else self._hosts.repeats_until_s
            self._view.begin(
                self.session,
                lambda: self._interrupt.requested,
                self._record_change,
                repeats_until_s,
            )
            if self._hosts is not None:
                self._hosts.on_waiting = self._view.wait_for
        if self._clients is not None:
            pointing = None if self._view is None else self._view.pointing
            self._clients.begin(self.session, pointing, self._must_end_timestep)
        self._real_network = open_real_network(self.session, self._options, self._note)

    def _must_end_timestep(self) -> bool:
        """Return whether the timestep must end without waiting for further clients."""
        return self._interrupt.requested or (self._view is not None and self._view.is_wanted)

    def _lost_blocks(self) -> Iterator[tuple[LostBlocks, ...]]:
        """Yield the heap blocks that each program has lost at its end, if they are reported."""
        wanted = self._options.as_json or shows_summary(self._options)
        for robot in range(len(self.session.fleet)):
            yield self.session.state.lost_blocks(robot) if wanted else ()

    def _current_calls(self) -> Iterator[ActiveCall | None]:
        """Yield the active call of each program that has not ended, if it is reported."""
        wanted = self._options.as_json or shows_summary(self._options)
        for robot in range(len(self.session.fleet)):
            yield self.session.state.current_call(robot) if wanted else None

    def _step_to_end(self) -> None:
        end_s = self._end_s
        self._sample()
        self._change()
        advance = self.session.advance
        calmly = self._recorder is None or not self._recorder.needs_each
        while not self._interrupt.requested and advance(self._most_timesteps(), calmly=calmly):
            self._sample()  # hashes are of the start of a timestep, before it is changed
            self._change()
            self._output.flush()
            if self._pace.is_limited:
                self._pace.wait(self.session.time_s, lambda: self._interrupt.requested)
            if end_s is None and not self._options.quiet:
                self._hint_at_silence()
            if self._progress.is_due():
                self._progress.draw(self._progress_text())
            if self._live is not None and self._live.is_due():
                self._live.draw(self.session, self._progress_text())
            if end_s is not None and self.session.time_s >= end_s - 1e-9:
                return

    def _change(self) -> None:
        """Make the changes that are due or come over the network, and record them."""
        if self._real_network is not None:
            self._real_network.exchange()
        if self._hosts is not None:
            self._hosts.change(self._record_change)
        if self._changes is None:
            return
        before = len(self.session.fleet)
        self._changes.apply_due(self.session, self._record_change)
        for robot in self.session.environment.world.robots[before:]:
            self._output.add(robot.id)
            if self._captured is not None:
                self._captured.add_robot()

    def _note(self, change: Change) -> None:
        if self._recorder is not None:
            self._recorder.change(change.as_data())

    def _record_change(self, change: Change) -> None:
        """Record a change by a user, and show it in pages."""
        self._note(change)
        if self._view is not None:
            self._view.change(change)

    def _hint_at_silence(self) -> None:
        """Report the progress of a run that has no time limit and prints nothing."""
        hint = self.hints.silence(on_terminal=is_terminal(sys.stderr))
        if hint is not None and self._options.compiler.warnings.severity(hint.flag) is not None:
            self._progress.clear()
            show([hint])

    def _most_timesteps(self) -> int:
        """Return the number of timesteps to run until output and interrupts are checked again."""
        most = self._changes.timesteps_left(self.session) if self._changes else _UNLIMITED
        if self._hosts is not None:
            most = min(most, self._hosts.timesteps_left() or most)
        if self._view is not None:  # which does what pages ask for, and waits
            most = min(most, self._view.timesteps())
            if self._clients is not None:
                self._clients.set_speed(self._view.speed)
            return min(most, 1) if self._real_network else most
        if self._plot or self._live or self._pace.is_limited or self._real_network:
            return 1  # it samples each, or waits after each
        left_s = _AT_ONCE_S / max(self.session.state.running, 1)
        if self._recorder is not None:
            left_s = min(left_s, self._recorder.seconds_left())
        if self._end_s is not None:
            left_s = min(left_s, self._end_s - self.session.time_s)
        return max(1, min(most, int(left_s / self._loaded.world.timestep_s + _ROUNDING)))

    def step(self, step: Step) -> None:
        """Process a timestep: trace it, and collect contacts for the plot."""
        if self._trace is not None:
            self._output.flush()
            self._trace.step(step)
        if self._plot is not None:
            self._plot.add_contacts(step, len(self.session.fleet))
        if self._live is not None:
            self._live.add_contacts(step)
        if self._view is not None:
            self._view.step(step)

    def _sample(self) -> None:
        """Add the current positions to the plot and to the recording."""
        if self._hosts is not None:
            self._hosts.check_resumption()
        if self._recorder is not None:
            self._recorder.sample()
        if self._plot is not None:
            self._plot.sample(self.session)
        if self._live is not None:
            self._live.sample(self.session)

    def report_recording(self) -> None:
        """Report whether the recording ended early."""
        if self._recorder is not None and self._recorder.failed is not None:
            reason, path = self._recorder.failed.strerror, self._options.record
            text = f"the recording ends at {self._recorder.written_s:.2f} s: {reason}"
            show([Diagnostic("warning", Location(str(path)), text)])

    def draw(self, run: Run) -> None:
        """Write the plot of the finished run, if it is wanted.

        Raises:
            OSError: it cannot be written.
        """
        if self._plot is not None and self._options.plot is not None:
            programs = [f"{Path(row[0]).name}.c" for row in self._loaded.arguments]
            sensors = self._options.plot_sensors
            picture = self._plot.picture(self.session, run, programs, sensors=sensors)
            with written_file(self._options.plot):
                self._options.plot.write_bytes(picture)

    def _read(self, robot: int, size: int) -> bytes:
        with self._waiting_for_input():
            content = self._input.read(robot, size)
        if self._recorder is not None:
            self._recorder.read(robot, content)
        return content

    def _waiting(self, robot: int, clock_s: float) -> tuple[int, float]:
        with self._waiting_for_input():  # a pipe may have nothing yet
            answer = self._input.waiting(robot, clock_s)
        if self._recorder is not None:
            self._recorder.waiting(robot, clock_s, answer)
        return answer

    @contextmanager
    def _waiting_for_input(self) -> Iterator[None]:
        """Show the output so far, and let Ctrl-C end the run."""
        self._progress.clear()
        self._output.flush()
        # Clients outside let a timestep end after Ctrl-C.
        with self._interrupt.waiting() if self._clients is None else nullcontext():
            yield

    def _write(self, robot: int, stream: int, content: bytes) -> None:
        if self._hosts is None or not self._hosts.shows_output:  # else it is shown there
            self._output.write(robot, stream, content)
        self.hints.wrote()
        if self._captured is not None:
            self._captured.add(robot, stream, content)
        if self._recorder is not None:
            self._recorder.write(robot, stream, content)
        if self._view is not None:
            self._view.write(robot, stream, content)

    def _progress_text(self) -> str:
        running = f"{self.session.state.running} of {len(self._loaded.world.robots)} running"
        real_s = time.monotonic() - self._started_s
        return progress_text(self.session.time_s, self._end_s, real_s, running)


def shows_summary(options: RunOptions) -> bool:
    """Return whether to show the summary: by default on a terminal."""
    if options.summary is None:
        return is_terminal(sys.stderr) and not options.quiet
    return options.summary


def _plot(options: RunOptions) -> RunPlot | None:
    if options.plot is None or is_animation(options.plot):
        return None
    from crs_cc.cli.run_plot import RunPlot

    return RunPlot()


def _changes(options: RunOptions, world: WorldModel) -> RunChanges | None:
    if options.changes is None:
        return None
    from crs_cc.cli.run_changes import RunChanges

    return RunChanges(options.changes, world.timestep_s)


def _run_view(
    loaded: Loaded, options: RunOptions, seed: int, remote_hosts: RemoteHosts | None
) -> RunView | None:
    if options.view is None:
        return None
    from crs_cc.cli.run_view import RunView

    return RunView(loaded, options, seed, None if remote_hosts is None else remote_hosts.front)


def _vendor_clients(loaded: Loaded, options: RunOptions) -> VendorClients | None:
    if not options.vendor:
        return None
    from crs_cc.cli.vendor_clients import VendorClients

    return VendorClients(options.vendor, loaded.world, loaded.sources, options.speed)


def _live_map(options: RunOptions) -> LiveMap | None:
    if not options.live:
        return None
    from crs_cc.cli.live_map import LiveMap, reason_against

    reason = reason_against(sys.stderr)
    if reason:
        say(f"crs: no live map: {reason}")
        return None
    return LiveMap(sys.stderr)


def _recorder(loaded: Loaded, options: RunOptions, seed: int) -> Recorder | None:
    if options.record is None:
        return None
    from crs_cc.cli.start_recording import start_recording

    return start_recording(loaded, options, seed, options.max_time_s or 0.0)


def _trace(what: str, world: WorldModel) -> Listener:
    from crs_cc.session.trace import MessageTrace, Trace

    names = [robot.id for robot in world.robots]
    if what == "requests":
        return Trace(say, names)
    return MessageTrace(say, names, [channel.name for channel in world.communication.channels])


def _save_files(session: Session, run: Run, options: RunOptions) -> bool:
    """Save the files that programs wrote, or warn; return whether all to be saved were saved."""
    robots = run.result.robots
    if not options.quiet:
        found = [missed_warning(robot, session.missed_files(n)) for n, robot in enumerate(robots)]
        show([each for each in found if each is not None])
    written = {number: session.files(number) for number in range(len(robots))}
    lost = [number for number, files in written.items() if files]
    if options.outputs is None:
        if lost and not options.quiet:
            show([discarded_warning(robots[number], written[number]) for number in lost])
        return True
    return save_all(options.outputs, [(robots[n].id, files) for n, files in written.items()])


def _report(run: Run, options: RunOptions, warned: Sequence[Diagnostic]) -> None:
    """Report the results of the run, and with JSON all warnings."""
    show_reports(run.result.robots)
    if options.as_json:
        click.echo(as_json(run, warned))
    if shows_summary(options):
        from crs_cc.cli.summary_table import print_summary

        print_summary(run)
