"""The cache is bounded: the least recently used entries are evicted, by any process."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from crs_cc.toolchain import cache, cache_size
from crs_cc.toolchain.cache_size import DEFAULT_LIMIT, StoreQuota, limit_bytes, stored_entries

SIZE = 1000  # of an entry's content [bytes]; pickled and with its digest it is a little more
STORES = """
import sys
from crs_cc.toolchain import cache
for number in range(100):
    cache.store(f"{int(sys.argv[1]) * 1000 + number:032x}", bytes(1000))
    cache.load(f"{number:032x}", bytes)
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of an empty cache with room for ten entries."""
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("CRS_CACHE_SIZE", str(11 * SIZE))
    monkeypatch.setattr(cache, "_quota", StoreQuota())
    return tmp_path / "cache"


def store(*numbers: int) -> None:
    for number in numbers:
        cache.store(f"{number:032x}", bytes(SIZE))


def is_stored(number: int) -> bool:
    return cache.load(f"{number:032x}", bytes) is not None


def kept(folder: Path) -> set[int]:
    return {int(entry.name, 16) for entry in stored_entries(folder)}


def age(folder: Path) -> None:
    """Make the entries an hour older: in a test everything happens at once."""
    for path in folder.iterdir():
        used_ns = path.stat().st_mtime_ns - 3600 * 10**9
        os.utime(path, ns=(used_ns, used_ns))


def test_the_cache_grew_without_end(folder: Path) -> None:
    store(*range(100))
    assert 99 in kept(folder)
    assert 5 * SIZE < sum(entry.size for entry in stored_entries(folder)) <= 11 * SIZE


def test_the_most_recently_used_entries_stay(folder: Path) -> None:
    store(*range(10))
    age(folder)
    assert is_stored(0)  # and so it is used
    age(folder)
    store(10, 11)
    assert {0, 10, 11} <= kept(folder)
    assert not {1, 2} & kept(folder)


def test_neither_a_hit_nor_most_stores_scan_the_folder(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CRS_CACHE_SIZE", str(1000 * SIZE))
    looks = []

    def counted(place: Path) -> list[cache_size.StoredEntry]:
        looks.append(place)
        return stored_entries(place)

    monkeypatch.setattr(cache_size, "stored_entries", counted)
    store(*range(50))
    assert all(map(is_stored, range(50)))
    assert looks == [folder]
    store(*range(50, 100))
    assert len(looks) == 2


def test_an_entry_larger_than_the_limit_does_not_empty_the_cache(folder: Path) -> None:
    store(1)
    cache.store("f" * 32, bytes(20 * SIZE))
    assert kept(folder) == {1}


def test_a_limit_of_0_keeps_nothing(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CRS_CACHE_SIZE", "0")
    store(1)
    assert kept(folder) == set()


def test_other_files_in_the_folder_are_left_alone(folder: Path) -> None:
    folder.mkdir(mode=0o700)
    (folder / "thesis.tex").write_bytes(bytes(50 * SIZE))
    (folder / ("e" * 32)).symlink_to(folder / "thesis.tex")
    store(*range(30))
    assert (folder / "thesis.tex").stat().st_size == 50 * SIZE
    assert (folder / ("e" * 32)).is_symlink()
    assert len(kept(folder)) > 5


def test_temporary_files_of_killed_processes_are_evicted(folder: Path) -> None:
    folder.mkdir(mode=0o700)
    (folder / "crs-abcd1234.tmp").write_bytes(bytes(5 * SIZE))
    age(folder)
    store(*range(10))
    assert not (folder / "crs-abcd1234.tmp").exists()


def test_processes_that_store_and_evict_at_once_do_not_disturb_each_other(folder: Path) -> None:
    running = [
        subprocess.Popen([sys.executable, "-c", STORES, str(number)], stderr=subprocess.PIPE)
        for number in range(3)
    ]
    assert [(each.communicate()[1], each.returncode) for each in running] == [(b"", 0)] * 3
    names = [entry.name for entry in stored_entries(folder)]
    assert all(cache.load(name, bytes) == bytes(SIZE) for name in names)
    # each process may store a sixteenth of the limit before it sees what the others have stored
    assert 0 < len(names) <= 10 + 3


def test_an_unreadable_cache_folder_is_harmless(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_path: object) -> None:
        raise OSError(errno.EACCES, "Permission denied")

    monkeypatch.setattr("os.scandir", refuse)
    store(1)
    assert not is_stored(1)


def test_a_read_only_cache_folder_still_gives_hits(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_path: object) -> None:
        raise OSError(errno.EROFS, "Read-only file system")

    store(1)
    monkeypatch.setattr("os.utime", refuse)
    assert is_stored(1)


@pytest.mark.parametrize(
    ("text", "size"),
    [("", DEFAULT_LIMIT), ("2G", 2 * 2**30), ("500 MiB", 500 * 2**20), ("1e9", DEFAULT_LIMIT)],
)
def test_the_limit_can_be_chosen(text: str, size: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CRS_CACHE_SIZE", text)
    assert limit_bytes() == size
