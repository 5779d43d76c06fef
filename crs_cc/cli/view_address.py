"""Runs of this user that are served to the browser, by port: `crs view HOST:PORT`.

Whoever shows a run leaves its address, which has its token, in a note (`port_note`).
"""

from __future__ import annotations

import os
import re
from contextlib import AbstractContextManager
from typing import Final

import click

from crs_cc.cli.net_address import TOKEN_VARIABLE, is_net_address
from crs_cc.cli.port_note import publish_note, read_note
from crs_cc.core.loopback import LOOPBACK

_HERE: Final = re.compile(rf"(?:http://)?(?:{re.escape(LOOPBACK)}|localhost):(\d{{1,5}})(?:/.*)?")
_SHOWN: Final = "shown"


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
        return read_note(_SHOWN, int(found[1]))
    except OSError:
        text = f"no run of yours is shown on port {found[1]}: start one with crs run --view"
        raise click.UsageError(f"{text} {found[1]}.") from None


def announced(port: int, address: str) -> AbstractContextManager[None]:
    """Publish the address of the run to other commands of this user inside a `with` block.

    Args:
        port: where pages connect.
        address: the address of the page, with its token.
    """
    return publish_note(_SHOWN, port, address)
