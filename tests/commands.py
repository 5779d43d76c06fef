"""Commands as processes of their own: `crs`, and Python, by forks of one process that is ready.

What tests start by these command lines behaves as `python -m crs_cc` or `python` would, and is
ready five times sooner (`fork_server.py`); only its compiler is that of tests (`fast_settings.py`).
Tests of what a process is, how it starts, what it imports, or what it takes, start `sys.executable`
itself, and compile as for users. `pytest --real-processes` and `pytest --quick` have all do so.
"""

from __future__ import annotations

import os
import shlex
import socket
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from typing import Final

SERVER: Final = Path(__file__).with_name("fork_server.py")
CLIENT: Final = Path(__file__).with_name("fork_client.py")
FAST_SETTINGS: Final = Path(__file__).with_name("fast_settings.py")

_ENVIRONMENT: Final = dict(os.environ)
"""Before a test changes it."""


def _can_fork() -> bool:
    """Return whether this system has all that the server needs: Linux has."""
    try:
        os.close(os.pidfd_open(os.getpid()))
    except (AttributeError, OSError):
        return False
    return hasattr(os, "fork") and Path("/proc/self/ns/net").exists()


real = not _can_fork()
"""Whether all commands are processes of their own from the start."""


def python(*words: str | Path) -> list[str]:
    """Return the command line that has Python run `-m MODULE`, `-c CODE`, or a script."""
    before = [] if real else ["-I", "-S", str(CLIENT), server().address]
    return [sys.executable, *before, *map(str, words)]


def fast_module(*words: str) -> list[str]:
    """Return the command line of `python(..., "-m", MODULE)` that compiles with fast settings."""
    return python(*[FAST_SETTINGS if word == "-m" else word for word in words])


def crs(*words: str | Path) -> list[str]:
    """Return the command line that runs `crs` with these arguments."""
    return python("-m", "crs_cc", *words)


def real_crs(*words: str | Path) -> list[str]:
    """Return the command line that runs `crs` in a process of its own from the start."""
    return [sys.executable, "-m", "crs_cc", *map(str, words)]


def put_into(folder: Path, name: str = "crs", module: str = "crs_cc") -> None:
    """Write a command that runs a module into a folder, for shells that have it in `PATH`."""
    _write(folder / name, python("-m", module))


def python_in(folder: Path) -> str:
    """Write a command into a folder that does as `python` does; return it, for `sys.executable`."""
    return _write(folder / "python", python())


def _write(command: Path, words: list[str]) -> str:
    command.write_text(f'#!/bin/sh\nexec {shlex.join(words)} "$@"\n')
    command.chmod(0o700)
    return str(command)


def left_behind() -> str:
    """Return what a test has changed for good, because of which commands are no longer forks."""
    if real or not _servers:
        return ""
    if _servers[0].has_ended():
        _servers.clear()
        return "the process whose forks run commands has ended (workers share it)"
    now = _surroundings()
    changed = [f"{name}: {now[name]}" for name in now if now[name] != _servers[0].around[name]]
    _servers[0].around = now
    return ", ".join(changed)


def processor_s() -> float:
    """Return the processor time of all commands that forks have run to their ends [s].

    Those of other workers count as well, where workers share a server.
    """
    if not _servers:
        return 0.0
    user, system = map(int, _servers[0].status()[13:15])
    return (user + system) / os.sysconf("SC_CLK_TCK")


class Server:
    """A process whose forks run commands; it ends with the one that has started it.

    Attributes:
        address: where its socket is.
        process: its process id.
        around: this process's surroundings when last compared: commands that differ from the
            server in them are not its forks.
    """

    def __init__(self, address: str, process: int) -> None:
        self.address = address
        self.process = process
        self.around = _surroundings()

    def status(self) -> list[str]:
        """Return what the system says of it, from its state on: see `proc_pid_stat(5)`.

        Raises:
            OSError: it has ended and been reaped.
        """
        return Path(f"/proc/{self.process}/stat").read_text().rpartition(")")[2].split()

    def has_ended(self) -> bool:
        """Return whether it has ended."""
        try:
            return self.status()[0] == "Z"
        except OSError:
            return True


def start_server(cache: str | Path = os.devnull) -> Server:
    """Start a server, which ends with this process; it compiles into a cache what runs need."""
    address = str(Path(tempfile.mkdtemp(prefix="crs-tests-")) / "socket")
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(address)
        listener.listen()
        process = subprocess.Popen(
            [sys.executable, SERVER, str(listener.fileno()), cache],
            stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
            env=_ENVIRONMENT, cwd=SERVER.parent, pass_fds=[listener.fileno()],
            start_new_session=True,
        )  # fmt: skip
    _started.append(process)
    return Server(address, process.pid)


def _surroundings() -> dict[str, object]:
    from tests.fork_client import READ_AT_START, surroundings  # which imports what only Unix has

    read = {name: value for name, value in os.environ.items() if name.startswith(READ_AT_START)}
    read.setdefault("OPENBLAS_NUM_THREADS", "1")  # as `crs` sets it, where a test runs that itself
    return {**surroundings(), "environment": read}


_started: list[subprocess.Popen[bytes]] = []  # a server ends when its standard input is closed
_servers: list[Server] = []
_starting = threading.Lock()


def server(cache: str | Path = os.devnull) -> Server:
    """Return the server that this process uses: a shared one, or its own.

    Its own is started, with this cache, when it is first needed.
    """
    with _starting:
        if not _servers:
            _servers.append(start_server(cache))
    return _servers[0]


def share(address: str, process: int) -> None:
    """Use the server of another process."""
    _servers[:] = [Server(address, process)]
