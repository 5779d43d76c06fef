"""The programs' output, kept for the results in JSON.

>>> kept = CapturedOutput(robots=1)
>>> kept.add(0, 1, b"hello")
>>> kept.fields(0)
{'stdout': 'hello', 'stderr': '', 'output_truncated': False}
"""

from __future__ import annotations

from typing import Any, Final

MAX_BYTES: Final = 16 * 2**20
"""Of all programs together; the rest is not kept."""


class CapturedOutput:
    """The output of all programs, by robot and stream."""

    def __init__(self, robots: int) -> None:
        self._streams: list[dict[int, bytearray]] = [
            {1: bytearray(), 2: bytearray()} for _ in range(robots)
        ]
        self._truncated = [False] * robots
        self._left = MAX_BYTES

    def add_robot(self) -> None:
        """Keep what one robot more prints, which has joined."""
        self._streams.append({1: bytearray(), 2: bytearray()})
        self._truncated.append(False)

    def add(self, robot: int, stream: int, content: bytes) -> None:
        """Keep a piece of output."""
        if len(content) > self._left:
            self._truncated[robot] = True
            content = content[: self._left]
        self._left -= len(content)
        self._streams[robot][stream] += content

    def fields(self, robot: int) -> dict[str, Any]:
        """Return the fields for a robot; bytes that are not UTF-8 are replaced."""
        out, err = (self._streams[robot][stream].decode("utf-8", "replace") for stream in (1, 2))
        return {"stdout": out, "stderr": err, "output_truncated": self._truncated[robot]}
