"""The results of foraging with trails and with faults, in the words of docs/swarms.md."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Final

from crs_cc.sweeps.experiment import Value
from crs_cc.sweeps.report.results import Group, Results, results
from crs_cc.sweeps.rows import Row

_MEASURE: Final = "items_per_min"
_CHANNEL: Final = "world.communication/channel"
_SOUND: Final = "ideal"
"""The setup of robots without a fault: the definition itself."""
_NONE: Final = "none"


def with_trails(rows: Sequence[Row]) -> Results:
    """Return the items per minute, by the number of robots, with and without trails."""
    return _renamed(
        rows,
        lambda given: {
            "robots": given["world.ant.count"],
            "trails": ("no", "yes")[int(given["define.TRAILS"])],
        },
    )


def with_faults(rows: Sequence[Row]) -> Results:
    """Return the items per minute, by the number of faulty robots and their fault."""

    def named(given: Mapping[str, Value]) -> dict[str, Value]:
        fault = given["world.faulty.setup"]
        if fault == _SOUND:
            return {"faulty": 0, "fault": _NONE}
        return {"faulty": given["world.faulty.count"], "fault": fault}

    found = _renamed(rows, named)
    return replace(found, groups=tuple(sorted(found.groups, key=_by_fault)))


def from_none(found: Results) -> Results:
    """Return results in which each fault begins with the robots that have none, for a figure."""
    sound = [group for group in found.groups if group.parameters["fault"] == _NONE]
    faulty = [group for group in found.groups if group.parameters["fault"] != _NONE]
    faults = dict.fromkeys(group.parameters["fault"] for group in faulty)
    begun = [
        replace(group, parameters={**group.parameters, "fault": fault})
        for fault in faults
        for group in sound
    ]
    return replace(found, groups=(*begun, *faulty))


def _by_fault(group: Group) -> tuple[bool, str, int]:
    fault, count = group.parameters["fault"], group.parameters["faulty"]
    return fault != _NONE, str(fault), int(count)


def with_losses(rows: Sequence[Row]) -> Results:
    """Return the items per minute, by how many messages are lost, and how many in a row."""

    def named(given: Mapping[str, Value]) -> dict[str, Value]:
        begin, end = (float(given[f"{_CHANNEL}.burst-{name}"]) for name in ("begin", "end"))
        lost = float(given[f"{_CHANNEL}.loss"]) if begin == 0.0 else begin / (begin + end)
        return {"lost": f"{lost:.0%}", "in bursts of": round(1.0 / end) if begin else 1}

    return _renamed(rows, named)


def _renamed(
    rows: Sequence[Row], named: Callable[[Mapping[str, Value]], dict[str, Value]]
) -> Results:
    """Return the items per minute, with parameters by which the page names them."""
    found = results(rows, _MEASURE)
    groups = tuple(replace(group, parameters=named(group.parameters)) for group in found.groups)
    return replace(found, varied=tuple(groups[0].parameters), groups=groups)
