"""Constant expressions have the values of gcc -m32, and the types of C."""

from __future__ import annotations

import pytest

from tests.frontend.compiling import compiled, messages

PRELUDE = """
struct s { char a; int b; struct { char x; short y; } c[4]; };
enum { A, B = 7, C };
"""

VALUES = {
    "1 + 2 * 3": 7,
    "(char)300": 44,
    "(unsigned char)-1": 255,
    "-7 / 2": -3,
    "-7 % 2": -1,
    "7 % -2": 1,
    "-1 >> 1": -1,
    "-1u >> 28": 15,
    "1 << 31": -2147483648,
    "2147483647 + 1": -2147483648,
    "0x7fffffff * 2": -2,
    "4294967295u + 1": 0,
    "-1 < 1u": 0,
    "-1L < 1u": 0,
    "-1LL < 1u": 1,
    "(short)0x18000": -32768,
    "~0": -1,
    "!5": 0,
    "!!5": 1,
    "5 && 0": 0,
    "0 || 3": 1,
    "3 > 2 ? 10 : 20": 10,
    "(int)3.99": 3,
    "(int)-3.99": -3,
    "(int)1e3f": 1000,
    "(unsigned)3000000000.0": -1294967296,
    "'a'": 97,
    "'\\377'": -1,
    "'ab'": 24930,
    "'\\x41'": 65,
    "'\\0'": 0,
    "L'\\x263a'": 9786,
    "sizeof(long) * 3": 12,
    'sizeof("abc")': 4,
    'sizeof "a\\0b" "c"': 5,
    "sizeof(int[5])": 20,
    "(int)sizeof(char) - 2": -1,
    "_Alignof(double)": 8,
    "0777": 511,
    "0b1011": 11,
    "0xFFFFFFFF == -1": 1,
    "0x80000000 > 0": 1,
    "2147483648 > 0": 1,
    "10 == 10.0": 1,
    "1.5f * 2 == 3": 1,
    "(int)(0.1f + 0.2f == 0.3f)": 1,
    "(int)(0.1 + 0.2 == 0.3)": 0,
    "(_Bool)0.5": 1,
    "(_Bool)256": 1,
    "1 ? -1 : 0u": -1,
    "(1 ? -1 : 0u) > 0": 1,
    "(char)'\\200'": -128,
    "'\\'' + '\"'": 73,
    "(int)(char)128": -128,
    "-2147483648 < 0": 1,
    "5 / 2 * 2.0 == 4": 1,
    "(long long)1 << 40 >> 38": 4,
    "(unsigned short)-1 + 1": 65536,
    "(unsigned char)200 + (unsigned char)100": 300,
    "(signed char)200": -56,
    "12 & 10 | 5 ^ 3": 14,
    "1, 2": 2,
    "__builtin_offsetof(struct s, b)": 4,
    "__builtin_offsetof(struct s, c[2].y)": 18,
    "(int)&((struct s *)0)->b": 4,
    "(char *)&((struct s *)8)->b - (char *)0": 12,
    "B + 1": 8,
    "C": 8,
    "sizeof(struct s)": 24,
    "0x1p3 == 8": 1,
    "1e400 > 1e308": 1,
    "0.0 / 0.0 == 0.0 / 0.0": 0,
    "0.0 / 0.0 > 1e308 || 0.0 / 0.0 < 1": 0,
    "1.0 / 0.0 > 1e308 && -1.0 / 0.0 < -1e308 && 1 / -0.0 < -1e308": 1,
    "'\\e'": 27,
    "(long)-1 == (unsigned)-1": 1,
    "sizeof(1 ? (char)1 : (char)2)": 4,
    "sizeof('a')": 4,
    "sizeof(1LL + 1)": 8,
    "sizeof(1.0f + 1)": 4,
    "sizeof(1.0f * 2.0)": 8,
    "sizeof(sizeof 1)": 4,
    "1 == 1 == 1": 1,
    "-5 >> 1 << 1": -6,
    "~0u / 3": 1431655765,
    "100000 * 100000": 1410065408,
    "(unsigned)100000 * 100000": 1410065408,
    "07 + 010 + 0x10": 31,
}


