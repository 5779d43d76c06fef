"""Commands that change the world: those of `world.edits`."""

from __future__ import annotations

from functools import partial
from typing import Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.world.edits import EDITS


def _change(context: CommandContext, text: str, *, name: str) -> Answer:
    yield f"{context.debugger.edit_world(f'{name} {text}')}."


CHANGES: Final = Group(
    "changes",
    "Changes to the world, which start a new history.",
    tuple(
        Command(
            name, each.syntax, each.summary, partial(_change, name=name),
            text=each.text, completes="edit",
        )
        for name, each in EDITS.items()
    ),
)  # fmt: skip
