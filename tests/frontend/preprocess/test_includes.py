"""`#include`: the search for headers, and files that a hostile program must not read."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.preprocessor import Preprocessed, preprocess
from crs_cc.frontend.preprocess.regular_file import MAX_FILE_SIZE
from tests.frontend.preprocess.preprocessing import tokens

SECRET = "the_content_of_a_file_that_a_program_must_not_read"


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Create a user's directory, header directories, and a file outside of all of them."""
    for name in ("user/sub", "extra", "system/sys", "outside"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "outside" / "secret.h").write_text(SECRET)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(
    source: str, *, root: Path | None = Path("user"), **files: str
) -> tuple[Preprocessed, Diagnostics]:
    """Preprocess `user/main.c`; other files are given with `__` for `/` and `_` for `.`."""
    for name, content in files.items():
        Path(name.replace("__", "/").replace("_", ".")).write_text(content)
    Path("user/main.c").write_text(source)
    diagnostics = Diagnostics()
    folders = (Path("extra"),), (Path("system"),)
    options = Options(*folders, root=root)
    return preprocess(Path("user/main.c"), options, diagnostics), diagnostics


def first_line(diagnostics: Diagnostics) -> str:
    return diagnostics.messages[0].render().split("\n")[0]


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ('#include "a.h"', "own"),
        ("#include <a.h>", "extra"),
        ('#include "b.h"', "extra"),
        ('#include "c.h"', "system"),
        ("#include <c.h>", "system"),
        ("#include <sys/d.h>", "sys"),
        ('#include "sub/e.h"', "sub"),
        ('#  include  "a.h" /* c */', "own"),
        ('#define H "a.h"\n#include H', "own"),
        ("#define H <a.h>\n#include H", "extra"),
        ("#define DOT .\n#define H <sys/d DOT h>\n#include H", ""),
        ("#define S(x) #x\n#define X(x) S(x)\n#include X(a.h)", "own"),
        ('#import "a.h"', "own"),
        ('#include "sub/../a.h"', "own"),
        ('#include "../extra/a.h"', "extra"),
    ],
)
def test_headers_are_searched_in_order(project: Path, line: str, found: str) -> None:
    program, diagnostics = run(
        line,
        user__a_h="own", extra__a_h="extra", system__a_h="system", extra__b_h="extra",
        system__b_h="system", system__c_h="system", system__sys__d_h="sys", user__sub__e_h="sub",
    )  # fmt: skip
    assert program.text.strip() == found
    assert bool(diagnostics.errors) == (not found)


def test_quoted_include_searches_the_including_directory_first(project: Path) -> None:
    program, diagnostics = run(
        '#include "sub/a.h"\nend', user__sub__a_h='#include "b.h"\nin_a', user__sub__b_h="own",
        user__b_h="not this",
    )  # fmt: skip
    assert tokens(program.text) == ["own", "in_a", "end"]
    assert str(program.location(1, 1)) == "user/sub/b.h:1:1"
    assert sorted(diagnostics.lines) == ["user/main.c", "user/sub/a.h", "user/sub/b.h"]


def test_include_next(project: Path) -> None:
    program, _ = run(
        "#include <a.h>", extra__a_h="#include_next <a.h>\nextra", system__a_h="system"
    )
    assert tokens(program.text) == ["system", "extra"]


def test_guards_and_pragma_once(project: Path) -> None:
    program, diagnostics = run(
        '#include "g.h"\n#include "o.h"\n' * 3 + "__FILE__ __INCLUDE_LEVEL__",
        user__g_h="#ifndef G\n#define G\nguarded __INCLUDE_LEVEL__\n#endif\n",
        user__o_h='#pragma once\n#include "sub/../o.h"\nonce __FILE__\n',
    )
    assert diagnostics.messages == []
    assert tokens(program.text) == tokens('guarded 1 once "o.h" "main.c" 0')


def test_has_include(project: Path) -> None:
    lines = [
        f"#if __has_include({name})\nyes\n#else\nno\n#endif\n"
        for name in ('"a.h"', "<a.h>", "<sys/linux/x.h>", '"../outside/secret.h"', '"none.h"', "A")
    ]
    source = '#define A "a.h"\n' + "".join(lines)
    program, diagnostics = run(source, user__a_h="#error not read")
    assert diagnostics.messages == []
    assert program.text.split() == ["yes", "no", "no", "no", "no", "yes"]


