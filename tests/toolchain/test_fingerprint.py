"""The cache knows by sizes and times whether our own sources are the same."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from crs_cc.toolchain import cache, fingerprint


@pytest.fixture
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder that stands for our package, and begin with an empty cache."""
    package = tmp_path / "package"
    (package / "ir" / "deeper").mkdir(parents=True)
    (package / "ir" / "deeper" / "one.py").write_text("ONE = 1\n")
    (package / "cli").mkdir()
    (package / "cli" / "other.py").write_text("\n")
    monkeypatch.setattr(fingerprint, "PACKAGE", package)
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "cache"))
    return package


def version() -> str:
    return cache.version.__wrapped__(("ir",))


def test_the_sources_are_read_once(sources: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = version()
    monkeypatch.setattr(cache, "fingerprint", lambda _folders: pytest.fail("read again"))
    assert version() == first


def test_a_change_of_the_same_size_and_time_is_noticed(sources: Path) -> None:
    """As when another version of the package is unpacked with the times of its archive."""
    first, file = version(), sources / "ir" / "deeper" / "one.py"
    times = file.stat().st_atime_ns, file.stat().st_mtime_ns
    file.write_text("ONE = 2\n")
    os.utime(file, ns=times)
    assert version() != first


def test_only_the_named_folders_matter(sources: Path) -> None:
    first = version()
    (sources / "cli" / "other.py").write_text("changed\n")
    (sources / "ir" / "notes.md").write_text("no source\n")
    assert version() == first
    (sources / "ir" / "two.c").write_text("int two;\n")
    assert version() != first


def test_the_same_contents_at_other_times_have_the_same_fingerprint(sources: Path) -> None:
    first, stamp = version(), fingerprint.stamp(("ir",))
    os.utime(sources / "ir" / "deeper" / "one.py", ns=(1, 1))
    assert fingerprint.stamp(("ir",)) != stamp
    assert version() == first
