"""The front end as a whole: hostile nesting, odd but legal programs, files."""

from __future__ import annotations

import sys
import threading
from pathlib import Path

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_file
from tests.frontend.compiling import compiled, messages

DEEP = {
    "parentheses": lambda n: f"int f(void) {{ return {'(' * n}1{')' * n}; }}",
    "else if": lambda n: "int f(int x) { if (x) return 1;"
    + "".join(f"else if (x == {i}) return {i};" for i in range(n))
    + "return 0; }",
    "sums": lambda n: f"int f(int x) {{ return x{'+ x' * n}; }}",
    "prefixes": lambda n: f"int f(int x) {{ return {'-~!' * n}x; }}",
    "blocks": lambda n: f"int f(int x) {{ {'{' * n}{'}' * n} return 1; }}",
    "conditionals": lambda n: f"int f(int x) {{ return {'x ? 1 : ' * n}2; }}",
    "casts": lambda n: f"int f(int x) {{ return {'(char)' * n}x; }}",
    "calls": lambda n: f"int f(int x) {{ return {'f(' * n}x{')' * n}; }}",
    "loops": lambda n: f"int f(int x) {{ {'while (x) ' * n}; return 1; }}",
    "structs": lambda n: "struct { " * n + "int x; " + "} a;" * n,
    "pointers": lambda n: f"int {'*' * n}p;",
    "parameters": lambda n: "int " + "f(int " * n + ")" * n + ";",
    "initialisers": lambda n: f"int x = {'{' * n}1{'}' * n};",
    "unclosed": lambda n: "int f(void) { return " + "(" * n,
    "labels": lambda n: "int f(void) { " + "".join(f"l{i}: " for i in range(n)) + "return 1; }",
    "type names": lambda n: "int x = " + "sizeof(char[" * n + "1" + "])" * n + ";",
    "literals": lambda n: "int f(void) { return "
    + "(int[sizeof(" * n + "int" + ")]){0}[0]" * n + "; }",
}  # fmt: skip


@pytest.mark.parametrize("depth", [500, 3000])
@pytest.mark.parametrize("kind", DEEP)
def test_deep_nesting_compiles_or_gives_a_clear_error(kind: str, depth: int) -> None:
    errors = [each for each in messages(DEEP[kind](depth)) if "error" in each]
    assert len(errors) <= 1
    assert all("nested too deeply" in each or kind == "unclosed" for each in errors)


@pytest.mark.parametrize("kind", ["parentheses", "else if", "sums", "blocks"])
def test_hundreds_of_nested_levels_compile(kind: str) -> None:
    assert messages(DEEP[kind](500)) == []


@pytest.mark.parametrize("kind", ["parentheses", "sums", "blocks", "pointers"])
def test_excessive_nesting_is_an_error(kind: str) -> None:
    (found,) = messages(DEEP[kind](40_000))
    assert "nested too deeply" in found


def test_compilation_restores_interpreter_limits() -> None:
    before = sys.getrecursionlimit(), threading.stack_size(), threading.active_count()
    messages(DEEP["parentheses"](40_000))
    assert (sys.getrecursionlimit(), threading.stack_size(), threading.active_count()) == before


@pytest.mark.parametrize("size", [2000])
@pytest.mark.parametrize(
    "line",
    [
        "f{n}() {{ }}",
        "int v{n} = {n};",
        "typedef struct s{n} {{ int a, b; }} t{n};",
        "int f{n}(int n) {{ static int x; {{ static int x; }} return g(n); }}",
        "enum {{ A{n} = {n} }};",
    ],
)
def test_compile_time_is_linear_in_file_length(line: str, size: int) -> None:
    source = "\n".join(line.format(n=n) for n in range(size))
    assert all("warning" in each for each in messages(source))


