"""The shape of the IR: few instructions, conditions as branches, variables in registers."""

from __future__ import annotations

import pytest

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Call, Register, Slot, Statement
from tests.frontend.compiling import body, compiled, function

SHAPES = {
    "int f(int i) { i = i + 1; return i; }": [
        "entry:", "%i.0 = i32.add %i.0, 1", "return %i.0",
    ],
    "int f(int i) { return i++ + 1; }": [
        "entry:", "%1 = %i.0", "%i.0 = i32.add %i.0, 1", "%2 = i32.add %1, 1", "return %2",
    ],
    "char f(int i) { char c = i; c += 200; return c; }": [
        "entry:", "%c.1 = i32.extend8_s %i.0", "%2 = i32.add %c.1, 200",
        "%c.1 = i32.extend8_s %2", "return %c.1",
    ],
    "unsigned short s; void f(int i) { s = i; }": ["entry:", "store u16 [@s], %i.0", "return"],
    "int a[9]; int f(int i) { return a[i]; }": [
        "entry:", "%1 = i32.shl %i.0, 2", "%2 = address @a", "%3 = i32.add %2, %1",
        "bounds %i.0 < 9 [@a]", "%4 = load i32 [%3]", "return %4",
    ],
    "int a[9]; int f(void) { return a[3] + *(a + 4); }": [
        "entry:", "%0 = load i32 [@a + 12]", "%1 = load i32 [@a + 16]", "%2 = i32.add %0, %1",
        "return %2",
    ],
    "extern int a[]; int f(void) { return a[3]; }": [
        "entry:", "%0 = address @a + 12", "%1 = load i32 [%0]", "return %1",
    ],
    "int a[9]; int f(void) { return a[9]; }": [
        "entry:", "bounds 9 < 9 [@a]", "%0 = address @a + 36", "%1 = load i32 [%0]", "return %1",
    ],
    "int f(int *p, int i) { return p[i + 2]; }": [
        "entry:", "%2 = i32.shl %i.1, 2", "%3 = i32.add %p.0, %2", "%4 = load i32 [%3 + 8]",
        "return %4",
    ],
    "int f(int *p) { return p[-1]; }": [
        "entry:", "%1 = i32.add %p.0, -4", "%2 = load i32 [%1]", "return %2",
    ],
    "struct s { int a; struct { short b[3]; } c; }; int f(struct s *p) { return p->c.b[2]; }": [
        "entry:", "%1 = load i16 [%p.0 + 8]", "return %1",
    ],
    "void f(double *p, int i) { *p++ = i; }": [
        "entry:", "%2 = %p.0", "%p.0 = i32.add %p.0, 8", "%3 = f64.convert_i32_s %i.1",
        "store f64 [%2], %3", "return",
    ],
    "int f(int a, int b) { if (a < b && !b) return 1; return 2; }": [
        "entry:", "%2 = i32.lt_s %a.0, %b.1", "branch %2 ? and.3 : endif.2",
        "and.3:", "branch %b.1 ? endif.2 : then.1",
        "then.1:", "return 1", "endif.2:", "return 2",
    ],
    "int f(long long a) { if (a == 0 || a > 5) return 1; return 2; }": [
        "entry:", "%1 = i64.eq %a.0, 0", "branch %1 ? then.1 : or.3",
        "or.3:", "%2 = i64.gt_s %a.0, 5", "branch %2 ? then.1 : endif.2",
        "then.1:", "return 1", "endif.2:", "return 2",
    ],
    "int f(int n) { int s = 0; while (n) s += n--; return s; }": [
        "entry:", "%s.1 = 0", "jump test.1",
        "test.1:", "branch %n.0 ? body.2 : endloop.4",
        "body.2:", "%2 = %n.0", "%n.0 = i32.add %n.0, -1", "%s.1 = i32.add %s.1, %2",
        "jump test.1", "endloop.4:", "return %s.1",
    ],
    "int f(int n) { for (;;) { if (n) break; } do n++; while (n < 9); return n; }": [
        "entry:", "jump body.2", "body.2:", "branch %n.0 ? then.5 : body.2",
        "then.5:", "jump body.8", "body.8:", "%n.0 = i32.add %n.0, 1",
        "%1 = i32.lt_s %n.0, 9", "branch %1 ? body.8 : endloop.10", "endloop.10:",
        "return %n.0",
    ],
    "int f(int n) { return n ? n + 1 : 7; }": [
        "entry:", "branch %n.0 ? then.1 : else.2", "then.1:", "%1 = i32.add %n.0, 1",
        "jump end.3", "else.2:", "%1 = 7", "jump end.3", "end.3:", "return %1",
    ],
    "int f(unsigned n) { switch (n) { case 4294967295u: return 1; default: n = 2; case 3: ; } "
    "return n; }": [
        "entry:", "switch %n.0", "-1 -> case.2", "3 -> endswitch.1", "else -> default.3",
        "case.2:", "return 1", "default.3:", "%n.0 = 2", "jump endswitch.1",
        "endswitch.1:", "return %n.0",
    ],
    "unsigned f(double d) { return d; }": [
        "entry:", "%1 = i64.trunc_f64_s %d.0", "%2 = i32.wrap_i64 %1", "return %2",
    ],
    "_Bool f(double d, int i) { return i ? d : i; }": [
        "entry:", "branch %i.1 ? then.1 : else.2", "then.1:", "%2 = %d.0", "jump end.3",
        "else.2:", "%2 = f64.convert_i32_s %i.1", "jump end.3", "end.3:",
        "%3 = f64.ne %2, 0.0", "return %3",
    ],
    "struct { unsigned a : 3, b : 5; int c : 9; } v; int f(void) { v.b = 7; return v.c; }": [
        "entry:", "%0 = load i32 [@v] unjudged", "%1 = i32.and %0, -249", "%2 = i32.or %1, 56",
        "store i32 [@v], %2", "%0 = load i32 [@v]", "%1 = i32.shl %0, 15",
        "%2 = i32.shr_s %1, 23", "return %2",
    ],
    "int f(void) { return 1; for (;;) ; }": ["entry:", "return 1"],
}  # fmt: skip


