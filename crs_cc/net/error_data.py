"""Serialisation of runtime error reports, which are made where the program runs, as JSON.

>>> import json
>>> report = ErrorReport("null pointer", Location("a.c", 3, 5), "null pointer: read", "*p = 1;")
>>> report_of(json.loads(json.dumps(data_of(report)))) == report
True
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from crs_cc.core.source import Location
from crs_cc.runtime.diagnosis.active_call import ActiveCall
from crs_cc.runtime.diagnosis.report import ErrorReport

_MAX_TEXT: Final = 10_000
_MAX_ITEMS: Final = 100


def data_of(report: ErrorReport) -> dict[str, Any]:
    """Return a report as plain data, without its object."""
    return {
        "kind": report.kind,
        "text": report.text,
        "place": _place(report.location),
        "source_line": report.source_line,
        "values": [list(pair) for pair in report.values],
        "notes": list(report.notes),
        "stack": [
            {
                "function": call.function,
                "arguments": [list(pair) for pair in call.arguments],
                "place": _place(call.location) if call.location else None,
                "count": call.count,
            }
            for call in report.stack
        ],
    }


def report_of(data: Mapping[str, Any]) -> ErrorReport:
    """Return the report from plain data.

    Raises:
        ValueError: the data are not a report.
    """
    try:
        return ErrorReport(
            _text(data["kind"]),
            _location(data["place"]),
            _text(data["text"]),
            _text(data["source_line"]),
            _pairs(data["values"]),
            tuple(map(_text, data["notes"][:_MAX_ITEMS])),
            tuple(map(_call, data["stack"][:_MAX_ITEMS])),
        )
    except (KeyError, TypeError, AttributeError, IndexError):
        raise ValueError("an error report is not valid") from None


def _place(place: Location) -> list[str | int]:
    return [place.file, place.line, place.column]


def _location(place: Any) -> Location:
    file, line, column = place
    return Location(_text(file), int(line), int(column))


def _call(data: Mapping[str, Any]) -> ActiveCall:
    place = data["place"]
    location = None if place is None else _location(place)
    return ActiveCall(
        _text(data["function"]), _pairs(data["arguments"]), location, int(data["count"])
    )


def _pairs(rows: Any) -> tuple[tuple[str, str], ...]:
    return tuple((_text(name), _text(value)) for name, value in rows[:_MAX_ITEMS])


def _text(value: Any) -> str:
    if isinstance(value, str):
        return value[:_MAX_TEXT]
    raise ValueError("an error report has a field that is not text")
