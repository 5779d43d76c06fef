"""What is remembered of our headers changes no program, whatever was compiled before it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.parse import header_memory
from crs_cc.frontend.preprocess import directives, macros
from crs_cc.frontend.preprocess.macros import Macro
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.source_text import forget_headers
from crs_cc.frontend.preprocess.tokens import Token
from crs_cc.frontend.unit import compile_file, compile_text
from crs_cc.ir.text import to_text
from crs_cc.ir.verify import verify
from crs_cc.session.library import library_options

OPTIONS = library_options()
MAIN = 'int main(void) { printf("%d", (int)strlen(strdup("abc"))); return 0; }'
PROGRAMS = {
    "plain": f"#include <stdio.h>\n#include <string.h>\n{MAIN}",
    "other order": f"#include <string.h>\n#include <stdio.h>\n{MAIN}",
    "further down": f"int before;\n\n#include <stdio.h>\n#include <string.h>\n{MAIN}",
    "a macro for a keyword": "#define const\n#include <string.h>\nchar *f(void) {"
    ' char *s = strchr("a", 0); int i = strlen(1); return s; }',
    "a macro for a parameter": "#define s other\n#include <string.h>\nint x = sizeof strlen(0);",
    "a macro for a function": "#define strlen length\n#include <string.h>\nint n = length(0);",
    "a macro for a type": "#define size_t short\n#include <string.h>\nint x = sizeof strlen(0);",
    "a type of the same name": "typedef short s;\n#include <string.h>\ns x = sizeof(s);",
    "a variable of the same name": "int n;\n#include <string.h>\nint x = sizeof n;",
    "a function as a type": "typedef int strlen;\n#include <string.h>\nint x = strlen(0);",
    "packed": "#pragma pack(1)\n#include <time.h>\n#include <stdlib.h>\n#include <search.h>\n"
    "struct p { char c; double d; }; int x = sizeof(struct p); int y = sizeof(struct tm);",
    "an attribute before": "__attribute__((noreturn))\n#include <string.h>\nint f(void) { }",
    "half a declaration before": "static\n#include <string.h>\nint x;",
    "half a declaration": "int\n#include <string.h>\nint x;",
    "inside a function": "int f(void) {\n#include <string.h>\nreturn strlen(0); }",
    "inside a struct": "struct a {\n#include <string.h>\n};",
    "after an error": "int x = ;\n#include <string.h>\nint y = sizeof strlen(0);",
    "after a warning": "x;\n#include <string.h>\nint y = sizeof strlen(0);",
    "an implicit int": "#define int\n#include <ctype.h>\nmain() { return isalpha(3); }",
    "without that warning": "#include <ctype.h>\nmain() { return isalpha(3); }",
    "that warning before": "x;\n#define int\n#include <ctype.h>\nmain() { return isalpha(3); }",
    "an open bracket before": "int x = (\n#include <string.h>\n3);",
    "an open attribute in it": "#define const __attribute__((\n#include <string.h>\n)) int x;",
    "a conflict": "#include <stdio.h>\nint printf(double);\nstruct FILE *f; FILE *g = f;",
    "statements alone": '#include <stdio.h>\nprintf("a");\nint x = 3;\nprintf("%d", x);',
    "names": "#include <stdio.h>\n#include <string.h>\nint f(void) { return strlne(stdinn); }",
    "a macro before": "#define EOF 3\n#include <stdio.h>\nint x = EOF;",
    "a macro after": "#include <stdio.h>\n#define EOF 3\nint x = EOF;",
    "no macro after": "#include <stdio.h>\n#undef EOF\nint x = EOF;",
    "another size_t": "typedef short size_t;\n#include <string.h>\nint x = sizeof strlen(0);",
    "another size_t in its place": "#define _STRINGS_H\ntypedef unsigned char size_t;\n"
    "#include <string.h>\nunsigned f(char *t, int n) { return strnlen(t, n); }",
    "a size_t by that name": "#define size_t mine\n#include <string.h>\nmine x = sizeof strlen(0);",
    "a struct of the same name": "struct tm { char c; };\n#include <time.h>\nstruct tm x;",
    "a struct": "#include <time.h>\nint f(struct tm *t) { return mktime(t) + t->tm_sec; }",
    "an enum constant": "enum { strlen, RAND_MAX };\n#include <string.h>\nint x = strlen;",
    "another function": "#include <string.h>\nstatic int strlen(int n) { return n; }\n"
    "int f(void) { return strlen(2); }",
    "noreturn": "#include <stdlib.h>\nint f(int x) { if (x) exit(1); else abort(); }",
    "format": '#include <stdio.h>\nint f(long x) { return printf("%d%s", x); }',
    "twice": "#include <assert.h>\n#include <assert.h>\n#include <complex.h>\nint f(void) {"
    " assert(creal(1) > 0); return 0; }",
}
VARIANTS = {
    "gnu17": OPTIONS,
    "c89": replace(OPTIONS, standard="c89"),
    "gnu23": replace(OPTIONS, standard="gnu23"),
    "defines": replace(OPTIONS, defines=("restrict=", "size_t=int"), undefines=("NULL",)),
    "report": replace(OPTIONS, dialect="report"),
}


@pytest.fixture(autouse=True)
def empty() -> Iterator[None]:
    """Forget what other tests have compiled, and what this one has."""
    forget_headers()
    yield
    forget_headers()


def outcome(source: str | Path, options: Options = OPTIONS) -> tuple[str, ...]:
    """Return the messages about a program, and its IR if there is no error."""
    found, program = Diagnostics(), ""
    with suppress(CompileError):
        unit = (
            compile_file(source, options, found)
            if isinstance(source, Path)
            else compile_text(source, "a.c", options, found)
        )
        verify(unit)
        program = to_text(unit) + repr((unit.undefined, unit.declared, unit.aliases))
    return *(each.render() for each in found.messages), program


def alone(source: str | Path, options: Options = OPTIONS) -> tuple[str, ...]:
    forget_headers()
    return outcome(source, options)


@pytest.mark.parametrize("variant", ["gnu17", "c89"])
def test_a_program_is_the_same_whatever_was_compiled_before(variant: str) -> None:
    options = VARIANTS[variant]
    expected = {name: alone(source, options) for name, source in PROGRAMS.items()}
    forget_headers()
    for order in (list(PROGRAMS), list(reversed(PROGRAMS))):
        for name in order:
            assert outcome(PROGRAMS[name], options) == expected[name], name


def test_a_program_is_the_same_after_the_same_with_other_options() -> None:
    source = PROGRAMS["plain"] + " int y = sizeof(NULL);"
    expected = {name: alone(source, options) for name, options in VARIANTS.items()}
    forget_headers()
    for name in [*VARIANTS, *reversed(VARIANTS)]:
        assert outcome(source, VARIANTS[name]) == expected[name], name


def test_programs_with_all_headers_are_the_same_in_either_order() -> None:
    paths = sorted(Path("tests/c/valid/library").glob("*.c"))[::15]
    paths += sorted(Path("samples/scout_c").glob("*.c"))[::10]
    expected = {path: alone(path) for path in paths}
    forget_headers()
    for path in [*paths, *reversed(paths)]:
        assert outcome(path) == expected[path], path


def test_a_header_is_parsed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    outcome(PROGRAMS["plain"])
    read: list[str] = []
    monkeypatch.setattr(header_memory, "lex", lambda text, *_: read.append(text) or [])
    outcome(PROGRAMS["further down"])
    assert [text for text in read if "printf(const" in text] == []
    assert len(read) == 2  # the lines before and after the headers


def test_a_definition_is_read_once(monkeypatch: pytest.MonkeyPatch) -> None:
    expected = outcome(PROGRAMS["a macro after"])
    read: list[str] = []

    def read_definition(tokens: list[Token], report: Report) -> Macro | None:
        read.append(tokens[0].text)
        return macros.read_definition(tokens, report)

    monkeypatch.setattr(directives, "read_definition", read_definition)
    assert outcome(PROGRAMS["a macro after"]) == expected
    assert read == ["EOF"]  # that of the program itself


def test_a_file_of_the_user_with_the_name_of_a_header_is_read(tmp_path: Path) -> None:
    main = tmp_path / "a.c"
    main.write_text('#include "string.h"\nint x = sizeof strlen(0);\n')
    before = outcome(main)
    (tmp_path / "string.h").write_text("char strlen(int);\n")
    assert before != outcome(main) == alone(main)


def test_what_is_remembered_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(header_memory, "MAX_PIECES", 4)
    monkeypatch.setattr(header_memory, "MAX_TREES", 3)
    for number in range(5):
        names = ["strlen", "strcpy", "strcat", "strchr"][:number]
        outcome("".join(f"int {name};\n" for name in names) + "#include <string.h>\n")
    assert header_memory.remembered()[1] == 3
    for number in range(5):
        outcome(f"#define size_t s{number}\n#include <string.h>\n")
    assert header_memory.remembered()[0] == 4
