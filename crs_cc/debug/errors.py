"""The error of the debugger."""

from __future__ import annotations


class DebugError(Exception):
    """An invalid request; the text is a one-line message for the user."""
