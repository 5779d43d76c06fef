"""Exact mathematical functions for float, and those that only have other names."""

from __future__ import annotations

import math
import random
import struct
from fractions import Fraction

import numpy as np

from tests.runtime.library_runner import run

FLOATS = r"""
#include <math.h>
#include <stdio.h>
int main(void)
{
    float in[3];
    double out[22];
    while (fread(in, sizeof in, 1, stdin) == 1) {
        float x = in[0], y = in[1], z = in[2], whole;
        int exponent, quotient;
        out[0] = fmaf(x, y, z);
        out[1] = fmodf(x, y);
        out[2] = remainderf(x, y);
        out[3] = remquof(x, y, &quotient);
        out[4] = quotient & 7;
        out[5] = floorf(x);
        out[6] = ceilf(x);
        out[7] = truncf(x);
        out[8] = rintf(x) + 0 * nearbyintf(x);
        out[9] = roundf(x);
        out[10] = frexpf(x, &exponent);
        out[11] = exponent;
        out[12] = ldexpf(x, (int)fmodf(z, 300));
        out[13] = nextafterf(x, y);
        out[14] = modff(x, &whole);
        out[15] = whole;
        out[16] = copysignf(x, y);
        out[17] = fdimf(x, y);
        out[18] = fmaxf(x, y);
        out[19] = fminf(x, y);
        out[20] = logbf(x);
        out[21] = ilogbf(x) + significandf(x) + sqrtf(fabsf(x));
        fwrite(out, sizeof out, 1, stdout);
    }
    return 0;
}
"""

DOUBLES = r"""
#include <math.h>
#include <stdio.h>
int main(void)
{
    double in[3], out[14];
    while (fread(in, sizeof in, 1, stdin) == 1) {
        double x = in[0], y = in[1];
        int k = (int)fmod(in[2], 1000), quotient;
        out[0] = copysign(x, y);
        out[1] = fdim(x, y);
        out[2] = fmax(x, y);
        out[3] = fmin(x, y);
        out[4] = ilogb(x);
        out[5] = logb(x);
        out[6] = scalbn(x, k);
        out[7] = scalbln(x, k);
        out[8] = scalb(x, k);
        out[9] = significand(x);
        out[10] = drem(x, y);
        remquo(x, y, &quotient);
        out[11] = quotient;
        out[12] = nearbyint(x);
        out[13] = nexttoward(x, y);
        fwrite(out, sizeof out, 1, stdout);
    }
    return 0;
}
"""


def single(choose: random.Random) -> float:
    """Return a finite float other than zero, of any size or with few digits."""
    while True:
        x = struct.unpack("<f", choose.randbytes(4))[0]
        if choose.random() < 0.5:
            x = choose.randrange(-4000, 4000) / 4
        if x - x == 0 and x != 0:
            return float(x)


def to_float(exact: Fraction, sign: float) -> float:
    """Round to float, a tie to even; zero takes the sign."""
    if exact == 0:
        return math.copysign(0.0, sign)
    size = abs(exact)
    exponent = size.numerator.bit_length() - size.denominator.bit_length()
    exponent -= size < Fraction(2) ** exponent
    unit = Fraction(2) ** (max(exponent, -126) - 23)
    rounded = round(size / unit) * unit
    if rounded >= Fraction(2) ** 128:
        return math.copysign(math.inf, exact)
    return math.copysign(float(rounded), exact)


def quotient(x: float, y: float) -> int:
    """Return the whole number next to x/y, the even one when there are two."""
    return round(Fraction(x) / Fraction(y))


def half_away(x: float) -> float:
    whole = int(abs(Fraction(x)) + Fraction(1, 2))
    return math.copysign(float(whole), x)


def expected_floats(x: float, y: float, z: float) -> list[float]:
    fraction, exponent = math.frexp(x)
    rest, whole = math.modf(x)
    total = Fraction(x) * Fraction(y) + Fraction(z)
    return [
        to_float(total, z if Fraction(x) * Fraction(y) == 0 else 1.0),
        math.fmod(x, y),
        math.remainder(x, y),
        math.remainder(x, y),
        (abs(quotient(x, y)) * (1 if (x < 0) == (y < 0) else -1)) & 7,
        float(math.floor(x)),
        float(math.ceil(x)),
        float(math.trunc(x)),
        float(round(x)),
        half_away(x),
        fraction,
        float(exponent),
        to_float(Fraction(x) * Fraction(2) ** int(math.fmod(z, 300)), x),
        float(np.nextafter(np.float32(x), np.float32(y))),
        rest,
        whole,
        math.copysign(x, y),
        to_float(max(Fraction(x) - Fraction(y), Fraction(0)), 1.0),
        max(x, y),
        min(x, y),
        float(exponent - 1),
        float(np.float32(exponent - 1) + np.float32(2 * fraction) + np.sqrt(np.float32(abs(x)))),
    ]


