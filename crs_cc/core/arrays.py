"""The array types of the whole package, by element type; and questions about flags.

>>> flags = np.array([True, False])
>>> any_of(flags), all_of(flags), any_of(flags[1:]), all_of(flags[:0])
(True, False, False, True)
"""

from __future__ import annotations

from typing import TypeVar

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
ComplexArray = npt.NDArray[np.complex128]
ByteArray = npt.NDArray[np.uint8]

IndexArray = npt.NDArray[np.intp]
"""Positions in other arrays."""

Int32Array = npt.NDArray[np.int32]
Int64Array = npt.NDArray[np.int64]

Records = npt.NDArray[np.void]
"""Rows of a structured dtype, documented where they are returned."""

Scalar = TypeVar("Scalar", bound=np.generic)


def read_only(array: npt.NDArray[Scalar]) -> npt.NDArray[Scalar]:
    """Return a read-only view of an array.

    >>> read_only(np.zeros(2)).flags.writeable
    False
    """
    view = array.view()
    view.flags.writeable = False
    return view


def any_of(flags: BoolArray) -> bool:
    """Return whether any flag is set, in a fraction of the time of `flags.any()` for few."""
    return b"\1" in flags.tobytes()


def all_of(flags: BoolArray) -> bool:
    """Return whether all flags are set, in a fraction of the time of `flags.all()`."""
    return b"\0" not in flags.tobytes()


def copied(records: Records) -> Records:
    """Return a copy of records, not field by field as their own method copies them.

    >>> copied(np.zeros(2, [("a", "<i4"), ("b", "u1", 300)])).dtype.names
    ('a', 'b')
    """
    whole = records.view(np.dtype((np.void, records.dtype.itemsize)))
    return whole.copy().view(records.dtype)
