"""The `<goal>` elements of a world file.

>>> from crs_cc.sim.files.world_xml import parse_world
>>> world = parse_world(b'''<world version="1"><area length="6m" width="5m"/>
...   <robot x="1m" y="1m"/>
...   <goal id="home" points="5" within="60s"><reach x="5m" y="4m" radius="30cm" stay="2s"/></goal>
...   <goal robots="robot0"><no-collision until="home"/></goal>
... </world>''', "room")
>>> [(goal.id, goal.points, goal.within_s) for goal in world.goals]
[('home', 5.0, 60.0), ('goal1', 1.0, inf)]
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Final

from crs_cc.core.quantity import HEAT, LENGTH, TIME
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.goals import (
    MAX_CELLS,
    MAX_GOALS,
    MAX_NAME,
    MAX_PLACES,
    MAX_POINTS,
    Approach,
    Bring,
    Condition,
    Cool,
    Cover,
    Follow,
    Goal,
    NoCollision,
    Place,
    Reach,
    Visit,
    cells_of,
)
from crs_cc.sim.model.world import WorldModel, is_pushable

_MIN_CELL_M: Final = 0.05
_POINTS_DECIMALS: Final = 6


def goals(root: Element, world: WorldModel, reader: Reader) -> tuple[Goal, ...]:
    """Return the goals of a world file; errors go to the reader.

    Args:
        root: the root element.
        world: the world without its goals.
        reader: receives the errors.
    """
    elements = list(root.all("goal"))
    if len(elements) > MAX_GOALS:
        reader.error(elements[MAX_GOALS], f"more than {MAX_GOALS} goals")
        return ()
    own = _GoalReader(world, reader)
    found = [own.goal(element) for element in elements]
    return tuple(goal for goal in found if goal is not None)


@dataclass(slots=True)
class _GoalReader:
    """Reads goals, each of which can refer to those before it.

    Attributes:
        world: the world without its goals.
        reader: reads the values, and receives the errors.
        known: the ids of the goals so far.
    """

    world: WorldModel
    reader: Reader
    known: list[str] = field(default_factory=list)

    def goal(self, element: Element) -> Goal | None:
        """Return the goal that an element describes; None after an error."""
        child = element.children[0]
        condition = _CONDITIONS[child.tag](self, child)
        within_s = self.reader.positive(element, "within", TIME, math.inf)
        stay_s = getattr(condition, "stay_s", 0.0)
        if stay_s > within_s:
            self.reader.refuse(child, "stay: is longer than the goal's time limit")
        if isinstance(condition, Bring | Cool) and "robots" in element.attributes:
            self.reader.refuse(element, f"robots: does not apply to <{child.tag}>")
        name = element.attributes.get("name", "").strip()
        if len(name) > MAX_NAME or not name.isprintable():
            self.reader.refuse(element, f"name: must be at most {MAX_NAME} printable letters")
        goal = Goal(
            element.attributes["id"],
            condition,
            name,
            self._points(element),
            self._names(element, "robots", "robot", [robot.id for robot in self.world.robots]),
            within_s,
            self._goal_before(element, "after"),
        )
        self.known.append(goal.id)
        return None if element.broken or child.broken else goal

    def reach(self, element: Element) -> Condition:
        """Return the condition `<reach>`."""
        return Reach(self.place(element), self._stay(element))

    def approach(self, element: Element) -> Condition:
        """Return the condition `<approach>`."""
        objects = self._names(element, "object", "object", self._objects())
        distance_m = self.reader.positive(element, "distance", LENGTH)
        return Approach(objects[0] if objects else "", distance_m, self._stay(element))

    def visit(self, element: Element) -> Condition:
        """Return the condition `<visit>`."""
        places = element.children[:MAX_PLACES]
        if len(element.children) > MAX_PLACES:
            self.reader.refuse(element, f"more than {MAX_PLACES} places")
        found = Visit(tuple(map(self.place, places)))
        element.broken |= any(place.broken for place in places)
        return found

    def no_collision(self, element: Element) -> Condition:
        """Return the condition `<no-collision>`."""
        known = [*(robot.id for robot in self.world.robots), *self._objects()]
        excepted = self._names(element, "except", "robot or object", known)
        return NoCollision(excepted, self._goal_before(element, "until"))

    def cool(self, element: Element) -> Condition:
        """Return the condition `<cool>`: by default, of all hot objects."""
        named = self._names(element, "objects", "object", self._objects())
        hot = [solid.id for solid in self.world.solids() if solid.heat > 0.0]
        if not hot and not named:
            self.reader.refuse(element, "no object in the world is hot")
        heat = self.reader.not_negative(element, "heat", HEAT)
        return Cool(named or tuple(hot), heat)

    def cover(self, element: Element) -> Condition:
        """Return the condition `<cover>`."""
        cell_m = self.reader.positive(element, "cell", LENGTH)
        area = self.world.area
        if cell_m < _MIN_CELL_M:
            self.reader.refuse(element, "cell: must be 5cm or more")
        elif math.prod(cells_of(cell_m, area.length_m, area.width_m)) > MAX_CELLS:
            self.reader.refuse(element, f"cell: more than {MAX_CELLS} cells in the world's area")
        return Cover(self._share(element), cell_m)

    def bring(self, element: Element) -> Condition:
        """Return the condition `<bring>`."""
        movable = [solid.id for solid in self.world.solids() if is_pushable(solid)]
        objects = self._names(element, "objects", "movable object", movable)
        return Bring(objects, self.place(element), self._stay(element))

    def follow(self, element: Element) -> Condition:
        """Return the condition `<follow>`."""
        movable = [solid.id for solid in self.world.solids() if is_pushable(solid)]
        known = [*(robot.id for robot in self.world.robots), *movable]
        target = self._names(element, "target", "robot or movable object", known)
        least_m = self.reader.not_negative(element, "least", LENGTH)
        most_m = self.reader.positive(element, "most", LENGTH)
        if least_m > most_m:
            self.reader.refuse(element, "least: is greater than most")
        share, until = self._share(element), self._goal_before(element, "until")
        return Follow(target[0] if target else "", least_m, most_m, share, until)

    def place(self, element: Element) -> Place:
        """Return a place, whose centre must be in the area."""
        x_m = self.reader.quantity(element, "x", LENGTH)
        y_m = self.reader.quantity(element, "y", LENGTH)
        radius_m = self.reader.positive(element, "radius", LENGTH)
        area = self.world.area
        inside = area.x_min_m <= x_m <= area.x_max_m and area.y_min_m <= y_m <= area.y_max_m
        if not inside and not element.broken:
            edges = f"x {area.x_min_m:g} to {area.x_max_m:g}, y {area.y_min_m:g} to"
            text = f"{edges} {area.y_max_m:g} m"
            self.reader.refuse(element, f"the place is outside of the area ({text})")
        return Place(x_m, y_m, radius_m)

    def _objects(self) -> list[str]:
        return [solid.id for solid in self.world.solids()]

    def _stay(self, element: Element) -> float:
        return self.reader.not_negative(element, "stay", TIME)

    def _share(self, element: Element) -> float:
        share = self.reader.fraction(element, "share", 1.0)
        if share == 0.0:
            self.reader.refuse(element, "share: must be greater than 0")
        return share

    def _points(self, element: Element) -> float:
        text = element.attributes.get("points", "1")
        try:
            points = float(text)
        except ValueError:
            points = math.nan
        if not 0.0 <= points <= MAX_POINTS:
            self.reader.refuse(
                element, f"points: {text[:40]!r} is not a number from 0 to {MAX_POINTS:.0f}"
            )
            return 0.0
        return round(points, _POINTS_DECIMALS)

    def _names(
        self, element: Element, attribute: str, kind: str, known: Sequence[str]
    ) -> tuple[str, ...]:
        """Return the names in an attribute, separated by spaces."""
        names = tuple(dict.fromkeys(element.attributes.get(attribute, "").split()))
        if attribute in element.attributes and not names:
            self.reader.refuse(element, f"{attribute}: names no {kind}")
        everything = set(known)
        for name in names:
            if name not in everything:
                text = unknown(kind, name, known)
                if "movable" in kind and name in self._objects():
                    text = f"'{name}' is fixed: give it a mass"
                self.reader.refuse(element, f"{attribute}: {text}")
                break
        if attribute in {"object", "target"} and len(names) > 1:
            self.reader.refuse(element, f"{attribute}: names more than one {kind}")
        return names

    def _goal_before(self, element: Element, attribute: str) -> str:
        """Return the id of an earlier goal; empty without the attribute."""
        name = element.attributes.get(attribute, "")
        if attribute in element.attributes and name not in self.known:
            text = unknown("earlier goal", name, self.known)
            self.reader.refuse(element, f"{attribute}: {text}")
        return name


_CONDITIONS: Final[dict[str, Callable[[_GoalReader, Element], Condition]]] = {
    "reach": _GoalReader.reach,
    "approach": _GoalReader.approach,
    "visit": _GoalReader.visit,
    "no-collision": _GoalReader.no_collision,
    "cool": _GoalReader.cool,
    "cover": _GoalReader.cover,
    "bring": _GoalReader.bring,
    "follow": _GoalReader.follow,
}
