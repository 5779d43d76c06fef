"""A state as one block of bytes: quick to take, small to hold, and never changed.

A state is made of dataclasses whose leaves are arrays and numbers. Very many small arrays take most
of their time and memory by being there at all.

>>> from crs_cc.sim.state.bodies import Pull
>>> pull = Pull(np.zeros((1, 2)), np.array([0.5]), np.array([False]))
>>> again = packed(pull).state()
>>> again.facing_rad, again.way_m.shape, again.hand is None
(array([0.5]), (1, 2), True)
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from typing import Any, Final, TypeAlias, cast

import numpy as np

Layout: TypeAlias = "tuple[type | tuple[np.dtype[Any], tuple[int, ...]] | None, ...]"
"""What a state is made of, the outer before the inner: the types of dataclasses, type and shape of
arrays, None for what is neither."""

_ALIGN: Final = 8
_PADDING: Final = tuple(bytes(size) for size in range(_ALIGN))


@dataclass(frozen=True, slots=True)
class Packed:
    """A state that has been packed.

    Attributes:
        layout: what it is made of.
        content: its arrays, one after the other, each aligned.
        others: what is no array, in the order of the layout.
    """

    layout: Layout
    content: bytes
    others: tuple[Any, ...]

    def state(self) -> Any:
        """Return the state; nothing of it is shared with anybody."""
        return _Unpacking(self).next()


def packed(state: Any, like: Packed | None = None) -> Packed:
    """Pack a state.

    Args:
        state: a dataclass.
        like: another state that may have the same layout, to share that.
    """
    parts: list[Any] = []
    content: list[Any] = []
    others: list[Any] = []
    _collect(state, parts, content, others)
    layout = tuple(parts)
    if like is not None and like.layout == layout:
        layout = like.layout
    return Packed(layout, b"".join(content), tuple(others))


def _collect(value: Any, layout: list[Any], content: list[Any], others: list[Any]) -> None:
    if isinstance(value, np.ndarray):
        layout.append((value.dtype, value.shape))
        content.append(value if value.flags.c_contiguous else value.copy())
        over = value.nbytes % _ALIGN
        if over:
            content.append(_PADDING[_ALIGN - over])
        return
    names = _names(cast("Hashable", type(value)))
    if names is None:
        layout.append(None)
        others.append(value)
        return
    layout.append(type(value))
    for name in names:
        _collect(getattr(value, name), layout, content, others)


class _Unpacking:
    """Goes through a packed state."""

    def __init__(self, packed: Packed) -> None:
        self._layout = iter(packed.layout)
        self._others = iter(packed.others)
        self._content = bytearray(packed.content)
        self._at = 0

    def next(self) -> Any:
        """Return the next thing, with all that is in it."""
        part = next(self._layout)
        if part is None:
            return next(self._others)
        if isinstance(part, tuple):
            dtype, shape = part
            array: np.ndarray[Any, Any] = np.ndarray(shape, dtype, self._content, self._at)
            self._at += -(-array.nbytes // _ALIGN) * _ALIGN
            return array
        return part(*[self.next() for _ in _names(part) or ()])


@cache
def _names(kind: Hashable) -> tuple[str, ...] | None:
    """Return the names of the fields of a dataclass, None for any other type."""
    return tuple(each.name for each in fields(kind)) if is_dataclass(kind) else None
