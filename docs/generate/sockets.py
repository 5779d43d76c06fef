"""The table of limits of `docs/sockets.md`."""

from __future__ import annotations

from crs_cc.session.network.sockets import (
    BUFFER,
    MAX_BACKLOG,
    MAX_DATAGRAM,
    MAX_SOCKETS,
)
from docs.generate import Fillers, table


def limits() -> str:
    """Return the table of limits."""
    rows = [
        ("sockets of a program", f"{MAX_SOCKETS}", "`EMFILE`"),
        ("connections queued at a listening socket", f"{MAX_BACKLOG}", "`ECONNREFUSED`"),
        ("bytes sent on a connection and not yet read", f"{BUFFER:,}", "`send` blocks"),
        ("bytes of a datagram", f"{MAX_DATAGRAM:,}", "`EMSGSIZE`"),
        ("bytes of datagrams waiting to be read", f"{BUFFER:,}", "further ones are lost"),
    ]
    return table(("quantity", "limit", "beyond it"), rows)


FILLERS: Fillers = {"limits": limits}