def test_macro_call_may_continue_after_an_include(project: Path) -> None:
    program, _ = run('#define F(x) <x>\nF(1\n#include "a.h"\n)', user__a_h="+ 2")
    assert tokens(program.text) == tokens("<1 + 2>")


def test_macro_call_cannot_continue_after_its_file(project: Path) -> None:
    _, diagnostics = run('#define F(x) x\n#include "a.h"\n)', user__a_h="int a;\n F(1")
    assert first_line(diagnostics) == (
        "user/a.h:2:2: error: unterminated call of macro 'F': missing ')'"
    )


def test_conditional_group_must_end_in_its_file(project: Path) -> None:
    program, diagnostics = run('#include "a.h"\n#endif\nend', user__a_h="#if 1\n")
    assert [str(each.location) for each in diagnostics.errors] == [
        "user/a.h:1:1",
        "user/main.c:2:1",
    ]
    assert program.text.strip() == "end"


@pytest.mark.parametrize(
    "name",
    [
        "{outside}/secret.h",
        "../outside/secret.h",
        "sub/../../outside/secret.h",
        "../user/../outside/secret.h",
        "link.h",
        "folder/secret.h",
        "pipe.h",
        "sub",
        "../outside",
        "/dev/zero",
        "/etc/passwd",
        "loop.h",
        "big.h",
        "x" * 5000,
    ],
)
@pytest.mark.parametrize("brackets", ['""', "<>"])
def test_files_outside_the_directories_are_not_read(
    project: Path, name: str, brackets: str
) -> None:
    user = project / "user"
    for folder in (user, project / "system"):
        (folder / "link.h").symlink_to(project / "outside" / "secret.h")
        (folder / "folder").symlink_to(project / "outside")
        (folder / "loop.h").symlink_to(folder / "loop.h")
        (folder / "big.h").write_bytes(b" " * (MAX_FILE_SIZE + 1))
        os.mkfifo(folder / "pipe.h")
    name = name.format(outside=project / "outside")
    program, diagnostics = run(f"#include {brackets[0]}{name}{brackets[1]}\nint a;\n")
    assert len(diagnostics.errors) == 1
    assert str(diagnostics.errors[0].location) == "user/main.c:1:10"
    assert program.text == "int a;\n"
    told = str(diagnostics.lines) + "".join(each.render() for each in diagnostics.messages)
    assert SECRET not in told


def test_existence_of_outside_files_is_not_revealed(project: Path) -> None:
    texts = [
        first_line(run(f'#include "../outside/{name}.h"\n')[1]).replace(name, "NAME")
        for name in ("secret", "nothing")
    ]
    assert texts[0] == texts[1]
    assert "is outside the directories that a program may read" in texts[0]


def test_a_project_that_contains_the_main_file_may_be_read(
    project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (project / "user/link.h").symlink_to(project / "outside/secret.h")
    source = '#include "../outside/secret.h"\n#include "link.h"\n'
    for root in (None, project):
        program, diagnostics = run(source, root=root)
        assert diagnostics.messages == []
        assert program.text.split() == [SECRET, SECRET]
    monkeypatch.chdir(project / "user")
    for root in (None, project / "outside"):
        refused = Diagnostics()
        preprocess(Path("main.c"), Options(root=root), refused)
        assert len(refused.errors) == 2
        assert "--root" in refused.errors[0].hint


def test_an_import_is_read_once(project: Path) -> None:
    program, _ = run('#import "a.h"\n#import "sub/../a.h"\n#include "a.h"\n', user__a_h="once")
    assert program.text.split() == ["once"]


def test_a_file_is_embedded_as_numbers(project: Path) -> None:
    Path("user/a.bin").write_bytes(bytes([0, 255, 39, 10]))
    Path("user/none.bin").write_bytes(b"")
    lines = [
        '#define NAME "a.bin"',
        "#embed NAME limit(2) prefix(7,) suffix(, 9)",
        '#embed "a.bin"',
        '#embed "none.bin" if_empty(5)',
        '#if __has_embed(NAME) + 2 * __has_embed("none.bin") + __has_embed("b.bin") == 5',
        "found",
        "#endif",
    ]
    program, diagnostics = run("\n".join(lines))
    assert diagnostics.messages == []
    assert program.text.replace(" ", "").split() == ["7,0,255,9", "0,255,39,10", "5", "found"]


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ('"none.bin"', "'none.bin' file not found"),
        ('"../outside/secret.h"', "is outside the directories"),
        ('"a.bin" limit(x)', "'limit' of '#embed' must be a number"),
        ('"a.bin" size(3)', "unknown parameter 'size' of '#embed'"),
        ('"a.bin" limit', "'limit' must be followed by its value in parentheses"),
        ('"large.bin"', "is larger than 131072 bytes"),
    ],
)
def test_wrong_embeds_are_reported(project: Path, line: str, text: str) -> None:
    Path("user/a.bin").write_bytes(b"a")
    Path("user/large.bin").write_bytes(bytes(200_000))
    _, diagnostics = run(f"#embed {line}")
    assert [text in each.text for each in diagnostics.errors] == [True]


