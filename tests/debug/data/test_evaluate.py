"""Expressions mean what they mean in the source where the program stands."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.debug.data.evaluate import Evaluator
from crs_cc.debug.data.expression_compiler import SourceNames
from crs_cc.debug.errors import DebugError
from tests.debug.stopped_program import Stopping

SOURCE = r"""
#include <stdlib.h>
#define TWICE(x) (2 * (x))
enum mode { IDLE, TURN = 5 };
struct point { int x, y; };
struct node { struct point at; struct node *next; char name[8]; unsigned on : 3; signed off : 4; };
int total = 7;
static int hidden = 3;
int order[6] = {1, 2, 3, 4, 5, 6};
char text[] = "hello";
int shadowed = 1;
static int twice(int n) { int made = n; made *= 2; return made; }
static int bump(int n) { static int calls; calls++; total += n; return calls; }
static struct point moved(struct point from, int by) { from.x += by; return from; }
static int fails(int n) { total = n; return n / (n - n); }
static int deep(int n) { return deep(n + 1); }
static int endless(void) { for (;;) ; return 0; }
int (*op)(int) = twice;
int work(int speed, double d, char letter)
{
    struct node n = {{1, 2}, 0, "abc", 5, -3};
    struct node *p = malloc(sizeof *p), *freed;
    unsigned short s = 65535;
    long long big = 1LL << 40;
    float f = 0.1f;
    char array[4];
    int i;
    enum phase { NEAR = 8, FAR };
    p->next = &n;
    p->at.x = 3;
    freed = malloc(24);
    free(freed);
    array[0] = 'a';
    for (i = 1; i < 3; i++) {
        int shadowed = 10 * i;
        {
            int speed = 99;
            total += speed - 99; /* INNER */
        }
        total += shadowed; /* STOP */
    }
    return i + s + big + f + d + letter + speed + p->at.x + array[0];
}
int main(void)
{
    int outer = 4;
    return op(outer) + work(outer, 2.5, 'x') + bump(0) + hidden + shadowed + text[0] + order[0]
        + moved((struct point) {1, 2}, 1).x + (outer > 9 ? fails(1) + deep(1) + endless() : 0);
}
"""


@pytest.fixture(scope="module")
def stopping(tmp_path_factory: pytest.TempPathFactory) -> Stopping:
    return Stopping(tmp_path_factory.mktemp("evaluate"), SOURCE).run()


@pytest.fixture(scope="module")
def evaluator(stopping: Stopping) -> Evaluator:
    return stopping.evaluator()


SHOWN = {
    "total": "7",
    "hidden + speed": "7",
    "shadowed": "10",
    "i * 3 - 1 << 2": "8",
    "-7 / 2": "-3",
    "-7 % 3": "-1",
    "7u - 8u": "4294967295",
    "s + 1": "65536",
    "(unsigned char)s": "255",
    "big": "1099511627776",
    "big >> 38 & 7": "4",
    "f": "0.1",
    "f == 0.1": "0",
    "d / 2": "1.25",
    "letter": "120 'x'",
    "letter == 'x' && total > 6 || 1 / 0": "1",
    "i ? order[i] : order[0]": "2",
    "n.at.y": "2",
    "p->next->name": '"abc"',
    "n.on": "5",
    "n.off": "-3",
    "TWICE(speed + 1)": "10",
    "TURN": "TURN",
    "TURN + 1": "6",
    "FAR": "FAR",
    "FAR + 1": "10",
    "(enum phase)8": "NEAR",
    "(enum mode)5": "TURN",
    "(enum mode)total": "7",
    "sizeof(struct node)": "24",
    "sizeof order / sizeof *order": "6",
    "twice(21)": "42",
    "op(4)": "8",
    "moved(n.at, 40).x": "41",
    "moved(n.at, 40)": "{x = 41, y = 2}",
    "op": "twice",
    "twice": "twice",
    "&order[3]": "&order[3]",
    "&speed": "&speed",
    "*&speed": "4",
    '"abc"': '"abc"',
    "text": '"hello"',
    "text[1]": "101 'e'",
    "(void)0": "void",
    'strlen(text) + strlen("ab")': "7",
    'strcmp(text, "help") < 0': "1",
    "sqrt(2.0 * 8)": "4.0",
    "fabs(sin(1.5)) > 0.99": "1",
    'abs(-3) + atoi("40")': "43",
    "isdigit(text[0])": "0",
    "array[0]": "97 'a'",
    "array[1]": "uninitialised",
    "p->at.y": "uninitialised",
    "p->at": "{x = 3, y = ?}",
}


@pytest.mark.parametrize("text", SHOWN)
def test_expressions_have_these_values(evaluator: Evaluator, stopping: Stopping, text: str) -> None:
    before = stopping.state()
    found = evaluator.evaluate(text)
    assert found.value.text == SHOWN[text]
    assert not found.changed
    assert stopping.state() == before


REFUSED = {
    "foo": "use of undeclared identifier 'foo'",
    "outer": "use of undeclared identifier 'outer'",
    "1 +": "expected an expression",
    "": "expected an expression",
    "n + 1": "invalid operands",
    "1 / 0": "integer division or modulo by zero",
    "*(int *)0": "the pointer is null",
    "order[6]": "is past the end of 'order'",
    "*freed": "a heap block of 24 bytes is freed at",
    "*(int *)0x7fffffff": "is not inside any object",
    "array[1] + 1": "'array[1]' is uninitialised",
    "p->at.y + 1": "a heap block of 24 bytes is uninitialised",
    "fails(3)": "integer division or modulo by zero",
    'printf("x")': "the program has no function 'printf'",
    "calloc(1, 2)": "the program has no function 'calloc'",
    "nothing()": "the program has no function 'nothing'",
    "deep(1)": "too many nested calls",
    "endless()": "evaluation exceeds 1,000,000 instructions",
    "((int (*)(int))12)(1)": "0xc is not a function's address",
    "(" * 5000: "nested too deeply",
    "9" * 20000: "too long",
}


@pytest.mark.parametrize("text", REFUSED, ids=lambda text: text[:20])
def test_an_error_is_one_line_and_has_no_effect(
    evaluator: Evaluator, stopping: Stopping, text: str
) -> None:
    before = stopping.state()
    with pytest.raises(DebugError) as caught:
        evaluator.evaluate(text)
    assert REFUSED[text] in str(caught.value)
    assert "\n" not in str(caught.value)
    assert stopping.state() == before


def test_assignments_change_the_program(tmp_path: Path) -> None:
    stopping = Stopping(tmp_path, SOURCE).run()
    evaluator = stopping.evaluator()
    for text in ("total = 12", "s = 1", "n.off = 7", "array[2] = 'z'", "i += 1", "p->at.y = -1"):
        assert evaluator.evaluate(text).changed, text
    assert not evaluator.evaluate("total = 12").changed
    assert evaluator.evaluate("bump(5)").changed
    shown = [evaluator.evaluate(each).value.text for each in ("total", "s", "n.off", "array[2]")]
    assert shown == ["17", "1", "7", "122 'z'"]
    assert evaluator.evaluate("array[1]").value.text == "uninitialised"
    assert evaluator.evaluate("p->at.y + i").value.text == "1"
    assert evaluator.evaluate("letter = 200").value.text == "-56"
    assert evaluator.evaluate("letter").value.text == "-56"


def test_the_program_continues_with_assigned_values(tmp_path: Path) -> None:
    source = """\
