"""Addresses of environments on the command line, and the tokens that go with them.

>>> parse_address("procyon:8000"), parse_address("[::1]:80"), parse_address(":8000")
(('procyon', 8000), ('::1', 80), ('127.0.0.1', 8000))
>>> is_net_address("a.c"), is_net_address("procyon:8000"), is_net_address("procyon:99999")
(False, True, False)
"""

from __future__ import annotations

import os
import re
from contextlib import AbstractContextManager, suppress
from typing import Final

import click

from crs_cc.cli.port_note import publish_note, read_note
from crs_cc.core.loopback import LOOPBACK

TOKEN_VARIABLE: Final = "CRS_TOKEN"  # noqa: S105 - the name of a variable

_ADDRESS: Final = re.compile(r"(\[[0-9a-fA-F:.]+\]|[A-Za-z0-9._-]*):(\d{1,5})")
_HOST: Final = re.compile(r"[A-Za-z0-9-]+(\.[A-Za-z0-9-]+)*")
_SERVED: Final = "served"


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
        raise click.BadParameter(f"'{word}' is not an address HOST:PORT{hint_of(word)}.")
    return found[1].strip("[]") or LOOPBACK, int(found[2])


def hint_of(word: str) -> str:
    """Return what to write in place of a host or a port alone.

    >>> hint_of("8000"), hint_of("procyon"), hint_of("a/b.c")
    ('; write :8000 for this machine', '; write procyon:8000 if it names no other port', '')
    """
    if word.isdecimal():
        return f"; write :{word} for this machine"
    return f"; write {word}:8000 if it names no other port" if _HOST.fullmatch(word) else ""


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
        return read_note(_SERVED, port)
    return ""


def publish_token(port: int, token: str) -> AbstractContextManager[None]:
    """Publish the token to hosts of this user on this machine inside a `with` block."""
    return publish_note(_SERVED, port, token)
