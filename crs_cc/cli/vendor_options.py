"""The options of programs that are linked with the vendor's own client libraries."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import click


@dataclass(frozen=True, slots=True)
class VendorOptions:
    """How such programs reach their robots.

    Attributes:
        nserver: the port of the simulator's protocol, 0 for any that is free; None for none.
        terminals: the robots whose lines are pseudo terminals.
        tcp_robots: robots whose lines are TCP ports, and the ports.
        insecure: whether other machines may connect.
    """

    nserver: int | None = None
    terminals: tuple[str, ...] = ()
    tcp_robots: tuple[tuple[str, int], ...] = ()
    insecure: bool = False

    def __bool__(self) -> bool:
        """Return whether there are any."""
        return self.nserver is not None or bool(self.terminals or self.tcp_robots)


def _robot_ports(
    _ctx: click.Context, _option: click.Parameter, texts: tuple[str, ...]
) -> tuple[tuple[str, int], ...]:
    """Return robots and ports of `ROBOT=PORT` or, for the first robot, `PORT`."""
    found = []
    for text in texts:
        robot, _, port = text.rpartition("=")
        if not port.isdecimal() or int(port) > 65535:
            raise click.BadParameter(f"'{text}' is not [ROBOT=]PORT.")
        found.append((robot, int(port)))
    return tuple(found)


_OPTIONS: Final = (
    click.option(
        "--nserver", type=click.IntRange(0, 65535), metavar="PORT",
        help="Serve programs linked with the vendor's Nclient, as the vendor's Nserver does on "
        "port 7019: each program gets the robot whose number it names, or the next free one.",
    ),
    click.option(
        "--serial", "terminals", multiple=True, metavar="ROBOT",
        help="Create a pseudoterminal that serves as the serial line of ROBOT for a program "
        "linked with the vendor's Ndirect, and print its name; may be repeated.",
    ),
    click.option(
        "--tcp-robot", "tcp_robots", multiple=True, metavar="[ROBOT=]PORT", callback=_robot_ports,
        help="Like --serial, but over TCP, which Ndirect uses if its device is a host name; "
        "Ndirect connects to port 65001. ROBOT defaults to the first robot.",
    ),
)  # fmt: skip


def vendor_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add these options to a command, which receives them as `vendor`, and has an `insecure`."""

    @functools.wraps(command)
    def with_options(
        *args: Any,
        nserver: int | None,
        terminals: tuple[str, ...],
        tcp_robots: tuple[tuple[str, int], ...],
        insecure: bool,
        **others: Any,
    ) -> Any:
        vendor = VendorOptions(nserver, terminals, tcp_robots, insecure)
        return command(*args, vendor=vendor, insecure=insecure, **others)

    wrapped: Callable[..., Any] = with_options
    for option in reversed(_OPTIONS):
        wrapped = option(wrapped)
    return wrapped
