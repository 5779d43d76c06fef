"""Calm time: cycles of few robots in which a kernel does all that happens.

Calm is a world in which nothing touches or is held, no wait ends, no message is on its way, no
device is degraded, no goal changes, and all that requests and sonars depend on is known to kernels.
Robots may drive as they are told. Then the kernel of `kernels/calm.c` answers requests,
fires sonars and ends cycles, in turn with the programs, until one of them asks for something else,
or something is near a robot or due that kernels do not know. It leaves that as it was, and the
general way goes on.

The rows of robots are copied into the kernel's memory, and back.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.sensor_board import BATTERIES, BOARD_MS, LASER_COUNT
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.devices.waits import when
from crs_cc.sim.engine.calm_instruments import CalmInstruments
from crs_cc.sim.engine.passage import Passage, served_of
from crs_cc.sim.engine.quiet_time import MARGIN, NEVER
from crs_cc.sim.kernels.calm import ANSWER, CODES, FRAME, MOST, CalmKernel
from crs_cc.sim.kernels.draws import Draws
from crs_cc.sim.physics.contacts import SLOP_M

if TYPE_CHECKING:
    from crs_cc.sim.engine.dispatch import Dispatcher
    from crs_cc.sim.engine.step import Served
    from crs_cc.sim.engine.world_data import WorldData

_DEVICES: Final = ("sonar", "bumper", "battery")
_CYCLES: Final = 512  # whose frames are logged at most
_ANSWERS: Final = 40_000 // 31  # that are logged at most for observers, and
_FEW_ANSWERS: Final = 64  # for each robot if only those of a cycle are kept
_ANSWER: Final = ANSWER.itemsize // 8
_FACE, _ROUND, _BACKUP, _RECORD = 6, 4, 114, 56  # numbers for each in the kernel's tables
_DEVIATES: Final = 3  # of a firing


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
        self._is_possible = False
        self._keeps = False
        self._most = np.zeros((0, 3))
        self._find_sensors()
        self._goal_room_m = 0.0  # at the last `end`

    # -- whether it is calm ----------------------------------------------------------------------

    def begin(self, cycles: int, *, is_new: bool, keeps: bool, most: FloatArray) -> bool:
        """Prepare the kernel for calm time, if it is calm now.

        Args:
            cycles: how many may end.
            is_new: whether anything may have been changed since the last `end`.
            keeps: whether an observer is to hear of it.
            most: the speeds above which requests are left to the general way, (robots, 3).
        """
        data, state = self._data, self._data.state
        if is_new:
            if not (self._can_be_calm() and self._is_calm()):
                return False
            self._enter(keeps=keeps, most=most)
        elif keeps != self._keeps or most is not self._most:
            self._enter(keeps=keeps, most=most)
        if keeps and not all(map(_is_like_ours, self._dispatcher.served)):
            cycles = 0  # observers hear of this cycle by itself
        if is_new:
            self._goal_room_m = data.goals.room_m(state)
        left, room_m = data.physics.calm_cycles(state.bodies)
        left = min(cycles, left, self._cycles_to_event() if cycles else 0)
        if left <= 0 < cycles or not self._goal_room_m:
            return False
        self._firings.renew(self.kernel, sonar_state(state).count)
        self._instruments.renew(self.kernel)
        self.kernel.begin(state.cycle + left, state.cycle, room_m, self._goal_room_m)
        return True

    def _can_be_calm(self) -> bool:
        """Return whether kernels know all that the world has."""
        data, state, devices = self._data, self._data.state, self._data.devices
        equipment = data.constants, data.rays, devices
        if all(a is b for a, b in zip(equipment, self._equipment, strict=True)):
            return self._is_possible
        self._equipment, self._places = equipment, b""
        self._find_sensors()
        self._is_possible = (
            len(state.bodies.angle_rad) <= MOST
            and len(data.constants.kinds.table) <= MOST
            and bool(data.simple)
            and self._instruments.are_simple
            and data.constants.inclines is None
            and data.rolling.are_exact
            and not devices.has_duties
            and devices.sonars.is_simple(data.rays)
            and data.rays.few_shapes(state, len(state.connected)) is not None
        )
        return self._is_possible

    def _find_sensors(self) -> None:
        data, sonars = self._data, self._data.devices.sonars
        robots = np.arange(len(data.state.connected))
        draw = sonars.draw if sonars.kernel_tables().are_random else None
        self._firings = Draws("sonar", robots, _DEVIATES, draw)
        self._instruments = CalmInstruments(data)
        self._devices = *_DEVICES, *self._instruments.names

    def _is_calm(self) -> bool:
        data, state, constants = self._data, self._data.state, self._data.constants
        if data.is_weary or not drive.moves_as_commanded(state, constants):
            return False
        if np.count_nonzero(state.drive.hindered):
            return False
        if np.count_nonzero(bumper_state(state).pressed) or len(state.contacts_before):
            return False
        if len(state.pos_data.reported) or data.log.snapshot():
            return False
        if any(constants.degradations.concern(state, device) for device in self._devices):
            return False
        messages = state.messages
        rest = messages.receptions, messages.packets, messages.shuts, messages.outbox
        return not any(map(len, rest)) and data.physics.calm_cycles(state.bodies)[0] > 0

    def _cycles_to_event(self) -> int:
        """Return how many cycles may end before the next event that is known."""
        data, state = self._data, self._data.state
        known_s = float(state.degradation.next_s), data.due_s, data.goals.due_s(state)
        event_s = min(*known_s, self._wait_ends_s())
        if not event_s < NEVER * data.timestep_s:
            return NEVER
        return int(event_s / data.timestep_s) - MARGIN - state.cycle

    def _wait_ends_s(self) -> float:
        """Return when the first wait may end, also as its robot's command timeout expires."""
        data, state = self._data, self._data.state
        if not np.count_nonzero(state.waits.code):
            return math.inf
        waiting = state.waits.code.nonzero()[0]
        ends_s = np.minimum(when(data.waits, state, waiting), state.drive.deadline_s[waiting])
        return float(ends_s.min())

    # -- the kernel's memory ---------------------------------------------------------------------

    def _enter(self, *, keeps: bool, most: FloatArray) -> None:
        """Copy what the kernel works on into its memory."""
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
            "records": _RECORD * count,
            "work": _FACE * len(segments) + _ROUND * len(circles),
            "backup": _BACKUP * count,
            "frames": cycles * count * FRAME,
            "answers": answers * _ANSWER,
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

    def end(self) -> tuple[int, int, int, Passage | None, bool]:
        """Copy back what has changed.

        Returns:
            why the kernel has returned, the cycles that have ended, the rounds of programs in the
            current one, what observers are to hear, and whether nothing was asked in the last cycle
            that has ended, nor since.
        """
        data, state, kernel = self._data, self._data.state, self.kernel
        verdict, changed = kernel.outcome()
        cycle, room_m, self._goal_room_m, rounds, ended, answered, _, *last = changed
        served, was_served, is_weary = last
        tables = state.rows.tables(data.constants.kinds)
        for memory, table in zip(self._memories(), tables, strict=True):
            table[:] = np.ndarray(table.shape, table.dtype, memory)
        self._instruments.leave(kernel)
        passage, earlier = None, len(self._dispatcher.served)
        if ended:
            data.physics.pass_over(ended, room_m)
            data.is_weary = bool(is_weary)
            if self._keeps:
                passage = self._passage(ended, answered - served)
            state.cycle = cycle
            self._dispatcher.served = []
        if served:
            answers = kernel.table("answers", answered, ANSWER)
            self._dispatcher.served += served_of(answers[answered - served :])
        was_served |= ended == 1 and earlier
        is_untouched = bool(ended) and not (served or was_served)
        return verdict, ended, rounds, passage, is_untouched

    def _passage(self, ended: int, answered: int) -> Passage:
        data, kernel = self._data, self.kernel
        moved = kernel.content("frames", ended * len(data.state.connected) * FRAME)
        logged = kernel.content("answers", answered * _ANSWER)
        earlier = self._dispatcher.served
        return Passage(data.state.cycle, ended, data.timestep_s, moved, logged, earlier)


def _is_like_ours(served: Served) -> bool:
    """Return whether an answer has what those of the kernel have."""
    return served.states is not None and served.replies is None
