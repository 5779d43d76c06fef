"""The first messages of a connection: the identity of a host, and its program.

>>> hello = Hello("token", "host", ("robot0",), "digest")
>>> Hello.of(hello.content()) == hello
True
"""

from __future__ import annotations

import binascii
import hashlib
import json
import posixpath
from base64 import b64decode, b64encode
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from typing import Any, Final, Self

from crs_cc import __version__
from crs_cc.frontend.preprocess.options import DIALECTS, STANDARDS
from crs_cc.net.channel import PROTOCOL
from crs_cc.recording.source_tree import MAX_FILES
from crs_cc.session.device_library import device_sources
from crs_cc.sim.model.robot import RobotModel

MAX_NAMES: Final = 100_000
MAX_TEXT: Final = 4096


class RefusedError(Exception):
    """The environment rejects a host; the text is the reason."""


@dataclass(frozen=True, slots=True)
class Hello:
    """The identity of a host.

    Attributes:
        token: a token for the role `robot`.
        host: a random name, by which it is recognized when it reconnects.
        robots: the robots whose programs it runs; empty for all that have no host.
        program: the digest of its program, see `Program.digest`.
        definition: the definition that the robots must have, see `definition_of`; empty for any.
        devices: the digest of the devices' C libraries.
        ends: the addresses of its connection, see `local_socket.endpoints`; empty to stay on TCP.
        version: its version of crs.
        protocol: its protocol version.
    """

    token: str
    host: str
    robots: tuple[str, ...]
    program: str
    definition: str = ""
    devices: str = ""
    ends: str = ""
    version: str = __version__
    protocol: int = PROTOCOL

    def content(self) -> bytes:
        """Return it as a message."""
        return json.dumps(asdict(self)).encode()

    @classmethod
    def of(cls, content: bytes) -> Self:
        """Return the contents of a message.

        Raises:
            RefusedError: it is not valid, or of another version.
        """
        values = _object(content)
        for name, ours in (("protocol", PROTOCOL), ("version", __version__)):
            require_same(name, ours, values.get(name))
        return cls(**_checked(cls, values))


@dataclass(frozen=True, slots=True)
class Program:
    """A program and its options, as needed for a recording.

    Attributes:
        name: as the user named it.
        command: its `argv[0]`.
        arguments: the others.
        sources: the paths of its C files, with slashes from the root on.
        files: all files that it was compiled from, by path, as base 64.
        include_paths, defines, undefines, standard, dialect, checked, trap_overflow: see
            `recording.description.RunDescription`.
    """

    name: str
    command: str
    arguments: tuple[str, ...] = ()
    sources: tuple[str, ...] = ()
    files: Mapping[str, str] = ()  # type: ignore[assignment]
    include_paths: tuple[str, ...] = ()
    defines: tuple[str, ...] = ()
    undefines: tuple[str, ...] = ()
    standard: str = "gnu17"
    dialect: str = ""
    checked: bool = True
    trap_overflow: bool = False

    def content(self) -> bytes:
        """Return it as a message."""
        return json.dumps(asdict(self), sort_keys=True).encode()

    @property
    def digest(self) -> str:
        """Return a digest that does not depend on where the folder with all its files is.

        >>> one, other = (
        ...     Program("a.c", "a", sources=(f"/{at}/a.c",), files={f"/{at}/a.h": ""})
        ...     for at in ("home/ann", "tmp")
        ... )
        >>> one.digest == other.digest
        True
        """
        folders = *map(posixpath.dirname, (*self.sources, *self.files)), *self.include_paths
        root = posixpath.commonpath(folders)

        def moved(path: str) -> str:
            return posixpath.relpath(path, root)

        found = replace(
            self,
            sources=tuple(map(moved, self.sources)),
            files={moved(path): text for path, text in self.files.items()},
            include_paths=tuple(map(moved, self.include_paths)),
        )
        return digest_of(found.content())

    @property
    def contents(self) -> dict[str, bytes]:
        """The contents of its files, by path."""
        return {name: b64decode(text) for name, text in self.files.items()}

    @classmethod
    def of(cls, content: bytes, digest: str) -> Self:
        """Return the program in a message.

        Raises:
            RefusedError: it is invalid, or not the announced one.
        """
        program = cls(**_checked(cls, _object(content)))
        program.check()
        if program.digest != digest:
            raise RefusedError("the host sent a program other than the announced one")
        return program

    def check(self) -> None:
        """Check the parts of a remote program that the environment uses.

        Raises:
            RefusedError: it is invalid.
        """
        if self.dialect not in ("", *DIALECTS) or self.standard not in STANDARDS:
            raise RefusedError("the program has an unknown dialect or standard")
        paths = [*self.sources, *self.include_paths, *self.files]
        are_valid = all(each.startswith("/") and each.isprintable() for each in paths)
        if not (self.sources and are_valid):
            raise RefusedError("the program has a file without a valid path")
        try:
            for text in self.files.values():
                b64decode(text, validate=True)
        except binascii.Error:
            raise RefusedError("a file of the program is not valid base 64") from None


def require_same(name: str, ours: object, theirs: object) -> None:
    """Check that a property is the same on both sides.

    Raises:
        RefusedError: it is not.
    """
    if ours != theirs:
        shown = str(theirs)[:80]
        raise RefusedError(f"the environment has {name} {ours}, the host has {name} {shown}")


def definition_of(model: RobotModel) -> str:
    """Return the name of a robot definition and a digest of its contents."""
    return f"{model.name} {digest_of(repr(model).encode())[:12]}"


def devices_digest() -> str:
    """Return a digest of the C libraries of all devices that are installed."""
    return digest_of(device_sources().encode())[:12]


def digest_of(content: bytes) -> str:
    """Return the SHA-256 of a content as hexadecimal digits."""
    return hashlib.sha256(content).hexdigest()


def as_text(content: bytes) -> str:
    """Return the content of a file as base 64."""
    return b64encode(content).decode("ascii")


def _object(content: bytes) -> dict[str, Any]:
    try:
        values = json.loads(content)
    except (ValueError, RecursionError):
        values = None
    if not isinstance(values, dict):
        raise RefusedError("invalid message from the host")
    return values


def _checked(cls: type[Hello | Program], values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the values of all fields, each of its type."""
    made = {}
    for each in fields(cls):
        value = values.get(each.name)
        kind = str(each.type)
        if kind.startswith("tuple"):
            if not isinstance(value, list) or len(value) > MAX_NAMES:
                raise RefusedError(f"the host gives no valid {each.name}")
            value = tuple(value)
            is_valid = all(isinstance(one, str) and len(one) <= MAX_TEXT for one in value)
        elif kind.startswith("Mapping"):
            is_valid = isinstance(value, dict) and len(value) <= MAX_FILES
            is_valid = is_valid and all(isinstance(one, str) for one in (value or {}).values())
        else:
            is_valid = type(value).__name__ == kind
            is_valid = is_valid and (not isinstance(value, str) or len(value) <= MAX_TEXT)
        if not is_valid:
            raise RefusedError(f"the host gives no valid {each.name}")
        made[each.name] = value
    return made
