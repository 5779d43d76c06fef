"""Replacements and hints for headers that do not exist.

>>> hint_for_missing("fstream", [])
'this is C++, but crs compiles C'
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from itertools import islice
from pathlib import Path
from typing import Final

from crs_cc.frontend.other_language_hint import CPLUSPLUS

_GUARD: Final = "put the code that needs it between '#ifndef __CRS__' and '#endif'"
_NETWORK: Final = f"control programs cannot use the network: {_GUARD}"
_PROCESSES: Final = f"control programs are single processes: {_GUARD}"
_TERMINAL: Final = f"control programs have no terminal or display: {_GUARD}"
_DEVICES: Final = f"control programs have no devices but their robot: {_GUARD}"
_DOS: Final = f"it is a header of DOS or Windows: {_GUARD}"


def _all(names: str, hint: str) -> dict[str, str]:
    return dict.fromkeys(names.split(), hint)


_HINTS: Final = {
    **_all("net/if.h rpc/rpc.h netinet/ip.h", _NETWORK),
    **_all("sys/ipc.h sys/shm.h sys/sem.h sys/msg.h", _PROCESSES),
    **_all("sys/ptrace.h semaphore.h threads.h spawn.h dlfcn.h", _PROCESSES),
    **_all("curses.h ncurses.h term.h", _TERMINAL),
    **_all("readline/readline.h", _TERMINAL),
    **_all("X11/Xlib.h X11/Xutil.h X11/Xos.h X11/Intrinsic.h GL/gl.h GL/glut.h", _TERMINAL),
    **_all("asm/io.h sys/io.h linux/serial.h linux/joystick.h linux/videodev.h", _DEVICES),
    **_all("conio.h dos.h bios.h io.h windows.h winsock.h winsock2.h", _DOS),
    **_all("iostream iostream.h fstream string vector map cstdio cstdlib cmath", CPLUSPLUS),
    **_all(
        "ucontext.h sys/ucontext.h",
        "getcontext, makecontext and swapcontext are not supported: setjmp and longjmp are,"
        " within one stack",
    ),
}

_MAX_LISTED: Final = 1000
_VENDORS: Final = "nclient.h"


def bundled_header(name: str, folders: Sequence[Path]) -> str:
    """Return the name of the bundled header that an unknown header name means.

    Programs for other systems use other letter case, and include the standard headers and the
    vendor's by the path of their installation.

    Args:
        name: the name between the quotes or angle brackets.
        folders: the directories of our own headers.

    Returns:
        The name, "" if there is none.
    """
    wanted = Path(name.replace("\\", "/").lower().removeprefix("/usr/include/"))
    if wanted.name == _VENDORS:
        wanted = Path(_VENDORS)
    if wanted.is_absolute() or ".." in wanted.parts:
        return ""
    for folder in folders:
        for each in _names_in(folder / wanted.parent):
            if each.lower() == wanted.name:
                return str(wanted.with_name(each))
    return ""


def hint_for_missing(name: str, folders: Sequence[Path]) -> str:
    """Return a hint for a header that is not in any of the directories, "" if there is none."""
    if name in _HINTS:
        return _HINTS[name]
    wanted = Path(name)
    for folder in folders:
        names = {each.lower(): each for each in _names_in(folder / wanted.parent)}
        close = difflib.get_close_matches(wanted.name.lower(), names, n=1, cutoff=0.8)
        if close:
            return f"did you mean '{wanted.with_name(names[close[0]])}'?"
    return ""


def _names_in(folder: Path) -> list[str]:
    try:
        return sorted(each.name for each in islice(folder.iterdir(), _MAX_LISTED))
    except (OSError, ValueError):
        return []