struct pair { int a, b; };
int main(void)
{
    signed char in_register = 1;
    int unset, more;
    struct pair pair;
    pair.a = 1;
    in_register++; /* STOP */
    return in_register * 20 + pair.a + pair.b + unset + (more = 0);
}
"""
    stopping = Stopping(tmp_path, source).run()
    evaluator = stopping.evaluator()
    for text in ("in_register = 257 + 2", "pair.b = 4", "unset = 2", "more = 1", "pair.a += 2"):
        evaluator.evaluate(text)
    stopping.run_to_end()
    assert stopping.status == 4 * 20 + 3 + 4 + 2


def test_names_mean_the_innermost_variable(tmp_path: Path) -> None:
    stopping = Stopping(tmp_path, SOURCE).run("INNER")
    evaluator = stopping.evaluator()
    assert evaluator.evaluate("speed").value.text == "99"
    frames = {each.function: each for each in stopping.fleet.stopped(0).stack}
    assert evaluator.evaluate("outer", frames["main"]).value.text == "4"
    assert evaluator.evaluate("shadowed", frames["main"]).value.text == "1"
    stopping.run("STOP")
    assert evaluator.evaluate("speed").value.text == "4"


def test_side_effects_of_conditions_are_undone(evaluator: Evaluator, stopping: Stopping) -> None:
    before = stopping.state()
    assert evaluator.holds("bump(1) == 1")
    assert evaluator.holds("bump(1) == 1")
    assert not evaluator.holds("p->next->at.x - 1")
    assert evaluator.holds("0.5")
    with pytest.raises(DebugError, match="invalid argument type"):
        evaluator.holds("n")
    assert stopping.state() == before


def test_locations_of_objects(evaluator: Evaluator) -> None:
    place = evaluator.place("order[2]")
    known = evaluator.evaluate("&order[0]").value.number
    assert (place.address, place.size, place.frame) == (known + 8, 4, None)
    inner = evaluator.place("p->next->at")
    assert inner.size == 8
    assert inner.frame is not None
    assert inner.frame.function == "work"
    for text in ("1 + 2", '"abc"', "twice", "&total"):
        with pytest.raises(DebugError, match="is a value, not an object in memory"):
            evaluator.place(text)


def shown(evaluator: Evaluator) -> list[tuple[str, str, str]]:
    found = evaluator.variables()
    return [(each.name, each.value.text, each.scope + " hidden" * each.is_hidden) for each in found]


def test_variables_are_those_in_scope(tmp_path: Path) -> None:
    source = """\
