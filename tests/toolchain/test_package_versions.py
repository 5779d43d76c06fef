"""Versions of packages are those that `importlib.metadata` tells."""

from __future__ import annotations

import importlib.metadata
import subprocess
import sys
from pathlib import Path

import pytest

from crs_cc.recording.description import PACKAGES
from crs_cc.toolchain.package_versions import package_version


@pytest.mark.parametrize("package", [*PACKAGES, "zstandard", "click", "lxml"])
def test_it_is_the_version_of_the_metadata(package: str) -> None:
    assert package_version(package) == importlib.metadata.version(package)


def installed(folder: Path, name: str, content: str) -> None:
    (folder / name).mkdir()
    (folder / name / "METADATA").write_text(content)


def test_the_first_folder_of_the_path_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in (1, 2):
        (tmp_path / str(number)).mkdir()
        content = f"Metadata-Version: 2.1\nName: thing\nVersion: {number}.5\n\nVersion: 9\n"
        installed(tmp_path / str(number), f"thing-{number}.dist-info", content)
    folders = [str(tmp_path / each) for each in ("none", "2", "1")]
    monkeypatch.setattr(sys, "path", folders)
    assert package_version("thing") == importlib.metadata.version("thing") == "2.5"


def test_who_is_not_found_here_is_looked_for_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "old-3.egg-info").mkdir()
    (tmp_path / "old-3.egg-info" / "PKG-INFO").write_text("Name: old\nVersion: 3.1\n")
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    assert package_version("old") == "3.1"
    with pytest.raises(importlib.metadata.PackageNotFoundError):
        package_version("missing")


def test_a_recording_starts_without_the_slow_import() -> None:
    code = (
        "import sys; from crs_cc.recording.description import versions; versions();"
        "sys.exit('importlib.metadata' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
