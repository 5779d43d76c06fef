"""The rows of a sweep on the disk: appended as runs end, so that a killed sweep can be resumed.

`rows.jsonl` has a line of JSON for each run, in the order in which they ended. A line that was cut
off is dropped when the file is opened again, as is a second one of the same run.
"""

from __future__ import annotations

import csv
import io
import json
import os
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Self

from crs_cc.core.source import Location
from crs_cc.sweeps.experiment import ExperimentError

try:
    import fcntl
except ImportError:  # Unix only
    fcntl = None  # type: ignore[assignment]

Row = dict[str, Any]
"""A row as it is in the file: `run`, `parameters`, `seed`, and what became of the run."""

ROWS: Final = "rows.jsonl"
TABLE: Final = "runs.csv"
PART: Final = ".mcap.part"
"""How the names of recordings end that are needed for measures only."""


class RowFile:
    """The rows of a sweep, open to add more; only one process can have it open."""

    def __init__(self, folder: Path) -> None:
        """Open the file of a folder, which is made if it is missing.

        Raises:
            ExperimentError: another sweep is writing it.
            OSError: it cannot be written.
        """
        self.path = folder / ROWS
        self._descriptor = os.open(self.path, os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o666)
        try:
            if fcntl is not None:
                fcntl.flock(self._descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(self._descriptor)
            place = Location(str(folder))
            raise ExperimentError.at(place, "another sweep is writing to this folder") from None
        self.rows, self._end = read_rows(self.path)
        os.ftruncate(self._descriptor, self._end)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _where: TracebackType | None,
    ) -> None:
        os.close(self._descriptor)

    def add(self, row: Row) -> None:
        """Append a row, whole or not at all.

        Raises:
            OSError: it cannot be written, such as on a full disk.
        """
        line = json.dumps(row).encode() + b"\n"
        try:
            written = 0
            while written < len(line):
                written += os.write(self._descriptor, line[written:])
        except OSError as error:
            os.ftruncate(self._descriptor, self._end)
            raise OSError(error.errno, error.strerror, str(self.path)) from None
        self._end += len(line)
        self.rows[row["run"]] = _compact(row)


def read_rows(path: Path) -> tuple[dict[int, Row], int]:
    """Return the rows of a file by their runs, and where the last whole line ends."""
    rows: dict[int, Row] = {}
    end = 0
    with path.open("rb") as file:
        for line in file:
            try:
                row = json.loads(line) if line.endswith(b"\n") else None
            except ValueError:
                row = None
            if not isinstance(row, dict) or not isinstance(row.get("run"), int):
                break
            rows.setdefault(row["run"], _compact(row))
            end += len(line)
    return rows, end


def _compact(row: Row) -> Row:
    """Return a row in half of the memory: rows share the names that all of them have."""
    return {
        sys.intern(name): _compact(value) if isinstance(value, dict) else value
        for name, value in row.items()
    }


# -- the table -----------------------------------------------------------------------------------


def failures(rows: Iterable[Row]) -> list[tuple[str, str, list[Row]]]:
    """Return the errors: status and first line of each, and its rows, the most frequent first.

    >>> failed = {"run": 1, "status": "limit", "error": "a: fuel"}
    >>> [found[:2] for found in failures([{"run": 0, "status": "ended"}, failed])]
    [('limit', 'a: fuel')]
    """
    found: dict[tuple[str, str], list[Row]] = {}
    for row in sorted(rows, key=lambda each: int(each["run"])):
        if row["status"] != "ended":
            text = str(row.get("error", "")).partition("\n")[0]
            found.setdefault((row["status"], text), []).append(row)
    ordered = sorted(found.items(), key=lambda each: -len(each[1]))
    return [(status, text, each) for (status, text), each in ordered]


def heading(rows: Sequence[Row]) -> list[str]:
    """Return the columns of a table: first the parameters, then the results."""
    parameters, goals, measures = (
        dict.fromkeys(name for row in rows for name in row.get(kind, ()))
        for kind in ("parameters", "goals", "measures")
    )
    return [
        "run",
        *parameters,
        "seed",
        "status",
        "error",
        "simulated_s",
        *(name for goal in goals for name in (f"goal.{goal}", f"goal.{goal}.at_s")),
        *measures,
        "state_hash",
        "recording",
    ]


def records(rows: Sequence[Row]) -> Iterator[dict[str, Any]]:
    """Yield rows as plain records by column, in the order of their runs."""
    for row in sorted(rows, key=lambda each: int(each["run"])):
        goals: Mapping[str, Mapping[str, Any]] = row.get("goals", {})
        yield {
            **{name: row.get(name) for name in ("run", "seed", "status", "error", "simulated_s")},
            **row.get("parameters", {}),
            **{f"goal.{name}": goal["status"] for name, goal in goals.items()},
            **{f"goal.{name}.at_s": goal["at_s"] for name, goal in goals.items()},
            **row.get("measures", {}),
            **{name: row.get(name, "") for name in ("state_hash", "recording")},
        }


def table_text(rows: Sequence[Row], constants: Mapping[str, str]) -> str:
    """Return rows as the text of a CSV file, equal for equal rows in any order.

    Args:
        rows: the rows.
        constants: columns at the end with one value for all rows, such as versions.
    """
    ordered = sorted(rows, key=lambda each: int(each["run"]))
    names = heading(ordered)
    target = io.StringIO()
    writer = csv.writer(target, lineterminator="\n")
    writer.writerow([*names, *constants])
    for record in records(ordered):
        writer.writerow([*(_cell(record.get(name)) for name in names), *constants.values()])
    return target.getvalue()


def _cell(value: object) -> object:
    """Return a value as it is written: numbers so that they are read again with equal bits."""
    if value is None:
        return ""
    return str(value).lower() if isinstance(value, bool) else value


def replace_text(path: Path, text: str) -> None:
    """Write a file, which is there as before or with the new text, whatever happens.

    Raises:
        OSError: it cannot be written.
    """
    part = path.with_name(path.name + ".part")
    try:
        part.write_text(text, "utf-8")
        part.replace(path)
    except OSError as error:  # a failed write does not say of what
        raise OSError(error.errno, error.strerror, str(path)) from None
    finally:
        part.unlink(missing_ok=True)