@pytest.mark.parametrize("source", SHAPES)
def test_lowered_instructions(source: str) -> None:
    assert body(source) == SHAPES[source]


def test_only_variables_whose_address_is_taken_are_in_memory() -> None:
    made = function(
        "void g(int *); int f(int a, int b) { int c = a, d = b, e[2]; g(&b); g(&d); g(e);"
        " { int d = c; return d; } }"
    )
    assert [each.variable.name for each in made.registers if each.variable] == ["a", "c", "d"]
    assert [each.name for each in made.slots] == ["d", "e"]
    places = [each.place for each in made.parameters]
    assert isinstance(places[0], Register)
    assert isinstance(places[1], Slot)


def test_arguments_are_evaluated_right_to_left() -> None:
    made = function("int g(), h(), k(); int f(void) { return k(g(), h()); }")
    calls = [each.terminator for each in made.blocks if isinstance(each.terminator, Call)]
    assert [each.callee for each in calls] == ["h", "g", "k"]


CALLS = {
    "char c; short s; float x; int g(); void f(void) { g(c, s, x, 1LL, f); }":
        ["i32", "i32", "f64", "i64", "i32"],
    "int g(char, float, long long, ...); void f(void) { g(300, 1, 2, 3.0f, (short)1); }":
        ["i32", "f32", "i64", "f64", "i32"],
    "struct p { int x, y, z; } v; int g(struct p, int); void f(void) { g(v, 1); }": [None, "i32"],
    "struct p { int x, y, z; } v; struct p g(int); void f(void) { v = g(1); }": ["i32", "i32"],
}  # fmt: skip


@pytest.mark.parametrize("source", CALLS)
def test_arguments_are_passed_as_on_i386(source: str) -> None:
    made = function(source)
    (call,) = [each.terminator for each in made.blocks if isinstance(each.terminator, Call)]
    assert [each.memory for each in call.arguments] == CALLS[source]


