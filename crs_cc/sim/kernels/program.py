"""The kernels' program, and how Python calls it.

The C files of this folder are compiled by crs_cc itself, so that what they compute is the same to
the bit on every processor, as what robots' programs compute. Arrays are copied into the memory of
the program and out of it; a call costs about a microsecond. The program is loaded on the first
call, once for each thread.
"""

from __future__ import annotations

import atexit
import functools
import math
import struct
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray, Int32Array, Int64Array, Records
from crs_cc.core.host_system import keep_freed_memory
from crs_cc.sim.kernels.tables import (
    ADVANCE,
    ANTENNAE,
    BATTERY_SIZE,
    BODIES,
    BODY_SIZE,
    CHARGES,
    FINISH,
    FIRE,
    KIND_SIZE,
    KINDS,
    RENEW,
    REPLIES,
    REPLY,
    REPORTS,
    RING_SIZE,
    RINGS,
    ROBOT_SIZE,
    ROBOTS,
    SERVE,
    SETUP,
    SPEEDS,
)

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable

BLOCK: Final = 0x20000
"""Elements of an array in the arena; complex numbers are two numbers each."""

_SETUP: Final = struct.Struct("<6i")
_ARGUMENTS: Final = tuple(struct.Struct(f"<{count}i") for count in range(11))
_ARCS: Final = 13

ROBOTS_AT_ONCE: Final = 2048
"""Robots whose columns or rows are copied for a kernel at once."""

_NUMBER: Final = 8  # bytes
_LAST: Final = struct.Struct("<d")
_FOUR: Final = struct.Struct("<4d")
_RESULT: Final = struct.Struct("<i")

_AT_ONCE: Final = 2 * BLOCK, ROBOTS_AT_ONCE, ROBOTS_AT_ONCE, ROBOTS_AT_ONCE
_WORLD: Final = 145_000, ROBOTS, BODIES, KINDS
_ARENA: Final = 600_000, 0, 0, 0
"""Numbers in a third of the arena, rows of robots, of bodies and of kinds."""

_Column: TypeAlias = Any  # contiguous arrays of float64, or bool at the end


