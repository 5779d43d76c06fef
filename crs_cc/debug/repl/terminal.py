r"""Output of the prompt: answers, optionally coloured, and the output of programs.

Both go to one stream in order. The output of a program starts on a new line, and so does an
answer; with several robots each of their lines begins with the robot's name.

>>> import io
>>> stream = io.BytesIO()
>>> terminal = Terminal(stream, ["left", "right"])
>>> for robot, piece in ((0, b"go"), (1, b"stop\n"), (0, b"ing\n"), (1, b"no end")):
...     terminal.program(robot, 1, piece)
>>> terminal.line(Line("Breakpoint 1"))
>>> print(stream.getvalue().decode(), end="")
[right] stop
[left] going
[right] no end
Breakpoint 1
"""

from __future__ import annotations

import io
import textwrap
from collections.abc import Callable, Sequence
from typing import BinaryIO, Final

from rich.console import Console
from rich.syntax import Syntax
from rich.text import Text

from crs_cc.core.file_names import displayed
from crs_cc.debug.commands.answer import Line, LineKind, SourceLine

_MAX_LINE_LENGTH: Final = 4096
_STYLES: Final[dict[LineKind, str]] = {
    "text": "", "stop": "bold yellow", "place": "cyan", "log": "green", "error": "bold red",
}  # fmt: skip
_THEME: Final = "ansi_dark"
_WIDTH: Final = 10_000
_MIN_COLUMNS: Final = 20
"""Narrower columns are not folded into."""
_BIDIRECTIONAL: Final = (*range(0x202A, 0x202F), *range(0x2066, 0x206A))
_CONTROLS: Final = dict.fromkeys(
    (*range(9), *range(10, 32), *range(127, 160), *_BIDIRECTIONAL), "?"
)


class Terminal:
    """A text stream."""

    def __init__(
        self,
        stream: BinaryIO,
        names: Sequence[str],
        *,
        is_coloured: bool = False,
        columns: Callable[[], int] | None = None,
    ) -> None:
        """Store where and how to write.

        Args:
            stream: the stream.
            names: the robots' names.
            is_coloured: whether to write colours.
            columns: returns the current width of the screen; None if the stream has none.
        """
        self._stream = stream
        self._names = names
        self._is_coloured = is_coloured
        self._columns = columns
        self._begun: dict[tuple[int, int], bytes] = {}
        self._at_start = True  # of a line

    def program(self, robot: int, stream: int, content: bytes) -> None:
        """Write output of a program: unchanged with one robot, else in whole lines."""
        if len(self._names) == 1:
            self._write(content)
            return
        *lines, rest = (self._begun.get((robot, stream), b"") + content).split(b"\n")
        while len(rest) >= _MAX_LINE_LENGTH:
            lines.append(rest[:_MAX_LINE_LENGTH])
            rest = rest[_MAX_LINE_LENGTH:]
        self._begun[robot, stream] = rest
        head = f"[{self._names[robot]}] ".encode()
        self._write(b"".join(head + line + b"\n" for line in lines))

    def line(self, line: Line | SourceLine) -> None:
        """Write a line of an answer."""
        self.finish_lines()
        lines: list[Line | SourceLine] = [line]
        if isinstance(line, Line) and line.indent and self._columns is not None:
            parts = folded(_clean(line.text), self._columns(), line.indent).split("\n")
            lines = [Line(each, line.kind) for each in parts]
        for each in lines:
            text = self._coloured(each) if self._is_coloured else _clean(each.text)
            self._write(text.encode(errors="replace") + b"\n")

    def finish_lines(self) -> None:
        """Complete lines of programs, and flush."""
        for (robot, _), rest in sorted(self._begun.items()):
            if rest:
                self._write(f"[{self._names[robot]}] ".encode() + rest + b"\n")
        self._begun.clear()
        if not self._at_start:
            self._write(b"\n")
        self._stream.flush()

    def broken(self) -> None:
        """Record that the cursor is not at the start of a line."""
        self._at_start = False

    def echo(self, prompt: str, line: str) -> None:
        """Write a line of a script as if typed."""
        self.finish_lines()
        self._write(f"{prompt}{_clean(line)}\n".encode(errors="replace"))

    def _write(self, content: bytes) -> None:
        if content:
            self._stream.write(content)
            self._at_start = content.endswith(b"\n")

    def _coloured(self, line: Line | SourceLine) -> str:
        if isinstance(line, Line):
            return _rendered(Text(_clean(line.text), style=_STYLES[line.kind]))
        text = Text()
        text.append(line.head, style="bold yellow" if line.is_current else "dim")
        code = Syntax("", "c", theme=_THEME, background_color="default")
        text.append(code.highlight(_clean(line.code)))
        text.rstrip()
        return _rendered(text)


def folded(text: str, columns: int, indent: int) -> str:
    """Return a line in lines that fit the screen, the others indented.

    >>> print(folded("@1   gap = 5   t = 1.000 s  gap = 2 + first", 30, 5))
    @1   gap = 5   t = 1.000 s
         gap = 2 + first
    """
    if not indent + _MIN_COLUMNS <= columns < len(text):
        return text
    lines = textwrap.wrap(
        text, columns, subsequent_indent=" " * indent, replace_whitespace=False,
        break_on_hyphens=False,
    )  # fmt: skip
    return "\n".join(lines)


def _clean(text: str) -> str:
    """Return a line without control characters."""
    return displayed(text).expandtabs().translate(_CONTROLS)


def _rendered(text: Text) -> str:
    console = Console(
        file=io.StringIO(), force_terminal=True, color_system="standard", width=_WIDTH,
        legacy_windows=False, no_color=False,
    )  # fmt: skip
    with console.capture() as captured:
        console.print(text, end="", soft_wrap=True)
    return captured.get()
