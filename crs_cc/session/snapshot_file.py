"""Snapshots of sessions in files.

A file has a magic number, a version, a checksum, and one zstd frame: the pages, each once, and then
the snapshot, which refers to them. It is made of tuples, dictionaries, arrays, plain values and the
dataclasses of a session's state. A reader makes nothing else of it: no code of the file runs, as it
could by unpickling, and no more memory is taken than the session may need.
"""

from __future__ import annotations

import hashlib
import json
import struct
from collections.abc import Hashable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any, Final, cast

import numpy as np
import zstandard

from crs_cc import __version__
from crs_cc.core.errors import RecordingError
from crs_cc.core.source import Location
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.snapshot import Snapshot as ProgramSnapshot
from crs_cc.session.files import DiskSnapshot, File
from crs_cc.session.network.sockets import Machine, NetworkState, Segment, Socket, Wait
from crs_cc.session.result import SessionSnapshot
from crs_cc.sim.engine.step import Served
from crs_cc.sim.engine.world_data import Snapshot as EnvironmentSnapshot
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.bodies import Bodies, PhysicsSnapshot, Pull, Ran
from crs_cc.sim.state.events import Event
from crs_cc.sim.state.holds import Holds
from crs_cc.sim.state.snapshot_codec import Packed

MAGIC: Final = b"crs snapshot\n\x1a\0\0"
VERSION: Final = 2
PAGE: Final = 4096
MAX_BASE_BYTES: Final = 512 * 2**20
MAX_ROBOT_BYTES: Final = 2 * 2**20
"""The maximum size of a snapshot in memory: a base, and an addition for each robot."""

_HEAD: Final = struct.Struct("<16sI32sQ")  # magic, version, SHA-256 and size of the content
_MAX_DEPTH: Final = 40
_LEVEL: Final = 3

_CONSTANTS: Final = {b"N": None, b"T": True, b"F": False}

_CLASSES: Final = (
    SessionSnapshot, EnvironmentSnapshot, PhysicsSnapshot, Bodies, Pull, Ran, Holds, Packed, Served,
    Event, ProgramSnapshot, DiskSnapshot, File, NetworkState, Socket, Segment, Wait, Machine,
)  # fmt: skip


def identity(world: WorldModel, seed: int, fleet: Fleet) -> dict[str, str]:
    """Return the properties that a session must share to continue from a snapshot."""
    programs = hashlib.sha256()
    for robot in range(len(fleet)):
        programs.update(hashlib.sha256(fleet.executable(robot).machine_code).digest())
    return {
        "version": __version__,
        "seed": str(seed),
        "world": hashlib.sha256(repr(world).encode()).hexdigest(),
        "programs": programs.hexdigest(),
    }


def write_snapshot(path: Path, snapshot: SessionSnapshot, identity: Mapping[str, str]) -> None:
    """Write a snapshot.

    Args:
        path: the file.
        snapshot: the snapshot, of a session to which no robots were added.
        identity: what the session must be that restores it.

    Raises:
        OSError: it cannot be written.
    """
    writer = _Writer()
    writer.put_text(json.dumps(dict(identity), sort_keys=True))
    writer.put(snapshot)
    pages = b"".join(writer.pages)
    content = struct.pack("<I", len(writer.pages)) + pages + bytes(writer.out)
    packed = zstandard.ZstdCompressor(level=_LEVEL).compress(content)
    head = _HEAD.pack(MAGIC, VERSION, hashlib.sha256(packed).digest(), len(content))
    path.write_bytes(head + packed)


def read_snapshot(
    path: Path, identity: Mapping[str, str], world: WorldModel, fresh: SessionSnapshot
) -> SessionSnapshot:
    """Return the snapshot in a file.

    Args:
        path: the file.
        identity: what the session is that is to restore it.
        world: its world.
        fresh: a snapshot of its start, which shows the classes that its state is made of.

    Raises:
        RecordingError: it is not a snapshot, or of another version or session.
        OSError: it cannot be read.
    """
    place = Location(str(path))
    most = MAX_BASE_BYTES + MAX_ROBOT_BYTES * len(fresh.programs)
    try:
        content = _content(path, most)
        reader = _Reader(content, world, _classes(fresh), most)
        found = json.loads(reader.text())
        wrong = [name for name, value in identity.items() if found.get(name) != value]
        if not wrong:
            return reader.snapshot()
    except (ValueError, KeyError, IndexError, TypeError, AttributeError, struct.error) as error:
        text = str(error) if isinstance(error, ValueError) else "its content is not valid"
        raise RecordingError.at(place, f"not a valid snapshot: {text[:200]}") from None
    except (zstandard.ZstdError, MemoryError, OverflowError, RecursionError):
        raise RecordingError.at(place, "not a valid snapshot: its content is not valid") from None
    text = f"the snapshot is of another session (different: {', '.join(wrong)})"
    raise RecordingError.at(place, text, "load it with the same world, programs, seed and version")


