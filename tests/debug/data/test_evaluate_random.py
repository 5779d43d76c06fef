"""Random expressions have the values that the compiled program computes."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.debug.stopped_program import Stopping

COUNT = 40
VARIABLES = """\
    signed char c = -7; unsigned char b = 201; short s = -1234; int i = 123456789;
    unsigned u = 4000000000u; long long l = -9000000000LL; _Bool yes = 1;
    unsigned long long w = 0xfedcba9876543210ULL; float f = 0.7f; double d = -12345.678;"""
HEAD = """\
#include <stdio.h>
enum { E = 77 };
struct pair { short x; int field : 9; } q = {-3, -200}, *r = &q;
static int p[4] = {9, -8, 7, 6};
static int twice(int n) { return n * 2; }
"""
WHOLE = [
    "c",
    "b",
    "s",
    "i",
    "u",
    "l",
    "w",
    "yes",
    "p[2]",
    "q.x",
    "q.field",
    "r->x",
    "twice(s)",
    "E",
]


def number(chance: random.Random, depth: int) -> str:
    """Make an expression of any arithmetic type."""
    if depth == 0:
        return chance.choice([*WHOLE, "f", "d", "3", "-1", "0.5", "2000000000u", "'a'", "1.5f"])
    left, right = number(chance, depth - 1), number(chance, depth - 1)
    match chance.randrange(8):
        case 0:
            return f"(({whole(chance, depth - 1)}) / (({whole(chance, depth - 1)}) | 5))"
        case 1:
            return f"({left} ? {right} : {left})"
        case 2:
            kind = chance.choice(["short", "unsigned char", "float", "int"])
            return f"(({kind})(char)({left} != 0))"
        case 3:
            return f"({left} {chance.choice(['<', '>=', '==', '!=', '&&', '||'])} {right})"
        case 4:
            return f"(- {left})"
        case 5:
            return whole(chance, depth)
    return f"({left} {chance.choice('+-*')} {right})"


def whole(chance: random.Random, depth: int) -> str:
    """Make an expression of an integer type."""
    if depth == 0:
        return chance.choice(WHOLE)
    left, right = whole(chance, depth - 1), whole(chance, depth - 1)
    match chance.randrange(5):
        case 0:
            return f"({left} {chance.choice(['<<', '>>'])} ({right} & 7))"
        case 1:
            return f"(~{left})"
        case 2:
            return f"({left} % ({right} | 3))"
        case 3:
            return f"(({chance.choice(['char', 'unsigned short', 'long long', 'unsigned'])}){left})"
    return f"({left} {chance.choice('&|^+-*')} {right})"


@pytest.mark.parametrize("seed", range(2))
def test_random_expressions(tmp_path: Path, seed: int) -> None:
    chance = random.Random(seed)
    made = [number(chance, 1 + n % 3) for n in range(COUNT)]
    lines = [f'    printf("%.17g\\n", (double)({each}));' for each in made]
    end = '    printf(""); /* STOP */\n    return (int)(c + b + s + i + u + l + w + yes + f + d);'
    body = "\n".join([HEAD, "int main(void)", "{", VARIABLES, *lines, end, "}\n"])
    stopping = Stopping(tmp_path, body)
    evaluator = stopping.run().evaluator()
    found = []
    for each in made:
        value = evaluator.evaluate(f"(double)({each})").value.number
        found.append(f"{value:.17g}")
    assert stopping.run_to_end().decode().split() == found
