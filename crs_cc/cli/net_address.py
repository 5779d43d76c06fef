"""Addresses of environments on the command line, and the tokens that go with them.

>>> parse_address("procyon:8000"), parse_address("[::1]:80"), parse_address(":8000")
(('procyon', 8000), ('::1', 80), ('127.0.0.1', 8000))
>>> is_net_address("a.c"), is_net_address("procyon:8000"), is_net_address("procyon:99999")
(False, True, False)
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Final

import click

from crs_cc.core.loopback import LOOPBACK
from crs_cc.toolchain.cache import folder

TOKEN_VARIABLE: Final = "CRS_TOKEN"  # noqa: S105 - the name of a variable

_ADDRESS: Final = re.compile(r"(\[[0-9a-fA-F:.]+\]|[A-Za-z0-9._-]*):(\d{1,5})")
_PRIVATE: Final = 0o600


def is_net_address(word: str) -> bool:
    """Return whether a word is the address of an environment."""
    found = _ADDRESS.fullmatch(word)
    return found is not None and int(found[2]) < 65536


def parse_address(word: str) -> tuple[str, int]:
    """Return host and port; without a host it is this machine.

    Raises:
        click.BadParameter: it is no address.
    """
    found = _ADDRESS.fullmatch(word)
    if found is None or int(found[2]) > 65535:
        raise click.BadParameter(f"'{word}' is not an address HOST:PORT.")
    return found[1].strip("[]") or LOOPBACK, int(found[2])


def shown_address(address: tuple[str, int]) -> str:
    """Return an address as it is written.

    >>> shown_address(("::1", 80))
    '[::1]:80'
    """
    host, port = address
    return f"[{host}]:{port}" if ":" in host else f"{host}:{port}"


def token_for(given: str | None, port: int) -> str:
    """Return the token of a host: the given one, else the user's, else that of a run found here.

    Args:
        given: on the command line.
        port: the environment's.
    """
    known = given or os.environ.get(TOKEN_VARIABLE, "")
    if known:
        return known
    with suppress(OSError):
        return _file(port).read_text("utf-8").strip()
    return ""


@contextmanager
def token_left(port: int, token: str) -> Iterator[None]:
    """Let hosts of this user on this machine find the token inside a `with` block."""
    with suppress(OSError):  # then it must be given
        path = _file(port)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, _PRIVATE)
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(token)
    try:
        yield
    finally:
        with suppress(OSError):
            _file(port).unlink(missing_ok=True)


def _file(port: int) -> Path:
    place = folder()
    if place is None:
        raise OSError("no folder")
    return place / "served" / str(port)
