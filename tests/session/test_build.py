"""Programs come from the cache as long as nothing has changed."""

from __future__ import annotations

import errno
import functools
import hashlib
import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics, Location
from crs_cc.ir.program import Function
from crs_cc.runtime import executable as executable_module
from crs_cc.session import build as build_module
from crs_cc.session import library as session_library
from crs_cc.session.build import build_executable
from crs_cc.toolchain import cache
from crs_cc.toolchain import library as library_module
from crs_cc.toolchain.fingerprint import PACKAGE, sources
from tests.fast_settings import USERS_SETTINGS

PROGRAM = '#include "speed.h"\nmain() { return SPEED; }\n'

COMPILES = """
import sys
from pathlib import Path
import crs_cc
crs_cc.compile_c(sys.argv[1])
for module in list(sys.modules.values()):
    if module.__name__.partition(".")[0] == "crs_cc":
        print(module.__file__)
"""


@pytest.fixture
def compilations(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """Return a list that grows with each compilation; the cache is empty at first."""
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "cache"))
    done: list[str] = []
    compile_ = build_module._compile

    def counted(*arguments: object, **options: object) -> object:
        done.append("compiled")
        return compile_(*arguments, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(build_module, "_compile", counted)
    return done


@pytest.fixture
def generations(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return a list that grows each time that machine code is made of a program."""
    done: list[str] = []
    make = executable_module.make_executable

    def counted(*arguments: object, **options: object) -> object:
        done.append("generated")
        return make(*arguments, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(executable_module, "make_executable", counted)
    return done


@pytest.fixture
def program(tmp_path: Path) -> Path:
    (tmp_path / "speed.h").write_text("#define SPEED 3\n")
    path = tmp_path / "program.c"
    path.write_text(PROGRAM)
    return path


def test_a_cached_program_is_not_compiled_but_its_warnings_are_repeated(
    program: Path, compilations: list[str]
) -> None:
    first, second = Diagnostics(), Diagnostics()
    one = build_executable([program], first)
    two = build_executable([program], second)
    assert len(compilations) == 1
    assert one.machine_code == two.machine_code
    assert first.messages == second.messages
    assert "int" in first.messages[0].text
    assert two.wat() == one.wat()


def test_a_changed_header_is_noticed(program: Path, compilations: list[str]) -> None:
    one = build_executable([program], Diagnostics())
    (program.parent / "speed.h").write_text("#define SPEED 4\n")
    two = build_executable([program], Diagnostics())
    assert len(compilations) == 2
    assert one.machine_code != two.machine_code


def test_a_header_that_appears_in_an_earlier_folder_is_noticed(
    program: Path, compilations: list[str]
) -> None:
    folders = [program.parent / name for name in ("a", "b")]
    for folder in folders:
        folder.mkdir()
    (program.parent / "speed.h").rename(folders[1] / "speed.h")
    one = build_executable([program], Diagnostics(), include_paths=folders)
    (folders[0] / "speed.h").write_text("#define SPEED 4\n")
    two = build_executable([program], Diagnostics(), include_paths=folders)
    assert len(compilations) == 2
    assert one.machine_code != two.machine_code


def test_a_header_looked_up_by_has_include_is_tracked(
    program: Path, compilations: list[str]
) -> None:
    program.write_text(
        '#if __has_include("speed.h")\nint main(void) { return 1; }\n'
        "#else\nint main(void) { return 2; }\n#endif\n"
    )
    one = build_executable([program], Diagnostics())
    (program.parent / "speed.h").unlink()
    two = build_executable([program], Diagnostics())
    assert one.machine_code != two.machine_code


@pytest.mark.parametrize("name", ["speed.h", "program.c"])
def test_an_edit_while_it_is_compiled_is_noticed(
    program: Path, compilations: list[str], monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    with monkeypatch.context() as patch:
        compile_ = build_module._compile

        def slow(*arguments: object, **options: object) -> object:
            executable = compile_(*arguments, **options)  # type: ignore[arg-type]
            edited = program.parent / name
            edited.write_text(edited.read_text().replace("SPEED", "OTHER_SPEED"))
            return executable

        patch.setattr(build_module, "_compile", slow)
        build_executable([program], Diagnostics())
    with pytest.raises(CompileError):
        build_executable([program], Diagnostics())
    assert len(compilations) == 2


def test_only_warnings_of_the_same_build_are_repeated(
    program: Path, compilations: list[str]
) -> None:
    first, second = Diagnostics(), Diagnostics()
    first.warning(Location("world.xml"), "of something else", flag="unused-program")
    build_executable([program], first)
    build_executable([program], second)
    assert second.messages == first.messages[1:]


def test_each_set_of_options_has_its_own_entry(
    program: Path, compilations: list[str], generations: list[str]
) -> None:
    for _ in range(2):
        build_executable([program], Diagnostics())
        build_executable([program], Diagnostics(), checked=False)
        build_executable([program], Diagnostics(), debug=True)
        build_executable([program], Diagnostics(), defines=["X=1"])
    assert len(generations) == 4
    assert len(compilations) == 2  # builds with the same macros share the linked program


def test_code_is_cached_for_each_engine_that_a_program_is_compiled_for(
    program: Path,
    compilations: list[str],
    generations: list[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    fast, codes = executable_module.settings, []
    for settings in (fast, USERS_SETTINGS, fast, USERS_SETTINGS):
        monkeypatch.setattr(executable_module, "settings", settings)
        codes.append(build_executable([program], Diagnostics()).machine_code)
    assert (len(compilations), len(generations)) == (1, 2)
    assert codes[:2] == codes[2:]
    assert codes[0] != codes[1]


def test_programs_that_differ_in_comments_and_folders_share_their_machine_code(
    program: Path, compilations: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    compiled: list[int] = []
    compile_module = build_module.compile_module

    def counted(wasm: bytes) -> tuple[executable_module.Module, bytes]:
        compiled.append(len(wasm))
        return compile_module(wasm)

    monkeypatch.setattr(build_module, "compile_module", counted)
    commented, faster = tmp_path / "commented" / "program.c", tmp_path / "faster.c"
    commented.parent.mkdir()
    commented.write_text("#define SPEED 3\n/* slow */\nmain() { return SPEED; }\n")
    faster.write_text("main() { return 4; }\n")
    one, two, other = (
        build_executable([path], Diagnostics()) for path in (program, commented, faster)
    )
    assert len(compilations) == 3
    assert len(compiled) == 2
    assert one.machine_code == two.machine_code != other.machine_code
    assert two.detail().lines[str(commented)][1] == "/* slow */"
    assert build_executable([commented], Diagnostics()).machine_code == two.machine_code
    assert len(compiled) == 2


@pytest.mark.parametrize("linked_here", [True, False])
def test_a_build_of_a_cached_program_equals_one_from_its_sources(
    program: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, linked_here: bool
) -> None:
    fresh, cached = Diagnostics(), Diagnostics()
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "one"))
    one = build_executable([program], fresh, debug=True)
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "two"))
    build_executable([program], Diagnostics())
    if not linked_here:  # as in another process
        another = functools.cache(session_library.library.__wrapped__)
        monkeypatch.setattr(session_library, "library", another)
    two = build_executable([program], cached, debug=True)
    assert two.wat() == one.wat()
    assert two.machine_code == one.machine_code
    assert two.detail().lines == one.detail().lines
    assert cached.messages == fresh.messages


def whole(entry: object) -> bytes:
    """Return the file of an entry as it would be stored."""
    pickled = pickle.dumps(entry)
    return hashlib.sha256(pickled).digest() + pickled


def with_half_the_machine_code(content: bytes) -> bytes:
    entry = pickle.loads(content[32:])
    return whole(entry[: len(entry) // 2]) if isinstance(entry, bytes) else content


damages = pytest.mark.parametrize(
    "damaged",
    [
        pytest.param(lambda content: b"rubbish", id="rubbish"),
        pytest.param(lambda content: b"", id="empty"),
        pytest.param(lambda content: content[: len(content) // 2], id="truncated"),
        pytest.param(lambda content: content[:-1] + b"\0", id="another last byte"),
        pytest.param(lambda content: pickle.dumps({}), id="pickle without digest"),
        pytest.param(lambda content: whole({}), id="nothing in it"),
        pytest.param(lambda content: whole(3), id="foreign pickle"),
        pytest.param(
            lambda content: hashlib.sha256(b"I1_\n.").digest() + b"I1_\n.", id="ValueError"
        ),
        pytest.param(with_half_the_machine_code, id="truncated machine code"),
    ],
)


@damages
def test_a_corrupt_entry_is_rebuilt(
    program: Path,
    compilations: list[str],
    generations: list[str],
    damaged: Callable[[bytes], bytes],
) -> None:
    one = build_executable([program], Diagnostics())
    for entry in (program.parent / "cache").iterdir():
        entry.write_bytes(damaged(entry.read_bytes()))
    two = build_executable([program], Diagnostics())
    assert len(generations) == 2
    assert two.machine_code == one.machine_code
    done = len(compilations)
    build_executable([program], Diagnostics())
    assert (len(generations), len(compilations)) == (2, done)  # the damage is mended


@damages
def test_a_corrupt_library_entry_is_rebuilt(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, damaged: Callable[[bytes], bytes]
) -> None:
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(library_module, "SOURCES", tmp_path)
    (tmp_path / "twice.c").write_text("int twice(int n) { return 2 * n; }\n")
    (tmp_path / "index.txt").write_text("twice.c: twice\n")
    assert library_module.CachedLibrary().find("twice")
    for entry in (tmp_path / "cache").iterdir():
        entry.write_bytes(damaged(entry.read_bytes()))
    again = library_module.CachedLibrary().find("twice")
    assert isinstance(again, Function)
    assert again.name == "twice"


def test_without_a_home_folder_nothing_is_cached(
    program: Path, compilations: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def nobody() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("CRS_CACHE")
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(Path, "home", nobody)
    for _ in range(2):
        build_executable([program], Diagnostics())
    assert len(compilations) == 2


@pytest.mark.parametrize("mode", [0o777, 0o720])
def test_a_cache_folder_writable_by_others_is_not_used(
    program: Path, compilations: list[str], mode: int
) -> None:
    build_executable([program], Diagnostics())
    folder = program.parent / "cache"
    folder.chmod(mode)
    before = {entry.name: entry.stat().st_mtime_ns for entry in folder.iterdir()}
    build_executable([program], Diagnostics())
    assert len(compilations) == 2
    assert {entry.name: entry.stat().st_mtime_ns for entry in folder.iterdir()} == before


def test_a_cache_folder_of_another_user_is_not_used(
    program: Path, compilations: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    build_executable([program], Diagnostics())
    monkeypatch.setattr(os, "geteuid", lambda: program.stat().st_uid + 1)
    build_executable([program], Diagnostics())
    assert len(compilations) == 2


def test_an_entry_that_cannot_be_written_leaves_nothing_behind(
    compilations: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    cache.store("entry", 1)
    assert list((tmp_path / "cache").iterdir()) == []


def test_errors_in_all_files_are_reported_at_once(tmp_path: Path) -> None:
    for name in ("a.c", "b.c"):
        (tmp_path / name).write_text("int f(void) { return missing; }\n")
    with pytest.raises(CompileError) as caught:
        build_executable([tmp_path / "a.c", tmp_path / "b.c"], Diagnostics())
    files = [Path(each.location.file).name for each in caught.value.diagnostics]
    assert files == ["a.c", "b.c"]


def test_the_fingerprint_covers_all_modules_used_to_compile(tmp_path: Path) -> None:
    program = tmp_path / "a.c"
    program.write_text("#include <stdio.h>\nint main(void) { puts(0); return *(int *)0; }\n")
    done = subprocess.run(
        [sys.executable, "-c", COMPILES, str(program)],
        capture_output=True,
        text=True,
        check=True,
        cwd=Path(__file__).parents[2],
        env=os.environ | {"CRS_CACHE": str(tmp_path / "cache")},
    )
    used = {Path(line) for line in done.stdout.splitlines()}
    assert {path.parent.name for path in used} >= {
        "codegen",
        "preprocess",
        "lower",
        "ir",
        "session",
    }
    covered = set(sources())
    # What the simulation contributes, the C side of devices, is part of each entry's name.
    # The public interface only passes on what its caller wants.
    others = (PACKAGE / "sim", PACKAGE / "api")
    used -= {path for path in used if any(path.is_relative_to(other) for other in others)}
    assert used <= covered
    lib = PACKAGE / "runtime" / "lib"
    assert covered >= {lib / "index.txt", lib / "include" / "Nclient.h"}


def test_a_device_whose_c_side_changes_makes_programs_new(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Programs that were compiled with other devices are not taken from the cache."""
    program = tmp_path / "a.c"
    program.write_text("int main(void) { return 0; }\n")
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "cache"))
    build_executable([program], Diagnostics())
    entries = set((tmp_path / "cache").iterdir())
    build_executable([program], Diagnostics())
    assert set((tmp_path / "cache").iterdir()) == entries
    monkeypatch.setattr(build_module, "device_sources", lambda: "other devices")
    build_executable([program], Diagnostics())
    assert set((tmp_path / "cache").iterdir()) > entries


def test_a_program_of_no_files_is_an_error() -> None:
    with pytest.raises(CompileError, match="no C files"):
        build_executable([], Diagnostics())
