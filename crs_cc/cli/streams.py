"""Set up our standard output and error, so that they exist and can encode every file name."""

from __future__ import annotations

import codecs
import contextlib
import io
import os
import sys
from typing import Final, TextIO

_ERRORS: Final = "crs.unencodable"


def prepare_streams() -> None:
    """Open streams that are closed, and make both encode any text.

    In an ASCII locale, text is written as UTF-8, as the programs' own output is.
    """
    codecs.register_error(_ERRORS, _as_bytes)
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: PTH123, SIM115 - for good
        elif isinstance(stream, io.TextIOWrapper):
            is_ascii = codecs.lookup(stream.encoding).name == "ascii"
            stream.reconfigure(encoding="utf-8" if is_ascii else None, errors=_ERRORS)


def mute(stream: TextIO) -> None:
    """Redirect a stream to /dev/null, so that the interpreter's final flush does not fail again."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _as_bytes(error: UnicodeError) -> tuple[str | bytes, int]:
    """Write undecodable bytes of a file name unchanged, and escape unencodable characters."""
    try:
        return codecs.lookup_error("surrogateescape")(error)
    except UnicodeEncodeError:
        return codecs.lookup_error("backslashreplace")(error)
