"""All code that depends on the operating system.

Linux is where crs is developed and tested. Here is what macOS and Windows do not have: names that
`os` lacks there, modules that cannot be imported, files below `/proc`. Where a safeguard of Linux
is missing, the next best is used instead, see `docs/platforms.md`.
"""

from __future__ import annotations

import contextlib
import errno
import functools
import ntpath
import os
import stat
import struct
import sys
from collections.abc import Callable, Sequence
from pathlib import Path, PureWindowsPath
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    import socket

_NOFOLLOW: Final = getattr(os, "O_NOFOLLOW", 0)
_ALWAYS: Final = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
"""The flags of every opened file: do not wait for the writer of a pipe; no conversion of bytes."""

_HAS_FOLDERS: Final = os.open in os.supports_dir_fd and hasattr(os, "O_DIRECTORY")
_FOLDER: Final = os.O_RDONLY | getattr(os, "O_DIRECTORY", 0)
_NOT_IN_NAMES: Final = frozenset('\\:*?"<>|')  # Windows, "Naming Files, Paths, and Namespaces"
_WINDOWS_STACK: Final = 2_000_000
"""Of the main thread of python.exe [bytes]: `/STACK` in CPython's PCbuild/python.vcxproj."""

_MMAP_THRESHOLD: Final = -3, 8 * 2**20
_TRIM_THRESHOLD: Final = -1, 64 * 2**20
"""Parameters of glibc's `mallopt`, and what they are set to [bytes]: the least block that is mapped
by itself, and how much free memory at the end of the heap is kept."""

_TCP: Final = Path("/proc/net/tcp")
_TCP6: Final = Path("/proc/net/tcp6")
_MAPPED: Final = "0000000000000000FFFF0000"
"""Precedes an IPv4 address in the table of IPv6."""


def machine() -> str:
    """Return the kind of processor, such as `x86_64`."""
    if hasattr(os, "uname"):
        return os.uname().machine
    return os.environ.get("PROCESSOR_ARCHITECTURE", "")


def available_cores() -> int:
    """Return the number of processors that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class KeptProcessor:
    """Keeps a thread on its processor in a `with` block, in which it waits and does nothing else.

    Who is woken runs on whichever processor is idle just then, and finds its data in the caches of
    another one. For a thread that others wake as the last thing they do, that is wrong: its own
    processor is busy at this moment, and idle a few microseconds later. Threads and processes that
    are started in the block are kept, too, so none should be. Only Linux can do this.
    """

    __slots__ = ("_before",)

    def __enter__(self) -> None:
        self._before: set[int] | None = None
        if (current := _current_processor()) is not None:
            with contextlib.suppress(OSError):  # a sandbox forbids it
                before = os.sched_getaffinity(0)
                os.sched_setaffinity(0, (current(),))
                self._before = before

    def __exit__(self, *_: object) -> None:
        if self._before is not None:
            with contextlib.suppress(OSError):  # none of them may be used any more
                os.sched_setaffinity(0, self._before)


@functools.cache
def _current_processor() -> Callable[[], int] | None:
    """Return a function that returns the number of a thread's processor, if there is one."""
    import ctypes

    if not hasattr(os, "sched_setaffinity"):
        return None
    return getattr(ctypes.PyDLL(None), "sched_getcpu", None)  # of glibc and musl


def stack_bytes() -> int | None:
    """Return the size of the main thread's stack [bytes], None if it is unlimited."""
    try:
        import resource
    except ImportError:
        return _WINDOWS_STACK
    limit, _ = resource.getrlimit(resource.RLIMIT_STACK)
    return None if limit < 0 else limit


def keep_freed_memory() -> bool:
    """Have the C library keep freed memory; return whether it does.

    A timestep of many robots makes arrays of some 100 KiB and frees them. glibc would return such
    memory to the system, and each page of the next array would be a fault: up to half of the time
    of 1,000 robots, depending on which sizes happened to be freed first.
    """
    import ctypes

    try:
        mallopt = ctypes.CDLL(None).mallopt
    except (AttributeError, OSError, TypeError):
        return False
    return bool(mallopt(*_MMAP_THRESHOLD) and mallopt(*_TRIM_THRESHOLD))


def is_private(status: os.stat_result) -> bool:
    """Return whether a file or folder belongs to the user, and no other user can write to it.

    Windows has no such permissions; there, folders in a user's profile are private by default.
    """
    if not hasattr(os, "geteuid"):
        return True
    return status.st_uid == os.geteuid() and not status.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def open_page_map() -> int | None:
    """Return a descriptor of this process's page map, which `os.pread` reads; None if none."""
    if not hasattr(os, "pread"):
        return None
    with contextlib.suppress(OSError):
        return os.open("/proc/self/pagemap", os.O_RDONLY)
    return None


def is_of_another_user(client: socket.socket) -> bool:
    """Return whether a process of another user is at the other end of a connection.

    Args:
        client: a connection over IPv4 between two processes of this machine.

    Returns:
        False where the system does not say.
    """
    user = _user_of_peer(client) if hasattr(os, "geteuid") else None
    return user is not None and user != os.geteuid()


def _user_of_peer(client: socket.socket) -> int | None:
    """Return the user from Linux's tables (`networking/proc_net_tcp.rst` of its documentation)."""
    mine, theirs = _as_in_table(client.getsockname()), _as_in_table(client.getpeername())
    for table, prefix in ((_TCP, ""), (_TCP6, _MAPPED)):
        with contextlib.suppress(OSError), table.open(encoding="ascii") as lines:
            for line in lines:
                words = line.split()
                if words[1:3] == [prefix + theirs, prefix + mine]:
                    return int(words[7])
    return None


