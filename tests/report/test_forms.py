"""Programs in the report's form, and the detection of their dialect."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.dialect import dialect_of
from crs_cc.frontend.preprocess.options import Dialect
from crs_cc.session.build import build_executable
from crs_cc.session.library import library_options
from tests.nclient.drive import drive

OPTIONS = library_options()

VENDORS = '#include "Nclient.h"\nint main(void) { return connect_robot(1) == 0; }\n'
UNDECLARED = "main() { connect_robot(1); vm(10, 10, 0); return 0; }\n"
REPORTS = "void runcode() { connect_robot(1, 7019, 0); vm(10); }\n"
PART = "int helper(int n) { return vm(n); }\n"


def errors_in(source: str, tmp_path: Path, dialect: Dialect | None = "report") -> list[str]:
    """Return `line:column: text` of the errors, and their hints."""
    path = tmp_path / "body.c"
    path.write_text(source)
    with pytest.raises(CompileError) as caught:
        build_executable([path], Diagnostics(), dialect=dialect)
    return [
        f"{each.location.line}:{each.location.column}: {each.text}"
        + (f" ({each.hint.replace(str(path), 'body.c')})" if each.hint else "")
        for each in caught.value.diagnostics
        if each.severity == "error"
    ]


# -- which dialect -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("sources", "expected"),
    [
        ([VENDORS], "nomad"),
        ([UNDECLARED], "nomad"),
        ([REPORTS], "report"),
        ([PART], "nomad"),
        ([PART, REPORTS], "report"),
        ([REPORTS, PART], "report"),
        ([PART, VENDORS], "nomad"),
        (['#include "Nclient.h"\n' + REPORTS], "nomad"),
        (["#include <Nclient.h>\n" + PART, REPORTS], "nomad"),
        ([REPORTS + "int main(void) { runcode(); return 0; }\n"], "nomad"),
        (["#ifdef NEVER\nint main(void) { return 0; }\n#endif\n" + REPORTS], "report"),
        (["int main(void); " + REPORTS], "report"),
        (["void runcode(); int main() { runcode(); return 0; }"], "nomad"),
        (["runcode(n) int n; { return n; }"], "report"),
        (["/* runcode() */ int x;"], "nomad"),
        (["int runcode() { int x = 3; struct { int a; } b = {1}; return b.a + x; }"], "report"),
    ],
)
def test_header_main_and_runcode_determine_the_dialect(
    sources: list[str], expected: str, tmp_path: Path
):
    paths = [tmp_path / f"part{number}.c" for number in range(len(sources))]
    for path, source in zip(paths, sources, strict=True):
        path.write_text(source)
    assert dialect_of(paths, OPTIONS) == expected


def test_a_copy_of_the_vendors_header_determines_it_too(tmp_path: Path):
    (tmp_path / "Nclient.h").write_text("extern long State[45];\nint vm(int t, int s, int r);\n")
    (tmp_path / "robot.h").write_text('#include "Nclient.h"\n')
    path = tmp_path / "program.c"
    path.write_text('#include "robot.h"\nvoid runcode() { vm(1, 2, 3); }\n')
    assert dialect_of([path], OPTIONS) == "nomad"


def test_files_that_are_not_c_are_left_to_others(tmp_path: Path):
    assert dialect_of([tmp_path / "missing.c", tmp_path], OPTIONS) == "nomad"


# -- runcode -----------------------------------------------------------------------------------


def test_runcode_stands_for_main():
    done = drive('void runcode() { vm(100); printf("%ld\\n", State[STATE_SONAR_0]); }')
    assert (done.output[0], done.status) == ("-1\n", 0)


def test_what_runcode_returns_is_the_exit_status():
    assert drive("int runcode(void) { if (st()) return 3; return 4; }").status == 3


@pytest.mark.parametrize("head", ["int runcode()", "runcode()", "void runcode(void)"])
def test_runcode_may_end_without_a_value(head: str):
    done = drive(f"{head} {{ if (st()) ; }}")
    assert done.status == 0
    assert done.session.result().robots[0].error is None


def test_parts_of_a_program_share_its_dialect(tmp_path: Path):
    (tmp_path / "a.c").write_text("int far(void);\nint runcode() { return far() == -1; }\n")
    (tmp_path / "b.c").write_text("int far(void) { sonarSensorCheck(); return State[17]; }\n")
    messages = Diagnostics()
    build_executable([tmp_path / "a.c", tmp_path / "b.c"], messages)
    assert not messages.messages


def test_with_the_vendors_header_runcode_follows_the_vendors_rules():
    source = '#include "Nclient.h"\nint runcode() { connect_robot(1); get_sn(); return State[17]; }'
    assert drive(source).status == 255


def test_the_requested_dialect_takes_precedence(tmp_path: Path):
    source = '#include "Nclient.h"\nint main(void) { sonarSensorCheck(); return State[17] == -1; }'
    assert drive(source, dialect="report").status == 1
    errors = errors_in("int runcode() { return STATE_HEAT; }", tmp_path, dialect="nomad")
    assert "'STATE_HEAT'" in errors[0]


def test_a_program_without_an_entry_point_is_reported(tmp_path: Path):
    for dialect in (None, "nomad", "report"):
        assert "no function 'main'" in errors_in(PART, tmp_path, dialect)[0]


# -- a body without a function -----------------------------------------------------------------


def body(source: str, *, status: int | None = 0) -> str:
    """Return what a body prints."""
    done = drive(source, dialect="report")
    assert done.session.result().robots[0].error is None
    assert done.status == status
    return done.output[0]


def test_a_body_needs_no_function_and_no_header():
    assert (
        body('String who = "scout"; boolean up = true; if (up) printf("%s\\n", who);') == "scout\n"
    )


def test_a_body_returns_the_exit_status():
    assert body('if (!vm(0)) return(1);\nprintf("on\\n"); return(7);', status=7) == "on\n"


def test_functions_before_and_after_a_body_are_outside_it():
    source = """
        #include <math.h>
        struct point { double x, y; };
        typedef struct { int n; } box;
        int count;
        double length(struct point p) { count++; return sqrt(p.x * p.x + p.y * p.y); }
        old(a, b) int a; char *b; { return a + b[0]; }
        static const int table[] = { 1, 2, 3 };
        int late(int x);
        struct point p = { 3, 4 };
        box *b = &(box){ 5 };
        int start = table[late(1)], i;
        for (i = 0; i < 2; i++) { length(p); }
        do { start++; } while (start < 10);
        printf("%g %d %d %d %d\\n", length(p), count, old(1, "a"), start, b->n);
        int late(int x) { return x + count; }
    """
    assert body(source) == "5 2 98 10 5\n"


@pytest.mark.parametrize(
    "statement",
    [
        "vm(0);", "x = 3;", "x++;", "++x;", "*&x = 3;", "(void)x;", ";;{ int y = 1; x = y; }",
        "again: if (x++ < 3) goto again;", "switch (x) { case 0: x = 2; break; default: ; }",
        "while (x < 3) x++;", "if (x) x = 1; else { x = 2; }", "FILE *f = stdout; fflush(f);",
        "String s = 0; s++;", "\"x\"[0];", "for (;;) { break; }", "return 0;",
    ],
)  # fmt: skip
def test_a_body_may_begin_with_any_statement(statement: str):
    assert body(f"int x = 0;\n{statement}\n") == ""
    if "x" not in statement.replace('"x"', ""):
        assert body(f"{statement}\n") == ""


def test_a_body_may_be_empty_but_for_a_comment(tmp_path: Path):
    assert "no function 'main'" in errors_in("/* nothing yet */\n", tmp_path)[0]


def test_errors_in_a_body_are_reported_at_their_location(tmp_path: Path):
    source = "int speed = 10;\n\nwhile (1) {\n    pr(sped, 0, 0);\n}\n  st(1);\n"
    assert errors_in(source, tmp_path)[0] == (
        "4:8: use of undeclared identifier 'sped' (did you mean 'speed'?)"
    )
    assert errors_in(source, tmp_path)[1].startswith("6:3: too many arguments")


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("st()\nst();\n", "1:5: expected ';' after ')'"),
        ("st();\n}\nst();\n", "2:1: extraneous closing brace ('}') (there is no matching '{'"),
        ("if (st()) {\n    st();\n",
         "2:9: unexpected end of file (to close the '{' at body.c:1:11)"),
        ("if (State[STATE_BUMPER] == 1 {\n    st();\n}\n",
         "1:30: expected ')' before '{' (to close the '(' at body.c:1:4)"),
        ("while (State[STATE BUMPER] != 1) { st(); }", "1:20: expected ']' before 'BUMPER'"),
    ],
)  # fmt: skip
def test_syntax_errors_in_a_body_are_located(source: str, expected: str, tmp_path: Path):
    assert any(each.startswith(expected) for each in errors_in(source, tmp_path)), errors_in(
        source, tmp_path
    )


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        ("vm()", "1:1: too few arguments to function call, expected 1, have 0"),
        ("vm(1, 2)", "1:1: too few arguments to function call, expected 3, have 2"),
        ("vm(1, 2, 3, 4)", "1:1: too many arguments to function call, expected 3, have 4"),
        ("vm(1, 2, speed)", "1:10: use of undeclared identifier 'speed'"),
    ],
)
def test_vm_takes_one_argument_or_three(call: str, expected: str, tmp_path: Path):
    assert errors_in(f"{call};\n", tmp_path)[0].startswith(expected)


def test_names_in_messages_are_the_users(tmp_path: Path):
    messages = errors_in("pr(1);\nvm();\nState = 0;\nheatSensorCheck = 1;\n", tmp_path)
    assert messages
    assert not any("__report" in message for message in messages), messages
