"""C files are linked like object files, and the library like an archive."""

from __future__ import annotations

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostic, Diagnostics
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.program import Program
from crs_cc.requests import FAILED
from crs_cc.runtime.executable import make_executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.link import link
from crs_cc.session.library import library, library_options


def linked(*sources: str, diagnostics: Diagnostics | None = None) -> Program:
    diagnostics = diagnostics or Diagnostics()
    options = library_options()
    units = [
        compile_text(source, f"{name}.c", options, diagnostics)
        for name, source in zip("abc", sources, strict=False)
    ]
    return link(units, library(), diagnostics)


def refusal(*sources: str) -> Diagnostic:
    with pytest.raises(CompileError) as caught:
        linked(*sources)
    (message,) = caught.value.diagnostics
    return message


def test_a_function_is_found_in_another_file() -> None:
    whole = linked("int f(void);\nint main(void) { return f(); }", "int f(void) { return 3; }")
    assert whole.functions["f"].location.file == "b.c"


def test_only_what_is_needed_is_linked() -> None:
    whole = linked("static int idle(void) { return 1; }\nint main(void) { return 0; }")
    assert not [name for name in whole.functions if "idle" in name or name == "printf"]


def test_tentative_definitions_become_one_object() -> None:
    whole = linked("int n; int main(void) { return n; }", "int n = 5; int *p = &n;")
    assert whole.data["n"].content == b"\5\0\0\0"


def test_the_larger_of_two_tentative_arrays_wins() -> None:
    whole = linked("int n[2]; int main(void) { return n[0]; }", "int n[7];")
    assert whole.data["n"].size == 28


def test_a_program_may_define_an_object_of_the_library_tentatively() -> None:
    source = '#include "Nclient.h"\nlong State[NUM_STATE];\nint main(void) { return State[0]; }'
    assert linked(source).data["State"].size == 180


def test_the_users_definition_replaces_the_librarys() -> None:
    whole = linked("int abs(int x) { return x; }\nint main(void) { return abs(-1); }")
    assert whole.functions["abs"].location.file == "a.c"


def test_redefining_the_vendors_client_is_warned_about() -> None:
    client = "int connect_robot(long id, ...)\n{ return id == 1; }"
    diagnostics = Diagnostics()
    linked('#include "Nclient.h"\nint main(void) { return connect_robot(1); }', client,
           diagnostics=diagnostics)  # fmt: skip
    (message,) = diagnostics.messages
    assert (message.severity, str(message.location)) == ("warning", "b.c:1:5")
    assert "cannot reach its simulated robot" in message.text
    assert "Ndirect.c" in message.hint


def test_two_definitions_of_a_function_are_an_error() -> None:
    message = refusal("int main(void) { return 0; }", "\nint main(void) { return 1; }")
    assert message.text == "multiple definition of 'main'"
    assert message.location.line == 2
    assert "a.c:1" in message.hint


def test_two_initialised_objects_are_an_error() -> None:
    assert refusal("int n = 1; int main(void) { return n; }", "int n = 1;").text == (
        "multiple definition of 'n'"
    )


def test_an_undefined_function_is_reported_with_a_suggestion() -> None:
    message = refusal('int prinft(const char *, ...);\nint main(void) {\n  prinft("");\n}')
    assert message.text == "'prinft' is used, but not defined"
    assert message.location.line == 3
    assert message.hint == "did you mean 'printf'?"


def test_a_name_is_optional_only_if_each_file_that_uses_it_declares_it_weak() -> None:
    weak = "__attribute__((weak)) int f(void);\nint main(void) { return f ? f() : 0; }"
    assert "f" not in linked(weak, "int g(void) { return 0; }").functions
    assert linked(weak, "int f(void) { return 3; }").functions["f"].location.file == "b.c"
    message = refusal(weak, "int f(void);\nint g(void) { return f(); }")
    assert message.text == "'f' is used, but not defined"


def test_a_program_without_main_is_an_error() -> None:
    assert refusal("int f(void) { return 0; }").text == "the program has no function 'main'"


@pytest.mark.parametrize("name", ["mian", "Main", "mainn"])
def test_a_misspelt_main_is_suggested(name: str) -> None:
    message = refusal(f"int f(void) {{ return 0; }}\nint {name}(void) {{ return 0; }}")
    assert message.text == "the program has no function 'main'"
    assert message.location.line == 2
    assert message.hint == f"should '{name}' be 'main'?"


def test_statics_of_one_name_in_two_files_are_two() -> None:
    whole = linked(
        "static int n = 1; int g(void); int main(void) { return n + g(); }",
        "static int n = 2; int g(void) { return n; }",
    )
    assert sorted(name for name in whole.data if name.endswith(":n")) == ["a.c:n", "b.c:n"]


def test_an_object_declared_larger_than_it_is_cannot_reach_outside_memory() -> None:
    whole = linked(
        "extern int n[9000000]; int main(void) { return n[8999999]; }", "int n[2] = {1, 2};"
    )
    fleet = Fleet([make_executable(whole, "a.c")])
    fleet.slots["fuel"] = 10**6
    while fleet.slots["status"][0] != FAILED:
        fleet.slots["message"]["result"] = -1  # there are no arguments
        fleet.slots["run"] = 1
        fleet.run_round()
    assert fleet.failure(0).kind == "pointer outside memory"
    assert fleet.failure(0).location.file == "a.c"
