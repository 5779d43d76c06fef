"""A limit for the memory of a process."""

from __future__ import annotations

from pathlib import Path
from typing import Final

_STATM: Final = Path("/proc/self/statm")
_DATA: Final = 5
"""The field with the pages of data, which is what RLIMIT_DATA limits (proc(5))."""


def limit_memory(most: int | None) -> None:
    """Limit the memory that this process may use in addition; None for no limit. Linux only.

    What running programs can use is limited anyway, see `runtime.layout` and `session.files`.
    """
    try:
        import resource
    except ImportError:  # Unix only
        return
    if not _STATM.exists():
        return
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    wanted = hard
    if most is not None:
        used = int(_STATM.read_text().split()[_DATA]) * resource.getpagesize()
        wanted = used + most if hard < 0 else min(used + most, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (wanted, hard))
