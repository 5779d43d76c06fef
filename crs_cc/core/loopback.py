"""What a server on this machine checks before it answers: tokens, hosts and origins.

A server listens on the loopback interface, so no other machine reaches it. But each user and each
web page on this machine does: hence a token that only the user knows, and the names of host and
origin, which a foreign page cannot choose (a name of its own that resolves to 127.0.0.1 stands in
`Host`: DNS rebinding).

>>> token = new_token()
>>> is_token(token, token), is_token("", token), is_token(token[:-1] + "é", token)
(True, False, False)
>>> is_own_host("127.0.0.1:8000", 8000), is_own_host("localhost:8000", 8000)
(True, True)
>>> is_own_host("evil.example:8000", 8000), is_own_host("127.0.0.1:9", 8000)
(False, False)
>>> is_own_origin("http://localhost:8000", 8000), is_own_origin("https://evil.example", 8000)
(True, False)
"""

from __future__ import annotations

import hmac
import secrets
from typing import Final

LOOPBACK: Final = "127.0.0.1"
"""The address that servers listen on."""

_NAMES: Final = (LOOPBACK, "localhost")


def new_token() -> str:
    """Return a token that nobody can guess, of letters, digits, `-` and `_`."""
    return secrets.token_urlsafe(16)


def is_token(given: str, token: str) -> bool:
    """Return whether a token is the right one, in a time that tells nothing of it."""
    return hmac.compare_digest(given.encode("utf-8", "replace"), token.encode())


def is_own_host(host: str, port: int) -> bool:
    """Return whether a request's `Host` names this server."""
    return host in {f"{name}:{port}" for name in _NAMES}


def is_own_origin(origin: str, port: int) -> bool:
    """Return whether a request's `Origin` is a page of this server."""
    scheme, _, host = origin.partition("://")
    return scheme == "http" and is_own_host(host, port)
