r"""Changes that a user has made to a run, as data for the history and for recordings.

A change of a program is the bytes that it changed, whatever expression did it: expressions may use
what the user has printed before, which is no part of the run.

>>> patch = MemoryPatch(4096, b"\x07", b"\xff")
>>> change = Change(Position(3, 0, 1, 40), "speed = 7", 1, (patch,))
>>> change.as_data()["patches"]
[[4096, 'Bw==', '/w==']]
>>> Change.of(change.as_data()) == change
True
"""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, Self

import numpy as np

from crs_cc.core.arrays import ByteArray
from crs_cc.debug.timeline.position import Position

Data = Mapping[str, Any]

UNLINKED: Final = 0x9000_0000
"""The first address of objects that a program does not use, see `data.unused_objects`."""

STREAMS: Final = (1, 2)
"""The standard output and error."""


@dataclass(frozen=True, slots=True)
class MemoryPatch:
    """Bytes that a change has written.

    Attributes:
        address: the first one's.
        content: the bytes.
        states: their states in the shadow memory; empty if it did not change.
    """

    address: int
    content: bytes
    states: bytes = b""


@dataclass(frozen=True, slots=True)
class Change:
    """A change.

    Attributes:
        position: where the run was.
        text: what the user asked for: a change of the world, or an expression.
        robot: the robot whose program was changed; -1 for the world.
        patches: what was changed in the program's memory, in this order.
        program: name and source of a program that the user brought, for a robot that joins.
        printed: what functions of the program have printed that the user called: the stream and
            bytes of each piece.
    """

    position: Position
    text: str
    robot: int = -1
    patches: tuple[MemoryPatch, ...] = ()
    program: tuple[str, str] | None = None
    printed: tuple[tuple[int, bytes], ...] = ()

    def as_data(self) -> dict[str, Any]:
        """Return it as plain data."""
        place = self.position
        return {
            "kind": "change",
            "robot": self.robot,
            "text": self.text,
            "position": [place.timestep, place.round, place.robot, place.statements],
            "patches": [
                [each.address, _encoded(each.content), _encoded(each.states)]
                for each in self.patches
            ],
            **({} if self.program is None else {"program": list(self.program)}),
            **({"printed": _printed(self.printed)} if self.printed else {}),
        }

    @classmethod
    def of(cls, data: Data) -> Self:
        """Return it from plain data.

        Raises:
            ValueError: it is not valid.
            KeyError: something is missing.
            TypeError: something has another type.
        """
        timestep, round_, halted, statements = map(int, data["position"])
        if min(timestep, round_, statements, halted + 1) < 0:
            raise ValueError("a change has an invalid position")
        patches = tuple(
            MemoryPatch(int(address), _decoded(content), _decoded(states))
            for address, content, states in data["patches"]
        )
        place = Position(timestep, round_, halted, statements)
        name, text = data.get("program", ("", ""))
        program = (str(name), str(text)) if name else None
        printed = tuple((int(each), _decoded(content)) for each, content in data.get("printed", ()))
        if any(stream not in STREAMS for stream, _ in printed):
            raise ValueError("a change prints to an unknown stream")
        return cls(place, str(data["text"]), int(data["robot"]), patches, program, printed)


def write(patches: Sequence[MemoryPatch], memory: ByteArray, shadow: ByteArray) -> None:
    """Write patches to a program's memory and its shadow.

    Those of objects that the program does not use are in the history only.

    Raises:
        ValueError: they are not within it; nothing is written.
    """
    parts = [
        (where, each.address, np.frombuffer(content, np.uint8))
        for each in patches
        if each.address < UNLINKED
        for where, content in ((memory, each.content), (shadow, each.states))
        if content
    ]
    if any(not 0 <= at <= len(where) - len(content) for where, at, content in parts):
        raise ValueError("a change outside of the memory")
    for where, at, content in parts:
        where[at : at + len(content)] = content


def _printed(pieces: Sequence[tuple[int, bytes]]) -> list[list[int | str]]:
    return [[stream, _encoded(content)] for stream, content in pieces]


def _encoded(content: bytes) -> str:
    return b64encode(content).decode("ascii")


def _decoded(text: str) -> bytes:
    return b64decode(text, validate=True)
