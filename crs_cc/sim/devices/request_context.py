"""Requests posted by robots, with all that is needed to answer them.

A handler reads arguments and writes results by the names that they have in `requests.REQUESTS`:

>>> from crs_cc.requests import CODES, MESSAGE, REQUESTS
>>> messages = np.zeros(2, MESSAGE)
>>> messages["i"][:, :3] = [[10, 20, 0], [30, 40, 0]]
>>> parts = dict(state=None, constants=None, rays=None, rows=np.arange(2), at_s=np.zeros(2))
>>> context = RequestContext(request=REQUESTS[CODES["VM"]], messages=messages, **parts)
>>> context["axis2"].tolist(), context.columns("axis1", "axis2").tolist()
([20, 40], [[10, 20], [30, 40]])
>>> context.put("laser_count", 7, where=np.array([False, True]))
>>> messages["i"][:, 0].tolist()
[10, 7]
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Final, TypeAlias

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records
from crs_cc.requests import Request

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_ALL: Final = slice(None)
_INT32: Final = np.dtype("<i4")


@dataclass(slots=True)
class RequestContext:
    """Requests of one kind; arrays have a row for each, k of them.

    Attributes:
        request: the kind of request.
        state: the state, to be changed in place; axes were turned to `at_s`.
        constants: the robots' constants.
        rays: casts rays.
        rows: the robots, in ascending order.
        messages: the requests, of dtype `MESSAGE`, to be changed in place into the replies;
            handlers read and write them by the names of fields.
        at_s: the time at which each is answered, within the current cycle.
    """

    request: Request
    state: EnvState
    constants: RobotConstants
    rays: RayCaster
    rows: IndexArray
    messages: Records
    at_s: FloatArray

    def __len__(self) -> int:
        return len(self.rows)

    def __getitem__(self, name: str) -> Int32Array:
        """Return an argument of each request, shape (k,); of `data` all bytes, (k, 248)."""
        array, number = self.request.argument_positions[name]
        column: Int32Array = self.messages[array]
        return column if number < 0 else column[:, number]

    def columns(self, *names: str) -> Int32Array:
        """Return arguments that are evenly spaced in the message, shape (k, names)."""
        columns: Int32Array = self.messages["i"][:, _columns(self.request, names)]
        return columns

    def __setitem__(self, name: str, values: npt.ArrayLike) -> None:
        """Write a result into each reply."""
        self.put(name, values)

    def put(
        self,
        name: str,
        values: npt.ArrayLike,
        where: BoolArray | IndexArray | slice | int = _ALL,
    ) -> None:
        """Write a result into some of the replies.

        Args:
            name: the result's name.
            values: what to write, one for all or one for each of these replies.
            where: which of the replies.
        """
        array, number = self.request.result_positions[name]
        if number < 0:
            self.messages[array][where] = values
        else:
            self.messages[array][where, number] = values

    def put_data(
        self, numbers: npt.NDArray[np.number], where: BoolArray | slice | int = _ALL
    ) -> None:
        """Write numbers as int32 into the data of some of the replies, and their size in bytes.

        Args:
            numbers: the numbers, shape (replies, n); of a single reply (n,).
            where: which of the replies.
        """
        content = np.ascontiguousarray(numbers, dtype=_INT32).view(np.uint8)
        size = content.shape[-1]
        self.messages["data"][where, :size] = content
        self.messages["size"][where] = size

    def put_bytes(self, content: bytes, place: int) -> None:
        """Write bytes into the data of one reply, and their number."""
        self.messages["data"][place, : len(content)] = list(content)
        self.messages["size"][place] = len(content)

    def clear_data(self) -> None:
        """Clear the data of the replies."""
        self.messages["size"] = 0


Handler: TypeAlias = Callable[[RequestContext], BoolArray | None]
"""The function that executes requests and writes replies; returns which were good, None for all."""


@cache
def _columns(request: Request, names: tuple[str, ...]) -> slice:
    """Return the positions of arguments among the integers of a message."""
    first, second, *rest = (request.argument_positions[name][1] for name in names)
    step = second - first
    block = slice(first, first + len(names) * step, step)
    assert [first, second, *rest] == [*range(block.start, block.stop, step)], names
    return block
