"""Conversion of file names, which are bytes to the system, from and to text.

Python decodes file names by the locale, and represents each undecodable byte by a lone surrogate
(PEP 383). So a name from a UTF-8 text differs from the same name given on the command line,
unless the locale is UTF-8; and surrogates cannot be encoded.
"""

from __future__ import annotations

import os


def from_text(name: str) -> str:
    """Return a file name from a UTF-8 text as it would be decoded by the locale.

    >>> from_text("room.xml")
    'room.xml'
    """
    try:
        return os.fsdecode(name.encode("utf-8", "surrogateescape"))
    except UnicodeEncodeError:  # a surrogate that encodes no byte: no file has this name
        return name


def displayed(name: str) -> str:
    r"""Return a file name, or a text with one, as valid Unicode; invalid bytes become U+FFFD.

    >>> displayed("h\udcc3\udca4llo.c"), displayed("h\udcff.c")
    ('hällo.c', 'h\ufffd.c')
    """
    try:
        content = name.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        content = name.encode("utf-8", "replace")
    return content.decode("utf-8", "replace")
