"""Elements for the goals of a world."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from crs_cc.core.quantity import HEAT, LENGTH, TIME
from crs_cc.sim.files.document import Element
from crs_cc.sim.model import goals


def goal_element(goal: goals.Goal) -> Element:
    """Return the element of a goal."""
    attributes = {
        "id": goal.id,
        "name": goal.name,
        "points": f"{float(goal.points)!r}" if goal.points != 1.0 else "",
        "robots": " ".join(goal.robots),
        "within": "" if math.isinf(goal.within_s) else TIME.exact(goal.within_s),
        "after": goal.after,
    }
    return Element("goal", 0, _given(attributes), children=[_condition(goal.condition)])


def _condition(condition: goals.Condition) -> Element:
    match condition:
        case goals.Reach():
            return _element("reach", **_place(condition.place), stay=_stay(condition.stay_s))
        case goals.Approach():
            distance = LENGTH.exact(condition.distance_m)
            return _element(
                "approach",
                object=condition.object, distance=distance, stay=_stay(condition.stay_s),
            )  # fmt: skip
        case goals.Visit():
            places = [Element("place", 0, _place(place)) for place in condition.places]
            return Element("visit", 0, children=places)
        case goals.NoCollision():
            return _element(
                "no-collision", **{"except": _names(condition.excepted)}, until=condition.until
            )
        case goals.Cool():
            heat = HEAT.exact(condition.heat)
            return _element("cool", objects=_names(condition.objects), heat=heat)
        case goals.Cover():
            cell = LENGTH.exact(condition.cell_m)
            return _element("cover", share=f"{float(condition.share)!r}", cell=cell)
        case goals.Bring():
            place, names = _place(condition.place), _names(condition.objects)
            return _element("bring", objects=names, **place, stay=_stay(condition.stay_s))
        case goals.Follow():
            return _element(
                "follow",
                target=condition.target,
                least=LENGTH.exact(condition.least_m),
                most=LENGTH.exact(condition.most_m),
                share=f"{float(condition.share)!r}",
                until=condition.until,
            )


def _place(place: goals.Place) -> dict[str, str]:
    return {name: LENGTH.exact(getattr(place, f"{name}_m")) for name in ("x", "y", "radius")}


def _stay(stay_s: float) -> str:
    return TIME.exact(stay_s) if stay_s else ""


def _names(names: Sequence[str]) -> str:
    return " ".join(names)


def _element(tag: str, **attributes: Any) -> Element:
    return Element(tag, 0, _given(attributes))


def _given(attributes: dict[str, str]) -> dict[str, str]:
    return {name: text for name, text in attributes.items() if text}
