"""A robot's disk: file operations, limits and errors."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.session import files
from crs_cc.session.files import CREATE, DISK_BYTES, DISK_FILES, EXCLUSIVE, NAMELESS, TRUNCATE, Disk
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import empty_world
from tests.session.programs import HALL, build

NAME_MAX = 255  # as limits.h promises programs


def test_an_input_is_read_and_its_original_stays_as_it_is() -> None:
    content = b"map"
    disk, other = Disk({"a/map": content}), Disk({"a/map": content})
    number = disk.open(b"./a/../a//map", 0)
    assert disk.read(number, 1, 99) == b"ap"
    assert disk.outputs() == {}
    assert disk.write(number, 1, b"IN") == 3
    assert disk.outputs() == {b"a/map": b"mIN"}
    assert other.read(other.open(b"a/map", 0), 0, 9) == content == b"map"


@pytest.mark.parametrize(
    ("name", "flags", "error"),
    [
        (b"none", 0, files.ENOENT),
        (b"", CREATE, files.ENOENT),
        (b"/", 0, files.EISDIR),
        (b"..", CREATE, files.EISDIR),
        (b"a", CREATE, files.EISDIR),
        (b"a/map/x", CREATE, files.ENOTDIR),
        (b"a/map", CREATE | EXCLUSIVE, files.EEXIST),
        (b"x" * 256, CREATE, files.ENAMETOOLONG),
        (b"a\nb", CREATE, files.EINVAL),
        (b"a\x7fb", CREATE, files.EINVAL),
        (b"dev/ttyS0", CREATE, files.EACCES),
    ],
)
def test_a_name_that_cannot_be_opened_has_its_error(name: bytes, flags: int, error: int) -> None:
    assert Disk({"a/map": b""}).open(name, flags) == -error


def test_a_name_of_the_longest_length_is_a_name() -> None:
    disk, name = Disk({}), b"%s/%s" % (b"d" * NAME_MAX, b"f" * NAME_MAX)
    assert disk.write(disk.open(name, CREATE), 0, b"x") == 1
    assert disk.outputs() == {name: b"x"}
    assert Disk({"n" * NAME_MAX: b""}).open(b"n" * NAME_MAX, 0) > 0
    assert disk.open(b"f" * (NAME_MAX + 1), CREATE) == -files.ENAMETOOLONG


def test_no_path_escapes_the_disk() -> None:
    disk = Disk({})
    for name in (b"../../etc/passwd", b"/etc/passwd", b"etc/./x/../passwd/"):
        assert disk.write(disk.open(name, CREATE), -1, b"x") > 0
    assert disk.outputs() == {b"etc/passwd": b"xxx"}


def test_an_unlinked_file_exists_until_it_is_closed() -> None:
    disk = Disk({})
    for _ in range(3 * DISK_FILES):
        temporary, named = disk.open(b"", NAMELESS), disk.open(b"log", CREATE)
        disk.write(temporary, 0, b"x" * 50_000)
        assert disk.remove(b"log") == 0
        assert disk.write(named, 0, b"still") == 5
        assert disk.read(named, 0, 9) == b"still"
        assert disk.close(named) == disk.close(temporary) == 0
    assert disk.read(named, 0, 9) == -files.EBADF
    assert disk.outputs() == {}


def test_the_disk_is_bounded() -> None:
    disk = Disk({"input": b"z" * 100})
    big = disk.open(b"big", CREATE)
    assert disk.resize(big, DISK_BYTES) == DISK_BYTES
    assert disk.write(big, -1, b"x") == -files.ENOSPC
    assert disk.write(disk.open(b"input", 0), 0, b"x") == 1  # grows nothing
    assert disk.write(disk.open(b"more", CREATE), 2**31 - 1, b"x") == -files.ENOSPC
    assert disk.resize(big, 10) == 10
    assert disk.write(disk.open(b"more", CREATE), 0, b"x") == 1
    opened = [disk.open(b"n%d" % number, CREATE) for number in range(DISK_FILES)]
    assert opened[-1] == -files.ENFILE
    assert min(opened[: DISK_FILES - 10]) > 0


def test_invalid_descriptors_and_offsets_are_errors() -> None:
    disk = Disk({})
    number = disk.open(b"a", CREATE)
    assert disk.close(99) == disk.write(99, 0, b"") == disk.resize(-1, 0) == -files.EBADF
    assert disk.read(99, 0, 1) == -files.EBADF
    assert disk.read(number, -1, 1) == disk.write(number, -2, b"x") == -files.EINVAL
    assert disk.resize(number, -2) == -files.EINVAL
    assert disk.remove(b"b") == disk.rename(b"b", b"c") == -files.ENOENT


def test_renaming_replaces_an_existing_file() -> None:
    disk = Disk({"old": b"input"})
    disk.write(disk.open(b"new", CREATE), 0, b"new")
    disk.open(b"d/x", CREATE)
    assert disk.rename(b"new", b"d") == -files.EISDIR
    assert disk.rename(b"new", b"old/x") == -files.ENOTDIR
    assert disk.rename(b"new", b"new") == 0
    assert disk.rename(b"new", b"old") == 0
    assert disk.outputs() == {b"d/x": b"", b"old": b"new"}
    assert disk.rename(b"d/x", b"d/x/y") == 0  # nothing is in its way once it has moved
    assert sorted(disk.outputs()) == [b"d/x/y", b"old"]


def test_the_null_device_discards_writes_and_reads_nothing() -> None:
    disk = Disk({})
    number = disk.open(b"/dev/null", CREATE | TRUNCATE)
    assert disk.write(number, 0, b"gone") == 4
    assert disk.resize(number, 100) == 0
    assert disk.read(number, 0, 9) == b""
    assert disk.close(number) == disk.close(number) == 0
    assert disk.open(b"dev/null", 0) == number


def test_a_snapshot_restores_everything() -> None:
    disk = Disk({"in": b"input"})
    number = disk.open(b"out", CREATE)
    disk.write(number, 0, b"first")
    saved, state = disk.snapshot(), b"".join(disk.state())
    disk.write(number, 0, b"FIRST and more")
    disk.remove(b"in")
    disk.open(b"third", CREATE)
    assert b"".join(disk.state()) != state
    for _ in range(2):  # a snapshot can be used again, whatever happened since
        disk.restore(saved)
        assert b"".join(disk.state()) == state
        assert disk.outputs() == {b"out": b"first"}
        assert disk.read(disk.open(b"in", 0), 0, 9) == b"input"
        disk.write(number, 0, b"second")


WRITES = r"""
#include <stdio.h>
#include <unistd.h>
int main(int argc, char **argv)
{
    FILE *log = fopen("log.txt", "w"), *map = fopen("map.txt", "r");
    char line[80];
    int i;
    fgets(line, sizeof line, map);
    for (i = 0; i < 20; i++) {
        fprintf(log, "%d %s %s\n", i, argv[1], line);
        fflush(log);
        usleep(100000);
    }
    return fclose(log);
}
"""


def test_each_robot_has_its_own_files_and_they_are_part_of_the_state(tmp_path: Path) -> None:
    def session() -> Session:
        arguments = [("a", "left"), ("a", "right")]
        return Session(HALL, [program] * 2, arguments=arguments, files={"map.txt": b"room"})

    program = build(tmp_path, WRITES)
    whole = session()
    while whole.step():
        pass
    text = "".join(f"{i} left room\n" for i in range(20)).encode()
    assert whole.files(0) == {b"log.txt": text}
    assert whole.files(1) == {b"log.txt": text.replace(b"left", b"right")}

    begun, later = session(), session()
    for _ in range(7):
        begun.step()
    assert 0 < len(begun.files(0)[b"log.txt"]) < len(text)
    later.restore(begun.snapshot())
    while later.step():
        pass
    assert later.files(0) == whole.files(0)
    assert later.state_hash() == whole.state_hash()
    begun.step()
    assert begun.state_hash() != later.state_hash()


def test_files_are_part_of_the_state_hash(tmp_path: Path) -> None:
    source = '#include <fcntl.h>\nint main(void) { return write(creat("%s", 0), "x", 1) < 0; }'
    hashes = set()
    for name in ("first", "other"):
        session = Session(empty_world(), [build(tmp_path, source % name, f"{name}.c")])
        session.step()
        hashes.add(b"".join(session._host.disks[0].state()))
    assert len(hashes) == 2
