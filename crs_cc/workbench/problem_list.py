"""What is wrong with a world that is edited, with the elements that it is about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from crs_cc.builder.addresses import named
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.core.source import Diagnostic


def problems(
    builder: WorldBuilder, programs: Mapping[str, Sequence[dict[str, Any]]]
) -> list[dict[str, Any]]:
    """Return the messages of `crs check` on a world and its programs, blocking errors first.

    Args:
        builder: the world.
        programs: the errors of the programs of robots.
    """
    errors = builder.problems()
    found, document = [*errors, *builder.warnings()], builder.document
    rows = list[tuple[int, int, str]]()
    for node, name in named(document.root) if found else ():
        rows.append((node.line, node.line + document.text.count(b"\n", node.begin, node.end), name))
    listed = [
        {
            "severity": each.severity, "text": each.text, "hint": each.hint, "file": "",
            "line": each.location.line, "blocks": each.severity == "error",
            "name": _at(rows, each) if each.location.file == document.file else "",
        }
        for each in found
    ]  # fmt: skip
    for name, messages in programs.items():
        listed += [
            {
                "severity": each["severity"], "text": each["text"], "hint": each["hint"],
                "file": Path(each["file"]).name, "line": each["line"], "blocks": False,
                "name": name,
            }
            for each in messages
        ]  # fmt: skip
    return listed


def _at(rows: list[tuple[int, int, str]], found: Diagnostic) -> str:
    """Return the name of the smallest element at the line of a message."""
    line = found.location.line
    around = [(last - first, name) for first, last, name in rows if first <= line <= last]
    return min(around)[1] if around else ""
