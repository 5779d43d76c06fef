"""Access to a port: clients that know the token, and only one of them at a time.

Until a client has sent the token it may only `initialize`, which reveals nothing of the user's.
Most editors send nothing of their own but the attributes of `launch`, so the token is one of these.

>>> gate = Gate("a token nobody knows", threading.Lock())
>>> gate.admit(ClientRequest(1, "initialize", {})).command, gate.is_open
('initialize', False)
>>> launch = {"program": "wander.c", "token": "a token nobody knows"}
>>> gate.admit(ClientRequest(2, "launch", launch)).arguments, gate.is_open
({'program': 'wander.c'}, True)
"""

from __future__ import annotations

import threading
from dataclasses import replace
from typing import Any, Final

from crs_cc.core.loopback import is_token
from crs_cc.debug.dap.arguments import RefusalError
from crs_cc.debug.dap.inbox import ClientRequest

SEAT_S: Final = 5.0
"""How long a client waits for the previous one to end; chosen by us."""

_HARMLESS: Final = frozenset({"initialize", "disconnect"})


class Gate:
    """Admits the requests of one client.

    Attributes:
        is_open: whether the client has shown the token.
    """

    def __init__(self, token: str, seat: threading.Lock) -> None:
        self.is_open = False
        self._token = token
        self._seat = seat

    def admit(self, request: ClientRequest) -> ClientRequest:
        """Return a request without the token.

        Raises:
            RefusalError: the client has not shown the token, or another one is being served.
        """
        if self.is_open:
            return request
        arguments: dict[str, Any] = request.arguments if isinstance(request.arguments, dict) else {}
        if "token" in arguments:
            self._open(arguments["token"])
            rest = {name: value for name, value in arguments.items() if name != "token"}
            return replace(request, arguments=rest)
        if request.command not in _HARMLESS:
            raise RefusalError(
                "this server requires its token: set 'token' in the launch configuration to what"
                " 'crs debug --dap' has printed"
            )
        return request

    def _open(self, token: object) -> None:
        if not is_token(token, self._token):
            raise RefusalError("wrong token: 'crs debug --dap' prints a new one whenever it starts")
        if not self._seat.acquire(timeout=SEAT_S):
            raise RefusalError("another editor is being served: end its session first")
        self.is_open = True

    def close(self) -> None:
        """Make room for the next client."""
        if self.is_open:
            self._seat.release()
