"""Initialised objects have the bytes of gcc -m32 -malign-double."""

from __future__ import annotations

import pytest

from crs_cc.ir.instruction import Copy, Fill, Store
from tests.frontend.compiling import compiled, function, messages

BYTES = {
    'int x = 258;': "02010000",
    'short x[] = {1, -2, 3};': "0100feff0300",
    'char x[] = "abc";': "61626300",
    'char x[2] = "ab";': "6162",
    'char x[6] = "ab";': "616200000000",
    'char x[] = {"xyz"};': "78797a00",
    'char x[2][4] = {"ab", "cde"};': "6162000063646500",
    'char x[][3] = {{\'a\'}, "b", {"c"}};': "610000620000630000",
    'int x[2][3] = {1, 2, 3, 4};': "010000000200000003000000040000000000000000000000",
    'int x[2][3] = {{1}, {2, 3}};': "010000000000000000000000020000000300000000000000",
    'int x[] = {[3] = 7, 8, [0] = 1};': "0100000000000000000000000700000008000000",
    'int x[2][2] = {[1][0] = 5, 6};': "00000000000000000500000006000000",
    'struct { char a; int b; } x = {1, 2};': "0100000002000000",
    'struct { char a; int b; } x = {.b = 2, .a = 1};': "0100000002000000",
    'struct { int a; struct { short b, c; } d; int e; } x = {1, 2, 3, 4};':
        "010000000200030004000000",
    'struct { int a; struct { short b, c; } d; int e; } x = {1, {2}, 4};':
        "010000000200000004000000",
    'struct { int a; struct { short b, c; } d; int e; } x = {.d.c = 9, 4};':
        "000000000000090004000000",
    'struct { int a; struct { short b, c; } d; int e; } x = {.d = {.c = 9}, .a = 3};':
        "030000000000090000000000",
    'struct { struct { int a, b; } p[2]; } x = {1, 2, 3};': "01000000020000000300000000000000",
    'struct { struct { int a, b; } p[2]; } x = {{{1}, {3}}};': "01000000000000000300000000000000",
    'struct { struct { int a, b; } p[2]; } x = {.p[1].a = 3, 4};':
        "00000000000000000300000004000000",
    'union { char a; int b; } x = {300};': "2c000000",
    'union { char a; int b; } x = {.b = 300};': "2c010000",
    'union { struct { short a, b; } s; int c; } x = {1, 2};': "01000200",
    'struct { int a; union { char b; int c; }; int d; } x = {1, 2, 3};': "010000000200000003000000",
    'struct { int a; union { char b; int c; }; int d; } x = {.c = 258, 3};':
        "000000000201000003000000",
    'struct { int a : 3, b : 7; unsigned c : 12; } x = {-1, 5, 4095};': "2ffc3f00",
    'struct { int a : 3; int : 5; int b : 4; } x = {1, 2};': "01020000",
    'struct { char n[4]; int v; } x[] = {"ab", 1, {"cdef", 2}, {{\'x\'}}};':
        "616200000100000063646566020000007800000000000000",
    'struct { char n[4]; int v; } x[2] = {[1].v = 3, [0] = {.n = "q"}};':
        "71000000000000000000000003000000",
    'double x[2] = {1, -2.5f};': "000000000000f03f00000000000004c0",
    'float x = 0.1;': "cdcccc3d",
    'long long x[] = {-1, 0x123456789abLL};': "ffffffffffffffffab89674523010000",
    '_Bool x[] = {0, 3, 0.5, 0.0};': "00010100",
    'char x = 300;': "2c",
    "unsigned char x[] = {-1, 256, 'a'};": "ff0061",
    'int x = {3};': "03000000",
    'int x = {{4}};': "04000000",
    'int x[3] = {1, 2, 3,};': "010000000200000003000000",
    'enum { A, B, C } x[] = {C, B};': "0200000001000000",
    "struct { double d; char c; } x = {.c = 'z', .d = 1};": "000000000000f03f7a00000000000000",
    'int x[4] = {};': "00000000000000000000000000000000",
    'struct { int n; int a[]; } x = {5};': "05000000",
    'struct { struct { char a[3]; int b; } s[2]; char t[2]; } x = '
    '{{{"ab", 1}, {{99}, 2}}, "de"};':
        "6162000001000000630000000200000064650000",
    'int x[2][2][2] = {{1, 2, 3}, {{4}, 5}};':
        "0100000002000000030000000000000004000000000000000500000000000000",
    'unsigned x = -1;': "ffffffff",
    'short x[3] = {[2] = 3, [1] = 2, [1] = 9};': "000009000300",
    'struct { int a, b, c; } x = {1, .c = 3};': "010000000000000003000000",
    'struct { int a, b, c; } x = {.b = 1, 2};': "000000000100000002000000",
    'struct { int a, b, c; } x = {.b = 1, .a = 5, 6};': "050000000600000000000000",
    'char x[3][2] = {"a", [2] = "c"};': "610000006300",
    'char x[] = "a\\0b" "c\\x41";': "610062634100",
    'char x[] = "\\303\\251";': "c3a900",
    'int x[] = L"ab";': "610000006200000000000000",
    'unsigned short x[] = u"ab";': "610062000000",
}  # fmt: skip


