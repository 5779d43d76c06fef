"""The mathematical functions, against mpmath: the error of each in units of the last place."""

from __future__ import annotations

import math
import random
import struct
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import mpmath

from tests.runtime.library_runner import run

MEASURED = Path(__file__).with_name("lib_math_errors.txt")
"""The largest errors found, which `docs/library.md` shows."""

Points = Callable[[random.Random], tuple[float, float]]


def between(low: float, high: float) -> Points:
    return lambda choose: (choose.uniform(low, high), 0.0)


def any_of(least: int, most: int, *, positive: bool = False) -> Points:
    """Return numbers of all magnitudes from 2^least to 2^most."""

    def point(choose: random.Random) -> tuple[float, float]:
        value = math.ldexp(choose.uniform(1, 2), choose.randrange(least, most))
        return (value if positive or choose.random() < 0.5 else -value), 0.0

    return point


def pairs(first: Points, second: Points) -> Points:
    return lambda choose: (first(choose)[0], second(choose)[0])


def exp10(x: Any) -> Any:
    return mpmath.power(10, x)


WHOLE = any_of(-1000, 1000)
FUNCTIONS: dict[str, tuple[float, Any, list[Points]]] = {
    # name: (largest error in ulp, the exact function, where to try it)
    "sin": (1, mpmath.sin, [between(-10, 10), any_of(-30, 30), WHOLE]),
    "cos": (1, mpmath.cos, [between(-10, 10), any_of(-30, 30), WHOLE]),
    "tan": (1, mpmath.tan, [between(-10, 10), any_of(-30, 30), WHOLE]),
    "asin": (1, mpmath.asin, [between(-1, 1), any_of(-100, -1)]),
    "acos": (1, mpmath.acos, [between(-1, 1), any_of(-100, -1)]),
    "atan": (1, mpmath.atan, [between(-8, 8), WHOLE]),
    "sinh": (2, mpmath.sinh, [between(-3, 3), between(-700, 700), any_of(-100, 1)]),
    "cosh": (2, mpmath.cosh, [between(-3, 3), between(-700, 700)]),
    "tanh": (2, mpmath.tanh, [between(-2, 2), any_of(-100, 5)]),
    "asinh": (2, mpmath.asinh, [between(-2, 2), WHOLE]),
    "acosh": (2, mpmath.acosh, [between(1, 2), any_of(1, 1000, positive=True)]),
    "atanh": (2, mpmath.atanh, [between(-1, 1), any_of(-100, -1)]),
    "exp": (1, mpmath.exp, [between(-2, 2), between(-708, 709)]),
    "exp2": (1, lambda x: mpmath.power(2, x), [between(-2, 2), between(-1022, 1023)]),
    "exp10": (1, exp10, [between(-2, 2), between(-300, 308)]),
    "expm1": (1, mpmath.expm1, [between(-2, 2), between(-50, 700), any_of(-100, 1)]),
    "log": (1, mpmath.log, [between(0.5, 2), any_of(-1074, 1023, positive=True)]),
    "log2": (1, lambda x: mpmath.log(x, 2), [between(0.5, 2), any_of(-900, 900, positive=True)]),
    "log10": (1, mpmath.log10, [between(0.5, 2), any_of(-900, 900, positive=True)]),
    "log1p": (1, mpmath.log1p, [between(-1, 2), any_of(-100, 0), any_of(0, 900, positive=True)]),
    "cbrt": (1, None, [between(-8, 8), WHOLE]),
    "sqrt": (0.5, mpmath.sqrt, [any_of(-1000, 1000, positive=True)]),
    "erf": (2, mpmath.erf, [between(-3, 3), any_of(-100, 2)]),
    "erfc": (2, mpmath.erfc, [between(-3, 3), between(0, 26)]),
    "tgamma": (2, mpmath.gamma, [between(-20, 20), between(20, 171), between(-170, -20)]),
    "lgamma": (2, mpmath.loggamma, [between(0, 4), between(4, 30), any_of(0, 900, positive=True)]),
    "pow": (1, mpmath.power, [
        pairs(between(0, 10), between(-200, 200)),
        pairs(between(0.999, 1.001), between(-5e5, 5e5)),
        pairs(any_of(-900, 900, positive=True), between(-1, 1)),
    ]),
    "atan2": (1, mpmath.atan2, [pairs(between(-9, 9), between(-9, 9)), pairs(WHOLE, WHOLE)]),
    "hypot": (1, mpmath.hypot, [pairs(between(-9, 9), between(-9, 9)), pairs(WHOLE, WHOLE)]),
}  # fmt: skip
TWO = ("pow", "atan2", "hypot")

HARD = {
    # nearest of all doubles to a multiple of pi/2 (J.-M. Muller, "Elementary Functions", 2006)
    "sin": [math.ldexp(6381956970095103, 797), math.pi, 1e22, 2.0**1023],
    "cos": [math.ldexp(6381956970095103, 797), math.pi / 2, 1e22, 2.0**1023],
    "tan": [math.ldexp(6381956970095103, 797), math.pi / 2, math.pi / 4, 1e22],
    "tgamma": [171.624376956302, 1e-300, -1e-5, -4.000001],
    "lgamma": [1 + 2.0**-40, 2 - 2.0**-40, 1e305],
}

