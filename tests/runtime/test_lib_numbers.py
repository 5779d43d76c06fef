"""Strings to numbers, against Python's own exact conversions."""

from __future__ import annotations

import math
import random
import struct
from fractions import Fraction

from tests.runtime.library_runner import run

LARGEST_FLOAT = float.fromhex("0x1.fffffep+127")

READS_DOUBLES = r"""
#include <stdio.h>
#include <stdlib.h>
static char line[4000];
int main(void)
{
    while (fgets(line, sizeof line, stdin) != NULL) {
        char *end;
        double x = strtod(line, &end);
        float y = strtof(line, NULL);
        int used = end - line;
        fwrite(&x, sizeof x, 1, stdout);
        fwrite(&y, sizeof y, 1, stdout);
        fwrite(&used, sizeof used, 1, stdout);
    }
    return 0;
}
"""

TRICKY = [
    "0", "-0", "1e400", "-1e400", "1e-400", ".5", "5.", "1e+0", "0e9999999999", "1e-99999999999",
    "2.2250738585072011e-308", "2.2250738585072014e-308", "2.4703282292062327e-324",
    "2.4703282292062328e-324", "1.7976931348623158e308", "1.7976931348623159e308",
    "9007199254740993", "9007199254740992.999999999999999999",
    "9007199254740993.00000000000000000000000000000000000000001", "3.4028235677973366e38",
    "3.40282356e38", "7.0064923216240853e-46", "7.0064923216240854e-46", "0.1",
    "123456789012345678901234567890", "4.9e-324",
]  # fmt: skip


def nearest_float(text: str) -> float:
    """Return a decimal number rounded once to 24 bits."""
    exact = Fraction(text)
    sign = -1.0 if text.startswith("-") else 1.0
    if abs(exact) >= 2**128 - 2**103:
        return sign * math.inf
    start = struct.pack("<f", min(abs(float(text)), LARGEST_FLOAT))
    bits = struct.unpack("<i", start)[0]
    near = [
        struct.unpack("<f", struct.pack("<i", bits + step))[0]
        for step in (-1, 0, 1)
        if 0 <= bits + step < 0x7F800000
    ]
    best = min(abs(Fraction(value) - abs(exact)) for value in near)
    ties = [value for value in near if abs(Fraction(value) - abs(exact)) == best]
    even = [v for v in ties if not struct.unpack("<i", struct.pack("<f", v))[0] & 1]
    return sign * (even or ties)[0]


def middle(choose: random.Random) -> str:
    """Return the exact decimal digits of a middle between two doubles, or just beside it."""
    bits = choose.randrange(0x3C0, 0x440) << 52 | choose.getrandbits(52)
    low, high = struct.unpack("<dd", struct.pack("<qq", bits, bits + 1))
    half = (Fraction(low) + Fraction(high)) / 2
    scale = 200
    digits = str(half * 10**scale // 1 + choose.choice((-1, 0, 1)))
    return f"{digits}e-{scale}"


def test_decimal_numbers_are_rounded_correctly() -> None:
    choose = random.Random(3)
    texts = list(TRICKY)
    for _ in range(300):
        texts.append(repr(struct.unpack("<d", choose.randbytes(8))[0]))
        texts.append(middle(choose))
        texts.append(
            f"{choose.randrange(10 ** choose.randrange(1, 40))}e{choose.randrange(-340, 300)}"
        )
        texts.append(f"{choose.randrange(10**9) / 1000}")
    texts = [text for text in texts if "n" not in text]
    out = run(READS_DOUBLES, stdin="\n".join(texts).encode() + b"\n").out
    found = list(struct.iter_unpack("<dfi", out))
    assert len(found) == len(texts)
    for text, (double, single, used) in zip(texts, found, strict=True):
        assert struct.pack("<d", double) == struct.pack("<d", float(text)), text
        assert used == len(text)
        if "e999" not in text and "e-999" not in text:
            assert single == nearest_float(text), text


def test_forms_of_floating_numbers() -> None:
    cases = {
        "inf": ("inf", 3), "-INFINITY": ("-inf", 9), "infinit": ("inf", 3), "nan": ("nan", 3),
        "NAN(12_a)x": ("nan", 9), "nan(": ("nan", 3), "0x1.8p3": ("12.0", 7), "0x": ("0.0", 1),
        "0x.8p-1074": ("0.0", 10), "-0x1p-1074": ("-5e-324", 10), "0x1p": ("1.0", 3),
        "0x1.fffffffffffff8p1023": ("inf", 23), "1e": ("1.0", 1), "1e+": ("1.0", 1),
        "  12abc": ("12.0", 4), ".": ("0.0", 0), "-": ("0.0", 0), ".e1": ("0.0", 0),
        "+.5": ("0.5", 3),
    }  # fmt: skip
    out = run(READS_DOUBLES, stdin="\n".join(cases).encode() + b"\n").out
    found = [(str(double), used) for double, _, used in struct.iter_unpack("<dfi", out)]
    assert dict(zip(cases, found, strict=True)) == cases


READS_INTEGERS = r"""
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
static char line[200];
int main(void)
{
    while (fgets(line, sizeof line, stdin) != NULL) {
        char *end, *text = line;
        int base = strtol(text, &text, 10);
        printf("%ld", strtol(text, &end, base));
        printf(" %d", (int)(end - text));
        errno = 0;
        printf(" %lu", strtoul(text, NULL, base));
        printf(" %d", errno);
        errno = 0;
        printf(" %lld", strtoll(text, NULL, base));
        printf(" %d", errno);
        printf(" %llu %d\n", strtoull(text, NULL, base), atoi(text));
    }
    return 0;
}
"""


def test_integers_of_all_bases_and_their_limits() -> None:
    cases = {
        "10 42": "42 3 42 0 42 0 42 42",
        "0 0x7fffffff": "2147483647 11 2147483647 0 2147483647 0 2147483647 0",
        "0 -0777z": "-511 6 4294966785 0 -511 0 18446744073709551105 -777",
        "16 0xg": "0 2 0 0 0 0 0 0",
        "36 zZ": "1295 3 1295 0 1295 0 1295 0",
        "10 2147483648": "2147483647 11 2147483648 0 2147483648 0 2147483648 2147483647",
        "10 -2147483649": "-2147483648 12 2147483647 0 -2147483649 0 18446744071562067967 "
        "-2147483648",
        "10 4294967296": "2147483647 11 4294967295 34 4294967296 0 4294967296 2147483647",
        "10 9223372036854775808": "2147483647 20 4294967295 34 9223372036854775807 34 "
        "9223372036854775808 2147483647",
        "10 99999999999999999999": "2147483647 21 4294967295 34 9223372036854775807 34 "
        "18446744073709551615 2147483647",
        "2 102": "2 3 2 0 2 0 2 102",
        "10 x": "0 0 0 0 0 0 0 0",
    }
    out = run(READS_INTEGERS, stdin="\n".join(cases).encode() + b"\n").out.decode().splitlines()
    assert dict(zip(cases, out, strict=True)) == cases
