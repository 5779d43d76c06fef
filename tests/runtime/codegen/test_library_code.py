"""Library functions that were generated for another program are as if generated for this one."""

from __future__ import annotations

import contextlib
import gc
import pickle
from pathlib import Path
from typing import Any

import pytest

from crs_cc.core.gc_pause import gc_paused
from crs_cc.core.source import Diagnostics
from crs_cc.ir.program import Program
from crs_cc.runtime.codegen import library_code
from crs_cc.runtime.codegen.flow_graph import Landing, Node
from crs_cc.runtime.codegen.function_code import generate
from crs_cc.runtime.codegen.module import compile_program
from crs_cc.runtime.compiled import Compiled
from crs_cc.session.build import build_executable

PROGRAMS = {
    "prints": '#include <stdio.h>\nint main(void) { printf("%g\\n", 0.5); return 0; }\n',
    "sorts": (
        "#include <stdio.h>\n#include <stdlib.h>\n"
        "static int less(const void *a, const void *b) { return *(int *)a - *(int *)b; }\n"
        "int main(void) { int a[] = {2, 1}; qsort(a, 2, sizeof *a, less);"
        ' printf("%d\\n", a[0]); return 0; }\n'
    ),
    "calls with a struct": (
        "#include <stdio.h>\n#include <stdlib.h>\nstruct S { int a[5]; };\n"
        "static int other(struct S s, double d) { return s.a[0] + (int)d; }\n"
        "static void at_end(void) { puts(\"end\"); }\n"
        "int (*chosen)(struct S, double) = other;\n"
        "int main(void) { struct S s = {{1}}; atexit(at_end); return chosen(s, 2.0); }\n"
    ),
    "returns nothing": (
        "#include <stdlib.h>\n"
        "static int order(const void *a, const void *b) { if (a == b) return 0; }\n"
        "int main(void) { int a[3] = {3, 2, 1}; qsort(a, 3, sizeof *a, order); return *a; }\n"
    ),
    "has its own small strlen": (
        "#include <stdio.h>\nunsigned strlen(const char *s) { return *s != 0; }\n"
        'int main(void) { char text[9]; sprintf(text, "%s", "ab"); puts(text); return 0; }\n'
    ),
    "has its own strlen": (
        "#include <stdio.h>\nunsigned strlen(const char *s, double more) { return more != 0; }\n"
        'int main(void) { char text[9]; sprintf(text, "%s", "ab"); puts(text); return 0; }\n'
    ),
}  # fmt: skip

BUILDS: list[dict[str, bool]] = [
    {"checked": True},
    {"checked": False},
    {"checked": True, "debug": True},
    {"checked": True, "trap_overflow": True},
    {"checked": True, "debug": True, "watching": True},
]


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> list[Program]:
    folder = tmp_path_factory.mktemp("programs")
    return [linked(folder / f"{name}.c", text) for name, text in PROGRAMS.items()]


def linked(path: Path, text: str) -> Program:
    path.write_text(text)
    return build_executable([path], Diagnostics()).program


def shown(compiled: Compiled) -> tuple[Any, ...]:
    """Return all that a compilation gives, to be compared."""
    infos = [
        (
            info.function,
            info.frame.size,
            list(info.frame.offsets.values()),
            info.landings,
            info.unset,
        )
        for info in compiled.functions
    ]
    return (
        compiled.module.to_binary(), compiled.module.data,
        compiled.sites, compiled.call_sites, compiled.call_landings, compiled.statements,
        infos, compiled.addresses,
    )  # fmt: skip


@pytest.mark.parametrize("build", BUILDS, ids=" ".join)
def test_linked_code_is_the_code_that_the_program_alone_would_have(
    programs: list[Program], build: dict[str, bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(library_code, "_TEMPLATES", {})
    for program in programs:
        compile_program(program, **build)
    shared = [shown(compile_program(program, **build)) for program in programs]
    assert any(library_code._TEMPLATES.values())
    monkeypatch.setattr("crs_cc.runtime.codegen.module.generate_shared", generate)
    for program, found in zip(programs, shared, strict=True):
        assert found == shown(compile_program(program, **build))


def test_code_in_which_a_number_was_lost_is_not_generated() -> None:
    number = library_code._Unknown(("address", "x"), 4)
    assert (8 + number + 8).symbol == ("address", "x")  # type: ignore[attr-defined]
    assert int(8 + number + 8) == 20
    for wrong in (lambda: number * 2, lambda: number | 1, lambda: 8 - number, lambda: bool(number)):
        with pytest.raises(TypeError, match="known only when it is linked"):
            wrong()


def test_pickled_code_is_that_of_the_program_alone(programs: list[Program]) -> None:
    for _ in range(3):
        module = compile_program(programs[0]).module
    assert b"Template" not in pickle.dumps(module)
    assert pickle.loads(pickle.dumps(module)).to_text() == module.to_text()


def test_programs_that_differ_in_turn_share_what_was_generated_for_each(
    programs: list[Program], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(library_code, "_TEMPLATES", {})
    for program in [*programs, *programs]:
        compile_program(program)
    made: list[str] = []
    monkeypatch.setattr(library_code, "_template", lambda function, *_: made.append(function.name))
    with contextlib.suppress(AttributeError):  # as no template is made
        for program in programs:
            compile_program(program)
    assert made == []


def test_code_that_is_generated_leaves_no_work_to_the_garbage_collector(tmp_path: Path) -> None:
    program = linked(tmp_path / "loop.c", "int main(void) { int n = 0; while (n < 9) n++; }\n")
    with gc_paused():
        gc.freeze()  # `get_objects` returns new objects only
        compile_program(program)
        assert not any(isinstance(each, Node | Landing) for each in gc.get_objects())
