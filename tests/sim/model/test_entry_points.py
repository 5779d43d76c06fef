"""The quick look for entry points finds all that `importlib.metadata` finds."""

from __future__ import annotations

import sys
import zipfile
from importlib.machinery import PathFinder
from importlib.metadata import DistributionFinder, MetadataPathFinder
from pathlib import Path

import pytest

from crs_cc.sim.model.entry_points import may_have_entries

GROUP = "crs_cc.tested"
METADATA = "Metadata-Version: 2.1\nName: one\nVersion: 1\n"
ENTRY = f"[{GROUP}]\nname = os:path\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(sys, "path", [str(tmp_path / "none"), str(tmp_path)])
    # importlib_metadata, which other tests import, looks for packages by itself.
    others = [each for each in sys.meta_path if not hasattr(each, "find_distributions")]
    monkeypatch.setattr(sys, "meta_path", [*others, PathFinder])
    return tmp_path


@pytest.mark.parametrize("kind", ["one-1.0.dist-info", "one.egg-info", "One-1.0.DIST-INFO"])
def test_an_installed_package_is_found(folder: Path, kind: str) -> None:
    (folder / kind).mkdir()
    (folder / kind / "METADATA").write_text(METADATA)
    assert not may_have_entries(GROUP)
    (folder / kind / "entry_points.txt").write_text(ENTRY)
    assert may_have_entries(GROUP)
    assert not may_have_entries("crs_cc.others")


def test_a_package_in_an_archive_is_found(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    archive = folder / "one.zip"
    with zipfile.ZipFile(archive, "w") as file:
        file.writestr("one-1.0.dist-info/METADATA", METADATA)
        file.writestr("one-1.0.dist-info/entry_points.txt", ENTRY)
    monkeypatch.setattr(sys, "path", [str(archive)])
    place = DistributionFinder.Context(path=[str(archive)])
    (found,) = MetadataPathFinder.find_distributions(place)
    assert found.entry_points.select(group=GROUP)
    assert may_have_entries(GROUP)


def test_a_package_of_an_importer_of_its_own_is_found(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Finder:
        def find_distributions(self, context: object) -> list[object]:
            return []

    monkeypatch.setattr(sys, "meta_path", [Finder(), *sys.meta_path])
    assert may_have_entries(GROUP)
