"""Conditional groups of lines: `#if` to `#endif` (C17 6.10.1).

>>> from crs_cc.frontend.preprocess.source_text import Places
>>> from pathlib import Path
>>> reader = Reader(Places().add("a.c", ""), "a.c", Path("."))
>>> open_group(reader, "#if", 0, holds=False)
>>> reader.skipping
True
"""

from __future__ import annotations

from collections.abc import Callable

from crs_cc.frontend.preprocess.reader import Conditional, Reader
from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.source_text import Place


def open_group(reader: Reader, directive: str, place: Place, *, holds: bool) -> None:
    """Open a group, whose first part is used if its condition is true."""
    skipped = reader.skipping
    active = holds and not skipped
    reader.conditionals.append(Conditional(directive, place, active, skipped or active))


def start_elif(
    reader: Reader, directive: str, place: Place, report: Report, holds: Callable[[], bool]
) -> None:
    """Start the next part, as `#elif` does; the condition matters only if no part was used."""
    group = _innermost(reader, directive, place, report)
    if group is None:
        return
    if group.else_place is not None:
        report.error(place, f"'{directive}' after '#else'")
        report.note(group.else_place, "the '#else' is here")
    group.active = not group.done and holds()
    group.done = group.done or group.active


def start_else(reader: Reader, place: Place, report: Report) -> None:
    """Start the last part, as `#else` does."""
    group = _innermost(reader, "#else", place, report)
    if group is None:
        return
    if group.else_place is not None:
        report.error(place, f"a second '#else' for the '{group.directive}'")
        report.note(group.else_place, "the first is here")
    group.active = not group.done
    group.done = True
    group.else_place = place


def end_group(reader: Reader, place: Place, report: Report) -> None:
    """Close a group, as `#endif` does."""
    if _innermost(reader, "#endif", place, report) is not None:
        reader.conditionals.pop()


def close_all(reader: Reader, report: Report) -> None:
    """Report the groups that are open at the end of a file."""
    for group in reversed(reader.conditionals):
        report.error(group.place, f"unterminated '{group.directive}': missing '#endif'")


def _innermost(reader: Reader, directive: str, place: Place, report: Report) -> Conditional | None:
    if not reader.conditionals:
        report.error(place, f"'{directive}' without an '#if' before it")
        return None
    return reader.conditionals[-1]
