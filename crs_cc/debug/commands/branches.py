"""Commands for checkpoints and branches."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import parse_numbers, require_argument
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.stop_text import position_text
from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from crs_cc.debug.branches import Checkpoint


def _checkpoint(context: CommandContext, text: str) -> Answer:
    made = context.debugger.checkpoint(text)
    yield f"Checkpoint {made.number}: {_shown(made)}"


def _restart(context: CommandContext, text: str) -> Answer:
    numbers = parse_numbers(require_argument(text, "a checkpoint's number"))
    if len(numbers) != 1:
        raise DebugError("expected the number of one checkpoint")
    return context.move(partial(context.debugger.restart, numbers[0]))


def _info_checkpoints(context: CommandContext, _text: str) -> Answer:
    found = context.debugger.branches.current.checkpoints
    for each in found:
        yield f"{each.number:<3} {_shown(each)}"
    if not found:
        yield "No checkpoints."


def _branch(context: CommandContext, text: str) -> Answer:
    name = require_argument(text, "a branch name")
    context.debugger.branch(name)
    yield f"Switched to new branch '{name}'."


def _switch(context: CommandContext, text: str) -> Answer:
    return context.move(partial(context.debugger.switch, require_argument(text, "a branch name")))


def _compare(context: CommandContext, text: str) -> Answer:
    found = context.debugger.compare(require_argument(text, "a branch name"))
    timestep = context.debugger.position.timestep
    if not found:
        yield f"No differences at the start of timestep {timestep}."
        return
    yield f"At the start of timestep {timestep}, this branch | other branch:"
    for each in found:
        yield f"{each.robot} {each.name}: {each.here or 'nothing'} | {each.there or 'nothing'}"


def _info_branches(context: CommandContext, _text: str) -> Answer:
    branches = context.debugger.branches
    for name in branches.names():
        yield f"{'=>' if name == branches.current.name else '  '} {name}"


def _shown(made: Checkpoint) -> str:
    name = f"'{made.name}' " if made.name else ""
    return f"{name}at t = {made.time_s:.3f} s, {position_text(made.position)}"


BRANCHES: Final = Group(
    "branches",
    "Checkpoints, and alternative histories.",
    (
        Command(
            "checkpoint", "[NAME]", "Save the current position, so that you can return to it.",
            _checkpoint,
        ),
        Command(
            "restart", "N", "Return to a checkpoint.", _restart, completes="checkpoint",
        ),
        Command("info checkpoints", "", "List the checkpoints.", _info_checkpoints),
        Command(
            "branch", "NAME", "Start a new branch here, and keep the current one.",
            _branch,
            text="Later changes (to variables, to the world) belong to the new branch.",
        ),
        Command(
            "switch", "NAME", "Switch to another branch, at the position where you left it.",
            _switch,
            completes="branch",
        ),
        Command(
            "compare", "NAME", "Show how another branch differs from this one.", _compare,
            completes="branch",
        ),
        Command("info branches", "", "List the branches.", _info_branches),
    ),
)  # fmt: skip
