"""From the parser's coordinates back to the user's file, line and column.

Each name is spelled once in the user's text, so that its expected location can be found in the
source itself.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from pycparser import c_ast
from pycparser.c_parser import CParser

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.preprocessor import Preprocessed, preprocess
from tests.frontend.preprocess.preprocessing import run, without_attributes

SOURCE = """\
#define ZERO 0
#define EMPTY
#define LONG_MACRO(x) ((x) + 1000000 + (x))
#define DECLARE(name) int name; int from_body
\tint\tafter_tabs = 1;
int /* comment */ after_comment /* another
   */ = 2; int after_long_comment;
int a1 = ZERO, after_macro = LONG_MACRO(5), after_call;
int EMPTY after_empty;
int con\\
tinued, after_splice \\
   , on_continued_line;
int a3 = LONG_MACRO(
   6), after_lines_of_call;
DECLARE(argument), after_declare;
int __attribute__((unused)) after_attribute __attribute__((
  unused)), after_two_attributes;
__extension__ int after_extension; char *s = "\\%" "\t", after_string;
#if 0
int nothing;
#endif

int g(void) {\tint in_function = ZERO; return\tin_function + last_use; }
"""


class _Names(c_ast.NodeVisitor):
    """Collect where each declared or used name is."""

    def __init__(self, program: Preprocessed) -> None:
        self.program = program
        self.places: dict[str, Location] = {}

    def _add(self, name: str, coord: object) -> None:
        line, column = coord.line, coord.column  # type: ignore[attr-defined]
        self.places.setdefault(name, self.program.location(line, column))

    def visit_TypeDecl(self, node: c_ast.TypeDecl) -> None:  # noqa: N802 - pycparser's name
        if node.declname is not None:  # the type in `sizeof (int)` has none
            self._add(node.declname, node.coord)

    def visit_ID(self, node: c_ast.ID) -> None:  # noqa: N802 - pycparser's name
        self._add(node.name, node.coord)


def names(program: Preprocessed) -> dict[str, Location]:
    """Parse a program and return the first location of each name."""
    visitor = _Names(program)
    visitor.visit(CParser().parse(without_attributes(program.text)))
    return visitor.places


def written(source: str, name: str, file: str = "a.c") -> Location:
    """Return the position of a name in a source."""
    before = source[: source.index(name)]
    return Location(file, before.count("\n") + 1, len(before) - before.rfind("\n"))


def test_the_parser_counts_a_tab_as_one_column() -> None:
    assert CParser().parse("\t\tint\tx;").ext[0].type.coord.column == 7


@pytest.mark.parametrize(
    "name",
    [
        "after_tabs",
        "after_comment",
        "after_long_comment",
        "after_macro",
        "after_call",
        "after_empty",
        "after_splice",
        "on_continued_line",
        "after_lines_of_call",
        "argument",
        "after_declare",
        "after_attribute",
        "after_two_attributes",
        "after_extension",
        "after_string",
        "in_function",
        "last_use",
    ],
)
def test_names_have_their_source_locations(name: str) -> None:
    program, _ = run(SOURCE)
    assert names(program)[name] == written(SOURCE, name)


def test_continued_name_has_the_location_of_its_first_part() -> None:
    program, _ = run(SOURCE)
    assert names(program)["continued"] == written(SOURCE, "con\\")


def test_expansion_has_the_location_of_the_macro_call() -> None:
    program, _ = run(SOURCE)
    assert names(program)["from_body"] == written(SOURCE, "DECLARE(argument")


def test_nested_expansion_has_the_location_of_the_outermost_call() -> None:
    source = "#define A(x) B(x)\n#define B(x) C + x\n#define C c1 + c2\nint i = 1 +\n  A(user);\n"
    places = names(run(source)[0])
    assert places["c1"] == places["c2"] == Location("a.c", 5, 3)
    assert places["user"] == Location("a.c", 5, 5)


def test_headers_have_their_own_locations(tmp_path: Path) -> None:
    (tmp_path / "inc").mkdir()
    header = "\n\tint first;\n#include <deep.h>\nint\tlast;"
    (tmp_path / "inc" / "h.h").write_text(header)
    (tmp_path / "deep.h").write_text("/* */ int deep; \\\n int deeper;")
    main = tmp_path / "main.c"
    source = '#include "inc/h.h"\nint after; M'
    main.write_text(source)
    diagnostics = Diagnostics()
    options = Options(include_paths=(tmp_path,), defines=("M=int by_option;",))
    places = names(preprocess(main, options, diagnostics))
    assert diagnostics.messages == []
    in_header = str(tmp_path / "inc" / "h.h")
    assert places["first"] == Location(in_header, 2, 6)
    assert places["last"] == Location(in_header, 4, 5)
    assert places["deep"] == Location(str(tmp_path / "deep.h"), 1, 11)
    assert places["deeper"] == Location(str(tmp_path / "deep.h"), 2, 6)
    assert places["after"] == Location(str(main), 2, 5)
    assert places["by_option"] == Location(str(main), 2, 12)
    for file in (main, tmp_path / "inc" / "h.h", tmp_path / "deep.h"):
        assert diagnostics.lines[str(file)] == file.read_text().split("\n")


def test_line_directives_do_not_change_locations() -> None:
    program, _ = run('#line 100 "gram.y"\nint x;\n')
    assert program.location(1, 5) == Location("a.c", 2, 5)


def test_positions_outside_the_text_are_clamped() -> None:
    program, _ = run("#define A 1\nint x;\nint y = A;\n")
    assert program.location(0, 0) == Location("a.c", 2, 1)
    assert program.location(1, 500) == Location("a.c", 2, 7)
    assert program.location(99, 1) == Location("a.c", 3, 10)
    assert run("")[0].location(1, 1).file == "a.c"


def test_messages_show_the_line_and_a_caret() -> None:
    _, diagnostics = run("int a;\n\tint b = 08;\n")
    assert diagnostics.messages[0].render().split("\n")[1:] == [
        "     int b = 08;",
        "             ^",
    ]
