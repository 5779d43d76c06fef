"""The C library is compiled on demand, and its index matches its sources."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.core.errors import InternalError
from crs_cc.session.device_library import device_headers
from crs_cc.toolchain import cache
from crs_cc.toolchain import library as library_module
from crs_cc.toolchain.library import SOURCES, CachedLibrary, index_of_sources


def test_the_index_is_that_of_the_sources(check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(SOURCES / "index.txt", index_of_sources(device_headers()).encode())


def test_every_unit_is_in_the_index() -> None:
    lines = (SOURCES / "index.txt").read_text().splitlines()
    units = [path.relative_to(SOURCES).as_posix() for path in sorted(SOURCES.rglob("*.c"))]
    assert [line.partition(":")[0] for line in lines] == units


def test_only_the_units_that_are_needed_are_compiled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cache.version()  # which the cache holds, too
    monkeypatch.setenv("CRS_CACHE", str(tmp_path))
    library = CachedLibrary()
    assert library.find("abs") is not None
    assert library.find("labs") is not None
    assert library.find("<library>/stdlib/none.c:x") is None
    assert library.find("nothing") is None
    assert len(list(tmp_path.iterdir())) == 1


def test_units_are_compiled_again_when_a_header_of_devices_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cache.version()  # which the cache holds, too
    monkeypatch.setenv("CRS_CACHE", str(tmp_path))
    for text in ("#define NUMBER 1\n", "#define NUMBER 2\n"):
        assert CachedLibrary((("numbers.h", text),)).find("abs") is not None
    assert len(list(tmp_path.iterdir())) == 2


def test_a_name_defined_twice_in_the_library_is_an_internal_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cache.version()  # which the cache holds, too
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(library_module, "SOURCES", tmp_path)
    for unit in ("a.c", "b.c"):
        (tmp_path / unit).write_text("int twice;\n" if unit == "a.c" else "int twice = 2;\n")
    with pytest.raises(InternalError, match=r"'twice' in a\.c and b\.c"):
        index_of_sources(())


def test_headers_of_another_installation_are_not_taken_for_the_users(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    here = cache.key("library", "system/errno.c")
    monkeypatch.setattr(cache, "PACKAGE", Path("/another/crs_cc"))
    assert cache.key("library", "system/errno.c") != here
