r"""A robot's file system, in memory, never on the host's disk.

The program sees a disk of its own, with the user's input files. Paths are resolved here: `..`
stops at the disk's root, and folders exist if they contain files. Files have numbers like inodes,
and continue to exist without a name while they are open.

>>> disk = Disk({"maps/room.txt": b"4 4"})
>>> number = disk.open(b"/maps/../maps/room.txt", 0)
>>> disk.read(number, 2, 100)
b'4'
>>> log = disk.open(b"log", CREATE)
>>> disk.write(log, 0, b"bumped\n")
7
>>> disk.outputs()
{b'log': b'bumped\n'}
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Final

DISK_BYTES: Final = 16 * 2**20
"""The capacity for a program's own data [bytes]; chosen by us: the size of its memory."""

DISK_FILES: Final = 1000
"""The maximum number of a robot's files, not counting the user's."""

MAX_PART: Final = 255  # of a name, between two slashes; Linux's NAME_MAX [bytes]

CREATE, EXCLUSIVE, TRUNCATE, NAMELESS = 0o100, 0o200, 0o1000, 0o20000000
"""Flags of `Disk.open`, with the values of Linux's O_CREAT, O_EXCL, O_TRUNC and O_TMPFILE."""

ENOENT, EBADF, EACCES, EEXIST, ENOTDIR, EISDIR = 2, 9, 13, 17, 20, 21
EINVAL, ENFILE, ENOSPC, ENAMETOOLONG = 22, 23, 28, 36
"""Linux's error numbers, which the C library uses, whatever the host's are."""

_NULL_DEVICE: Final = 0
_MISSED: Final = 100


@dataclass(slots=True)
class File:
    """One file.

    Attributes:
        content: its bytes; immutable while a snapshot or another robot may share them.
        named: whether it has a name.
        uses: number of open descriptors.
        changed: whether the program created or changed it.
    """

    content: bytes | bytearray
    named: bool = True
    uses: int = 0
    changed: bool = False


@dataclass(frozen=True, slots=True)
class DiskSnapshot:
    """The state of a disk; see `Disk.snapshot`."""

    names: dict[bytes, int]
    files: dict[int, File]