def unusable(path: Path) -> RecordingError:
    """Return the error for a snapshot whose values do not go together."""
    text = "not a valid snapshot: its values do not go together"
    return RecordingError.at(Location(str(path)), text)


def _content(path: Path, most: int) -> bytes:
    with path.open("rb") as file:
        head = file.read(_HEAD.size)
        if len(head) < _HEAD.size or not head.startswith(MAGIC):
            raise ValueError("it was not written by crs")
        _, version, checksum, size = _HEAD.unpack(head)
        if version != VERSION:
            raise ValueError(f"its version is {version} (this version reads {VERSION})")
        packed = file.read(most + 1)
    if size > most or len(packed) > most:
        raise ValueError("it is too large")
    if hashlib.sha256(packed).digest() != checksum:
        raise ValueError("it is damaged (wrong checksum)")
    source = zstandard.ZstdDecompressor(max_window_size=2**27).stream_reader(packed)
    content = source.read(size)
    if len(content) != size or source.read(1):
        raise ValueError("its size differs from the declared size")
    return content


class _Writer:
    def __init__(self) -> None:
        self.out = bytearray()
        self.pages: list[bytes] = []
        self._numbers: dict[bytes, int] = {}

    def put(self, value: Any) -> None:
        """Append a value, with a letter for its type."""
        match value:
            case None:
                self.out += b"N"
            case bool():
                self.out += b"T" if value else b"F"
            case int():
                self.out += b"I" + value.to_bytes(16, "little", signed=True)
            case float():
                self.out += b"D" + struct.pack("<d", value)
            case str():
                self.out += b"S"
                self.put_text(value)
            case bytes() | bytearray():
                self.out += b"B"
                self._put_bytes(bytes(value))
            case np.ndarray():
                self.out += b"A"
                self._put_dtype(value.dtype)
                self.put(value.shape)
                self._put_bytes(np.ascontiguousarray(value).tobytes())
            case np.dtype():
                self.out += b"Y"
                self._put_dtype(value)
            case np.generic():
                self.put(value.item())
            case _:
                self._put_parts(value)

    def put_text(self, text: str) -> None:
        data = text.encode("utf-8", "surrogatepass")
        self.out += struct.pack("<I", len(data)) + data

    def _put_parts(self, value: Any) -> None:
        if isinstance(value, WorldModel):
            self.out += b"W"
        elif isinstance(value, type):
            self.out += b"C"
            self.put_text(_name(value))
        elif isinstance(value, tuple | list):
            self.out += b"U" + struct.pack("<I", len(value))
            for part in value:
                self.put(part)
        elif isinstance(value, dict):
            self.out += b"M" + struct.pack("<I", len(value))
            for key, part in value.items():
                self.put(key)
                self.put(part)
        else:
            names = _names(type(value))
            if not names:
                raise TypeError(f"{type(value)} cannot be part of a snapshot")
            self.out += b"O"
            self.put_text(_name(type(value)))
            for name in names:
                self.put(getattr(value, name))

    def _put_dtype(self, dtype: np.dtype[Any]) -> None:
        shape = dtype.descr if dtype.names else dtype.str
        self.put_text(json.dumps(shape))

    def _put_bytes(self, data: bytes) -> None:
        """Append bytes; whole pages are numbers of pages, each of which is written once."""
        whole = len(data) // PAGE
        self.out += struct.pack("<Q", len(data))
        for number in range(whole):
            page = data[number * PAGE : (number + 1) * PAGE]
            place = self._numbers.setdefault(page, len(self.pages))
            if place == len(self.pages):
                self.pages.append(page)
            self.out += struct.pack("<I", place)
        self.out += data[whole * PAGE :]