static int calls = 3;
int work(int a, char *name)
{
    static int count = 4;
    int later, i = 0, sum;
    if (a > 5) sum = 1;
    for (int k = 0; k < 2; k++) { /* HEAD */
        double a = 0.5;
        i += 1; /* INNER */
        int behind = 2; int *p = &i; i += behind + *p;
    }
    later = i;
    sum = 2; count++; calls++; /* END */
    return later + sum;
}
int main(void) { return work(1, "x") + work(9, 0); }
"""
    stopping = Stopping(tmp_path, source).run("INNER")
    evaluator = stopping.evaluator()
    outer = [("count", "4", "static"), ("later", "uninitialised", "local")]
    assert shown(evaluator) == [
        ("a", "0.5", "local"), ("k", "0", "local"), *outer, ("i", "0", "local"),
        ("sum", "uninitialised", "local"),
        ("a", "1", "parameter hidden"), ("name", '"x"', "parameter"),
    ]  # fmt: skip
    assert [each.name for each in evaluator.globals_()] == ["calls"]
    stopping.run("END")
    assert shown(evaluator)[3:5] == [("sum", "uninitialised", "local"), ("a", "1", "parameter")]
    stopping.run("END").run("END")
    stopping.run("HEAD")
    assert shown(evaluator)[-3:] == [
        ("sum", "1", "local"), ("a", "9", "parameter"), ("name", "null", "parameter"),
    ]  # fmt: skip
    assert evaluator.evaluate("sum = 4").changed
    stopping.run("INNER")
    assert evaluator.evaluate("later").value.text == "uninitialised"
    assert evaluator.evaluate("sum").value.text == "4"
    assert evaluator.evaluate("behind").value.text == "uninitialised"
    with pytest.raises(DebugError, match="'later' is uninitialised"):
        evaluator.evaluate("later + 1")


def test_a_variable_declared_later_may_be_named(tmp_path: Path) -> None:
    source = """\
int x = 5;
int main(void)
{
    int a = x; /* STOP */
    int x = 2, y = 3;
    return x + y + a;
}
"""
    evaluator = Stopping(tmp_path, source).run().evaluator()
    assert evaluator.evaluate("x").value.text == "5"
    assert evaluator.evaluate("y").value.text == "uninitialised"
    assert evaluator.evaluate("y = 5").value.text == "5"
    assert evaluator.evaluate("(y = 6) + y").value.text == "12"
    assert [each.name for each in evaluator.variables()] == ["a"]


SPECIAL = """\
#include <stdlib.h>
struct pair { int a, b; };
struct pair pairs[3] = {{1, 2}, {3, 4}, {5, 6}};
static int count = 3;
static int depth(int left) { static int calls = 10; calls++; int own = left;
    return left ? depth(left - 1) : own + calls; /* DEEP */ }
