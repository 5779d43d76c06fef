"""Commands that query the recorded past without moving the run.

Each answer is a list of instants, numbered so that `goto @3` goes to the third.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from pathlib import PurePath
from typing import Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import require_argument, split_arguments
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext, ListedInstant
from crs_cc.debug.commands.log_text import log_text
from crs_cc.debug.commands.notes import NOTES
from crs_cc.debug.commands.stop_text import when_text
from crs_cc.debug.errors import DebugError
from crs_cc.debug.past import Instant, Past, Range
from crs_cc.debug.world.events import WorldEvent, check_event_kind

_RANGE: Final = re.compile(
    r"(?:^|\s)(?P<first>\d+(?:\.\d*)?|\.\d+|)\.\.(?P<last>\d+(?:\.\d*)?|\.\d+|)\s*$"
)
_PLACE: Final = re.compile(r"\sat\s+(?P<place>\S+)\s*$")
_CSV: Final = re.compile(r"/csv\b\s*")

MAX_ROWS: Final = 60
"""So many rows of a list are shown; `/csv` shows all."""
_COLUMNS: Final = 60
_BARS: Final = "▁▂▃▄▅▆▇█"


def past(context: CommandContext) -> Past:
    """Return the recorded past of the run."""
    return Past(context.debugger.view, context.debugger.stop_points)


def _when(context: CommandContext, text: str) -> Answer:
    if not text:
        yield when_text(context.debugger)
        return
    condition, part = _ranged(context, text)
    found = past(context).times(condition, part)
    if not found:
        raise DebugError(f"'{condition}' was never true in the recorded run")
    yield from _listed(context, found, [""] * len(found))


def _history(context: CommandContext, text: str) -> Answer:
    csv = _CSV.match(text)
    expression, part = _ranged(context, text[csv.end() :] if csv else text)
    found = past(context).values(expression, part)
    if csv:
        yield "time_s,value"
        for each in found:
            yield f"{each.time_s:.6f},{_field(each)}"
        return
    yield from _listed(context, found, [_shown_value(each) for each in found])
    end_s = part.end.timestep * context.debugger.session.environment.timestep_s
    yield from sparkline(found, end_s)


def _shown_value(one: Instant) -> str:
    """Return a value in a list: of a floating-point number as many digits as %g has."""
    return f"{one.number:g}" if isinstance(one.number, float) else one.text


def _field(one: Instant) -> str:
    """Return a value as a field of CSV (RFC 4180)."""
    if one.number is not None:
        return repr(one.number)
    return '"' + one.text.replace('"', '""') + '"'


def sparkline(found: Sequence[Instant], end_s: float) -> Answer:
    """Answer with a line that draws values over time, if they are numbers and differ.

    Each column shows the last value before its end, as values stay until they change.
    """
    numbers = [each.number for each in found]
    known = [each for each in numbers if each is not None and math.isfinite(each)]
    if len(set(known)) < 2:
        return
    low, high, start_s = min(known), max(known), found[0].time_s
    bars, at = "", 0
    for column in range(1, _COLUMNS + 1):
        until_s = start_s + (end_s - start_s) * column / _COLUMNS
        while at + 1 < len(found) and found[at + 1].time_s <= until_s:
            at += 1
        number = numbers[at]
        is_known = number is not None and math.isfinite(number)
        share = (number - low) / (high - low) if number is not None and is_known else 0.0
        bars += _BARS[round(share * (len(_BARS) - 1))] if is_known else " "
    yield f"{bars}  {low:g} to {high:g}, t = {start_s:.3f} to {end_s:.3f} s"


def log_past(context: CommandContext, text: str) -> Answer:
    """Answer with the past messages of a log point, among the world's events."""
    rest, part = _ranged(context, text)
    found = _PLACE.search(rest)
    if not found:
        raise DebugError('a location is missing: log "FORMAT",EXPRESSION... at LOCATION')
    literal, *expressions = split_arguments(rest[: found.start()])
    debugger = context.debugger
    place = debugger.stop_points.location(found["place"])
    said = past(context).messages(place, log_text(literal, expressions), part)
    events = [each for _, each in past(context).events("", part)]
    context.instants = _instants(said)
    rows: list[tuple[float, str]] = [
        (each.time_s, f"{_head(number, each)}  {each.text}") for number, each in enumerate(said, 1)
    ]
    rows += [(each.time_s, _event_row(each)) for each in events]
    yield from _shown([row for _, row in sorted(rows, key=lambda each: each[0])])


