r"""Shorter escape sequences for styles: only changes are sent.

Rich resets each piece of text and sends its whole style again, in 24-bit colours some forty bytes a
piece. A terminal keeps a colour until it gets another one.

>>> shorter("\x1b[31;48;2;9;9;9mif\x1b[0m\x1b[1;32;48;2;9;9;9m (\x1b[0m\x1b[32;48;2;9;9;9mx\x1b[0m")
'\x1b[31;48;2;9;9;9mif\x1b[1;32m (\x1b[0;32;48;2;9;9;9mx\x1b[0m'
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from textual.driver import Driver

_STYLE: Final = re.compile(r"\x1b\[([\d;]*)m")
_LAST_ATTRIBUTE: Final = 29
_DEFAULT_FOREGROUND, _DEFAULT_BACKGROUND = 39, 49
_BRIGHT, _BRIGHT_BACKGROUND = 90, 100
_NEUTRAL: Final = re.compile(r"(?:\x1b\[[\d;]*H|\x1b\[\?[\d;]*[hl]|[\r\n])*")
"""Moves and modes, which are the same in each style."""


@dataclass(frozen=True, slots=True)
class _Style:
    """A style in which a terminal shows text; empty for its defaults."""

    foreground: str = ""
    background: str = ""
    attributes: frozenset[str] = frozenset()

    def after(self, codes: str) -> _Style:
        """Return the style after a sequence of codes."""
        foreground, background, attributes = self.foreground, self.background, self.attributes
        for code in _codes(codes):
            number = int(code.partition(";")[0] or 0)
            if number == 0:
                foreground, background, attributes = "", "", frozenset()
            elif number <= _LAST_ATTRIBUTE:
                attributes |= {code}
            elif number <= _DEFAULT_FOREGROUND or _BRIGHT <= number < _BRIGHT_BACKGROUND:
                foreground = "" if number == _DEFAULT_FOREGROUND else code
            else:
                background = "" if number == _DEFAULT_BACKGROUND else code
        return _Style(foreground, background, attributes)

    def from_(self, other: _Style) -> str:
        """Return the shortest codes that lead from another style to this one."""
        colours = (
            (self.foreground, other.foreground, "39"),
            (self.background, other.background, "49"),
        )
        changes = [now or default for now, before, default in colours if now != before]
        restated = ["0", *sorted(self.attributes), *(now for now, _, _ in colours if now)]
        if self == _Style() or not other.attributes <= self.attributes:
            return ";".join(restated)
        more = ";".join([*sorted(self.attributes - other.attributes), *changes])
        return min(more, ";".join(restated), key=len)


def _codes(text: str) -> Iterator[str]:
    """Return the codes of a sequence, each with the colour that belongs to it."""
    parts = text.split(";")
    while parts:
        count = 1
        if parts[0] in {"38", "48"}:  # a colour by red, green and blue, or by its number
            count = 5 if parts[1:2] == ["2"] else 3
        yield ";".join(parts[:count])
        del parts[:count]


def shorter(content: str) -> str:
    """Return an equivalent text for a terminal, with shorter style sequences.

    Args:
        content: text and escape sequences; the style is the default one before and after it.
    """
    pieces = _STYLE.split(content)
    sent, wanted, found = _Style(), _Style(), [pieces[0]]
    for codes, text in zip(pieces[1::2], pieces[2::2], strict=True):
        wanted = wanted.after(codes)
        if wanted != sent and not _NEUTRAL.fullmatch(text):
            found.append(f"\x1b[{wanted.from_(sent)}m")
            sent = wanted
        found.append(text)
    return "".join([*found, "\x1b[0m"] if sent != _Style() else found)


def short_driver(driver: type[Driver]) -> type[Driver]:
    """Return a driver of Textual's that writes shorter styles to a terminal.

    That of Windows stays as it is: there, Textual cuts what is written anywhere.
    """
    if driver.__module__ != "textual.drivers.linux_driver":
        return driver

    class ShortDriver(driver):  # type: ignore[valid-type, misc]
        """The driver."""

        def write(self, data: str) -> None:
            """Write to the terminal."""
            super().write(shorter(data))

    return ShortDriver
