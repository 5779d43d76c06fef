"""What a user of the debugger can do wrong."""

from __future__ import annotations


class DebugError(Exception):
    """A wish that cannot be fulfilled; the text says why, in one line."""
