"""Who changes degradations while a world runs, and tells of them: for programs that run worlds.

What goes in and comes out is plain data (`Degradation`). Every change is an event of the kind
`degradation`: one is added, changed or removed, it began, faded, ended.

>>> from crs_cc.sim.engine.environment import Environment
>>> from crs_cc.sim.files.world_xml import empty_world
>>> environment = Environment(empty_world(), seed=1)
>>> environment.degradations.add(Degradation("robot0", "sonar", element=3, gain=0.5))
'degradation0'
>>> environment.degradations.change("degradation0", gain=0.25, duration_s=0.02).gain
0.25
>>> for event in environment.step().events:
...     print(f"{event.time_s:.2f} {event.text}")
0.00 degradation0 added: sonar 3, gain 0.5
0.00 degradation0 changed: sonar 3, gain 0.25
0.00 degradation0 began: sonar 3, gain 0.25
0.02 degradation0 ended: sonar 3, gain 0.25
>>> environment.degradations.remove("degradation0")
>>> environment.degradations.all()
()
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.suggest import unknown
from crs_cc.sim.model.degradation import MAX_MEMORY, Degradation, complaint, described
from crs_cc.sim.state.degradation import (
    ACTS,
    FADES,
    OVER,
    WAITS,
    DegradationState,
    degradation_of,
    empty_memory,
    record,
    turns_s,
)

if TYPE_CHECKING:
    from crs_cc.sim.model.robot import RobotModel
    from crs_cc.sim.state.events import EventLog
    from crs_cc.sim.state.running_world import Running

PHASES: Final = {WAITS: "waits", ACTS: "acts", FADES: "fades", OVER: "over"}
"""What the phases are called."""

_TURNS: Final = {ACTS: "began", FADES: "began to fade", OVER: "ended"}
_LONGEST_ID: Final = 64


class DegradationControl:
    """The degradations of a world that runs, to be asked and changed between two of its steps."""

    def __init__(self, running: Running, log: EventLog) -> None:
        """Makes one.

        Args:
            running: the world; its state is changed.
            log: takes the events.
        """
        self._running, self._log = running, log

    @property
    def _state(self) -> DegradationState:
        return self._running.state.degradation

    @property
    def _time_s(self) -> float:
        return self._running.time_s

    @property
    def _robots(self) -> list[str]:
        return [robot.id for robot in self._running.world.robots]

    def all(self) -> tuple[Degradation, ...]:
        """Gives all degradations, in the order in which they work."""
        return tuple(map(self._degradation, self._state.table))

    def phase(self, name: str) -> str:
        """Gives how far a degradation has come: one of `PHASES`.

        Raises:
            ValueError: there is none of that name.
        """
        return PHASES[int(self._state.table["phase"][self._place(name)])]

    def add(self, degradation: Degradation) -> str:
        """Adds a degradation; an onset that is past means now.

        Returns:
            its name.

        Raises:
            ValueError: it cannot be, and why.
        """
        if not isinstance(degradation.id, str):
            raise ValueError("an id must be a text")  # noqa: TRY004 - as all that cannot be
        names = set(self._state.table["id"].tolist())
        if degradation.id in names:
            raise ValueError(f"a second degradation with the id {degradation.id!r}")
        if not degradation.id:
            free = next(n for n in range(len(names) + 1) if f"degradation{n}" not in names)
            degradation = replace(degradation, id=f"degradation{free}")
        self._check(degradation)
        degradation = replace(degradation, onset_s=max(degradation.onset_s, self._time_s))
        robot = self._robots.index(degradation.robot)
        row = record(degradation, robot, int(self._state.made[robot]))
        self._make_room(row)
        self._state.made[robot] += 1
        self._state.append([row])
        self._say(self._time_s, "added", row)
        return degradation.id

    def change(self, name: str, **changes: Any) -> Degradation:
        """Changes some of the attributes of a degradation; it forgets what it remembers.

        Its onset stays as it was, unless that is changed; then the degradation begins anew.

        Args:
            name: its name.
            changes: new values of attributes of `Degradation`, `id`, `robot` and `device` apart.

        Returns:
            what it is now.

        Raises:
            ValueError: there is none of that name, or it cannot be so, and why.
        """
        place = self._place(name)
        fixed = {"id", "robot", "device"} & changes.keys()
        if fixed:
            raise ValueError(f"{', '.join(sorted(fixed))} cannot change: remove it, add another")
        old = self._state.table[place]
        try:
            degradation = replace(self._degradation(old), **changes)
        except TypeError:
            unknown = changes.keys() - set(Degradation.__dataclass_fields__)
            raise ValueError(f"a degradation has no {', '.join(sorted(unknown))}") from None
        self._check(degradation)
        if "onset_s" in changes:
            degradation = replace(degradation, onset_s=max(degradation.onset_s, self._time_s))
        row = record(degradation, int(old["robot"]), int(old["serial"]))
        row["count"] = old["count"]
        row["phase"] = _phase(row, self._time_s)
        self._make_room(row)
        self._state.replace(place, row)
        self._say(self._time_s, "changed", row)
        return degradation

    def remove(self, name: str) -> None:
        """Removes a degradation, and with it at once what it does.

        Raises:
            ValueError: there is none of that name.
        """
        place = self._place(name)
        row = self._state.table[place].copy()
        self._state.remove(place)
        self._say(self._time_s, "removed", row)

    def tell(self, until_s: float) -> None:
        """Says which degradations begin, fade or are over before an instant."""
        if self._state.next_s >= until_s:
            return
        table, said = self._state.table, []
        while True:
            at_s = turns_s(table)
            due = np.flatnonzero(at_s < until_s)
            if not len(due):
                break
            phase = table["phase"][due] + 1
            phase[(phase == FADES) & (table["recovery_s"][due] == 0.0)] = OVER
            table["phase"][due] = phase
            said += list(zip(at_s[due].tolist(), due.tolist(), phase.tolist(), strict=True))
        self._state.refresh(others=any(phase == OVER for _, _, phase in said))
        for time_s, place, now in sorted(said):
            self._say(time_s, _TURNS[now], table[place])

    def _place(self, name: str) -> int:
        places = np.flatnonzero(self._state.table["id"] == name)
        if not len(places):
            raise ValueError(unknown("degradation", name, self._state.table["id"].tolist()))
        return int(places[0])

    def _degradation(self, row: Any) -> Degradation:
        return degradation_of(row, self._running.world.robots[int(row["robot"])].id)

    def _model(self, robot: str) -> RobotModel:
        return self._running.world.robots[self._robots.index(robot)].model

    def _check(self, degradation: Degradation) -> None:
        if degradation.robot not in self._robots:
            raise ValueError(unknown("robot", str(degradation.robot), self._robots))
        if len(degradation.id) > _LONGEST_ID:
            raise ValueError(f"an id has at most {_LONGEST_ID} characters")
        wrong = complaint(degradation, self._model(degradation.robot))
        if wrong:
            raise ValueError(wrong)

    def _make_room(self, row: Any) -> None:
        if len(self._state.memory) + len(empty_memory(row)) > MAX_MEMORY:
            raise ValueError("too many degradations to remember what they need")

    def _say(self, time_s: float, what: str, row: Any) -> None:
        degradation = self._degradation(row)
        model = self._running.world.robots[int(row["robot"])].model
        text = f"{degradation.id} {what}: {described(degradation, model)}"
        self._log.say(time_s, "degradation", text, int(row["robot"]))


def _phase(row: Any, at_s: float) -> int:
    """Gives the phase of a degradation at an instant at which it has been told of all before."""
    end_s = float(row["onset_s"] + row["duration_s"])
    over_s = end_s + float(row["recovery_s"])
    if at_s <= row["onset_s"]:
        return WAITS
    if at_s <= end_s:
        return ACTS
    return FADES if at_s <= over_s else OVER
