"""Runs of this user that show themselves in the browser, by their ports: `crs view HOST:PORT`.

Whoever shows a run writes its address, which has its token, to a file that only the user can read.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Final

import click

from crs_cc.cli.net_address import TOKEN_VARIABLE, is_net_address
from crs_cc.core.loopback import LOOPBACK
from crs_cc.toolchain.cache import folder

_HERE: Final = re.compile(rf"(?:http://)?(?:{re.escape(LOOPBACK)}|localhost):(\d{{1,5}})(?:/.*)?")
_PRIVATE: Final = 0o600


def is_address(word: str) -> bool:
    """Return whether a word names a port, and no file.

    >>> is_address("127.0.0.1:8700"), is_address("http://localhost:87/#token=x"), is_address("a.c")
    (True, True, False)
    >>> is_address("procyon:8000"), is_address("https://procyon:8000")
    (True, True)
    >>> address_of("https://procyon:8000", "secret")
    'https://procyon:8000/#token=secret'
    """
    return _HERE.fullmatch(word) is not None or is_net_address(word.removeprefix("https://"))


def address_of(word: str, token: str | None = None) -> str:
    """Return the address of the run that is shown on a port.

    Args:
        word: the port, on this machine or another one.
        token: shows that we may look; by default that of a run of this user is found.

    Raises:
        click.UsageError: no run of this user is shown there, and there is no token.
    """
    if "#token=" in word:
        return word
    token = token or os.environ.get(TOKEN_VARIABLE, "")
    if token:
        scheme, _, rest = word.rpartition("://")
        return f"{scheme or 'http'}://{rest.partition('/')[0]}/#token={token}"
    found = _HERE.fullmatch(word)
    if found is None:
        raise click.UsageError(f"{word}: give --token, which crs serve has printed there.")
    try:
        return _file(int(found[1])).read_text("utf-8").strip()
    except OSError:
        text = f"no run of yours is shown on port {found[1]}: start one with crs run --view"
        raise click.UsageError(f"{text} {found[1]}.") from None


@contextmanager
def announced(port: int, address: str) -> Iterator[None]:
    """Let other commands of this user find the run at a port inside a `with` block.

    Args:
        port: where pages connect.
        address: the address of the page, with its token.
    """
    with suppress(OSError):  # then only those who see the address can connect
        path = _file(port)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, _PRIVATE)
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(address)
    try:
        yield
    finally:
        with suppress(OSError):
            _file(port).unlink(missing_ok=True)


def _file(port: int) -> Path:
    """Return the file of a port; raise OSError if this user has no folder for it."""
    place = folder()
    if place is None:
        raise OSError("no folder")
    return place / "shown" / str(port)
