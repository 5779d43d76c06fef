"""The table of operations, and what the example prints, of `docs/world-builder.md`."""

from __future__ import annotations

import contextlib
import io
import re
from tempfile import TemporaryDirectory

from crs_cc import WorldBuilder
from crs_cc.builder.table import OPERATIONS, Operation
from docs.generate import Fillers, cell, table, template


def operations() -> str:
    """Return the table of operations."""
    rows = ((f"`{row.name}`", row.summary, _values(row)) for row in OPERATIONS.values())
    return table(("operation", "what it does", "values"), rows)


def _values(row: Operation) -> str:
    words = [f"`{field.name}`: {_lower(field.help)}" for field in row.fields]
    words += ["attributes"] if row.attributes else []
    return cell("; ".join(words))


def _lower(text: str) -> str:
    return text[:1].lower() + text[1:].rstrip(".")


def hall() -> str:
    """Return what the last example prints."""
    example = re.findall(r"```python\n(.*?)```", template("world-builder"), re.DOTALL)[-1]
    printed = io.StringIO()
    with (
        TemporaryDirectory() as folder,
        contextlib.chdir(folder),
        contextlib.redirect_stdout(printed),
    ):
        exec(example, {"WorldBuilder": WorldBuilder})  # noqa: S102 - our own page
    return printed.getvalue().strip()


FILLERS: Fillers = {"operations": operations, "hall": hall}
