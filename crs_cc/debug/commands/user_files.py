"""The files that the debugger keeps for a user: settings, and the commands typed before.

They are in the folders of the XDG base directory specification. Nothing depends on them: a file
that cannot be read is empty, and one that cannot be written is left alone.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Final

_MAX_BYTES: Final = 4 << 20


def settings_file() -> Path | None:
    """Return the file of the settings; None without a home directory."""
    return _file("XDG_CONFIG_HOME", ".config", "debugger.conf")


def history_file() -> Path | None:
    """Return the file of the commands typed before; None without a home directory."""
    return _file("XDG_STATE_HOME", ".local/state", "debugger_history")


def _file(variable: str, default: str, name: str) -> Path | None:
    try:
        folder = os.environ.get(variable) or Path.home() / default
    except RuntimeError:  # no $HOME, and no passwd entry
        return None
    return Path(folder) / "crs_cc" / name


def read_lines(path: Path) -> list[str]:
    """Return the lines of a file that are not empty; none if it cannot be read."""
    try:
        with path.open("rb") as file:
            content = file.read(_MAX_BYTES)
    except OSError:
        return []
    return [line for line in content.decode(errors="replace").splitlines() if line.strip()]


def write_lines(path: Path, lines: Sequence[str]) -> None:
    """Write lines to a file in one step, if possible."""
    made = path.with_name(f"{path.name}.{os.getpid()}")
    with contextlib.suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        made.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
        made.replace(path)
