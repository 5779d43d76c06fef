"""Mathematical functions that give the same bits on every processor.

numpy's and Python's own depend on the processor's vector instructions, on whether it has FMA, on
strides and on the host's C library. These are those of crs_cc's C library (`runtime/lib/math`, at
most 1 ulp off), compiled to WebAssembly, whose arithmetic is defined bit for bit. What is rounded
correctly everywhere needs no replacement: sums, differences, products and quotients of real
numbers, square roots, remainders, and products of a real and a complex number.

Each takes numbers or arrays that broadcast, and returns a number if all are numbers.

>>> float(sin(np.pi / 6)), arctan2(np.array([1.0, -1.0]), 0.0).tolist()
(0.49999999999999994, [1.5707963267948966, -1.5707963267948966])
>>> complex(product(1 + 2j, 3 - 1j)), float(magnitude(3 + 4j))
((5+5j), 5.0)
"""

from __future__ import annotations

import math
from typing import Any, Final, TypeAlias, overload

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import ComplexArray, FloatArray
from crs_cc.sim.kernels.program import BLOCK, kernels

_Values: TypeAlias = npt.NDArray[Any]


class _Unary:
    """A function of one real number."""

    def __init__(self, number: int) -> None:
        self._number = number

    @overload
    def __call__(self, a: float) -> float: ...
    @overload
    def __call__(self, a: FloatArray) -> FloatArray: ...
    def __call__(self, a: FloatArray | float) -> FloatArray | float:
        if not isinstance(a, np.ndarray):
            return kernels().number(self._number, a, 0.0)
        return _evaluate(self._number, np.asarray(a, np.float64), None, is_complex=False)


class _Binary:
    """A function of two real numbers."""

    def __init__(self, number: int) -> None:
        self._number = number

    @overload
    def __call__(self, a: float, b: float) -> float: ...
    @overload
    def __call__(self, a: FloatArray, b: FloatArray | float) -> FloatArray: ...
    @overload
    def __call__(self, a: FloatArray | float, b: FloatArray) -> FloatArray: ...
    def __call__(self, a: FloatArray | float, b: FloatArray | float) -> FloatArray | float:
        if not (isinstance(a, np.ndarray) or isinstance(b, np.ndarray)):
            return kernels().number(self._number, a, b)
        first, second = np.asarray(a, np.float64), np.asarray(b, np.float64)
        return _evaluate(self._number, first, second, is_complex=False)


sin: Final = _Unary(0)
cos: Final = _Unary(1)
tan: Final = _Unary(2)
arcsin: Final = _Unary(3)
arccos: Final = _Unary(4)
arctan: Final = _Unary(5)
arctan2: Final = _Binary(6)
exp: Final = _Unary(7)
exp2: Final = _Unary(8)
log: Final = _Unary(9)
power: Final = _Binary(10)
board_ms: Final = _Binary(15)
"""The time that the clock of a sensor board shows, from its own time and its tick [s]."""
_TURN: Final = 11
_PRODUCT: Final = 12
_NORMAL_PAIRS: Final = 14


@overload
def hypot(x: float, y: float) -> float: ...
@overload
def hypot(x: FloatArray, y: FloatArray | float) -> FloatArray: ...
@overload
def hypot(x: FloatArray | float, y: FloatArray) -> FloatArray: ...
def hypot(x: FloatArray | float, y: FloatArray | float) -> FloatArray | float:
    """Return the length of vectors, whose square must not overflow."""
    square = x * x + y * y
    return np.sqrt(square) if isinstance(square, np.ndarray) else math.sqrt(square)


@overload
def magnitude(a: complex) -> float: ...
@overload
def magnitude(a: ComplexArray) -> FloatArray: ...
def magnitude(a: ComplexArray | complex) -> FloatArray | float:
    """Return the absolute value of complex numbers, whose square must not overflow."""
    return hypot(a.real, a.imag)


@overload
def dot(a: complex, b: complex) -> float: ...
@overload
def dot(a: ComplexArray, b: ComplexArray | complex) -> FloatArray: ...
@overload
def dot(a: ComplexArray | complex, b: ComplexArray) -> FloatArray: ...
def dot(a: ComplexArray | complex, b: ComplexArray | complex) -> FloatArray | float:
    """Return the inner product of vectors as complex numbers, the real part of a * conj(b)."""
    return a.real * b.real + a.imag * b.imag


@overload
def angle(a: complex) -> float: ...
@overload
def angle(a: ComplexArray) -> FloatArray: ...
def angle(a: ComplexArray | complex) -> FloatArray | float:
    """Return the direction of complex numbers, -pi to pi [rad]."""
    return arctan2(a.imag, a.real)


@overload
def turn(angle_rad: float) -> complex: ...
@overload
def turn(angle_rad: FloatArray) -> ComplexArray: ...
def turn(angle_rad: FloatArray | float) -> ComplexArray | complex:
    """Return the complex numbers of magnitude 1 with given directions."""
    if not isinstance(angle_rad, np.ndarray):
        return complex(cos(angle_rad), sin(angle_rad))
    return _evaluate(_TURN, np.asarray(angle_rad, np.float64), None, is_complex=True)


@overload
def product(a: complex, b: complex) -> complex: ...
@overload
def product(a: ComplexArray, b: ComplexArray | complex) -> ComplexArray: ...
@overload
def product(a: ComplexArray | complex, b: ComplexArray) -> ComplexArray: ...
def product(a: ComplexArray | complex, b: ComplexArray | complex) -> ComplexArray | complex:
    """Return the product of complex numbers, rounded after each operation."""
    if not (isinstance(a, np.ndarray) or isinstance(b, np.ndarray)):
        real, imag = a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real
        return complex(real, imag)
    first, second = np.asarray(a, np.complex128), np.asarray(b, np.complex128)
    return _evaluate(_PRODUCT, first, second, is_complex=True)


def normal_pairs(a: FloatArray, b: FloatArray) -> ComplexArray:
    """Return pairs of standard normal deviates, as complex numbers, from uniform ones below 1.

    G. E. P. Box, M. E. Muller, "A note on the generation of random normal deviates", 1958.
    """
    return _evaluate(_NORMAL_PAIRS, a, b, is_complex=True)


def _evaluate(number: int, a: _Values, b: _Values | None, *, is_complex: bool) -> _Values:
    """Return a function of arrays that broadcast, of any size."""
    shape = a.shape if b is None or a.shape == b.shape else np.broadcast(a, b).shape
    count = math.prod(shape)
    if count > BLOCK:
        parts = [
            _evaluate(
                number,
                np.broadcast_to(a, shape).ravel()[begin : begin + BLOCK],
                None if b is None else np.broadcast_to(b, shape).ravel()[begin : begin + BLOCK],
                is_complex=is_complex,
            )
            for begin in range(0, count, BLOCK)
        ]
        return np.concatenate(parts).reshape(shape)
    own = kernels()
    first, second, _ = own.complexes if a.dtype == np.complex128 else own.reals
    if len(shape) == 1:
        first[:count] = a
    else:
        first[:count].reshape(shape)[...] = a
    if b is not None:
        second[:count].reshape(shape)[...] = b
    own.apply(number, count)
    _, _, result = own.complexes if is_complex else own.reals
    return result[:count].reshape(shape).copy()
