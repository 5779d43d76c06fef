"""Breakpoints, watchpoints and catchpoints as data, for recordings.

Their commands are not saved: opening another user's run would execute them.
"""

from __future__ import annotations

import contextlib
from pathlib import PurePath
from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.errors import DebugError
from crs_cc.debug.watch import KINDS

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from crs_cc.debug.breakpoints import Breakpoint
    from crs_cc.debug.stop_points import StopPoints

KIND: Final = "breakpoint"
"""What they are called among the input of a recording."""

MAX_KEPT: Final = 200
_MAX_TEXT: Final = 400


def saved_breakpoints(points: StopPoints) -> Iterator[dict[str, Any]]:
    """Yield the user's breakpoints as plain data."""
    for each in points.breakpoints:
        if each.number > 0 and not each.temporary:
            yield {
                "kind": KIND,
                "what": each.kind,
                "text": _place(each),
                "access": each.watch.watched.kind if each.watch else "",
                "condition": each.condition,
                "log": each.log,
                "ignore": each.ignore,
                "every": each.every,
                "robot": -1 if each.robot is None else each.robot,
                "enabled": each.enabled,
                **({} if each.stops_left is None else {"stops_left": each.stops_left}),
            }


def _place(each: Breakpoint) -> str:
    """Return its location: a line by the file name only, since the folder may change."""
    location = each.location.location if each.location else None
    is_line = location is not None and (each.text.isdecimal() or ":" in each.text)
    return f"{PurePath(location.file).name}:{location.line}" if location and is_line else each.text


def restore_breakpoints(points: StopPoints, kept: Iterable[Mapping[str, Any]], robots: int) -> None:
    """Set breakpoints from plain data; those that are not valid in this run are left out."""
    for data in list(kept)[:MAX_KEPT]:
        with contextlib.suppress(DebugError, TypeError, ValueError):
            _restore(points, data, robots)


def _restore(points: StopPoints, data: Mapping[str, Any], robots: int) -> None:
    text, robot = _text(data, "text"), int(data.get("robot", -1))
    if robot >= robots:
        return
    options: dict[str, Any] = {
        "condition": _text(data, "condition"),
        "robot": None if robot < 0 else robot,
        "ignore": max(0, int(data.get("ignore", 0))),
    }
    access = next((each for each in KINDS if each == data.get("access")), None)
    match data.get("what"):
        case "breakpoint":
            made = points.add_breakpoint(text, **options)
        case "watchpoint" if access is not None:
            made = points.add_watchpoint(text, access, **options)
        case "catchpoint":
            made = points.add_catchpoint(text, **options)
        case _:
            return
    made.log, made.enabled = _text(data, "log"), bool(data.get("enabled", True))
    made.stops_left = max(0, int(data["stops_left"])) if "stops_left" in data else None
    made.every = max(1, int(data.get("every", 1)))


def _text(data: Mapping[str, Any], name: str) -> str:
    """Return a text of one line."""
    return " ".join(str(data.get(name, ""))[:_MAX_TEXT].split("\n"))