def test_exact_functions_for_float() -> None:
    choose = random.Random(11)
    points = [tuple(single(choose) for _ in range(3)) for _ in range(800)]
    data = b"".join(struct.pack("<3f", *point) for point in points)
    found = struct.iter_unpack("<22d", run(FLOATS, stdin=data).out)
    for (x, y, z), row in zip(points, found, strict=True):
        assert list(row) == expected_floats(x, y, z), (x, y, z)


def expected_doubles(x: float, y: float, z: float) -> list[float]:
    fraction, exponent = math.frexp(x)
    shift, n = int(math.fmod(z, 1000)), quotient(x, y)
    try:
        shifted = float(Fraction(x) * Fraction(2) ** shift)
    except OverflowError:
        shifted = math.copysign(math.inf, x)
    low = abs(n) & 0x7FFFFFFF
    return [
        math.copysign(x, y),
        max(x - y, 0.0),
        max(x, y),
        min(x, y),
        float(exponent - 1),
        float(exponent - 1),
        shifted,
        shifted,
        shifted,
        2 * fraction,
        math.remainder(x, y),
        float(low if (x < 0) == (y < 0) else -low),
        float(round(x)),
        math.nextafter(x, y),
    ]


def test_exact_functions_by_their_other_names() -> None:
    choose = random.Random(12)
    points = []
    while len(points) < 800:
        x, y, z = struct.unpack("<3d", choose.randbytes(24))
        if choose.random() < 0.6:
            x, y = choose.randrange(-4000, 4000) / 8, choose.randrange(1, 99) / 4
        if all(each - each == 0 for each in (x, y, z)) and x != 0 and y != 0:
            points.append((x, y, z))
    data = b"".join(struct.pack("<3d", *point) for point in points)
    found = struct.iter_unpack("<14d", run(DOUBLES, stdin=data).out)
    for point, row in zip(points, found, strict=True):
        assert list(row) == expected_doubles(*point), point


def test_several_at_once_and_signs_of_gamma() -> None:
    source = r"""
    #include <math.h>
    #include <stdio.h>
    int main(void)
    {
        double s, c, special[] = {0.0, -0.0, INFINITY, -INFINITY, NAN};
        float sf, cf;
        int sign, i;
        sincos(0.7, &s, &c);
        sincosf(0.7F, &sf, &cf);
        printf("%d %d\n", s == sin(0.7) && c == cos(0.7), sf == sinf(0.7F) && cf == cosf(0.7F));
        for (i = -7; i < 8; i += 2) {
            double value = lgamma_r(i / 4.0, &sign);
            int same = value == lgamma(i / 4.0);
            printf("%d%d%d ", sign, same, sign == signgam);
        }
        printf("%d\n", lgammaf_r(-0.5F, &sign) == lgammaf(-0.5F) && sign == -1);
        for (i = 0; i < 5; i++) {
            double x = special[i];
            float f = (float)x;
            printf("%d%d%d%d%d ", finite(x), finitef(f), isnanf(f) != 0, isinff(f), isinfl(x));
            printf("%g %g %g %s\n", significand(x), scalb(x, 3), fabs(scalb(2, -x)),
                   nan("7") != nan("") ? "nan" : "number");
        }
        printf("%ld %ld %lld\n", lrint(-2.5), lround(-2.5), llround(0.49999999999999994));
        return 0;
    }
    """
    assert run(source).out.decode().splitlines() == [
        "1 1",
        "111 111 -111 -111 111 111 111 111 1",  # gamma is positive between -2 and -1
        "11000 0 0 2 nan",
        "11000 -0 -0 2 nan",
        "00011 inf inf 0 nan",
        "000-1-1 -inf -inf inf nan",
        "00100 nan nan nan nan",
        "-2 -3 0",
    ]
