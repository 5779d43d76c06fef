r"""Program output as events: whole lines, with the robot's name if there are several.

>>> import io
>>> from crs_cc.debug.dap.connection import Connection
>>> sink = io.BytesIO()
>>> output = OutputEvents(Connection(sink))
>>> output.begin(["left", "right"])
>>> output.write(1, 1, b"turn"); output.write(1, 1, b"ing\n"); output.flush()
>>> sink.getvalue().count(b"Content-Length"), b"[right] turning" in sink.getvalue()
(1, True)
"""

from __future__ import annotations

import codecs
from collections.abc import Sequence
from typing import Final

from crs_cc.debug.dap.connection import Connection

_MAX_LENGTH: Final = 4096  # of what is kept back until its line ends [characters]; chosen by us
_CATEGORIES: Final = {1: "stdout", 2: "stderr"}


class OutputEvents:
    """Sends the output of all programs to the client."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._names: Sequence[str] = ()
        self._decoders: dict[tuple[int, int], codecs.IncrementalDecoder] = {}
        self._begun: dict[tuple[int, int], str] = {}

    def begin(self, names: Sequence[str]) -> None:
        """Start the output of a new run with these robots."""
        self._names = names
        self._decoders.clear()
        self._begun.clear()

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Write output of a program."""
        which = robot, stream
        decoder = self._decoders.setdefault(which, codecs.getincrementaldecoder("utf-8")("replace"))
        text = self._begun.get(which, "") + decoder.decode(content)
        whole, newline, rest = text.rpartition("\n")
        if len(rest) > _MAX_LENGTH:
            whole, newline, rest = text, "", ""
        self._begun[which] = rest
        if whole or newline:
            self._send(which, whole + newline)

    def flush(self) -> None:
        """Send incomplete lines."""
        for which, text in self._begun.items():
            if text:
                self._send(which, text)
        self._begun.clear()

    def send_message(self, text: str, category: str = "console") -> None:
        """Send a message of the debugger."""
        self._connection.event("output", {"category": category, "output": f"{text}\n"})

    def _send(self, which: tuple[int, int], text: str) -> None:
        robot, stream = which
        if len(self._names) > 1:
            lines = text.splitlines(keepends=True)
            text = "".join(f"[{self._names[robot]}] {line}" for line in lines)
        category = _CATEGORIES.get(stream, "stdout")
        self._connection.event("output", {"category": category, "output": text})