static double sum(int n, int m, double table[n][m])
{
    double all[n], grid[n][2 * m];
    struct part { int values[m]; int last; struct part *self; } part;
    int *numbers = malloc(n * sizeof *numbers);
    for (int i = 0; i < n; i++) { all[i] = i; grid[i][0] = 10 * i; numbers[i] = i * i; }
    part.last = 8; part.self = &part; part.values[2] = 9;
    return all[1] + grid[1][0] + table[1][0] + numbers[1] + pairs[0].a; /* VLA */
}
extern int other(void);
int main(void)
{
    double table[2][3] = {{1, 2, 3}, {4, 5, 6}};
    return depth(2) + (int)sum(2, 3, table) + other() + count;
}
"""
OTHER = "static int count = 44; static int hidden; int other(void) { return count + hidden; }\n"


@pytest.fixture(scope="module")
def special(tmp_path_factory: pytest.TempPathFactory) -> Stopping:
    return Stopping(tmp_path_factory.mktemp("special"), SPECIAL, OTHER).run("VLA")


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("all", "{0.0, 1.0}"),
        ("all[1] + 0.5", "1.5"),
        ("sizeof all", "16"),
        ("part.last + part.values[2] + part.self->last", "25"),
        ("sizeof part", "20"),
        ("sizeof grid[0]", "48"),
        ("grid[1][0]", "10.0"),
        ("grid[1]", "{10.0, ?, ?, ?, ?, ?}"),
        ("table[1][2]", "6.0"),
        ("table[0]", "{1.0, 2.0, 3.0}"),
        ("*numbers@2", "{0, 1}"),
        ("numbers[0..1]", "{0, 1}"),
        ("pairs[1..2]", "{{a = 3, b = 4}, {a = 5, b = 6}}"),
        ("pairs[n - 1..n]", "{{a = 3, b = 4}, {a = 5, b = 6}}"),
        ("pairs[1]@2", "{{a = 3, b = 4}, {a = 5, b = 6}}"),
        ("count", "3"),
        ("test1.c::count", "44"),
        ("'test1.c'::count + count", "47"),
        ("depth::calls", "13"),
    ],
)
def test_slices_and_qualified_names(special: Stopping, text: str, wanted: str) -> None:
    before = special.state()
    found = special.evaluator().evaluate(text)
    assert found.value.text == wanted
    assert special.state() == before


def test_elements_of_slices_have_array_indices(special: Stopping) -> None:
    evaluator = special.evaluator()
    parts = list(evaluator.evaluate("pairs[1..2]").value.children())
    assert [(name, part.text) for name, part in parts] == [
        ("[1]", "{a = 3, b = 4}"), ("[2]", "{a = 5, b = 6}"),
    ]  # fmt: skip
    place = evaluator.place("pairs[1..2]")
    assert (place.address, place.size) == (parts[0][1].address, 16)
    assert [each.name for each in evaluator.variables()] == [
        "all", "grid", "part", "numbers", "n", "m", "table",
    ]  # fmt: skip
    assert {each.name: str(each.value.type) for each in evaluator.variables()}["grid"] == (
        "double[2][6]"
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("pairs[2..1]", "invalid slice length 0 (expected 1 to 100,000)"),
        ("pairs[1..3]", "is past the end of 'pairs'"),
        ("pairs@200000", "invalid slice length 200,000 (expected"),
        ("count[1..2]", "'count' is neither an array nor a pointer"),
        ("(count + 1)@2", "only objects in memory can form a slice"),
        ("numbers@2", "'numbers' is in a register: nothing is adjacent to it"),
        ("pairs[0.5..2]", "'0.5' is not an integer"),
        ("pairs[count++..3]", "'count++' would change the program"),
        ("nobody::x", "no function 'nobody'"),
        ("depth::nothing", "'depth' has no variable 'nothing'"),
        ("depth::own", "'depth' is not active: it has no variables"),
        ("test.c::nothing", "no variable 'nothing' in test.c"),
        ("depth::calls.x", "member reference type 'int' is not a structure or union"),
        ("$nothing + 1", "no convenience variable $nothing"),
    ],
)
def test_errors_of_extended_notation(special: Stopping, text: str, message: str) -> None:
    before = special.state()
    with pytest.raises(DebugError) as caught:
        special.evaluator().evaluate(text)
    assert message in str(caught.value)
    assert special.state() == before


def test_variables_of_callers(tmp_path: Path) -> None:
    stopping = Stopping(tmp_path, SPECIAL, OTHER).run("DEEP").run("DEEP").run("DEEP")
    evaluator = stopping.evaluator()
    frames = [each for each in stopping.fleet.stopped(0).stack if each.function.endswith("depth")]
    assert [evaluator.evaluate("own", each).value.text for each in frames] == ["0", "1", "2"]
    main = next(each for each in stopping.fleet.stopped(0).stack if each.function == "main")
    assert evaluator.evaluate("depth::own", main).value.text == "0"
    assert evaluator.evaluate("main::table[1][0]").value.text == "4.0"


def test_convenience_variables(special: Stopping) -> None:
    evaluator = special.evaluator()
    evaluator.evaluate("$p = pairs[1]")
    evaluator.evaluate("$n = $p.b * 2")
    assert evaluator.evaluate("$n + $p.a").value.text == "11"
    evaluator.evaluate("$n = 0.5")
    assert evaluator.evaluate("$n").value.text == "0.5"
    evaluator.evaluate("$q = &pairs[2]")
    assert evaluator.evaluate("$q->a").value.text == "5"


def test_an_edited_source_file_is_reported(tmp_path: Path) -> None:
    stopping = Stopping(tmp_path, OTHER + "int main(void) { return 0; /* STOP */ }\n").run()
    (tmp_path / "test.c").write_text("int count;\nint main(void) { return 1; }\n")
    with pytest.raises(DebugError, match="has changed since the program was built"):
        stopping.evaluator().evaluate("count")


def test_only_globals_are_in_scope_in_the_library(evaluator: Evaluator) -> None:
    frame = evaluator._stopped().stack[-1]
    assert frame.function == "__crs_start"
    assert evaluator.evaluate("total + order[1]", frame).value.text == "9"
    assert evaluator.variables(frame) == []
    with pytest.raises(DebugError, match="use of undeclared identifier 'i'"):
        evaluator.evaluate("i", frame)


def test_a_failed_program_can_be_inspected(tmp_path: Path) -> None:
    source = """\
