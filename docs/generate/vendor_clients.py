"""The options and limits in `docs/vendor-clients.md`."""

from __future__ import annotations

import click

from crs_cc.cli.serve import serve
from crs_cc.net.vendor.server import MAX_WITHOUT_ROBOT, OPENING_TIMEOUT_S
from crs_cc.net.vendor.switchboard import CLIENT_TIMEOUT_S
from docs.generate import Fillers, cell, table

_NAMES = ("--nserver", "--serial", "--tcp-robot")


def options() -> str:
    """Return the table of the options of `crs serve` for these programs."""
    found = {name: each for each in serve.params for name in each.opts}
    rows = []
    for name in _NAMES:
        option = found[name]
        assert isinstance(option, click.Option)
        rows.append((f"`{name} {option.metavar}`", cell(option.help or "")))
    return table(("option", "meaning"), rows)


FILLERS: Fillers = {
    "options": options,
    "patience": lambda: f"{CLIENT_TIMEOUT_S:g}",
    "opening": lambda: f"{OPENING_TIMEOUT_S:g}",
    "strangers": lambda: str(MAX_WITHOUT_ROBOT),
}
