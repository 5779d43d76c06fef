"""Run a C program that needs only the library and a host, without a world."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.verify import verify
from crs_cc.requests import CODES, FAILED, RETURNED
from crs_cc.runtime.executable import Executable, make_executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.link import link
from crs_cc.session.host import HOST_CODES, Host, HostRequest
from crs_cc.session.library import library, library_options

FUEL = 1_000_000_000_000

Robot = Callable[[int, Any], None]
"""Answers a robot's request: its code and the message."""


@dataclass(slots=True)
class Outcome:
    """What a program did: what it wrote, its exit status, or the kind of error that stopped it."""

    out: bytes = b""
    err: bytes = b""
    status: int | None = None
    error: str = ""


def build(source: str) -> Executable:
    diagnostics = Diagnostics()
    unit = compile_text(source, "program.c", library_options(), diagnostics)
    verify(unit)
    return make_executable(link([unit], library(), diagnostics), "program.c")


def run(
    source: str,
    arguments: Sequence[str] = (),
    stdin: bytes = b"",
    robot: Robot | None = None,
) -> Outcome:
    """Compile a program and run it to its end; time advances only while it sleeps."""
    outcome = Outcome()
    rest = bytearray(stdin)
    streams = {1: bytearray(), 2: bytearray()}

    def write(_robot: int, stream: int, content: bytes) -> None:
        streams[stream] += content

    def read(_robot: int, wanted: int) -> bytes:
        piece = bytes(rest[:wanted])
        del rest[:wanted]
        return piece

    fleet = Fleet([build(source)])
    host = Host([["program.c", *arguments]], write, read)
    slot, clock_s = fleet.slots[0], 0.0
    while host.exit_status[0] is None and not outcome.error:
        slot["run"], slot["fuel"] = 1, FUEL
        fleet.run_round()
        code = int(slot["code"])
        if slot["status"] == FAILED:
            outcome.error = fleet.failure(0).kind
        elif slot["status"] == RETURNED:
            outcome.error = "returned"
        elif code == CODES["CLOCK"]:
            slot["message"]["f"][:2] = clock_s, clock_s / 2
        elif code == CODES["SLEEP"]:
            clock_s += float(slot["message"]["f"][0])
            slot["message"]["result"] = 0
        elif code in HOST_CODES:
            host.serve(code, HostRequest(0, slot["message"]))
        elif robot is not None:
            robot(code, slot["message"])
    outcome.out, outcome.err = bytes(streams[1]), bytes(streams[2])
    outcome.status = host.exit_status[0]
    return outcome
