"""Sessions: runs of programs in a world, stepped, read and changed from Python.

>>> from crs_cc.api.worlds import load_world
>>> session = Session(load_world(), "int main(void) { return 7; }")
>>> session.run().robots[0].exit_status
7
>>> session
<Session of empty: 1 robot, 0.05 s>
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Final, Self

import numpy as np

from crs_cc.api.edits import Edits
from crs_cc.api.events import EventCallbacks
from crs_cc.api.numbers import check_number
from crs_cc.api.output import Streams
from crs_cc.api.program_choice import NONE, Programs, executables_of
from crs_cc.api.robots import Robots, shown_result
from crs_cc.api.run_picture import Paths, picture_of
from crs_cc.api.worlds import WorldSource, world_of
from crs_cc.core.arrays import FloatArray, read_only
from crs_cc.core.suggest import unknown
from crs_cc.core.time_grid import ROUNDING_S
from crs_cc.debug.world.events import WorldEvent
from crs_cc.runtime.executable import Executable
from crs_cc.session.host import CLIENTS, Client
from crs_cc.session.result import RunResult, SessionSnapshot
from crs_cc.session.session import Session as InnerSession
from crs_cc.sim.engine.goals import GoalResult
from crs_cc.sim.model.world import WorldModel

if TYPE_CHECKING:
    from crs_cc.jobs.cluster import Where
    from crs_cc.net.cluster_fleet import ClusterFleet

_ROUNDING: Final = 1e-6  # [timesteps]


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The whole state of a session at an instant.

    Attributes:
        state: the state.
        world: the session's world at the start.
        seed: its seed.
        programs: the machine code of its programs at the start.
        paths: where its robots have been.
    """

    state: SessionSnapshot = field(repr=False)
    world: WorldModel = field(repr=False)
    seed: int
    programs: tuple[bytes, ...] = field(repr=False)
    paths: Paths = field(repr=False)


