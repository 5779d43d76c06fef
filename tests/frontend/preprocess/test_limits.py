"""Hostile sources end soon, with a located message and without a traceback."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess import state
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.preprocessor import preprocess
from tests.frontend.preprocess.preprocessing import messages, result, run


def doubling(first: str) -> str:
    """Return macros that each expand to the previous one twice."""
    rows = [f"#define A{i} A{i - 1} A{i - 1}\n" for i in range(1, 100)]
    return f"#define A0 {first}\n{''.join(rows)}\n  A99\n"


@pytest.mark.parametrize(
    "source",
    [
        doubling("x"),
        doubling(""),
        "#define D(x) P(x,x)\n#define P(a,b) a##b\n" + "D(" * 100 + "a" + ")" * 100,
        "#define S(x) T(x)\n#define T(x) #x\n" + "S(" * 40 + r'"\\"' + ")" * 40,
        f"#define S(x) {'x ' * 9000}\nS({'a ' * 9000})\n",
        f"#define S(x) {'#x ' * 9000}\nS({'a ' * 9000})\n",
        f"#define S(x) {'x##' * 90000}x\nS(aaaaa)\n",
        "#define f(x) x\n" + "f(" * 3000 + "1" + ")" * 3000,
        f"#define f(x) x\n#if {'f(' * 3000}1{')' * 3000}\n#endif",
    ],
)
def test_macro_expansion_is_limited(source: str) -> None:
    errors = messages(source)
    assert len(errors) == 1
    assert errors[0].endswith("error: macro expansion is too large")
    assert int(errors[0].split(":")[0]) == source.rstrip().count("\n") + 1 - source.count("#endif")


def test_long_chains_of_macros() -> None:
    chain = "".join(f"#define A{i} A{i + 1}\n" for i in range(20_000))
    assert result(f"{chain}A0") == ["A20000"]
    calls = "".join(f"#define F{i}(x) F{i + 1}(x)\n" for i in range(5_000))
    assert result(f"{calls}F0(1)") == ["F5000", "(", "1", ")"]


def test_recursive_includes_end(tmp_path: Path) -> None:
    (tmp_path / "self.h").write_text('int a;\n#include "self.h"\n')
    main = tmp_path / "main.c"
    main.write_text('#include "self.h"\n')
    diagnostics = Diagnostics()
    preprocess(main, Options(), diagnostics)
    assert [each.render().split("\n")[0] for each in diagnostics.messages] == [
        f"{tmp_path / 'self.h'}:2:10: error: #include nested more than 200 deep"
    ]


def test_doubling_includes_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(state, "FILE_COST", 1 << 18)
    (tmp_path / "twice.h").write_text(
        "#if __INCLUDE_LEVEL__ < 150\n" + '#include "twice.h"\n' * 2 + "#endif\n"
    )
    main = tmp_path / "main.c"
    main.write_text('#include "twice.h"\n')
    diagnostics = Diagnostics()
    preprocess(main, Options(), diagnostics)
    assert len(diagnostics.errors) == 1
    assert "more than 32 million characters of source" in diagnostics.errors[0].text


@pytest.mark.parametrize("line", ['"abc', "#else", "#include <none.h>", "#if (", "@", "08"])
def test_errors_have_a_limit(line: str) -> None:
    errors = messages(f"{line}\n" * 1000)
    assert len(errors) == 101
    assert errors[-1].endswith("too many errors (100), stopping now")


def test_warnings_have_a_limit() -> None:
    assert len(messages("#warning x\n" * 1000)) == 100


@pytest.mark.parametrize(
    "source",
    [
        "/*" * 100_000,
        "'\"'" * 50_000,
        "\\\n" * 100_000 + "x",
        "#if 1\n" * 20_000 + "#endif\n" * 20_000,
        "x = " + "1" * 100_000 + ";",
        "x = " + "1." * 50_000 + ";",
        "/**" * 50_000,
        "#define f(x) x\n" + "f " * 50_000,
        "#define f(x) x\n" + "f( " * 50_000,
        "#define F(" + ",".join(f"a{i}" for i in range(20_000)) + ") a1\nF(1)",
        'int x asm("y"); ' * 3_000,
        "int y __attribute__((unused)); " * 3_000,
        "\0" * 50_000,
    ],
    ids=lambda source: repr(source[:12]),
)
def test_preprocessing_time_is_linear(source: str) -> None:
    program, diagnostics = run(source)  # the suite's patience is the measure
    assert program.text or diagnostics.messages or source.startswith("#if")


WORDS = """
    # ## define undef include if ifdef elif else endif line pragma error defined
    ( ) < > " ' \\ /* */ // , ... + ? : && %: <: ; { } @ 08 0x1.5e a b f f( 1
    __VA_ARGS__ __VA_OPT__( __LINE__ __has_include __attribute__ (( )) asm _Pragma(
"""
PIECES = (
    *WORDS.split(),
    *("\n", "\n", "\n", " ", "\t", "\r", "\0", "\v", "\xe9", "\u0410", "\ud800", "\udcff"),
    *("#define f(x,y...) x##y #x f(y)\n", "#define a b\n", "f(a,b)", "int x;", '"s\\%"', "'c'"),
)


@pytest.mark.parametrize("seed", range(300))
def test_random_tokens_never_crash(seed: int) -> None:
    choice = random.Random(seed)
    source = "".join(choice.choices(PIECES, k=choice.randint(1, 120)))
    program, diagnostics = run(source)
    program.text.encode()
    for message in diagnostics.messages:
        message.render().encode()
        line = diagnostics.lines[message.location.file][message.location.line - 1]
        assert 1 <= message.location.column <= len(line) + 1
    for number, line in enumerate(program.text.split("\n")[:-1], 1):
        for column in range(1, len(line) + 1):
            place = program.location(number, column)
            assert 1 <= place.column <= len(diagnostics.lines["a.c"][place.line - 1]) + 1
