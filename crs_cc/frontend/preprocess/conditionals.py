"""Conditional groups of lines: `#if` to `#endif` (C17 6.10.1).

>>> from crs_cc.frontend.preprocess.source_text import SourceMap
>>> from pathlib import Path
>>> reader = Reader(SourceMap().add("a.c", ""), "a.c", Path("."))
>>> open_group(reader, "#if", 0, holds=False)
>>> reader.skipping
True
"""

from __future__ import annotations

from collections.abc import Callable

from crs_cc.frontend.preprocess.reader import Conditional, Reader
from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.source_text import Position


def open_group(reader: Reader, directive: str, position: Position, *, holds: bool) -> None:
    """Open a group, whose first part is used if its condition is true."""
    skipped = reader.skipping
    active = holds and not skipped
    reader.conditionals.append(Conditional(directive, position, active, skipped or active))


def start_elif(
    reader: Reader, directive: str, position: Position, report: Report, holds: Callable[[], bool]
) -> None:
    """Start the next part, as `#elif` does; the condition matters only if no part was used."""
    group = _innermost(reader, directive, position, report)
    if group is None:
        return
    if group.else_position is not None:
        report.error(position, f"'{directive}' after '#else'")
        report.note(group.else_position, "the '#else' is here")
    group.active = not group.done and holds()
    group.done = group.done or group.active


def start_else(reader: Reader, position: Position, report: Report) -> None:
    """Start the last part, as `#else` does."""
    group = _innermost(reader, "#else", position, report)
    if group is None:
        return
    if group.else_position is not None:
        report.error(position, f"a second '#else' for the '{group.directive}'")
        report.note(group.else_position, "the first is here")
    group.active = not group.done
    group.done = True
    group.else_position = position


def end_group(reader: Reader, position: Position, report: Report) -> None:
    """Close a group, as `#endif` does."""
    if _innermost(reader, "#endif", position, report) is not None:
        reader.conditionals.pop()


def close_all(reader: Reader, report: Report) -> None:
    """Report the groups that are open at the end of a file."""
    for group in reversed(reader.conditionals):
        report.error(group.position, f"unterminated '{group.directive}': missing '#endif'")


def _innermost(
    reader: Reader, directive: str, position: Position, report: Report
) -> Conditional | None:
    if not reader.conditionals:
        report.error(position, f"'{directive}' without an '#if' before it")
        return None
    return reader.conditionals[-1]