SOURCE = r"""
#include <math.h>
#include <stdio.h>
static TYPE (*const one[])(TYPE) = {%s};
static TYPE (*const two[])(TYPE, TYPE) = {%s};
int main(void)
{
    struct { int function, unused; double x, y; } point;
    while (fread(&point, sizeof point, 1, stdin) == 1) {
        double result = point.function < %d ? one[point.function](point.x)
                                            : two[point.function - %d](point.x, point.y);
        fwrite(&result, sizeof result, 1, stdout);
    }
    return 0;
}
"""

FLOATS = [name for name in FUNCTIONS if name != "exp10"]
"""The functions that have a version for float; it rounds the double's result once more."""


def exact(name: str, x: float, y: float) -> Any:
    if name == "cbrt":
        return mpmath.sign(x) * mpmath.cbrt(abs(mpmath.mpf(x)))
    function = FUNCTIONS[name][1]
    return function(mpmath.mpf(x), mpmath.mpf(y)) if name in TWO else function(mpmath.mpf(x))


@cache
def limit_of(digits: int, largest: int) -> Any:
    """Return the least number that is rounded to infinity."""
    return mpmath.ldexp(1, largest) - mpmath.ldexp(1, largest - digits - 1)


def error_in_ulp(result: float, wanted: Any, *, single: bool) -> float:
    """Return how far a result is off, in units of the last place of the exact value."""
    digits, least, largest = (24, -149, 128) if single else (53, -1074, 1024)
    exponent = max(mpmath.frexp(wanted)[1] - digits, least)
    limit = limit_of(digits, largest)
    if math.isinf(result) or abs(wanted) >= limit:
        return 0.0 if math.isinf(result) and abs(wanted) >= limit else 1e9
    return float(abs(mpmath.mpf(result) - wanted) / mpmath.ldexp(1, exponent))


def as_float(x: float) -> float:
    """Return the nearest number that a float can hold and that is neither infinite nor zero."""
    limit = math.ldexp(2 - 2.0**-23, 127)
    nearest = struct.unpack("<f", struct.pack("<f", max(-limit, min(limit, x))))[0]
    return float(nearest or math.copysign(2.0**-149, x))


def worst_errors(count: int, *, single: bool = False) -> dict[str, tuple[float, float, float]]:
    """Return for each function its largest error [ulp] over `count` points, and where it is."""
    choose = random.Random(4)
    known = FLOATS if single else list(FUNCTIONS)
    names = [name for name in known if name not in TWO] + list(TWO)
    points = []
    for number, name in enumerate(names):
        points += [(number, 0, x, 0.0) for x in HARD.get(name, [])]
        places = FUNCTIONS[name][2]
        points += [(number, 0, *places[k % len(places)](choose)) for k in range(count)]
    if single:
        points = [(number, 0, as_float(x), as_float(y)) for number, _, x, y in points]
    ones = len(names) - len(TWO)
    called = [name + "f" * single for name in names]
    source = SOURCE % (", ".join(called[:ones]), ", ".join(called[ones:]), ones, ones)
    source = source.replace("TYPE", "float" if single else "double")
    data = b"".join(struct.pack("<iidd", *point) for point in points)
    results = [value for (value,) in struct.iter_unpack("<d", run(source, stdin=data).out)]
    worst = dict.fromkeys(names, (0.0, 0.0, 0.0))
    for (number, _, x, y), result in zip(points, results, strict=True):
        name = names[number]
        # As many bits more as a multiple of pi that is subtracted has before its point.
        reduced = max(0, math.frexp(x)[1]) if name in ("sin", "cos", "tan") else 0
        with mpmath.workprec(200 + reduced):
            try:
                wanted = exact(name, x, y)
            except ValueError:  # a pole
                continue
            if mpmath.isfinite(wanted):
                error = error_in_ulp(result, wanted, single=single)
                worst[name] = max(worst[name], (error, x, y))
    return worst


def check(count: int) -> None:
    worst = worst_errors(count)
    assert {n: found for n, found in worst.items() if found[0] > FUNCTIONS[n][0]} == {}


def check_floats(count: int) -> None:
    worst = worst_errors(count, single=True)
    assert {n: found for n, found in worst.items() if found[0] > 0.5000001} == {}


def test_functions_are_as_accurate_as_documented() -> None:
    check(100)


def test_float_functions_are_correctly_or_faithfully_rounded() -> None:
    check_floats(60)


def test_functions_are_as_accurate_as_documented_at_many_points(
    check_golden: Callable[[Path, bytes], None],
) -> None:
    worst = worst_errors(3000)
    assert {n: found for n, found in worst.items() if found[0] > FUNCTIONS[n][0]} == {}
    rows = [f"{name}\t{FUNCTIONS[name][0]:g}\t{error:.2f}" for name, (error, *_) in worst.items()]
    check_golden(MEASURED, "\n".join(["# function\tpromised\tmeasured [ulp]", *rows, ""]).encode())


def test_float_functions_are_correctly_or_faithfully_rounded_at_many_points() -> None:
    check_floats(2000)
