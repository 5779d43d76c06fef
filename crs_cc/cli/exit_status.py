"""The exit statuses of `crs` that do not belong to an error class (see `crs_cc.core.errors`)."""

from typing import Final

SYSTEM: Final = 1
"""A system error, such as a full disk."""
INTERRUPTED: Final = 130
"""Ctrl-C: 128 + SIGINT, the shells' convention."""
BROKEN_PIPE: Final = 141
"""Broken pipe: the reader closed the output. 128 + SIGPIPE."""
