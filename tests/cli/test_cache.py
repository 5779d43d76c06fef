"""`crs cache`: showing and clearing the cache."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.toolchain import cache


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def test_the_cache_is_shown_and_cleared(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for number in range(3):
        cache.store(f"{number:032x}", bytes(2**19))
    assert main(["cache"]) == 0
    shown = f"folder   {folder}\nentries  3\nsize     1.5 MiB\nlimit    1 GiB\n"
    assert capsys.readouterr() == (shown, "")
    (folder / "notes.txt").write_text("not an entry")
    assert main(["cache", "clear"]) == 0
    assert capsys.readouterr() == ("3 entries removed, 1.5 MiB\n", "")
    assert [path.name for path in folder.iterdir()] == ["notes.txt"]


def test_a_missing_cache_folder_is_empty(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["cache"]) == main(["cache", "clear"]) == 0
    assert "entries  0\nsize     0 bytes\n" in capsys.readouterr().out
    assert not folder.exists()


def test_an_invalid_cache_limit_is_reported(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CRS_CACHE_SIZE", "much")
    assert main(["cache"]) == 0
    said = capsys.readouterr()
    assert "limit    1 GiB\n" in said.out
    assert said.err == "warning: CRS_CACHE_SIZE=much is not a size such as 500M or 2G\n"


def test_an_unused_cache_folder_is_reported(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder.mkdir()
    folder.chmod(0o777)
    assert main(["cache"]) == 0
    assert f"warning: {folder} is not used: " in capsys.readouterr().err


def test_a_cache_folder_that_is_a_file_is_a_system_error(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder.write_text("a file")
    assert main(["cache"]) == 1
    assert capsys.readouterr().err == f"crs: error: Not a directory: {folder}\n"


def test_an_entry_that_cannot_be_removed_does_not_block_the_others(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(3):
        cache.store(f"{number:032x}", bytes(10))
    unlink = Path.unlink

    def refuse(path: Path, **options: bool) -> None:
        if path.name.endswith("1"):
            raise PermissionError(1, "Operation not permitted")
        unlink(path, **options)

    monkeypatch.setattr(Path, "unlink", refuse)
    assert main(["cache", "clear"]) == 1
    said = capsys.readouterr()
    assert said.out.startswith("2 entries removed")
    assert (
        said.err == f"{folder / f'{1:032x}'}: error: cannot be removed: Operation not permitted\n"
    )
