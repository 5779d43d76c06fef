"""The interface between a control program and everything outside its memory.

A program has one operation on the world: fill in a message, post it with a request code, and
suspend. The runtime finds the message in the program's slot, overwrites it with the reply, and
resumes the program. All slots of a fleet are adjacent in one memory that C cannot address; `SLOT`
is their numpy dtype. `REQUESTS` lists every code; there is no other interface. `host` has those
that a program's host computer serves, `network` those about sockets, `robot` those for its robot,
`device` those of `crs.h`.

>>> import numpy as np
>>> slots = np.zeros(2, SLOT)                       # two robots
>>> slots["code"] = [CODES["VM"], CODES["WRITE"]]   # the requests
>>> slots["message"]["i"][0, :2] = 100, 80          # robot 0: 10 and 8 inches per second
>>> REQUESTS[slots["code"][0]].prototype
'int vm(int trans, int steer, int turret)'
"""

from __future__ import annotations

from typing import Final

from crs_cc.requests.device import DEVICE_REQUESTS, device_request
from crs_cc.requests.door import (
    DATA_SIZE,
    ERROR_KINDS,
    FAILED,
    LARGEST,
    MESSAGE,
    NUM_STATE,
    RETURNED,
    SLOT,
    SUSPENDED,
    SYSTEM_CALL,
    TIMING,
    slot_offset,
    timing_offset,
)
from crs_cc.requests.host import HOST_REQUESTS
from crs_cc.requests.network import NETWORK_REQUESTS
from crs_cc.requests.request import Field, Request
from crs_cc.requests.robot import ROBOT_REQUESTS

__all__ = [
    "CODES",
    "DATA_SIZE",
    "DEVICE_CODES",
    "ERROR_KINDS",
    "FAILED",
    "LARGEST",
    "MESSAGE",
    "NUM_STATE",
    "REGISTERED",
    "REQUESTS",
    "RETURNED",
    "SLOT",
    "SUSPENDED",
    "SYSTEM_CALL",
    "TIMING",
    "Field",
    "Request",
    "device_request",
    "register",
    "slot_offset",
    "timing_offset",
]

_TABLE: Final = (*HOST_REQUESTS, *NETWORK_REQUESTS, *ROBOT_REQUESTS, *DEVICE_REQUESTS)

REQUESTS: Final[dict[int, Request]] = {request.code: request for request in _TABLE}
"""Every request by its number."""

CODES: Final[dict[str, int]] = {request.name: request.code for request in _TABLE}
"""Request codes by name."""

DEVICE_CODES: Final = range(200, 512)
"""The codes of requests to devices of `crs.h`."""

REGISTERED: Final = DEVICE_CODES[100:]
"""The codes of requests whose devices do not fix them."""


def register(request: Request) -> None:
    """Add the request of a device to the tables."""
    assert request.code not in REQUESTS
    assert request.name not in CODES
    REQUESTS[request.code] = request
    CODES[request.name] = request.code
