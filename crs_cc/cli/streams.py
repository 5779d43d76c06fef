"""Our standard output and standard error: there at all, and able to show every name of a file."""

from __future__ import annotations

import codecs
import contextlib
import io
import os
import sys
from typing import Final, TextIO

_ERRORS: Final = "crs.unencodable"


def prepare_streams() -> None:
    """Open streams that are closed, and let both write whatever a message may hold.

    Where the locale knows nothing but ASCII, text goes out as UTF-8, as the programs' own does.
    """
    codecs.register_error(_ERRORS, _as_bytes)
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w"))  # noqa: PTH123, SIM115 - for good
        elif isinstance(stream, io.TextIOWrapper):
            is_ascii = codecs.lookup(stream.encoding).name == "ascii"
            stream.reconfigure(encoding="utf-8" if is_ascii else None, errors=_ERRORS)


def mute(stream: TextIO) -> None:
    """Let the interpreter's own last flush of a stream go nowhere instead of failing again."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _as_bytes(error: UnicodeError) -> tuple[str | bytes, int]:
    """Write the bytes of a file's name as they are, and escape what the encoding lacks."""
    try:
        return codecs.lookup_error("surrogateescape")(error)
    except UnicodeEncodeError:
        return codecs.lookup_error("backslashreplace")(error)