class Session(Edits):
    """A run of programs in a world; `with` closes it where its programs are on other machines.

    Attributes:
        world: the world at the start.
        robots: the robots, by name: poses, readings, output.
        duration_s: when `run` ends [s]; None for when all programs have ended.
        seed: the random seed.
        programs: the programs at the start, in the world's order of robots.
        streams: what the programs have written.
        inner: the session behind this one, for what is not public.
    """

    def __init__(
        self,
        world: WorldModel | WorldSource | None = None,
        programs: Programs = None,
        *,
        seed: int | None = None,
        duration_s: float | None = None,
        arguments: Sequence[str] = (),
        files: Mapping[str, bytes | str] | None = None,
        stdin: bytes | str = b"",
        client: Client = "nclient",
        threads: int | None = None,
        hosts: Where | None = None,
        per_host: int | None = None,
    ) -> None:
        """Load programs into the robots of a world.

        Args:
            world: the world, or what `load_world` takes.
            programs: what the robots run: one program for all to which the world gives none; a
                program for each in the world's order; or programs by the robots' names. A
                program is what `compile_c` returns or takes. Robots without one stand still
                until `session.robots[name].drive(...)` steers them.
            seed: the random seed; by default the world's, or 0 if it has none.
            duration_s: when `run` ends [s]; by default the world's duration, infinite for none.
            arguments: `argv` without its first element, for robots to which the world gives
                neither a program nor arguments.
            files: the initial contents of every program's disk, by file name.
            stdin: the standard input of each program.
            client: which of the vendor's client libraries to emulate.
            threads: how many threads may run programs; results do not depend on it.
            hosts: a Dask cluster whose workers run the programs: a client of it, or the
                scheduler's address. Results do not depend on it; such a session goes forward only,
                and is closed at its end.
            per_host: how many robots a host there has at most; by default so many that each
                thread of its workers has a host.

        Raises:
            TypeError: an argument has the wrong type.
            ValueError: an argument is invalid.
            CompileError: a program is invalid.
            WorldError: the world is invalid.
            ClusterError: the cluster cannot be used.
        """
        self.world = world_of(world)
        check_number("seed", seed, whole=True)
        check_number("duration_s", duration_s)
        if seed is not None and seed < 0:
            raise ValueError(f"seed must be 0 or more, not {seed!r}")
        if duration_s is not None and duration_s <= 0.0:
            raise ValueError(f"duration_s must be a positive number, not {duration_s!r}")
        if client not in CLIENTS:
            raise ValueError(unknown("client", str(client), CLIENTS))
        wanted_s = self.world.duration_s if duration_s is None else duration_s
        self.duration_s = None if wanted_s == math.inf else wanted_s
        self.seed = self.world.seed or 0 if seed is None else seed
        self._events = EventCallbacks()
        self.streams = Streams(_content("stdin", stdin))
        executables, argv = executables_of(self.world, programs, arguments)
        self._hosts = None
        if hosts is not None:
            self._hosts = _on_hosts(self.world, executables, hosts, per_host)
        self.inner = InnerSession(
            self.world,
            executables,
            self.seed,
            arguments=argv,
            output=self.streams.write,
            read=self.streams.read,
            files={name: _content(name, each) for name, each in (files or {}).items()},
            client=client,
            threads=threads,
            observer=self._events,
            fleet=self._hosts,
        )
        self.programs = tuple(executables)
        self.robots = Robots(self.inner, self.streams)
        self._paths = Paths(self.positions_m)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self.close()

    def close(self) -> None:
        """Dismiss the hosts on a cluster, if there are any; results can be read afterwards."""
        if self._hosts is not None:
            self._hosts.close()

    # -- time ----------------------------------------------------------------------------------

    @property
    def time_s(self) -> float:
        """The simulated time [s]."""
        return self.inner.time_s

    @property
    def timesteps(self) -> int:
        """Number of timesteps run."""
        return self.inner.timesteps

    @property
    def timestep_s(self) -> float:
        """The length of a timestep [s]."""
        return self.world.timestep_s

    @property
    def is_time_up(self) -> bool:
        """Whether the duration has been reached."""
        return self._is_time_up(self.duration_s)

    @property
    def is_over(self) -> bool:
        """Whether the duration has been reached, or all programs have ended and no robot joins."""
        state = self.inner.state
        return self.is_time_up or not (state.running or state.environment.expects_robots)

    def step(self, timesteps: int = 1) -> bool:
        """Run some timesteps; return whether the run continues: `while session.step(): ...`.

        Raises:
            TypeError: their number is not an integer.
            ValueError: it is negative.
        """
        check_number("timesteps", timesteps, whole=True)
        if timesteps < 0:
            raise ValueError(f"timesteps must be 0 or more, not {timesteps!r}")
        end = self.timesteps + timesteps
        while self.timesteps < end and not self._is_time_up(self.duration_s):
            if not self._advance(end - self.timesteps):
                return False
        return not self._is_time_up(self.duration_s)

    def run(self, until_s: float | None = None) -> RunResult:
        """Run until a time or the end of all programs; return the result.

        Args:
            until_s: the time [s], which may be later than the duration of the session; by default
                that duration. Without either, a program that never ends runs until it is
                interrupted.

        Raises:
            TypeError: the time is not a number.
            ValueError: it is NaN.
        """
        check_number("until_s", until_s)
        end_s = self.duration_s if until_s is None else until_s
        while not self._is_time_up(end_s) and self._advance(self._timesteps_to(end_s)):
            pass
        return self.result()

    def _advance(self, most: int) -> bool:
        most = min(most, self._paths.timesteps_left(self.timesteps))
        goes_on = self.inner.advance(most, calmly=not self._events.are_wanted)
        if self._paths.is_due(self.timesteps):
            self._paths.add(self.timesteps, self.positions_m)
        self._events.report(self.inner.state)
        return goes_on

    def _is_time_up(self, end_s: float | None) -> bool:
        return end_s is not None and self.time_s >= end_s - ROUNDING_S

    def _timesteps_to(self, end_s: float | None) -> int:
        if end_s is None or not math.isfinite(end_s):
            return 2**31
        return max(1, int((end_s - self.time_s) / self.timestep_s + _ROUNDING))

    # -- contents ------------------------------------------------------------------------------

    @property
    def positions_m(self) -> FloatArray:
        """X and y of all robots now [m], (robots, 2): a read-only view."""
        state = self.inner.environment.last_state
        return read_only(state.bodies.position_m[: len(state.heading_rad)])

    @property
    def headings_rad(self) -> FloatArray:
        """The headings of all robots now [rad], (robots,): a read-only view."""
        return read_only(self.inner.environment.last_state.heading_rad)

    @property
    def poses(self) -> FloatArray:
        """X [m], y [m] and heading [rad] of all robots now, (robots, 3)."""
        return np.column_stack([self.positions_m, self.headings_rad])

    @property
    def object_poses(self) -> FloatArray:
        """X [m], y [m] and heading [rad] of all movable objects now, (objects, 3)."""
        state = self.inner.environment.last_state
        robots = len(state.heading_rad)
        return np.column_stack([state.bodies.position_m, state.bodies.angle_rad])[robots:]

    def field(self, name: str) -> FloatArray:
        """Return the amounts in a pheromone field, (rows, columns), from the smallest x and y."""
        return self.inner.environment.field(name)

    @property
    def steered(self) -> tuple[str, ...]:
        """The names of the robots without a program, which Python steers."""
        programs = self.inner.fleet.executable
        return tuple(name for n, name in enumerate(self.robots) if programs(n).name == NONE)

    @property
    def goals(self) -> tuple[GoalResult, ...]:
        """The current status of the world's goals."""
        return self.inner.goals

    def result(self) -> RunResult:
        """Return the result of the run so far; nothing is prepared for it while it runs."""
        found = self.inner.result()
        return replace(found, robots=tuple(map(shown_result, found.robots)))

    def state_hash(self) -> str:
        """Return the SHA-256 of the whole state, see `RunResult`."""
        return self.inner.state_hash()

    def snapshot(self) -> Snapshot:
        """Return the whole state, apart from the standard streams."""
        codes = tuple(each.machine_code for each in self.programs)
        paths = self._paths.copy()
        return Snapshot(self.inner.snapshot(), self.world, self.seed, codes, paths)

    def restore(self, snapshot: Snapshot) -> None:
        """Go back, or forward, to a snapshot of a session of the same programs, world and seed.

        Raises:
            TypeError: it is no snapshot.
            ValueError: it is of another world, another seed or other programs, or the programs
                are on a cluster; nothing changes.
        """
        if self._hosts is not None:
            raise ValueError("a session with programs on a cluster can only go forward")
        if not isinstance(snapshot, Snapshot):
            raise TypeError(f"restore takes a Snapshot, not {type(snapshot).__name__}")
        codes = tuple(each.machine_code for each in self.programs)
        for what, is_same in (
            ("another world", snapshot.world == self.world),
            ("another seed", snapshot.seed == self.seed),
            ("other programs", snapshot.programs == codes),
        ):
            if not is_same:
                raise ValueError(f"the snapshot is of a session with {what}")
        self.inner.restore(snapshot.state)
        self._events.restart(self.inner.state)
        self._paths = snapshot.paths.copy()

    # -- events --------------------------------------------------------------------------------

    def on(self, kind: str, function: Callable[[WorldEvent], Any]) -> None:
        """Call a function at each event of a kind, at the end of the timestep.

        Args:
            kind: such as `collision`, `message`, `exit`; docs/python.md has a list. A part of
                one is enough: `bumper` for `bumper-pressed` and `bumper-released`.
            function: receives the event; it may read and change the session.

        Raises:
            ValueError: there is no such kind.
        """
        self._events.add(kind, function, self.inner.state)

    # -- pictures ------------------------------------------------------------------------------

    def svg(self) -> str:
        """Return a picture of the run so far: the world from above and the robots' paths."""
        return picture_of(self.inner, self._paths)

    def _repr_html_(self) -> str:
        picture = self.svg().partition("?>")[2].strip()
        return f'<div style="max-width: 480px">{picture}</div>'

    def __repr__(self) -> str:
        robots = len(self.robots)
        plural = "" if robots == 1 else "s"
        return f"<Session of {self.world.name}: {robots} robot{plural}, {self.time_s:g} s>"


def _on_hosts(
    world: WorldModel,
    executables: Sequence[Executable],
    hosts: Where,
    per_host: int | None,
) -> ClusterFleet:
    """Return programs that run on a cluster."""
    check_number("per_host", per_host, whole=True)
    if per_host is not None and per_host < 1:
        raise ValueError(f"per_host must be 1 or more, not {per_host!r}")
    from crs_cc.net.cluster_fleet import ClusterFleet

    return ClusterFleet(world.robots, executables, hosts, per_host)


def _content(name: str, content: bytes | str) -> bytes:
    """Return a program's input as bytes; text is encoded in UTF-8."""
    if not isinstance(content, bytes | str):
        raise TypeError(f"{name} must be bytes or text, not {type(content).__name__}")
    return content.encode() if isinstance(content, str) else content
