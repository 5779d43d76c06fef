"""Calm time: cycles of few robots that are executed entirely in a kernel.

While it is calm, see `calm_moments`, and kernels support everything in the world, robots drive as
commanded: then the kernel of `kernels/calm.c` answers requests, fires sonars and ends cycles, in
turn with the programs, until one of them makes another request, or something is near a robot or due
that kernels do not support. The kernel leaves that unchanged, and the general code continues.

The rows of robots are copied into the kernel's memory, and back.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.devices.sensor_board import BATTERIES, BOARD_MS, LASER_COUNT
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.engine.calm_instruments import CalmInstruments
from crs_cc.sim.engine.calm_moments import cycles_to_event, is_calm
from crs_cc.sim.engine.passage import Passage, served_of
from crs_cc.sim.kernels.calm import (
    ANSWER,
    BACKUP_SIZE,
    CODES,
    FACE_SIZE,
    FRAME,
    MAX_ROWS,
    RECORD_SIZE,
    ROUND_SIZE,
    CalmKernel,
)
from crs_cc.sim.kernels.draws import Draws
from crs_cc.sim.physics.contacts import SLOP_M

if TYPE_CHECKING:
    from crs_cc.sim.engine.dispatch import Dispatcher
    from crs_cc.sim.engine.step import Served
    from crs_cc.sim.engine.world_data import WorldData

_DEVICES: Final = ("sonar", "bumper", "battery")
_CYCLES: Final = 512  # whose frames are logged at most
_ANSWER_SIZE: Final = ANSWER.itemsize // 8  # numbers
_ANSWERS: Final = 40_000 // _ANSWER_SIZE  # that are logged at most for observers, and
_FEW_ANSWERS: Final = 64  # for each robot if only those of a cycle are kept
_DEVIATES: Final = 3  # of a firing


class CalmOutcome(NamedTuple):
    """The outcome of a passage of calm time.

    Attributes:
        verdict: why the kernel has returned, see `kernels.calm`.
        ended: the cycles that have ended.
        rounds: the rounds of programs in the current cycle.
        passage: the data for observers.
        is_untouched: whether nothing was asked in the last cycle that has ended, nor since.
    """

    verdict: int
    ended: int
    rounds: int
    passage: Passage | None
    is_untouched: bool


class CalmTime:
    """The calm time of a world.

    Attributes:
        kernel: the kernel; its memory belongs to this world.
    """

    def __init__(self, data: WorldData, dispatcher: Dispatcher, kernel: CalmKernel) -> None:
        """Prepare for calm time, which has not come yet.

        Args:
            data: the world.
            dispatcher: has what was answered in this cycle.
            kernel: the kernel.
        """
        self.kernel = kernel
        self._data, self._dispatcher = data, dispatcher
        self._equipment: tuple[object, ...] = (None,) * 3  # that tables were made for
        self._places = b""
        self._was_simple = False  # with this equipment
        self._keeps = False
        self._most = np.zeros((0, 3))
        self._find_sensors()
        self._goal_room_m = 0.0  # at the last `end`

    # -- before it -------------------------------------------------------------------------------

    def begin(self, cycles: int, *, is_new: bool, keeps: bool, most: FloatArray) -> bool:
        """Prepare the kernel for calm time, if it is calm now.

        Args:
            cycles: how many may end.
            is_new: whether anything may have been changed since the last `end`.
            keeps: whether an observer needs it.
            most: the speeds above which requests are left to the general way, (robots, 3).
        """
        data, state = self._data, self._data.state
        if is_new:
            if not (self._is_simple() and is_calm(data, self._devices)):
                return False
            self._enter(keeps=keeps, most=most)
        elif keeps != self._keeps or most is not self._most:
            self._enter(keeps=keeps, most=most)
        if keeps and not all(map(_is_like_ours, self._dispatcher.served)):
            cycles = 0  # observers receive this cycle separately
        if is_new:
            self._goal_room_m = data.goals.room_m(state)
        left, room_m = data.physics.calm_cycles(state.bodies)
        left = min(cycles, left, cycles_to_event(data) if cycles else 0)
        if left <= 0 < cycles or not self._goal_room_m:
            return False
        self._firings.renew(self.kernel, sonar_state(state).count)
        self._instruments.renew(self.kernel)
        self.kernel.begin(state.cycle + left, state.cycle, room_m, self._goal_room_m)
        return True

    def _is_simple(self) -> bool:
        """Return whether kernels know all that the world has."""
        data, state, devices = self._data, self._data.state, self._data.devices
        equipment = data.constants, data.rays, devices
        if all(a is b for a, b in zip(equipment, self._equipment, strict=True)):
            return self._was_simple
        self._equipment, self._places = equipment, b""
        self._find_sensors()
        self._was_simple = (
            len(state.bodies.angle_rad) <= MAX_ROWS
            and len(data.constants.kinds.table) <= MAX_ROWS
            and bool(data.simple)
            and self._instruments.are_simple
            and data.constants.inclines is None
            and data.rolling.are_exact
            and not devices.has_duties
            and devices.sonars.is_simple(data.rays)
            and data.rays.few_shapes(state, len(state.connected)) is not None
        )
        return self._was_simple

    def _find_sensors(self) -> None:
        data, sonars = self._data, self._data.devices.sonars
        robots = np.arange(len(data.state.connected))
        draw = sonars.draw if sonars.kernel_tables().are_random else None
        self._firings = Draws("sonar", robots, _DEVIATES, draw)
        self._instruments = CalmInstruments(data)
        self._devices = *_DEVICES, *self._instruments.names

    # -- the kernel's memory ---------------------------------------------------------------------

    def _enter(self, *, keeps: bool, most: FloatArray) -> None:
        """Copy the kernel's input into its memory."""
        data, state, kernel = self._data, self._data.state, self.kernel
        places = state.bodies.position_m[len(state.connected) :].tobytes()
        places += state.bodies.angle_rad[len(state.connected) :].tobytes()
        places += state.link.baud.tobytes() + state.presence.joined_s.tobytes()
        if places != self._places or keeps != self._keeps or most is not self._most:
            self._places, self._keeps, self._most = places, keeps, most
            self._lay()
        rows = state.rows
        kinds = data.constants.kinds
        for memory, table in zip(self._memories(), rows.tables(kinds), strict=True):
            memory[: table.nbytes] = table.tobytes()
        kernel.kinds[: kinds.table.nbytes] = kinds.table.tobytes()
        self._instruments.enter(kernel)
        self._place_circles()

    def _memories(self) -> tuple[Any, ...]:
        kernel = self.kernel
        return kernel.robots, kernel.bodies, kernel.batteries, kernel.sonars

    def _place_circles(self) -> None:
        """Place the outlines of robots where these are."""
        segments, circles = self._data.rays.obstacles(self._data.state).rows()
        self.kernel.table("circles", circles.size)[:] = circles.reshape(-1)
        self.kernel.table("segments", segments.size)[:] = segments.reshape(-1)

    def _lay(self) -> None:
        """Lay the tables of what does not change in calm time."""
        data, state = self._data, self._data.state
        count = len(state.connected)
        present = state.presence.present.nonzero()[0]
        shapes = data.rays.few_shapes(state, count)
        assert shapes is not None
        segments, circles, pieces = shapes.tables()
        sonars, batteries = data.devices.sonars, data.devices.sensor_board.batteries
        volts, volts_of = batteries.byte_tables()
        beams, modes, mistakes, _ = sonars.kernel_tables()
        commands = np.full(CODES, -1.0)
        simple = np.array([pair for pair in data.simple.items() if pair[0] < CODES])
        commands[simple[:, 0]] = simple[:, 1]
        links = np.zeros((count, CODES))
        robots = np.arange(count)
        links[:, simple[:, 0]] = data.line.time_s(state.link, simple[:, 0], robots[:, None], 0)
        tables = {
            "rows": present,
            "joined": state.presence.joined_s,
            "called": np.full(count, -np.inf),
            "modes": modes,
            "mistakes": mistakes,
            "beams": beams,
            "segments": segments,
            "circles": circles,
            "pieces": pieces,
            "links": links,
            "commands": commands,
            "most": self._most,
            "volts": volts,
            "volts_of": volts_of,
            **self._firings.tables(),
            **self._instruments.tables(),
        }
        answers = max(_ANSWERS, 2 * count) if self._keeps else _FEW_ANSWERS * count
        cycles = _CYCLES if self._keeps else 0
        spaces = {
            "records": RECORD_SIZE * count,
            "work": FACE_SIZE * len(segments) + ROUND_SIZE * len(circles),
            "backup": BACKUP_SIZE * count,
            "frames": cycles * count * FRAME,
            "answers": answers * _ANSWER_SIZE,
            **self._firings.spaces(),
            **self._instruments.spaces(),
        }
        self.kernel.lay(tables, spaces)
        self.kernel.tell(
            count=count,
            present=len(present),
            segment_count=len(segments),
            circle_count=len(circles),
            piece_count=len(pieces),
            sonar_draws=self._firings.ahead,
            **self._instruments.draws(),
            frame_room=cycles * count,
            answer_room=answers,
            keeps=self._keeps,
            laser_count=LASER_COUNT,
            batteries=BATTERIES.start,
            board_ms=BOARD_MS,
            timestep_s=data.timestep_s,
            slop_m=SLOP_M,
        )

    # -- after it --------------------------------------------------------------------------------

    def end(self) -> CalmOutcome:
        """Copy back what has changed, and return what has happened."""
        data, state, kernel = self._data, self._data.state, self.kernel
        verdict, changed = kernel.outcome()
        ended, answers, served = changed.ended, changed.answers, changed.served
        self._goal_room_m = changed.goal_room_m
        tables = state.rows.tables(data.constants.kinds)
        for memory, table in zip(self._memories(), tables, strict=True):
            table[:] = np.ndarray(table.shape, table.dtype, memory)
        self._instruments.leave(kernel)
        passage, was_served = None, bool(changed.was_served)
        if ended:
            data.physics.skip_cycles(ended, changed.room_m)
            data.is_weary = bool(changed.is_weary)
            if self._keeps:
                passage = self._passage(ended, answers - served)
            state.cycle = changed.cycle
            was_served |= ended == 1 and bool(self._dispatcher.served)
            self._dispatcher.served = []
        if served:
            logged = kernel.table("answers", answers, ANSWER)
            self._dispatcher.served += served_of(logged[answers - served :])
        is_untouched = bool(ended) and not (served or was_served)
        return CalmOutcome(verdict, ended, changed.rounds, passage, is_untouched)

    def _passage(self, ended: int, answered: int) -> Passage:
        data, kernel = self._data, self.kernel
        moved = kernel.content("frames", ended * len(data.state.connected) * FRAME)
        logged = kernel.content("answers", answered * _ANSWER_SIZE)
        earlier = self._dispatcher.served
        return Passage(data.state.cycle, ended, data.timestep_s, moved, logged, earlier)


def _is_like_ours(served: Served) -> bool:
    """Return whether an answer has what those of the kernel have."""
    return served.states is not None and served.replies is None