def test_links_inside_the_directories_are_followed(project: Path) -> None:
    Path("extra/real.h").write_text("real")
    Path("user/link.h").symlink_to(project / "extra" / "real.h")
    program, _ = run('#include "link.h"')
    assert program.text.strip() == "real"


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("net/if.h", "network"),
        ("threads.h", "single processes"),
        ("conio.h", "DOS or Windows"),
        ("linux/serial.h", "no devices but their robot"),
        ("iostream", "C++"),
        ("Nclint.h", "did you mean 'Nclient.h'?"),
        ("sys/tme.h", "did you mean 'sys/time.h'?"),
        ("something_else.h", ""),
    ],
)
def test_missing_header_hint(project: Path, name: str, hint: str) -> None:
    _, diagnostics = run(f"\n#include <{name}>\n", system__Nclient_h="", system__sys__time_h="")
    assert first_line(diagnostics) == (
        f"user/main.c:2:10: error: '{name}' file not found; searched in: extra, the headers of crs"
    )
    assert hint in diagnostics.messages[0].hint
    assert bool(hint) == bool(diagnostics.messages[0].hint)


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("nclient.h", "Nclient.h"),
        ("NCLIENT.H", "Nclient.h"),
        ("/usr/local/nomad/include/Nclient.h", "Nclient.h"),
        ("../../client/nclient.h", "Nclient.h"),
        (r"c:\nomad\nclient.h", "Nclient.h"),
        ("Sys/Time.H", "sys/time.h"),
        ("/usr/include/sys/time.h", "sys/time.h"),
    ],
)
def test_headers_are_found_by_names_of_other_systems(project: Path, name: str, meant: str) -> None:
    ours = {"system__Nclient_h": "Nclient.h", "system__sys__time_h": "sys/time.h"}
    program, diagnostics = run(f'#include "{name}"\n', **ours)
    assert program.text.strip() == meant
    assert len(diagnostics.messages) == 1
    assert first_line(diagnostics) == (
        f"user/main.c:1:10: warning: '{name}' not found; using '{meant}' [-Wheader-name]"
    )


def test_only_the_vendor_header_is_found_below_any_path(project: Path) -> None:
    for name in ("../time.h", "/opt/time.h", "../system/../outside/TIME.H", "x/time.h"):
        _, diagnostics = run(f'#include "{name}"\n', system__time_h="")
        assert len(diagnostics.errors) == 1


def test_has_include_knows_exact_names_only(project: Path) -> None:
    source = '#if __has_include("nclient.h")\nyes\n#else\nno\n#endif\n'
    program, diagnostics = run(source, system__Nclient_h="")
    assert (program.text.strip(), diagnostics.messages) == ("no", [])


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("#include", "1:1: error: '#include' must be followed by a header's name"),
        ("#include a", '1:10: error: write "name.h" or <name.h>'),
        ('#include "a', '1:10: error: write "name.h" or <name.h>'),
        ('#include ""', "1:10: error: '' cannot be included"),
        ('#include "main.c" x', "1:19: warning: 'x' after '#include' is ignored [-Wextra-tokens]"),
    ],
)
def test_include_errors(project: Path, line: str, message: str) -> None:
    _, diagnostics = run(f"{line}\n#if 0\n#endif")
    assert first_line(diagnostics) == f"user/main.c:{message}"


@pytest.mark.parametrize("make", ["missing", "folder", "pipe"])
def test_unreadable_main_file_is_an_error(project: Path, make: str) -> None:
    path = project / "user" / "other.c"
    if make == "folder":
        path.mkdir()
    elif make == "pipe":
        os.mkfifo(path)
    diagnostics = Diagnostics()
    assert preprocess(path, Options(), diagnostics).text == ""
    assert len(diagnostics.errors) == 1
    assert diagnostics.errors[0].location.file == str(path)
