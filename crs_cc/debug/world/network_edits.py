"""Changes to the network of a run: events of the real network, or made in its place."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.core.suggest import unknown
from crs_cc.debug.world.edit import Words, find_robot
from crs_cc.session.network import outside

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable
    from crs_cc.session.session import Session

_SYNTAX: Final = "reach NAME PORT|call ROBOT PORT|N accept|N refuse|N send TEXT|N end|N reset"

_HELP: Final = (
    "'reach' lets programs connect to a port of a computer that is not in the world; 'call' "
    "connects to a robot's port. Connections are numbered from 0, including those that programs "
    "open, which wait until they are accepted or refused. In TEXT, each of the escapes \\n, \\r, "
    "\\t and \\xNN stands for one byte."
)

NETWORK_HELP: Final = (
    _SYNTAX,
    "Act as the real network: call a robot's port, send, accept, end.",
    _HELP,
)
"""Syntax, summary and further help."""

_ACTIONS: Final = ("accept", "refuse", "send", "end", "reset")


def change_network(session: Session, _programs: Sequence[Executable], words: Words) -> str:
    """Act as the real network; return a description.

    Raises:
        ValueError: it is invalid or impossible.
    """
    if len(words) == 3 and words[0] == "reach":
        outside.add_machine(session.network.network, words[1], _number(words[2]))
        return f"programs can reach {words[1]}:{words[2]}"
    if len(words) == 3 and words[0] == "call":
        return _call(session, words[1], _number(words[2]))
    if len(words) < 2 or not words[0].isdecimal():
        raise ValueError(f"expected: network {_SYNTAX}")
    if words[1] not in _ACTIONS:
        raise ValueError(unknown("action", words[1], _ACTIONS))
    return _act(session, _number(words[0]), words[1], " ".join(words[2:]))


def _call(session: Session, name: str, port: int) -> str:
    robot = find_robot(session.environment, name)
    row = session.environment.world.robots.index(robot)
    number = outside.open_connection(session.network.network, row, port, session.time_s)
    return f"connection {number} to {name}:{port} begins"


def _act(session: Session, number: int, action: str, text: str) -> str:
    network, at_s = session.network.network, session.time_s
    if (action == "send") != bool(text):
        raise ValueError(f"expected: network {_SYNTAX}")
    if action == "send":
        content = outside.unescaped(text)
        outside.send(network, number, content, at_s)
        return f"connection {number} sends {len(content)} bytes"
    if action in ("accept", "refuse"):
        outside.answer(network, number, at_s, accepted=action == "accept")
    else:
        outside.close(network, number, at_s, at_once=action == "reset")
    return f"connection {number}: {action}"


def _number(text: str) -> int:
    if not text.isdecimal() or len(text) > 9:
        raise ValueError(f"{text[:60]!r} is not a number")
    return int(text)
