"""The options that connect a run to the real network."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final

import click


@dataclass(frozen=True, slots=True)
class ReachableMachine:
    """A computer of the real network that programs can reach.

    Attributes:
        name: its name in the run.
        port: its port in the run.
        host: its name or address in the real network.
        real_port: its port there.
    """

    name: str
    port: int
    host: str
    real_port: int


@dataclass(frozen=True, slots=True)
class Forward:
    """A port of this machine that is forwarded to a robot.

    Attributes:
        port: the port, here and there.
        robot: the robot's name; empty for the first one of the world.
    """

    port: int
    robot: str = ""


_MACHINE: Final = re.compile(
    r"([\w.-]{1,60})(?::(\d{1,5}))?=(\[[^\]]+\]|[^:\[\]]+):(\d{1,5})", re.ASCII
)
_FORWARD: Final = re.compile(r"(\d{1,5})(?::([\w.-]+))?", re.ASCII)


def _port(text: str) -> int:
    port = int(text)
    if not 0 < port <= 0xFFFF:
        raise click.BadParameter(f"{port} is not a port (1 to 65535).")
    return port


def _machines(
    _ctx: click.Context, _option: click.Parameter, texts: Sequence[str]
) -> tuple[ReachableMachine, ...]:
    found = []
    for text in texts:
        match = _MACHINE.fullmatch(text)
        if match is None:
            raise click.BadParameter(f"'{text}' is not NAME=HOST:PORT or NAME:PORT=HOST:PORT.")
        name, port, host, real_port = match.groups()
        found.append(
            ReachableMachine(name, _port(port or real_port), host.strip("[]"), _port(real_port))
        )
    return tuple(found)


def _forwards(
    _ctx: click.Context, _option: click.Parameter, texts: Sequence[str]
) -> tuple[Forward, ...]:
    found = []
    for text in texts:
        match = _FORWARD.fullmatch(text)
        if match is None:
            raise click.BadParameter(f"'{text}' is not PORT or PORT:ROBOT.")
        found.append(Forward(_port(match[1]), match[2] or ""))
    return tuple(found)


_OPTIONS: Final = (
    click.option(
        "--connect", "machines", multiple=True, metavar="NAME[:PORT]=HOST:PORT", callback=_machines,
        help="When a program connects to NAME[:PORT], forward the connection to HOST:PORT on the "
        "real network; may be repeated. See docs/sockets.md.",
    ),
    click.option(
        "--forward", "forwards", multiple=True, metavar="PORT[:ROBOT]", callback=_forwards,
        help="Accept connections on port PORT on this machine and forward them to the same port on "
        "ROBOT (default: the first robot); may be repeated. With this option or --connect, "
        "--speed defaults to 1.",
    ),
)  # fmt: skip


def network_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add these options to a command, which receives `machines` and `forwards`."""
    for option in reversed(_OPTIONS):
        command = option(command)
    return command