int order[4];
static int sum(int n)
{
    int k = n * 2, unset;
    for (int i = 0; i < 3; i++) { k += i + 1; order[k - 3] = 1; unset = k; }
    return unset;
}
int main(void) { int m = 3; return sum(m); }
"""
    stopping = Stopping(tmp_path, source)
    with pytest.raises(AssertionError, match="out of bounds"):
        stopping.run()
    stopped = stopping.fleet.failure(0).stopped
    assert stopped is not None
    evaluator = Evaluator(lambda: stopped, SourceNames(stopping.program))
    assert [each[:2] for each in shown(evaluator)] == [
        ("i", "0"), ("k", "7"), ("unset", "uninitialised"), ("n", "3"),
    ]  # fmt: skip
    assert evaluator.evaluate("order[k - 4] + main::m").value.text


def test_a_stack_overflow_can_be_inspected(tmp_path: Path) -> None:
    source = """\
struct big { int numbers[40]; };
static int down(int n, struct big big) { int next = n + 1; big.numbers[3] = n;
    return down(next, big) + big.numbers[3] + next; }
int main(void) { struct big big = {{0}}; return down(0, big); }
"""
    stopping = Stopping(tmp_path, source)
    with pytest.raises(AssertionError, match="stack overflow"):
        stopping.run()
    stopped = stopping.fleet.failure(0).stopped
    assert stopped is not None
    evaluator = Evaluator(lambda: stopped, SourceNames(stopping.program))
    depth = len(stopped.stack) - 3
    frames = [evaluator.evaluate("n", each).value.number for each in stopped.stack[:2]]
    assert frames == [depth, depth - 1]
    assert evaluator.evaluate("big.numbers[3]", stopped.stack[1]).value.number == depth - 1
    assert "next" in {each.name for each in evaluator.variables(stopped.stack[1])}
    for each in evaluator.variables():
        assert each.value.full


def test_functions_in_headers_use_the_scope_of_their_file(tmp_path: Path) -> None:
    (tmp_path / "shared.h").write_text(
        "static int scaled(int by) { return by * factor; /* STOP */ }\n"
        "int once(int by) { return by + factor; /* ONCE */ }\n"
    )
    first = "int once(int by);\nint other(void);\nint main(void) { return other() + once(1); }\n"
    second = 'static int factor = 3;\n#include "shared.h"\nint other(void) { return scaled(2); }\n'
    stopping = Stopping(tmp_path, first, second)
    header = str(tmp_path / "shared.h")
    stopping.lines[header] = Path(header).read_text().splitlines()
    assert stopping.run().evaluator().evaluate("by * factor").value.text == "6"
    assert stopping.run("ONCE").evaluator().evaluate("by * factor").value.text == "3"
