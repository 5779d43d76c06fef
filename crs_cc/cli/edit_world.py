"""The work of `crs world`: open a file, do one operation, save it or show what has changed."""

from __future__ import annotations

import difflib
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import click

from crs_cc.builder.addresses import address
from crs_cc.builder.table import Operation
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.cli.inputs import check_readable
from crs_cc.core.errors import WorldError
from crs_cc.core.quantity import LENGTH
from crs_cc.sim.files.xml_document import MAX_BYTES


def open_builder(file: Path) -> WorldBuilder:
    """Return the builder of a file.

    Raises:
        WorldError: it cannot be read.
    """
    check_readable(file)
    return WorldBuilder(file)


def element_list(file: Path, name: str) -> list[str]:
    """Return the names of elements with their tags, one a line."""
    builder = open_builder(file)
    try:
        nodes = builder.element(name).children
    except ValueError as wrong:
        raise click.UsageError(f"{wrong}.") from None
    names = [address(node) for node in nodes]
    width = max(map(len, names), default=0)
    return [f"{name:{width}}  {node.tag}" for name, node in zip(names, nodes, strict=True)]


def copy_elements(file: Path, names: Sequence[str]) -> str:
    """Return elements as XML with the definitions that they need."""
    builder = open_builder(file)
    try:
        return builder.copy(names)
    except ValueError as wrong:
        raise click.UsageError(f"{wrong}.") from None


def edit(
    row: Operation, file: Path, output: Path | None, given: Mapping[str, Any], *, diff: bool
) -> Sequence[str]:
    """Do an operation with a file.

    Args:
        row: the operation.
        file: the file.
        output: the file for the result; None for the same.
        given: the values of the command line: fields by their names, `names`, `words`.
        diff: whether to write nothing.

    Returns:
        what to print: the names of new elements, or the differences.

    Raises:
        WorldError: the result would not be valid, or the file cannot be read.
        click.UsageError: the operation cannot be done.
    """
    builder = open_builder(file)
    before = builder.text
    values = {name: given[name] for name in (field.name for field in row.fields) if given.get(name)}
    words = list(given.get("words") or ())
    names = [given["names"]] if given.get("names") else []
    names += [word for word in words if "=" not in word or not row.attributes]
    pairs = [word.partition("=") for word in words if "=" in word and row.attributes]
    attributes = {name: value for name, _, value in pairs}
    if row.attributes and not attributes and row.name != "add":
        raise click.UsageError("no attribute to set: give NAME=VALUE.")
    try:
        if "clip" in values:
            values["clip"] = _clip(values["clip"])
        new = builder.apply(row.name, names, values, attributes)
    except WorldError:
        raise
    except ValueError as wrong:
        raise click.UsageError(f"{wrong}.") from None
    if diff:
        lines = difflib.unified_diff(
            before.splitlines(), builder.text.splitlines(), str(file), str(file), lineterm=""
        )
        return list(lines)
    builder.save(output)
    return new


def import_plan(file: Path, plan: Path, given: Mapping[str, Any]) -> Sequence[str]:
    """Put a plan into a world, which is made if it does not exist; return what to say.

    Raises:
        WorldError: the plan cannot be read, or the result would not be valid.
        click.UsageError: a value is invalid.
    """
    try:
        values = {name: LENGTH.parse(text) for name, text in given.items() if text is not None}
    except ValueError as wrong:
        raise click.UsageError(f"{wrong}.") from None
    size = {name: values[name] for name in ("scale", "thickness") if name in values}
    if file.exists():
        builder = open_builder(file)
        names, left_out = builder.import_plan(plan, **size, x=values["x"], y=values["y"])
    else:
        builder, left_out = WorldBuilder.from_plan(plan, **size)
        names = builder.names()
    builder.save(file)
    return [f"{len(names)} elements in {file}", *(f"left out: {each}" for each in left_out)]


def export_world(file: Path, target: Path) -> Sequence[str]:
    """Write a world in another format; return what to say.

    Raises:
        WorldError: the world is invalid.
        click.UsageError: there is no such format.
    """
    try:
        left_out = open_builder(file).export(target)
    except ValueError as wrong:
        raise click.UsageError(f"{wrong}.") from None
    return [f"wrote {target}", *(f"left out: {each}" for each in left_out)]


def _clip(name: str) -> str:
    """Return the text of a clip: of a file, or of standard input for `-`."""
    if name == "-":
        return sys.stdin.buffer.read(MAX_BYTES).decode(errors="replace")
    try:
        with Path(name).open("rb") as file:
            return file.read(MAX_BYTES).decode(errors="replace")
    except OSError as error:
        raise click.UsageError(f"cannot read '{name}': {error.strerror}.") from None
