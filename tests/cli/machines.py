"""Machines with wires between them: network namespaces where that is allowed, else this one."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Final

_NAMED: Final = 'mount --bind "$0" /etc/hosts && exec "$@"'
"""A shell's script that gives a command names of hosts of its own."""


@dataclass(frozen=True, slots=True)
class Machine:
    """Somewhere to run commands.

    Attributes:
        prefix: what stands before a command.
        server: the name of the machine that the others reach.
    """

    prefix: tuple[str, ...]
    server: str


def _ip(*words: str) -> bool:
    return subprocess.run(["ip", *words], capture_output=True, check=False).returncode == 0


@cache
def has_namespaces() -> bool:
    """Return whether network namespaces can be made here."""
    name = f"crs-{os.getpid()}-probe"
    if shutil.which("ip") is None or not _ip("netns", "add", name):
        return False
    can_mount = _ip("netns", "exec", name, "sh", "-c", _NAMED, "/etc/hosts", "true")
    can_wire = _ip("-n", name, "link", "add", "wire0", "type", "veth", "peer", "name", "wire1")
    _ip("netns", "delete", name)
    return can_mount and can_wire


@contextmanager
def machines(folder: Path, server: str, count: int) -> Iterator[list[Machine]]:
    """Yield a machine with a name that a number of others know, and these.

    Args:
        folder: for files.
        server: the full name of the first machine.
        count: how many others there are, each with a wire to it.
    """
    if not has_namespaces():
        yield [Machine((), "127.0.0.1")] * (count + 1)
        return
    with ExitStack() as stack:
        spaces = [f"crs-{os.getpid()}-{number}" for number in range(count + 1)]
        for space in spaces:
            assert _ip("netns", "add", space)
            stack.callback(_ip, "netns", "delete", space)
            assert _ip("-n", space, "link", "set", "lo", "up")
        found = [_named(folder, spaces[0], "127.0.0.1", server)]
        for number, space in enumerate(spaces[1:], 1):
            network, wire = f"10.77.{number}", f"wire{number}"
            ends = ("link", "add", wire, "type", "veth", "peer", "name", wire, "netns", space)
            assert _ip("-n", spaces[0], *ends)
            for end, address in ((spaces[0], f"{network}.1/24"), (space, f"{network}.2/24")):
                assert _ip("-n", end, "address", "add", address, "dev", wire)
                assert _ip("-n", end, "link", "set", wire, "up")
            found.append(_named(folder, space, f"{network}.1", server))
        yield found


def _named(folder: Path, space: str, address: str, server: str) -> Machine:
    hosts = folder / f"{space}.hosts"
    hosts.write_text(f"127.0.0.1 localhost\n{address} {server}\n")
    return Machine(("ip", "netns", "exec", space, "sh", "-c", _NAMED, str(hosts)), server)


def free_port() -> int:
    """Return an unused port of this machine."""
    with socket.create_server(("127.0.0.1", 0)) as taken:
        return int(taken.getsockname()[1])
