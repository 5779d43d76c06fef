"""Names of files, which are bytes to the system: between its form, texts, and what people see.

Python decodes the system's names by the locale, and keeps each byte that this cannot decode as a
lone surrogate. So a name from a UTF-8 text is another string than the same name from the command
line, unless the locale is one of UTF-8; and no encoding has a form for surrogates.
"""

from __future__ import annotations

import os


def from_text(name: str) -> str:
    """Return a file name that stands in a UTF-8 text as the system's own names are decoded.

    >>> from_text("room.xml")
    'room.xml'
    """
    try:
        return os.fsdecode(name.encode("utf-8", "surrogateescape"))
    except UnicodeEncodeError:  # a surrogate that stands for no byte: no file has this name
        return name


def displayed(name: str) -> str:
    r"""Return a file name, or a text with one, as UTF-8 has it; a byte outside of UTF-8 is U+FFFD.

    >>> displayed("h\udcc3\udca4llo.c"), displayed("h\udcff.c")
    ('hällo.c', 'h\ufffd.c')
    """
    try:
        content = name.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        content = name.encode("utf-8", "replace")
    return content.decode("utf-8", "replace")
