r"""The contents of messages between robots: recorded once, with the message that was sent.

>>> said = MessageContents()
>>> said.of({"sender": [2, 0], "number": [7, 1], "content": ["676f00", None]})
[b'go\x00', None]
>>> said.of({"sender": [2], "number": [7]})  # what became of it later
[b'go\x00']
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import repeat
from typing import Any, Final

MAX_KEPT: Final = 20_000
"""Messages on their way at most; chosen by us."""

_Message = tuple[int, int]  # its sender, and its number among those of the sender


class MessageContents:
    """The contents of the messages in a recording, in the order of its entries."""

    def __init__(self) -> None:
        """Create one that knows of none."""
        self._known: dict[_Message, bytes] = {}

    def of(self, entry: Mapping[str, Sequence[Any]]) -> list[bytes | None]:
        """Return the content of each message in an entry, None where it is not known.

        Raises:
            KeyError, TypeError, ValueError: the entry is not valid.
        """
        found = []
        given = entry.get("content", repeat(None))
        for sender, number, content in zip(entry["sender"], entry["number"], given, strict=False):
            key = int(sender), int(number)
            if content is not None:
                self._known[key] = bytes.fromhex(content)
            found.append(self._known.get(key))
        while len(self._known) > MAX_KEPT:
            del self._known[next(iter(self._known))]
        return found


def shown(content: bytes) -> str:
    r"""Return a message's content as people read it: text, with escapes for other bytes.

    >>> shown(b"go\x00\x01\xc3\xa4"), shown(b"hello\x00")
    ('go\\x00\\x01ä', 'hello')
    """
    text = content.rstrip(b"\0").decode("utf-8", "backslashreplace")
    return "".join(each if each.isprintable() else f"\\x{ord(each):02x}" for each in text)