def _events(context: CommandContext, text: str) -> Answer:
    kind, part = _ranged(context, f" {text}") if text else ("", past(context).whole())
    found = past(context).events(check_event_kind(kind) if kind else "", part)
    if not found:
        raise DebugError("no such event in the recorded run")
    instants = [one for one, _ in found]
    yield from _listed(context, instants, [f"{each.kind}: {each.text}" for _, each in found])


def _event_row(event: WorldEvent) -> str:
    return f"{'':6} t = {event.time_s:8.3f} s  {event.kind}: {event.text}"


def _ranged(context: CommandContext, text: str) -> tuple[str, Range]:
    """Return an argument without the range of times at its end, and that range."""
    text = text if text.startswith(" ") else require_argument(text, "an expression")
    found = _RANGE.search(text)
    if found is None:
        return text.strip(), past(context).whole()
    try:
        first, last = (float(found[each]) if found[each] else None for each in ("first", "last"))
    except ValueError:
        raise DebugError(f"'{found[0].strip()}' is not a range of times (12..20.5)") from None
    return text[: found.start()].strip(), past(context).part(first, last)


def _instants(found: Sequence[Instant]) -> list[ListedInstant]:
    return [ListedInstant(each.position, each.robot, each.function) for each in found]


def _listed(context: CommandContext, found: Sequence[Instant], texts: Sequence[str]) -> Answer:
    """Answer with a numbered list of instants."""
    context.instants = _instants(found)
    pairs = enumerate(zip(found, texts, strict=True), 1)
    yield from _shown([f"{_head(number, each)}  {text}".rstrip() for number, (each, text) in pairs])


def _shown(rows: Sequence[str]) -> Answer:
    """Answer with rows, of many with the last ones."""
    if len(rows) > MAX_ROWS:
        yield f"({len(rows) - MAX_ROWS:,} earlier ones: give a range, such as 0..5)"
    yield from rows[-MAX_ROWS:]


def _head(number: int, one: Instant) -> str:
    place = one.location
    where = f"{PurePath(place.file).name}:{place.line}" if place else ""
    return f"{f'@{number}':<6} t = {one.time_s:8.3f} s  {where:<16}"


_RANGE_TEXT: Final = (
    "FROM..TO, in seconds, selects a part of the recorded run; the default is all of it. Each row "
    "has a"
    ' number: "goto @3" goes to the third.'
)

PAST: Final = Group(
    "queries",
    "Query the recorded run without changing the current position.",
    (
        Command(
            "when", "[CONDITION [FROM..TO]]",
            "Show the time, or list when a condition became true.", _when,
            text=f"CONDITION is as for \"watch\". {_RANGE_TEXT}", completes="expression",
        ),
        Command(
            "history", "[/csv] EXPRESSION [FROM..TO]",
            "List and plot the values that an expression has had.", _history,
            text=f"EXPRESSION is as for \"watch\". {_RANGE_TEXT} With /csv, print all the values "
            "in CSV format.",
            completes="expression",
        ),
        Command(
            "events", "[EVENT] [FROM..TO]",
            "List the events of the world: collisions, messages, ...", _events,
            text="EVENT is as for \"catch\"; the default is all events except ticks. "
            f"{_RANGE_TEXT}",
            completes="catch",
        ),
        *NOTES,
    ),
)  # fmt: skip