def _as_in_table(address: tuple[str, int]) -> str:
    host = int.from_bytes(bytes(map(int, address[0].split("."))), sys.byteorder)
    return f"{host:08X}:{address[1]:04X}"


def limit_waits(connection: Any, longest_s: float) -> None:
    """Limit how long each call for a connection waits.

    Where the system itself can do so, Python need not ask it before each call whether it would
    wait, which takes as long as the call: then a call that has waited so long raises
    BlockingIOError, elsewhere TimeoutError.

    Args:
        connection: a socket, or an object with its interface.
        longest_s: the limit [s].
    """
    import socket

    if sys.platform != "linux" or type(connection) is not socket.socket:
        connection.settimeout(longest_s)
        return
    seconds, part_s = divmod(longest_s, 1.0)
    limit = struct.pack("@ll", int(seconds), round(part_s * 1e6))  # timeval, see `socket(7)`
    connection.settimeout(None)
    for option in (socket.SO_RCVTIMEO, socket.SO_SNDTIMEO):
        connection.setsockopt(socket.SOL_SOCKET, option, limit)


def is_input_waiting() -> bool:
    """Return whether something has been typed at the terminal that is our standard input."""
    if sys.platform == "win32":
        import msvcrt

        return msvcrt.kbhit()
    import select

    return bool(select.select([sys.stdin], [], [], 0.0)[0])


def open_regular(path: Path, flags: int, *, follow: bool = True) -> int:
    """Return a descriptor of a regular file.

    Args:
        path: the file.
        flags: of `os.open`.
        follow: whether the last part of the path may be a link.

    Raises:
        OSError: it cannot be opened, or is a device, a pipe or a folder.
    """
    if not (_NOFOLLOW or follow):
        _reject_symlink(path)
    with contextlib.suppress(FileNotFoundError):
        _require_regular(path.stat())
    return _regular(os.open(path, flags | _ALWAYS | (0 if follow else _NOFOLLOW), 0o666))


def open_beneath(folder: Path, parts: Sequence[str], flags: int, *, make: bool = False) -> int:
    """Return a descriptor of a regular file below a folder, without following any link there.

    The path is opened part by part, so that concurrent changes of the folder cannot lead out
    of it. Where the system cannot do that, every part is looked at before the file is opened.

    Args:
        folder: the folder, which may be a link.
        parts: the path from there; no part is `..`.
        flags: of `os.open`.
        make: whether folders on the way are made.

    Raises:
        OSError: it cannot be opened; ELOOP, EMLINK or ENOTDIR if a part is a link.
    """
    if not _HAS_FOLDERS:
        return _open_checked(folder, parts, flags, make=make)
    with contextlib.ExitStack() as opened:
        place = os.open(folder, _FOLDER)
        opened.callback(os.close, place)
        for part in parts[:-1]:
            if make:
                with contextlib.suppress(FileExistsError):
                    os.mkdir(part, dir_fd=place)
            place = os.open(part, _FOLDER | _NOFOLLOW, dir_fd=place)
            opened.callback(os.close, place)
        return _regular(os.open(parts[-1], flags | _ALWAYS | _NOFOLLOW, 0o666, dir_fd=place))


def _open_checked(folder: Path, parts: Sequence[str], flags: int, *, make: bool) -> int:
    path = folder
    for part in parts:
        if not is_plain_file_name(part):
            raise OSError(errno.EINVAL, os.strerror(errno.EINVAL), part)
        if make and path != folder:
            path.mkdir(exist_ok=True)
        path /= part
        _reject_symlink(path)
    return open_regular(path, flags)


def is_plain_file_name(part: str) -> bool:
    """Return whether a part of a path without `/` names a file in its folder and nothing else."""
    return os.sep == "/" or _is_plain_on_windows(part)


def _is_plain_on_windows(part: str) -> bool:
    """Return whether Windows takes a name for that of a file in the folder.

    >>> [_is_plain_on_windows(part) for part in ("map.txt", "C:map", "nul.txt")]
    [True, False, False]
    """
    if sys.version_info >= (3, 13):
        reserved = ntpath.isreserved(part)
    else:
        reserved = PureWindowsPath(part).is_reserved()
    return not (reserved or _NOT_IN_NAMES & set(part))


def _reject_symlink(path: Path) -> None:
    is_junction = getattr(path, "is_junction", None)  # Python 3.12
    if path.is_symlink() or (is_junction is not None and is_junction()):
        raise OSError(errno.ELOOP, os.strerror(errno.ELOOP), str(path))


def _require_regular(status: os.stat_result) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, "not a regular file")


def _regular(descriptor: int) -> int:
    try:
        _require_regular(os.fstat(descriptor))
    except OSError:
        os.close(descriptor)
        raise
    return descriptor


def open_terminal() -> tuple[int, str, Callable[[], None]]:
    """Return a pseudo terminal: our end, the name of the other, and a function that closes both.

    Raises:
        OSError: the system has none.
    """
    try:
        import tty

        ours, theirs = os.openpty()
    except (ImportError, AttributeError):
        raise OSError(errno.ENOSYS, "this system has no pseudoterminals") from None
    tty.setraw(theirs)

    def close() -> None:
        os.close(ours)
        os.close(theirs)

    return ours, os.ttyname(theirs), close
