"""Tables of `docs/crs-h.md`, from the table of the functions of `crs.h`."""

from __future__ import annotations

from crs_cc.robot_api import Function
from crs_cc.robot_api.device import DEVICE_GROUPS
from crs_cc.session.device_library import device_groups
from docs.generate import Fillers, cell, table


def functions() -> str:
    """Return a section with a table for each group of functions."""
    titles = ("function", "units", "description")
    return "\n\n".join(
        f"## {group.title}\n\n{table(titles, [_row(each) for each in group.functions])}"
        for group in (*device_groups(), *DEVICE_GROUPS)
    )


def _row(each: Function) -> tuple[str, ...]:
    does = f"{each.does}; waits {each.waits}" if each.waits else each.does
    columns = (f"`{each.prototype}`", each.units, f"{does}. {each.chosen}".rstrip(". "))
    return tuple(cell(column) or "-" for column in columns)


FILLERS: Fillers = {"functions": functions}
