"""Packing of a state into one immutable block of bytes, which is fast to create and small.

A state is made of dataclasses whose leaves are arrays and numbers. For very many small arrays, most
of the time and memory is the overhead of each array.

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
"""The structure of a state in preorder: the types of dataclasses, dtype and shape of arrays, None
for other values."""

_ALIGN: Final = 8
_PADDING: Final = tuple(bytes(size) for size in range(_ALIGN))


@dataclass(frozen=True, slots=True)
class Packed:
    """A packed state.

    Attributes:
        layout: its structure.
        content: its arrays, one after the other, each aligned.
        others: values that are not arrays, in the order of the layout.
    """

    layout: Layout
    content: bytes
    others: tuple[Any, ...]

    def state(self) -> Any:
        """Return the state, which shares nothing with the packed one."""
        return _Unpacking(self).next()


def packed(state: Any, like: Packed | None = None) -> Packed:
    """Pack a state.

    Args:
        state: a dataclass.
        like: another state that may have the same layout, which is then shared.
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
    """Reads a packed state from start to end."""

    def __init__(self, packed: Packed) -> None:
        self._layout = iter(packed.layout)
        self._others = iter(packed.others)
        self._content = bytearray(packed.content)
        self._at = 0

    def next(self) -> Any:
        """Return the next value, with everything in it."""
        part = next(self._layout)
        if part is None:
            return next(self._others)
        if isinstance(part, tuple):
            dtype, shape = part
            array: np.ndarray[Any, Any] = np.ndarray(shape, dtype, self._content, self._at)
            self._at += -(-array.nbytes // _ALIGN) * _ALIGN
            return array
        return part(**{name: self.next() for name in _names(part) or ()})


@cache
def _names(kind: Hashable) -> tuple[str, ...] | None:
    """Return the names of the fields of a dataclass, None for any other type."""
    return tuple(each.name for each in fields(kind)) if is_dataclass(kind) else None
