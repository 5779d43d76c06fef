"""The tables of a recorded run as Parquet or Arrow files, written by pyarrow, an extra."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal

import click

from crs_cc.cli.tables import tables
from crs_cc.cli.written_file import written_file

if TYPE_CHECKING:
    from crs_cc.recording.recording import Recording

Form = Literal["parquet", "arrow"]

ROWS: Final = 50_000
"""In memory at a time."""


def write_columnar(recording: Recording, folder: Path, form: Form) -> None:
    """Write the tables of `crs replay --csv` in another form.

    Raises:
        click.UsageError: pyarrow is not installed.
        RecordingError: the recording is not valid.
        OSError: a file cannot be written.
    """
    check_pyarrow(f"--{form}")
    import pyarrow as pa
    import pyarrow.parquet as pq

    for name, heading, rows in tables(recording):
        schema: Any = pa.schema([(title, _type(title)) for title in heading])
        path = folder / f"{name}.{form}"
        with written_file(path):
            if form == "parquet":
                writer: Any = pq.ParquetWriter(path, schema, compression="zstd")
            else:
                writer = pa.ipc.new_file(str(path), schema)
            with writer:
                source = iter(rows)
                while batch := list(itertools.islice(source, ROWS)):
                    writer.write_table(_table(schema, batch))


def check_pyarrow(option: str) -> None:
    """Check that pyarrow is installed.

    Raises:
        click.UsageError: it is not.
    """
    if find_spec("pyarrow") is None:
        raise click.UsageError(f"{option} needs pyarrow: pip install 'crs_cc[arrow]'.")


def write_records(path: Path, names: Sequence[str], records: Sequence[Mapping[str, Any]]) -> None:
    """Write records to a Parquet file; columns of different types of values become text.

    Raises:
        OSError: it cannot be written.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    columns = {}
    for name in names:
        values = [record.get(name) for record in records]
        kinds = {type(value) for value in values if value is not None}
        if len(kinds) > 1 and kinds != {int, float}:
            values = [None if value is None else str(value) for value in values]
        columns[name] = pa.array(values)
    pq.write_table(pa.table(columns), path, compression="zstd")


def _table(schema: Any, batch: Sequence[Sequence[Any]]) -> Any:
    import pyarrow as pa

    columns = [
        pa.array([_cell(cell, field.type) for cell in column], field.type)
        for column, field in zip(zip(*batch, strict=True), schema, strict=True)
    ]
    return pa.Table.from_arrays(columns, schema=schema)


def _type(title: str) -> str:
    """Return the type of a column: what has a unit is a number.

    >>> _type("x [m]"), _type("robot")
    ('double', 'string')
    """
    return "double" if "[" in title or title == "laser mode" else "string"


def _cell(cell: Any, kind: Any) -> Any:
    if str(kind) == "string":
        return str(cell)
    return float(cell) if isinstance(cell, int | float) else None
