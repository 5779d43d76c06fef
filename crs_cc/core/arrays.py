"""The array types of the whole package, by element type."""

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
