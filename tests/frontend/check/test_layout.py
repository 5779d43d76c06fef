"""Types have the sizes, alignments and offsets of the target.

The numbers are those of gcc -m32 -malign-double: ILP32 with natural alignment.
"""

from __future__ import annotations

import pytest

from crs_cc.ir.types import RecordType
from tests.frontend.compiling import type_of

LAYOUTS = {
    "struct char_double { char a; double b; char c; }": "24 8 a:0 b:64 c:128",
    "struct mixed { char a; short b; int c; long long d; float e; char f; }":
        "24 8 a:0 b:16 c:32 d:64 e:128 f:160",
    "struct pointers { char a; char *p; void (*f)(void); char b[3]; }":
        "16 4 a:0 p:32 f:64 b:96",
    "struct nested { char a; struct { short x; double y; } in; char b; }":
        "32 8 a:0 in:64 b:192",
    "struct arrays { char a[5]; short b[3]; int c[2][3]; }": "36 4 a:0 b:48 c:96",
    "struct tail { int a; char b; }": "8 4 a:0 b:32",
    "struct flexible { int n; double d[]; }": "8 8 n:0 d:64",
    "struct bits { int a:3; int b:7; unsigned c:22; int d:5; }": "8 4 a:0 b:3 c:10 d:32",
    "struct bits_char { char a; int b:8; char c; }": "4 4 a:0 b:8 c:16",
    "struct bits_cross { char a:5; char b:4; short c:9; short d:8; }":
        "6 2 a:0 b:8 c:16 d:32",
    "struct bits_zero { int a:3; int :0; int b:2; char c; }": "8 4 a:0 b:32 c:40",
    "struct bits_unnamed { char a; int :4; int b:4; char c; }": "4 4 a:0 b:12 c:16",
    "struct bits_unnamed_only { char a; int :20; char c; }": "5 1 a:0 c:32",
    "struct bits_long_long { int a; long long b:40; int c:10; }": "16 8 a:0 b:64 c:104",
    "struct bits_bool { _Bool a:1; _Bool b:1; int c:30; _Bool d:1; }":
        "8 4 a:0 b:1 c:2 d:32",
    "struct bits_tail { short a:12; char b; int c:17; }": "8 4 a:0 b:16 c:32",
    "struct aligned { char a; _Alignas(16) char b; int c; }": "32 16 a:0 b:128 c:160",
    "struct empty { }": "0 1",
    "union overlay { char a[5]; int b; double c; }": "8 8 a:0 b:0 c:0",
    "union small { char a; short b[3]; }": "6 2 a:0 b:0",
    "union bits_union { int a:5; char b; unsigned c:17; }": "4 4 a:0 b:0 c:0",
}  # fmt: skip


@pytest.mark.parametrize("declaration", LAYOUTS)
def test_layout_is_that_of_gcc(declaration: str) -> None:
    ctype = type_of(f"{declaration} x;")
    assert isinstance(ctype, RecordType)
    places = [
        f"{each.name}:{8 * each.offset + each.bit_offset}"
        for each in ctype.record.members or []
        if each.name is not None
    ]
    assert " ".join([str(ctype.size), str(ctype.align), *places]) == LAYOUTS[declaration]


SIZES = {
    "_Bool": 1, "char": 1, "short": 2, "int": 4, "long": 4, "long long": 8, "float": 4,
    "double": 8, "long double": 8, "char *": 4, "void (*)(void)": 4, "enum { A, B }": 4,
    "int[3][5]": 60, "void": 1,
}  # fmt: skip


@pytest.mark.parametrize("name", SIZES)
def test_sizeof(name: str) -> None:
    assert type_of(f"char x[sizeof({name})];").size == SIZES[name]


def test_members_of_anonymous_structs_are_members_of_the_whole() -> None:
    ctype = type_of("struct { int a; union { int b; struct { short c, d; }; }; int e; } x;")
    assert isinstance(ctype, RecordType)
    offsets = {name: each.offset for name, each in ctype.record.named.items()}
    assert offsets == {"a": 0, "b": 4, "c": 4, "d": 6, "e": 8}


SPELLINGS = {
    "char *x[3];": "char *[3]",
    "char (*x)[3];": "char (*)[3]",
    "int (*x)(int, ...);": "int (*)(int, ...)",
    "int (*(*x)(void))[4];": "int (*(*)(void))[4]",
    "const char *const x = 0;": "const char *const",
    "unsigned long int x;": "unsigned long",
    "long unsigned long x;": "unsigned long long",
    "short signed int x;": "short",
    "struct s { int a; } *x;": "struct s *",
    "typedef struct { int a; } point; point *x;": "point *",
    "int (*x[2])();": "int (*[2])()",
    "void (*x)(int a[4], int f(char));": "void (*)(int *, int (*)(char))",
    "volatile int x;": "volatile int",
    "typedef int row[4]; const row x = {0};": "const int[4]",
}


@pytest.mark.parametrize("declaration", SPELLINGS)
def test_type_spelling(declaration: str) -> None:
    assert str(type_of(declaration)) == SPELLINGS[declaration]