ODD = [
    "",
    ";;",
    "int f(void) { { ; } ; }",
    "int f(int n) { switch (n) ; switch (n) { n = 1; } switch (n) case 1: n = 2; return n; }",
    "int f(int n) { return 1; n = 2; goto end; end: return n; n++; }",
    "int f(int n) { goto in; while (n) { in: n--; } return n; }",
    "int f(int n) { while (1) ; return n; }",
    "int f(int n) { do { continue; } while (0); for (;;) { break; } return n; }",
    ("int f(int n) { switch (n & 3) { case 0: do { n--; case 3: n--; case 2: n--; } while (n); }"
     " return n; }"),
    "int f(int n) { if (n) { int n = 3; return n; } else ; return n; }",
    "int f(void) { return sizeof(int[3]) + sizeof(f) + sizeof(struct { int x; }); }",
    "void f(void) { (void)0; (void)f; f; *f; (*f)(); (**f)(); (&f); }",
    "struct s { int x; } g(void); int f(void) { return g().x + (g(), 1) + sizeof g(); }",
    "struct s { int a[3]; } g(void); int f(int i) { return g().a[i]; }",
    "struct s { int x; } a, b; int f(int n) { return (n ? a : b).x + (a = b).x + (0, a).x; }",
    ("int f(void) { struct s { int x; } *p = 0; struct s v; { struct s { char c; } w; w.c = 1; }"
     " v.x = 1; return (p = &v)->x; }"),
    "int f(int n) { return ({ int m = n; m * m; }) + ({ 3; }); }",
    "int f(float x) { x++; --x; x += 1; x *= 2.0; return -x < !x; }",
    "int f(char c) { c++; c--; c <<= 1; c /= 3; c ^= c; return c-- + ++c; }",
    "int f(_Bool b) { b++; b += 3; b = 0.5; return b--; }",
    "long long f(long long n) { n <<= 3; n = n << n; n >>= 1u; n %= 7; return n++ / 2 - -n; }",
    "int *f(int *p, int **q) { p += 3; p -= *p; *q++ = p--; return p - 1 + (p - *q); }",
    "int f(void *p, char *q) { return p == q && q < (char *)p + 1 && p; }",
    "union u { int i; float x; } f(union u v) { v.x = v.i; return v; }",
    "struct { unsigned a : 3; int : 0; int b : 5; } v; int f(void) { return v.b++ + --v.a; }",
    "int (*f(int n))(int) { return n ? f(0) : 0; }",
    ("int f(int n, ...) { __builtin_va_list a, b; double d; __builtin_va_start(a, n);"
     " __builtin_va_copy(b, a); d = __builtin_va_arg(a, double); __builtin_va_end(a); return d; }"),
    ("struct p { int x, y; }; int f(int n, ...) { __builtin_va_list a; __builtin_va_start(a, n);"
     " return __builtin_va_arg(a, struct p).y; }"),
    "double f(double x) { return __builtin_sqrt(x) + __builtin_copysign(x, -1); }",
    "int f(unsigned n) { return __builtin_clz(n) + __builtin_popcountll(n); }",
    "int f(int n) { if (n) __builtin_unreachable(); __crs_stop(\"abort called\"); }",
    "int f(int n) { return n > 0 ? __builtin_trap(), 1 : 2; }",
    "int a[2][3]; int f(int (*p)[3]) { return p[1][2] + (*p)[1] + *p[1] + **(a + 1) + sizeof *p; }",
    "char *f(void) { return __func__; }",
    "extern int x; int f(void) { extern int x; return x; } int x = 3;",
    "static int x; int f(void) { extern int x; return x; }",
    "int f(void) { int g(int); return g(1); } int g(int n) { return n; }",
    "inline int f(void) { return 1; } static inline int g(void) { return f(); }",
    "typedef int F(int); F f; F *p = f; int f(int n) { return (*p)(n); }",
    "const struct s { int a; } v = {1}; int f(void) { struct s w = v; return w.a; }",
    "int f(a, b) { return a + b; }",
    "int f(int n) { int a[] = {n, n + 1}, i = 0; a[i++] += a[i]; return a[0]; }",
]  # fmt: skip


@pytest.mark.parametrize("source", ODD)
def test_odd_but_legal_programs_compile(source: str) -> None:
    compiled(source)


def test_locations_use_the_given_file_name(tmp_path: Path) -> None:
    path = tmp_path / "twice.c"
    path.write_text("static int n;\nint twice(void) { return n * 2 }\n")
    diagnostics = Diagnostics()
    with pytest.raises(CompileError, match="expected ';' after '2'") as caught:
        compile_file(path, Options(), diagnostics)
    (message,) = caught.value.diagnostics
    assert str(message.location) == f"{path}:2:31"
    assert message.source_line == "int twice(void) { return n * 2 }"