class Disk:
    """The files of one robot. Failures return a negative error number, as in Linux.

    Attributes:
        missed: the first names that were opened and did not exist.
    """

    def __init__(self, inputs: Mapping[str, bytes]) -> None:
        """Store the user's files, by name."""
        self.missed: list[bytes] = []
        self._names: dict[bytes, int] = {}
        self._files: dict[int, File] = {_NULL_DEVICE: File(b"")}
        self._room = DISK_FILES + 1
        for name, content in inputs.items():
            self.put(name, content)

    def put(self, name: str, content: bytes) -> int:
        """Store a file of the user's; return 0 or a negative error number."""
        asked = name.encode("utf-8", "surrogateescape")
        path, number = normal(asked), len(self._files)
        failed = -EEXIST if path in self._names else self._creation_error(asked, path)
        if not failed:
            self._names[path] = number
            self._files[number] = File(content)
            self._room += 1
        return failed

    def open(self, name: bytes, flags: int) -> int:
        """Open a file, create or truncate it if the flags say so, and return its number."""
        if flags & NAMELESS:
            return self._create(None)
        path = normal(name)
        if path == b"dev/null":
            return _NULL_DEVICE
        number = self._names.get(path)
        if number is None:
            failed = self._creation_error(name, path)
            if failed or not flags & CREATE:
                if not failed and len(self.missed) < _MISSED and path not in self.missed:
                    self.missed.append(path)
                return failed or -ENOENT
            return self._create(path)
        if flags & CREATE and flags & EXCLUSIVE:
            return -EEXIST
        file = self._files[number]
        if flags & TRUNCATE:
            file.content, file.changed = bytearray(), True
        file.uses += 1
        return number

    def close(self, number: int) -> int:
        """Close a descriptor of a file; delete the file if it was the last and there is no name."""
        file = self._files.get(number)
        if file is None:
            return -EBADF
        file.uses -= 1
        self._forget(number)
        return 0

    def read(self, number: int, offset: int, wanted: int) -> bytes | int:
        """Read bytes at an offset; fewer than wanted at the end of the file."""
        file = self._files.get(number)
        if file is None or offset < 0 or wanted < 0:
            return -EBADF if file is None else -EINVAL
        return bytes(file.content[offset : offset + wanted])

    def write(self, number: int, offset: int, content: bytes) -> int:
        """Write at an offset, -1 for the end, and return the offset after the data."""
        file = self._files.get(number)
        if file is None or offset < -1:
            return -EBADF if file is None else -EINVAL
        if number == _NULL_DEVICE:
            return max(offset, 0) + len(content)
        offset = len(file.content) if offset < 0 else offset
        end = offset + len(content)
        failed = self.resize(number, max(len(file.content), end))
        if failed < 0:
            return failed
        mutable = _mutable(file)
        mutable[offset:end] = content
        return end

    def resize(self, number: int, size: int) -> int:
        """Truncate a file or extend it with zeros, unless size is -1, and return its size."""
        file = self._files.get(number)
        if file is None or size < -1:
            return -EBADF if file is None else -EINVAL
        now = len(file.content)
        if number == _NULL_DEVICE or size in (-1, now):
            return now
        if size > now and self._written_bytes() - (now if file.changed else 0) + size > DISK_BYTES:
            return -ENOSPC
        mutable = _mutable(file)
        if size < now:
            del mutable[size:]
        else:
            mutable.extend(bytes(size - now))
        return size

    def remove(self, name: bytes) -> int:
        """Remove a file's name."""
        path = normal(name)
        number = self._names.pop(path, None)
        if number is None:
            return self._creation_error(name, path) or -ENOENT
        self._files[number].named = False
        self._forget(number)
        return 0

    def rename(self, old: bytes, new: bytes) -> int:
        """Rename a file, replacing a file of the new name."""
        number, path = self._names.get(normal(old)), normal(new)
        if number is None:
            return self._creation_error(old, normal(old)) or -ENOENT
        if path == normal(old):
            return 0
        del self._names[normal(old)]
        failed = 0 if path in self._names else self._creation_error(new, path)
        if not failed and path in self._names:
            failed = self.remove(new)
        self._names[normal(old) if failed else path] = number
        if not failed:
            self._files[number].changed = True
        return failed

    def entry(self, name: bytes, index: int) -> bytes | int:
        """Return the name of a folder's entry, with a slash if it is a folder, empty at the end.

        Folders exist while they contain files, and the topmost one always exists.
        """
        path = normal(name)
        if path in self._names:
            return -ENOTDIR
        start = path + b"/" if path else b""
        inside = [each[len(start) :] for each in self._names if each.startswith(start)]
        if not inside and path:
            return -ENOENT
        entries = sorted({b"".join(each.partition(b"/")[:2]) for each in inside})
        return entries[index] if 0 <= index < len(entries) else b""

    def outputs(self) -> dict[bytes, bytes]:
        """Return the files that the program created or changed, sorted by name."""
        return {
            name: bytes(self._files[number].content)
            for name, number in sorted(self._names.items())
            if self._files[number].changed
        }

    def snapshot(self) -> DiskSnapshot:
        """Return the state of the disk; contents are shared until they are changed."""
        for file in self._files.values():
            file.content = bytes(file.content)
        return DiskSnapshot(dict(self._names), _copies(self._files))

    def restore(self, snapshot: DiskSnapshot) -> None:
        """Restore a snapshot."""
        self._names = dict(snapshot.names)
        self._files = _copies(snapshot.files)

    def state(self) -> Iterator[bytes]:
        """Yield the changes made by the program, to be hashed."""
        for name, number in sorted(self._names.items()):
            yield b"%d:%s;" % (number, name)
        for number, file in sorted(self._files.items()):
            if file.changed:
                yield b"%d:%d;" % (number, len(file.content)) + file.content

    def _create(self, path: bytes | None) -> int:
        if len(self._files) >= self._room:
            return -ENFILE
        number = next(number for number in range(self._room) if number not in self._files)
        self._files[number] = File(b"", path is not None, 1, changed=True)
        if path is not None:
            self._names[path] = number
        return number

    def _forget(self, number: int) -> None:
        file = self._files[number]
        if not file.named and file.uses <= 0:
            del self._files[number]

    def _creation_error(self, name: bytes, path: bytes) -> int:
        """Return the error number for creating a file of a name, 0 for none."""
        parts = path.split(b"/")
        if not name:
            return -ENOENT
        if not path or any(each.startswith(path + b"/") for each in self._names):
            return -EISDIR
        if any(b"/".join(parts[:count]) in self._names for count in range(1, len(parts))):
            return -ENOTDIR
        if any(len(part) > MAX_PART for part in parts):
            return -ENAMETOOLONG
        if min(path) < 32 or 127 in path:
            return -EINVAL
        return -EACCES if parts[0] == b"dev" else 0

    def _written_bytes(self) -> int:
        return sum(len(file.content) for file in self._files.values() if file.changed)


def normal(name: bytes) -> bytes:
    """Return the canonical form of a path: without outer slashes, `.` or `..`.

    >>> normal(b"/logs//./today/../run.txt"), normal(b"../../etc/passwd")
    (b'logs/run.txt', b'etc/passwd')
    """
    parts: list[bytes] = []
    for part in name.split(b"/"):
        if part == b"..":
            del parts[-1:]
        elif part not in (b"", b"."):
            parts.append(part)
    return b"/".join(parts)


def _mutable(file: File) -> bytearray:
    """Return a file's content as a mutable array that is not shared."""
    if isinstance(file.content, bytes):
        file.content = bytearray(file.content)
    file.changed = True
    return file.content


def _copies(files: Mapping[int, File]) -> dict[int, File]:
    return {number: replace(file) for number, file in files.items()}
