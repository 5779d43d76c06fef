"""The rows of the control panel in the table of commands, see `commands`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.uploads import MAX_TEXT
from crs_cc.workbench import control, instruments
from crs_cc.workbench.command import Command

if TYPE_CHECKING:
    from crs_cc.workbench.context import Context


def _upload(screen: Context, name: str, text: str) -> dict[str, str]:
    screen.run.shell().debugger.run.uploads.add(name, text)
    return {"name": name}


def _traffic(screen: Context, since: int) -> dict[str, Any]:
    return screen.feed.messages.since(max(0, since))


PANEL: Final = (
    Command("edit", "Change the run, at the start of this timestep.", control.edit,
            {"text": str}, needs="change"),
    Command("upload", "Bring a C program to the run, for robots that join.", _upload,
            {"name": str, "text": str}, needs="debug", longest=MAX_TEXT, asks=True),
    Command("undo", "Take back a change, by its number, and all that followed.",
            control.revert, {"number": int}, needs="debug"),
    Command("switch", "Go to another branch of the run, by its name.", control.switch,
            {"name": str}, needs="debug"),
    Command("export", "Return what was changed, as a script or as XML.", control.export,
            {"form": str}, needs="change", controls=False, asks=True),
    Command("faults", "Return what of a robot can be degraded, and how.", control.form,
            {"robot": int}, needs="change", controls=False, asks=True),
    Command("rows", "Return rows of the table of robots.", instruments.rows, {"robots": str},
            needs="debug", controls=False, asks=True),
    Command("inspect", "Return what a robot's instruments show.", instruments.inspect,
            {"robot": int, "expressions": str}, needs="change", controls=False, asks=True),
    Command("history", "Return what is known of quantities of a robot over time.",
            instruments.history,
            {"robot": int, "expressions": str, "begin_s": float, "end_s": float, "count": int},
            controls=False, asks=True),
    Command("near", "Return close approaches, those of one robot first.",
            instruments.close_approaches, {"robot": int}, controls=False, asks=True),
    Command("traffic", "Return what became of messages, from a number on.", _traffic,
            {"since": int}, controls=False, at_once=True),
)  # fmt: skip
