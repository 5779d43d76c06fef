"""Text without control characters: programs may write any bytes."""

from __future__ import annotations


def printable(text: str) -> str:
    r"""Return a line of text with visible control characters.

    >>> printable("a\x1b[31m\r")
    'a␛[31m␍'
    """
    return text if text.isprintable() else "".join(map(_picture, text))


def _picture(letter: str) -> str:
    if letter.isprintable():
        return letter
    if ord(letter) < 0x20:
        return chr(0x2400 + ord(letter))
    return "\N{REPLACEMENT CHARACTER}"
