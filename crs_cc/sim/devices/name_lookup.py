"""Requests that look up a number by a name, or a name by a number."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray
from crs_cc.requests import DATA_SIZE

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext

_OWN: Final = -1  # one's own number; in replies: none


def numbers_of(names: Sequence[str]) -> dict[str, int]:
    """Return the number of each name, from 0."""
    return {name: number for number, name in enumerate(names)}


def look_up(context: RequestContext, numbers: dict[str, int], own: IndexArray) -> BoolArray:
    """Look up a name, or without one a number, -1 for one's own; reply with both and the count."""
    good = np.zeros(len(context), dtype=np.bool_)
    names, sizes = list(numbers), context["size"].tolist()
    asked = context["number"].tolist()
    for row, mine in enumerate(own.tolist()):
        size, number = sizes[row], asked[row]
        if size:
            wanted = context["name"][row, : max(0, size)].tobytes().decode("utf-8", "replace")
            number = numbers.get(wanted, _OWN)
        elif number == _OWN:
            number = mine
        good[row] = 0 <= number < len(names)
        text = names[number].encode()[:DATA_SIZE] if good[row] else b""
        context.put("number", number if good[row] else _OWN, row)
        context.put("count", len(names), row)
        context.put_bytes(text, row)
    return good