PARAMETERS = {
    "int f(char c, float x, double y) { return 0; }": ["i8", "f32", "f64"],
    "int f(c, x, y, s, n) char c; float x; double y; short *s; { return 0; }":
        ["i32", "f64", "f64", "i32", "i32"],
    "int f(char, float); int f(c, x) char c; float x; { return 0; }": ["i8", "f32"],
    "struct p { int x; } f(int n, struct p v) { return v; }": ["i32", "i32", None],
}  # fmt: skip


@pytest.mark.parametrize("source", PARAMETERS)
def test_old_style_parameters_are_converted(source: str) -> None:
    assert [each.memory for each in function(source).parameters] == PARAMETERS[source]


def test_statements_have_markers() -> None:
    made = function(
        """int g(int);
int f(int n) {
    int a, b = 2;
    ;
    { a = 1; }
    if (n)
        b++;
    else
        g(b);
    for (a = 0;
         a < 3;
         a++) {
        if (b) continue;
        break;
    }
    switch (a) {
    case 1: goto end;
    }
    while (a) a--;
    do b--; while (b);
end:
    return a;
}"""
    )
    lines = [
        each.location.line
        for block in made.blocks
        for each in block.instructions
        if isinstance(each, Statement)
    ]
    wanted = [3, 5, 6, 7, 9, 10, 11, 12, 13, 13, 14, 16, 17, 19, 19, 20, 20, 22]
    assert sorted(lines) == wanted


def test_undefined_names_are_listed_with_their_first_use() -> None:
    program = compiled(
        """extern int far, unused;
int near, *pointer = &far;
int g(void);
int f(void) {
    return near + missing(far) + g();
    never();
}"""
    )
    found = {name: f"{place.line}:{place.column}" for name, place in program.undefined.items()}
    assert found == {"far": "2:12", "missing": "5:19", "g": "5:34"}


def test_static_names_are_unique() -> None:
    program = compiled(
        """static int a;
static int g(void) { static int a; { static int a; return a; } }
int f(void) { static int a; return g() + a; }
char *s = "x", *t = "y", *u = "x";"""
    )
    assert list(program.functions) == ["a.c:g", "f"]
    assert sorted(program.data) == [
        'a.c:"0', 'a.c:"1', "a.c:a", "a.c:f.a", "a.c:g.a", "a.c:g.a.2", "s", "t", "u",
    ]  # fmt: skip
    tentative = [
        name for name, data in compiled("int a; static int b;").data.items() if data.tentative
    ]
    assert tentative == ["a"]


def test_main_returns_zero_at_its_end() -> None:
    assert body("int main(void) { }", "main") == ["entry:", "return 0"]
    assert body("int f(void) { }") == ["entry:", "return"]


def test_statements_share_temporary_registers() -> None:
    lines = "".join(f"i += g({number}) * a[i & 7];" for number in range(200))
    source = f"int g(int n); int a[8]; int f(int i) {{ {lines} return i; }}"
    assert len(compiled(source).functions["f"].registers) < 20


def test_too_many_variables_are_kept_in_memory() -> None:
    lines = "".join(f"int v{number} = {number};" for number in range(12_000))
    function = compiled(f"int f(void) {{ {lines} return v7 + v11999; }}").functions["f"]
    assert len(function.registers) < 10_100
    assert len(function.slots) > 1_900


def test_variables_have_their_blocks() -> None:
    source = (
        "int f(int a) {\n  for (int i = 0; i < 3; i++)\n    { int a = i; f(a); }\n  return a;\n}"
    )
    known = [each.variable for each in function(source).registers if each.variable]

    def visible(line: int, column: int) -> list[tuple[str, int]]:
        place = Location("a.c", line, column)
        return [(each.name, each.location.line) for each in known if each.is_visible(place)]

    assert visible(2, 3) == [("a", 1)]
    assert visible(2, 19) == visible(3, 5) == [("a", 1), ("i", 2)]
    assert visible(3, 18) == [("a", 1), ("i", 2), ("a", 3)]
    assert visible(4, 3) == [("a", 1)]