class _Reader:
    def __init__(
        self, content: bytes, world: WorldModel, classes: Mapping[str, type], most: int
    ) -> None:
        (count,) = struct.unpack_from("<I", content)
        self.at = 4 + count * PAGE
        if self.at > len(content):
            raise ValueError("it has fewer pages than it declares")
        self._content = content
        self._world = world
        self._classes = classes
        self._left = most
        self._pages = count

    def snapshot(self) -> SessionSnapshot:
        """Return the snapshot, which ends the file."""
        found = self.value()
        if type(found) is not SessionSnapshot or self.at != len(self._content):
            raise ValueError("not a session snapshot")
        return found

    def value(self, depth: int = 0) -> Any:
        """Return the next value."""
        if depth > _MAX_DEPTH:
            raise ValueError("it is nested too deeply")
        kind = self._take(1)
        if kind in _CONSTANTS:
            return _CONSTANTS[kind]
        match kind:
            case b"I":
                return int.from_bytes(self._take(16), "little", signed=True)
            case b"D":
                return struct.unpack("<d", self._take(8))[0]
            case b"S":
                return self.text()
            case b"B":
                return self._bytes()
            case b"A":
                dtype, shape = self._dtype(), self.value(depth + 1)
                return np.frombuffer(self._bytes(), dtype).reshape(shape).copy()
            case b"Y":
                return self._dtype()
        return self._parts(kind, depth + 1)

    def text(self) -> str:
        """Return the next text."""
        (size,) = struct.unpack("<I", self._take(4))
        return self._take(size).decode("utf-8", "surrogatepass")

    def _parts(self, kind: bytes, depth: int) -> Any:
        if kind == b"W":
            return self._world
        if kind == b"C":
            return self._classes[self.text()]
        if kind == b"O":
            made = self._classes[self.text()]
            return made(*[self.value(depth) for _ in _names(made) or ()])
        (count,) = struct.unpack("<I", self._take(4))
        self._charge(count * 8)
        if kind == b"U":
            return tuple(self.value(depth) for _ in range(count))
        if kind == b"M":
            pairs = ((self.value(depth), self.value(depth)) for _ in range(count))
            return dict(pairs)
        raise ValueError("it has a value of an unknown kind")

    def _dtype(self) -> np.dtype[Any]:
        dtype = _as_dtype(json.loads(self.text()))
        if dtype.hasobject:
            raise ValueError("it has an array of objects")
        return dtype

    def _bytes(self) -> bytes:
        (size,) = struct.unpack("<Q", self._take(8))
        self._charge(size)
        whole = size // PAGE
        numbers = struct.unpack(f"<{whole}I", self._take(4 * whole))
        if numbers and max(numbers) >= self._pages:
            raise ValueError("it refers to a missing page")
        parts = [self._content[4 + n * PAGE : 4 + (n + 1) * PAGE] for n in numbers]
        return b"".join([*parts, self._take(size - whole * PAGE)])

    def _charge(self, size: int) -> None:
        self._left -= size
        if self._left < 0:
            raise ValueError("it requires more memory than its session")

    def _take(self, size: int) -> bytes:
        if size > len(self._content) - self.at:
            raise ValueError("it ends early")
        self.at += size
        return self._content[self.at - size : self.at]


def _as_dtype(shape: Any) -> np.dtype[Any]:
    """Return the dtype that `np.dtype.descr` describes, after it has been through JSON."""
    if isinstance(shape, str):
        return np.dtype(shape)
    parts = [(name, _as_dtype(kind), *map(tuple, counts)) for name, kind, *counts in shape]
    return np.dtype(parts)


def _classes(fresh: SessionSnapshot) -> dict[str, type]:
    """Return the classes that a snapshot may be made of, by name."""
    layout = fresh.environment.state.layout
    own = {part for part in layout if isinstance(part, type)}
    return {_name(each): each for each in (*_CLASSES, *own, *_classes_in(fresh))}


def _classes_in(value: Any) -> Iterator[type]:
    """Yield the dataclasses in a snapshot."""
    if isinstance(value, tuple):
        for part in value:
            yield from _classes_in(part)
    elif (names := _names(type(value))) and not isinstance(value, WorldModel):
        yield type(value)
        for name in names:
            yield from _classes_in(getattr(value, name))


def _name(kind: type) -> str:
    return f"{kind.__module__}.{kind.__qualname__}"


def _names(kind: type) -> tuple[str, ...] | None:
    """Return the names of the fields of a dataclass, None for any other class."""
    return _names_of(cast("Hashable", kind))


@cache
def _names_of(kind: Hashable) -> tuple[str, ...] | None:
    return tuple(each.name for each in fields(kind)) if is_dataclass(kind) else None