@pytest.mark.parametrize("declaration", BYTES)
def test_global_initialiser_bytes(declaration: str) -> None:
    data = compiled(declaration).data["x"]
    assert (data.content or bytes(data.size)).hex() == BYTES[declaration]


ADDRESSES = {
    "int y; int *x = &y;": [(0, "y", 0)],
    "int y[9]; int *x[] = {y + 2, &y[3], 0, &2[y]};": [(0, "y", 8), (4, "y", 12), (12, "y", 8)],
    "struct { char c; int v[4]; } y; int x = (int)&y.v[1];": [(0, "y", 8)],
    "int f(int); int (*x[])(int) = {f, &f, *f};": [(0, "f", 0), (4, "f", 0), (8, "f", 0)],
    'struct { int n; char *s; } x[] = {{1, "one"}, {2, "two" + 1}};': [
        (4, 'a.c:"0', 0), (12, 'a.c:"1', 1),
    ],
    "struct s { struct s *next; } x = {&x};": [(0, "x", 0)],
    "int *x = (int[]){1, 2} + 1;": [(0, "a.c:.literal", 4)],
    "extern char y[]; char *x = y + 4 - 1;": [(0, "y", 3)],
    "int y[4]; char *x = (char *)y + sizeof y;": [(0, "y", 16)],
}  # fmt: skip


@pytest.mark.parametrize("source", ADDRESSES)
def test_address_in_an_initialiser_is_a_relocation(source: str) -> None:
    relocations = compiled(source).data["x"].relocations
    found = [(each.offset, each.symbol, each.addend) for each in relocations]
    assert found == ADDRESSES[source]


def test_local_is_zeroed_only_if_its_initialiser_has_gaps() -> None:
    full = function("int f(int n) { int v[2] = {n, 1}; return v[0]; }")
    gaps = function("int f(int n) { int v[3] = {n, 1}; return v[0]; }")
    kinds = [
        [type(each) for each in made.blocks[0].instructions if isinstance(each, Fill | Store)]
        for made in (full, gaps)
    ]
    assert kinds == [[Store, Store], [Fill, Store, Store]]


def test_a_local_table_of_constants_is_copied_from_an_image() -> None:
    program = compiled("int f(int i) { int v[9] = {1, 2, 3, 4, 5, 6, 7, [8] = i}; return v[i]; }")
    instructions = program.functions["f"].blocks[0].instructions
    assert [type(each) for each in instructions].count(Copy) == 0
    program = compiled("int f(int i) { int v[10] = {1, 2, 3, 4, 5, 6, 7, 8, 9, i}; return v[i]; }")
    instructions = program.functions["f"].blocks[0].instructions
    assert [type(each) for each in instructions].count(Copy) == 1
    assert len([each for each in instructions if isinstance(each, Store)]) == 1
    (image,) = program.data.values()
    numbers = [1, 2, 3, 4, 5, 6, 7, 8, 9, 0]
    assert image.content == b"".join(each.to_bytes(4, "little") for each in numbers)


@pytest.mark.parametrize(
    "source",
    [
        "int x[2000000000];",
        "char x[] = {[2000000000] = 1};",
        "struct { char a[1900000000], b[1900000000]; } x;",
        "char x[1 << 28] = {1};",
        "int f(void) { char x[2147483647][2]; return x[0][0]; }",
    ],
)
def test_an_enormous_object_is_refused(source: str) -> None:
    assert "too large" in " ".join(messages(source))