class Kernels:
    """An instance of the kernels.

    Attributes:
        room: numbers that the tables of a kernel have room for.
        arena: their memory.
        reals: two arguments and the result of a function of real arrays.
        complexes: the same memory as complex numbers.
        robots: the bytes of the rows of robots, see `robot.h`.
        bodies: those of robots' and objects' bodies.
        batteries: those of motor batteries.
        kinds: those of the constants of each kind of robot.
        sonars: those of robots' sonars.
    """

    def __init__(
        self, *, holds_world: bool = False, is_arena: bool = False, checked: bool = False
    ) -> None:
        """Load the program.

        Args:
            holds_world: whether the rows of a world lie in its memory, or a larger arena.
            is_arena: whether only the arena is there.
            checked: check every access through a pointer, for tests.
        """
        # Not needed by a run that computes nothing.
        from crs_cc.runtime.kernel_instance import KernelInstance

        instance = KernelInstance(executable(checked=checked))
        self._place, self._memory = int(instance.message[0]), instance.memory.data
        self._resume, self._resume_aside = instance.resume, instance.resume_without_gil
        sizes = _ARENA if is_arena else _WORLD if holds_world else _AT_ONCE
        third, robots, bodies, kinds = sizes
        self.call(SETUP, third, robots, bodies, kinds)
        arena, *tables = _SETUP.unpack_from(self._memory, self._place)
        memory = instance.memory[arena : arena + 3 * third * _NUMBER].reshape(3, -1)
        self.reals = tuple(memory.view(np.float64))
        self.complexes = tuple(memory.view(np.complex128))
        self.arena = memory.view(np.float64).reshape(-1)
        self._bytes = self.arena.data.cast("B")
        lengths = (
            robots * ROBOT_SIZE,
            bodies * BODY_SIZE,
            robots * BATTERY_SIZE,
            kinds * KIND_SIZE,
            RINGS * RING_SIZE,
        )
        self.robots, self.bodies, self.batteries, self.kinds, self.sonars = (
            instance.memory[begin : begin + size * _NUMBER].data
            for begin, size in zip(tables, lengths, strict=True)
        )
        results = memory[1:].reshape(-1)
        self._second, self._charges = results.view(np.int32), results.view(np.float64)
        self._replies = memory[1:].reshape(-1).data
        self.room = len(self.arena)

    def call(self, *arguments: int) -> None:
        """Run a kernel, by its number in `main.c`, with its other arguments."""
        _ARGUMENTS[len(arguments)].pack_into(self._memory, self._place, *arguments)
        self._resume()

    def call_aside(self, *arguments: int) -> None:
        """Run a kernel that takes long, while other threads run Python."""
        _ARGUMENTS[len(arguments)].pack_into(self._memory, self._place, *arguments)
        self._resume_aside()

    @property
    def result(self) -> int:
        """Return the result of the last kernel."""
        found: int = _RESULT.unpack_from(self._memory, self._place)[0]
        return found

    def lay(self, content: bytes, place: int = 0) -> None:
        """Copy numbers into the arena, from a place on."""
        first = place * _NUMBER
        self._bytes[first : first + len(content)] = content

    def apply(self, function: int, count: int) -> None:
        """Apply a function, by its number in `functions.c`, to arguments in the arena."""
        self.call(function, count)

    def arcs(
        self, heading_rad: FloatArray, way_m: FloatArray, turn_rad: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Return the displacements in x and y along arcs, see `odometry.arc`."""
        count = len(heading_rad)
        if count > BLOCK:
            parts = (slice(begin, begin + BLOCK) for begin in range(0, count, BLOCK))
            found = [self.arcs(heading_rad[one], way_m[one], turn_rad[one]) for one in parts]
            x_m, y_m = (np.concatenate(each) for each in zip(*found, strict=True))
            return x_m, y_m
        first, second, third = self.reals
        first[:count], second[:count], third[:count] = heading_rad, way_m, turn_rad
        self.apply(_ARCS, count)
        return first[:count].copy(), second[:count].copy()

    def columns(self, kernel: int, count: int, arrays: Sequence[_Column]) -> FloatArray:
        """Run a kernel of `drive.c` on arrays with a row for each robot, of consecutive numbers.

        Returns:
            the arena, with the arrays one after the other, changed in place; until the next call.
        """
        # Far quicker than numpy's `concatenate` for short arrays.
        self.lay(b"".join([array.tobytes() for array in arrays]))
        self.call(kernel, count)
        return self.arena

    def advance(
        self, rows: IndexArray | None, to_s: FloatArray, last_s: float, *, renews: bool = False
    ) -> int:
        """Advance robots to a time each, if nothing happens to them before, see `drive.c`.

        Args:
            rows: their rows in `robots`, None for the first ones.
            to_s: the times, (k,).
            last_s: the time up to which sensors matter.
            renews: whether their command timeouts restart.

        Returns:
            `ADVANCED`, or what happens before.
        """
        times = _LAST.pack(last_s) + to_s.tobytes()
        self._select(RENEW if renews else ADVANCE, len(to_s), rows, times)
        return self.result

    def reports(self, rows: IndexArray | None, count: int) -> Int32Array:
        """Return the motion values in `State` of robots, shape (k, 8), see `report.c`.

        Args:
            rows: their rows in `robots`, None for the first ones.
            count: the number of robots.
        """
        self._select(REPORTS, count, rows)
        return np.array(self._second[: 8 * count].reshape(count, 8))

    def antennae(
        self,
        rows: IndexArray | None,
        count: int,
        numbers: bytes,
        sizes: tuple[int, int, bool, bool],
    ) -> Int64Array:
        """Return the tiles of pheromone fields at the ends of antennae, and the places in them.

        Args:
            rows: the robots' rows in `robots`, None for the first ones, or if `numbers` has poses.
            count: the number of robots.
            numbers: what is known of fields and robots, see `fields.c`.
            sizes: the numbers of fields and antennae, whether these are the same of all robots, and
                whether `numbers` has their poses.

        Returns:
            tiles and places, (2, fields, antennae, robots), until the next call.
        """
        out = len(numbers) // _NUMBER + (0 if rows is None else count)
        self._select(ANTENNAE, count, rows, numbers, *sizes, out)
        shape = 2, *sizes[:2], count
        found = self.arena[out : out + math.prod(shape)].view(np.int64)
        return found.reshape(shape)

    def replies(self, rows: IndexArray | None, for_s: FloatArray) -> Records:
        """Return the contents of replies of robots, (k,) of dtype `REPLY`.

        Args:
            rows: their rows in `robots`, None for the first ones.
            for_s: the time for which each has been in the world, (k,).
        """
        self._select(REPLIES, len(for_s), rows, for_s.tobytes())
        return self._told(len(for_s))

    def serve(
        self,
        rows: IndexArray | None,
        service: tuple[float, float, int, int],
        clock_s: FloatArray,
        joined_s: FloatArray,
        values: Int32Array,
    ) -> tuple[int, FloatArray, FloatArray, Records]:
        """Answer requests that need nothing but the rows of robots, see `requests.c`.

        Args:
            rows: their rows in `robots`, None for the first ones.
            service: the end of the cycle, and the time up to which sensors matter [s]; the code of
                a command that sets speeds, or 0; the cycle.
            clock_s: when the requests arrive, (k,).
            joined_s: when the robots have joined, (k,).
            values: the integers of the messages, (k, 8).

        Returns:
            `ADVANCED`, or what comes before; the times of the replies, (k,); x, y [m] and direction
            [rad] of the robots' mounts, (k, 3); and the data of replies, of dtype `REPLY`.
        """
        count = len(clock_s)
        numbers = clock_s.tobytes() + joined_s.tobytes() + values.tobytes()
        self._select(SERVE, count, rows, _FOUR.pack(*service) + numbers)
        found = self.result
        first = 4 + (0 if rows is None else count)
        times_s = self.arena[first : first + count].copy()
        first += 2 * count
        mounts = self.arena[first : first + 3 * count].reshape(-1, 3).copy()
        return found, times_s, mounts, self._told(count)

    def fire(
        self, rows: IndexArray | None, to_s: FloatArray, numbers: bytes, sizes: tuple[int, int, int]
    ) -> int:
        """Fire sonars that are due, at most one of each robot, see `sonars.c`.

        Args:
            rows: the robots' rows in `robots`, None for the first ones.
            to_s: up to when, (k,).
            numbers: the first row of each robot's beams, (k,); the deviates of its next firing, (k,
                3); the beams; rows of segments, and of circles.
            sizes: how many numbers describe the beams; the numbers of segments, and of circles.

        Returns:
            `ADVANCED`; `SENSOR_DUE` if more are due; `NOT_HANDLED` if nothing was done, as
            robots may not have moved as their wheels did.
        """
        self._select(FIRE, len(to_s), rows, to_s.tobytes() + numbers, *sizes)
        return self.result

    def charges(self, rows: IndexArray | None, for_s: FloatArray) -> FloatArray:
        """Return the charges of the batteries of computers and motors, 0 to 1, (k, 2).

        Args:
            rows: their rows in `robots`, None for the first ones.
            for_s: the time for which each has been in the world, (k,).
        """
        self._select(CHARGES, len(for_s), rows, for_s.tobytes())
        return self._charges[: 2 * len(for_s)].reshape(-1, 2).copy()

    def set_speeds(
        self,
        rows: IndexArray | None,
        speed: FloatArray,
        ramp: FloatArray | None,
        which: FloatArray | None,
    ) -> None:
        """Ramp axes of robots to speeds within their limits.

        Args:
            rows: their rows in `robots`, None for the first ones.
            speed: of each axis, (k, 3).
            ramp: their accelerations, (k, 3); None for those of commands.
            which: 1 for the axes to change, (k, 3); None for all.
        """
        numbers, places = speed.tobytes(), []
        for each in (ramp, which):
            places.append(0 if each is None else len(numbers) // _NUMBER)
            numbers += b"" if each is None else each.tobytes()
        self._select(SPEEDS, len(speed), rows, numbers, *places)

    def finish(
        self,
        count: int,
        cycle: tuple[float, float, bool, float],
        joined_s: FloatArray,
        before_m: FloatArray | None,
    ) -> tuple[int, list[int], bool]:
        """End a cycle of the first robots, see `cycle.c`.

        Args:
            count: how many.
            cycle: its length and end [s], whether the robots move as their wheels do, and whether
                any wheel has turned or was held back, negative if that is not known.
            joined_s: when each has joined, (count,).
            before_m: where they were, if they have moved already, (count, 2).

        Returns:
            `ADVANCED`, or `NOT_HANDLED` if they have moved, but for rounding errors nothing else
            was done; the robots whose batteries are empty now; and whether any is by the end of the
            next cycle.
        """
        before = b"" if before_m is None else before_m.tobytes()
        self._select(FINISH, count, None, _FOUR.pack(*cycle) + joined_s.tobytes() + before)
        found = self._second
        empty = found[2 : 2 + found[0]].tolist() if found[0] else []
        return self.result, empty, bool(found[1])

    def _told(self, count: int) -> Records:
        """Return copies of the first replies in the arena, of dtype `REPLY`."""
        return np.ndarray(count, REPLY, bytearray(self._replies[: count * REPLY.itemsize]))

    def _select(
        self,
        kernel: int,
        count: int,
        rows: IndexArray | None,
        numbers: bytes = b"",
        *places: int,
    ) -> None:
        """Run a kernel on some of the `robots`, with numbers, and places in them."""
        self.lay(numbers if rows is None else rows.tobytes() + numbers)
        self.call(kernel, count, rows is not None, *places)

    def number(self, function: int, a: float, b: float) -> float:
        """Return a function of one or two numbers."""
        first, second, result = self.reals
        first[0], second[0] = a, b
        self.apply(function, 1)
        return float(result[0])


def pairs(points: ComplexArray) -> FloatArray:
    """Return complex numbers as pairs of real ones, shape (k, 2), as kernels read them."""
    return np.ascontiguousarray(points).view(np.float64).reshape(-1, 2)


@functools.cache
def executable(*, checked: bool) -> Executable:
    """Return the kernels' program."""
    from crs_cc.toolchain.kernels import build_kernels

    keep_freed_memory()
    return build_kernels(Path(__file__).parent, checked=checked)


class _Threads(threading.local):
    """The instance of each thread, made on first use."""

    kernels: Kernels | None = None


_threads: Final = _Threads()


def kernels() -> Kernels:
    """Return this thread's kernels."""
    found = _threads.kernels
    if found is None:
        found = _threads.kernels = Kernels()
    return found


@atexit.register
def _release() -> None:
    """Release the instance while wasmtime can still do so."""
    _threads.kernels = None
    executable.cache_clear()