@pytest.mark.parametrize("expression", VALUES)
def test_constant_expression_values(expression: str) -> None:
    program = compiled(f"{PRELUDE} int x = ({expression});")
    content = program.data["x"].content or bytes(4)
    assert int.from_bytes(content, "little", signed=True) == VALUES[expression]


TYPES = {
    "1": "int", "1u": "unsigned int", "1l": "long", "1ul": "unsigned long", "1ll": "long long",
    "1ull": "unsigned long long", "2147483648": "long long", "0x80000000": "unsigned int",
    "4294967296": "long long", "0xffffffffffffffff": "unsigned long long", "1.0": "double",
    "1.0f": "float", "1.0L": "long double", "'a'": "int", "(char)1": "char", "A": "int",
    "(char)1 + (char)1": "int", "1 + 1u": "unsigned int", "1u + 1l": "unsigned long",
    "1l + 1": "long", "1u + 1ll": "long long", "1ll + 1ull": "unsigned long long",
    "1.0f + 1": "float", "1.0f + 1.0": "double", "1.0 + 1.0L": "long double",
    "(short)1 << 1ll": "int", "1ll << 1": "long long", "!1.0": "int", "1.0 < 2.0": "int",
    "-(unsigned char)1": "int", "~(unsigned short)1": "int", "sizeof 1": "unsigned int",
    "1 ? 1 : 2.0": "double", "1 ? (char)1 : (char)2": "int", "(enum e)1": "unsigned int",
    "'a' + A": "int", '&"abc"[1] - "abc"': "int", '"abc"': "char *",
    "1 ? (void *)0 : (int *)0": "int *", "(long double)1": "long double",
    "bits.all + 1": "unsigned int", "bits.three + 1u": "unsigned int",
}  # fmt: skip

ALL_TYPES = [
    "_Bool", "char", "short", "int", "unsigned int", "long", "unsigned long", "long long",
    "unsigned long long", "float", "double", "long double", "char *", "int *",
]  # fmt: skip


@pytest.mark.parametrize("expression", TYPES)
def test_expression_types(expression: str) -> None:
    prelude = "enum e { A }; struct { unsigned three : 3, all : 32; } bits;"
    cases = ", ".join(f"{name}: {number}" for number, name in enumerate(ALL_TYPES, 1))
    program = compiled(f"{prelude} int f(void) {{ return _Generic(({expression}), {cases}); }}")
    (leave,) = [block.terminator for block in program.functions["f"].blocks]
    assert leave.value.value == 1 + ALL_TYPES.index(TYPES[expression])


NOT_CONSTANT = {
    "int n; int a[n];": "variable length array declaration not allowed at file scope",
    "int n; int x = n;": "initializer element is not a compile-time constant",
    "int f(void); int x = f();": "initializer element is not a compile-time constant",
    "int x = 1 / 0;": "initializer element is not a compile-time constant",
    "int n; enum { A = n };": "value of 'A' is not an integer constant expression",
    "enum { A = 1.5 };": "value of 'A' is not an integer constant expression",
    "int f(int n) { switch (n) { case n: ; } return 0; }":
        "case label is not an integer constant expression",
    "struct { int a : 1.0; } x;": "bit-field width is not an integer constant expression",
    "int a[-1];": "array size is negative",
    "int a[0x7fffffff];": "array is too large",
    "_Static_assert(1 > 2, \"numbers\");": 'static assertion failed: "numbers"',
}  # fmt: skip


@pytest.mark.parametrize("source", NOT_CONSTANT)
def test_non_constant_expressions_are_errors(source: str) -> None:
    errors = [each for each in messages(source) if "error" in each]
    assert [each.partition("error: ")[2].partition(" [")[0] for each in errors] == [
        NOT_CONSTANT[source]
    ]
