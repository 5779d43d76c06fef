"""The package, built as it is published: all files in it, and usable without the checkout."""

from __future__ import annotations

import email
import os
import shutil
import subprocess
import sys
import zipfile
from email.message import Message
from pathlib import Path

import pytest

import crs_cc

ROOT = Path(__file__).parents[1]
BUILD = """
import sys, zlib
import setuptools.build_meta as build
compressor = zlib.compressobj
zlib.compressobj = lambda _level, *others: compressor(1, *others)
build.build_{}(sys.argv[1])
"""
"""Builds a distribution; how well it is compressed matters to nobody here."""

LEFT_OUT = shutil.ignore_patterns(
    *(".*", "__pycache__", "build", "dist", "*.egg-info", "*.mcap", "node_modules"),
    "tests",  # half of all files, and none is for a wheel
)


def built(kind: str, source: Path, target: Path) -> Path:
    """Build a distribution offline, and return it."""
    target.mkdir()
    command = [sys.executable, "-c", BUILD.format(kind), str(target)]
    subprocess.run(command, cwd=source, check=True, capture_output=True)
    (made,) = target.iterdir()
    return made


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build a source distribution, and a wheel from nothing else."""
    folder = tmp_path_factory.mktemp("package")
    shutil.copytree(ROOT, folder / "checkout", ignore=LEFT_OUT)
    shutil.unpack_archive(
        built("sdist", folder / "checkout", folder / "sdist"), folder / "unpacked"
    )
    (unpacked,) = (folder / "unpacked").iterdir()
    return built("wheel", unpacked, folder / "wheel")


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("installed")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    return folder


def files_in(folder: Path, patterns: tuple[str, ...] = ("*",)) -> set[str]:
    found = (each for pattern in patterns for each in folder.rglob(pattern) if each.is_file())
    kept = (each for each in found if not {"__pycache__", ".mypy_cache"} & set(each.parts))
    return {str(each.relative_to(folder)) for each in kept}


def test_the_wheel_has_all_files_of_the_package(installed: Path) -> None:
    ours = {name for name in files_in(ROOT / "crs_cc") if not name.startswith("share/")}
    theirs = {name for name in files_in(installed / "crs_cc") if not name.startswith("share/")}
    assert theirs == ours


@pytest.mark.parametrize("name", ["samples", "worlds"])
def test_the_wheel_has_all_samples_and_worlds(installed: Path, name: str) -> None:
    assert files_in(installed / "crs_cc" / "share" / name) == files_in(ROOT / name)


def test_the_wheel_has_all_pages_and_licences(installed: Path) -> None:
    pages = installed / "crs_cc" / "share" / "docs"
    assert {each.name for each in pages.glob("*.md")} == {
        each.name for each in (ROOT / "docs").glob("*.md")
    }
    (manual,) = installed.glob("*.data/data/share/man/man1")
    assert files_in(manual) == files_in(ROOT / "docs" / "man")
    (licences,) = installed.glob("*.dist-info/licenses")
    vendored = {str(each.relative_to(ROOT)) for each in (ROOT / "crs_cc").rglob("LICENSE")}
    assert files_in(licences) == {"LICENSE", *vendored}


def metadata(installed: Path) -> Message:
    (file,) = installed.glob("*.dist-info/METADATA")
    return email.message_from_string(file.read_text("utf-8"))


def test_the_metadata_is_complete(installed: Path) -> None:
    data = metadata(installed)
    assert data["Version"] == crs_cc.__version__
    assert data["License-Expression"] == "MIT"
    assert not data.get_all("Project-URL")
    named = {row.rpartition(" :: ")[2] for row in data.get_all("Classifier", [])}
    assert {"3.11", "3.12", "3.13", "3.14", "Typed"} <= named
    assert f"version: {crs_cc.__version__}\n" in (ROOT / "CITATION.cff").read_text()
    assert f"\n## {crs_cc.__version__}" in (ROOT / "CHANGELOG.md").read_text()


def test_an_installed_package_runs_in_an_empty_folder(installed: Path, tmp_path: Path) -> None:
    def crs(*arguments: str, typed: str = "") -> str:
        command = [sys.executable, "-P", "-m", "crs_cc", *arguments]
        environment = {**os.environ, "PYTHONPATH": str(installed)}
        return subprocess.run(
            command, cwd=tmp_path, env=environment, input=typed, check=True, text=True,
            stdout=subprocess.PIPE,
        ).stdout  # fmt: skip

    crs("samples", "copy", "square.c", "room.xml", ".")
    run = ("square.c", "room.xml")
    crs("run", *run, "--max-time", "1", "--record", "run.mcap")
    crs("replay", "run.mcap", "--html", "run.html")
    assert "square.c" in (tmp_path / "run.html").read_text("utf-8")
    assert "main" in crs("debug", *run, "--repl", typed="backtrace\nquit\n")
    assert "Sensors" in crs("docs", "sensors")
