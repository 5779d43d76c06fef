"""Kernels that measure distances: first echoes of pings, and beams.

The shapes within reach are copied into the arena with each call.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.errors import WorldError
from crs_cc.core.source import Location
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.tables import COVERS, ECHOES, RAYS, SCAN

_VIEWER: Final = 5  # numbers of a robot
_WIDTHS: Final = 7, 5, 14  # of rows of segments, circles and pieces
_NUMBER: Final = 8  # bytes


class Shapes(NamedTuple):
    """All shapes of a small world, for `scan` and `Kernels.fire`.

    Attributes:
        counts: the numbers of segments, circles and pieces.
        content: their rows, see `rays.c`, one after the other.
    """

    counts: tuple[int, int, int]
    content: bytes

    @classmethod
    def of(cls, segments: FloatArray, circles: FloatArray, pieces: FloatArray) -> Self:
        """Return shapes from their rows."""
        tables = segments, circles, pieces
        content = b"".join([table.tobytes() for table in tables])
        return cls((len(segments), len(circles), len(pieces)), content)

    def tables(self) -> tuple[FloatArray, ...]:
        """Return the rows of segments, circles and pieces, read-only."""
        numbers, found, end = np.frombuffer(self.content), [], 0
        for count, width in zip(self.counts, _WIDTHS, strict=True):
            begin, end = end, end + count * width
            found.append(numbers[begin:end].reshape(count, width))
        return tuple(found)


def echoes(instance: Kernels, tables: Sequence[FloatArray], *, absorbing: bool) -> FloatArray:
    """Return the first echo of each ping [m], see `echoes.c` for the tables.

    Args:
        instance: the instance of the kernels.
        tables: a row for each ping; then one for each face near a ping, by rising ping; the
            same of circles, and of crosstalk.
        absorbing: whether there are absorbing surfaces.

    Raises:
        WorldError: there are more shapes within reach than the arena holds.
    """
    places, end, count = [], 0, len(tables[0])
    for table in tables:
        places.append(end)
        end += table.size
    if end + count > instance.room:
        text = f"too many outlines are within reach of a sonar: {sum(map(len, tables[1:]))}"
        raise WorldError.at(Location("<world>"), text)
    for table, place in zip(tables, places, strict=True):
        instance.arena[place : place + table.size] = table.reshape(-1)
    instance.call(ECHOES, count, absorbing, *places[1:], end)
    return instance.arena[end : end + count].copy()


def rays(
    instance: Kernels,
    fan: FloatArray,
    poses: FloatArray,
    own: IndexArray,
    tables: tuple[FloatArray, FloatArray],
    *,
    wants_objects: bool = False,
) -> FloatArray:
    """Return the distance that each beam of each robot measures [m], see `rays.c`.

    Args:
        instance: the instance of the kernels.
        fan: the beams.
        poses: x, y [m] and heading [rad] of each robot, shape (k, 3).
        own: the number of each robot's own body, (k,).
        tables: a row for each segment, and robot if not of all of them, see `rays.c`, and the same
            of circles; the arena need not hold all.
        wants_objects: whether to return what the beams hit, too.

    Returns:
        the distances, and the number of the object that each beam hits, shape (1 or 2, k,
        beams).
    """
    numbers = RAYS, 1 + wants_objects, wants_objects
    return _survey(instance, numbers, fan, viewers_of(poses, own), tables)


def covers(instance: Kernels, fan: FloatArray, poses: FloatArray, pieces: FloatArray) -> FloatArray:
    """Return the number of the object that each beam starts in or on, -1 for none, (k, beams).

    Args:
        instance: the instance of the kernels.
        fan: the beams.
        poses: x, y [m] and heading [rad] of each robot, shape (k, 3).
        pieces: a row for each piece, as of segments for `rays`.
    """
    tables = pieces, pieces[:0]
    return np.asarray(_survey(instance, (COVERS, 1, 1), fan, viewers_of(poses, 0), tables)[0])


def scan(
    instance: Kernels, fan: FloatArray, poses: FloatArray, own: IndexArray, shapes: Shapes
) -> FloatArray | None:
    """Return the distance that each beam measures, 0 for a start in or on a piece, (k, beams).

    None if the arena has no room for all.

    Args:
        instance: the instance of the kernels.
        fan: the beams.
        poses: x, y [m] and heading [rad] of each robot, shape (k, 3).
        own: the number of each robot's own body, (k,).
        shapes: all shapes.
    """
    count, beams, robots = len(poses), int(fan[0]), len(fan)
    first = robots + _VIEWER * count
    end, size = first + len(shapes.content) // _NUMBER, count * beams
    if end + 2 * size > instance.room:
        return None
    instance.lay(b"".join((fan.tobytes(), viewers_of(poses, own).tobytes(), shapes.content)))
    segments, circles, pieces = shapes.counts
    instance.call(SCAN, count, segments, circles, True, False, robots, end, first, pieces)
    return instance.arena[end : end + size].reshape(count, beams).copy()


def _survey(
    instance: Kernels,
    numbers: tuple[int, int, int],
    fan: FloatArray,
    viewers: FloatArray,
    tables: tuple[FloatArray, FloatArray],
) -> FloatArray:
    """Run a kernel of `rays.c`, in as many calls as the tables of shapes need.

    Args:
        instance: the instance of the kernels.
        numbers: the kernel, the number of results for each beam, and whether it wants objects.
        fan: the beams.
        viewers: the rows of the robots.
        tables: the shapes.
    """
    kernel, results, wanted = numbers
    count, robots = len(viewers), len(fan)
    shapes, out = robots + _VIEWER * count, instance.room - results * count * int(fan[0])
    rows = max(1, (out - shapes) // (tables[0].shape[1] + tables[1].shape[1]))
    place, head = 0, fan.tobytes() + viewers.tobytes()
    first, longest = 0, max(len(tables[0]), len(tables[1]))
    while first == 0 or first < longest:
        some = [table[first : first + rows] for table in tables]
        instance.lay(b"".join((head, *[table.tobytes() for table in some])), place)
        sizes = len(some[0]), len(some[1])
        instance.call(kernel, count, *sizes, first == 0, wanted, robots, out, shapes)
        first, place, head = first + rows, shapes, b""
    return instance.arena[out : instance.room].reshape(results, count, int(fan[0])).copy()


def viewers_of(poses: FloatArray, own: IndexArray | int) -> FloatArray:
    """Return the rows of robots, see `rays.c`."""
    viewers = np.empty((len(poses), _VIEWER))
    viewers[:, :3], viewers[:, 4] = poses, own
    return viewers
