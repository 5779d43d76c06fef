"""Control of degradations in a running world, for programs that run worlds.

Arguments and results are plain data (`Degradation`). Every change is an event of the kind
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
0.00 sonar 3, gain 0.5 (degradation0 added)
0.00 sonar 3, gain 0.25 (degradation0 changed)
0.00 sonar 3, gain 0.25 (degradation0 began)
0.02 sonar 3, gain 0.25 (degradation0 ended)
>>> environment.degradations.remove("degradation0")
>>> environment.degradations.all()
()
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.suggest import unknown
from crs_cc.sim.model.degradation import MAX_MEMORY, Degradation, described, validation_error
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
    from crs_cc.sim.state.running_world import RunningWorld

PHASES: Final = {WAITS: "waits", ACTS: "acts", FADES: "fades", OVER: "over"}
"""The names of the phases."""

_TURNS: Final = {ACTS: "began", FADES: "began to fade", OVER: "ended"}
_MAX_ID: Final = 64


class DegradationControl:
    """The degradations of a running world, to be read and changed between two steps."""

    def __init__(self, running: RunningWorld, log: EventLog) -> None:
        """Create the control."""
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
        """Return all degradations, in the order in which they apply."""
        return tuple(map(self._degradation, self._state.table))

    def phase(self, name: str) -> str:
        """Return the phase of a degradation: one of `PHASES`.

        Raises:
            ValueError: the degradation does not exist.
        """
        return PHASES[int(self._state.table["phase"][self._place(name)])]

    def add(self, degradation: Degradation) -> str:
        """Add a degradation; an onset in the past means now.

        Returns:
            its name.

        Raises:
            ValueError: it is invalid; the message is the reason.
        """
        if not isinstance(degradation.id, str):
            raise ValueError("a degradation's id must be a string")  # noqa: TRY004 - as all others
        names = set(self._state.table["id"].tolist())
        if degradation.id in names:
            raise ValueError(f"duplicate degradation {degradation.id!r}")
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
        """Change some attributes of a degradation, and clear its memory of past values.

        A new onset starts the degradation again.

        Args:
            name: its name.
            changes: new values of attributes of `Degradation`, except `id`, `robot` and `device`.

        Returns:
            the changed degradation.

        Raises:
            ValueError: it does not exist, or the change is invalid; the message is the reason.
        """
        place = self._place(name)
        fixed = {"id", "robot", "device"} & changes.keys()
        if fixed:
            names = ", ".join(sorted(fixed))
            raise ValueError(f"cannot change {names}: remove the degradation and add another")
        old = self._state.table[place]
        try:
            degradation = replace(self._degradation(old), **changes)
        except TypeError:
            unknown = changes.keys() - set(Degradation.__dataclass_fields__)
            names = ", ".join(sorted(unknown))
            raise ValueError(f"unknown attribute of a degradation: {names}") from None
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
        """Remove a degradation; its effect ends at once.

        Raises:
            ValueError: the degradation does not exist.
        """
        place = self._place(name)
        row = self._state.table[place].copy()
        self._state.remove(place)
        self._say(self._time_s, "removed", row)

    def log_changes(self, until_s: float) -> None:
        """Log the degradations that begin, fade or end before some time."""
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
        if len(degradation.id) > _MAX_ID:
            raise ValueError(f"a degradation's id has at most {_MAX_ID} characters")
        wrong = validation_error(degradation, self._model(degradation.robot))
        if wrong:
            raise ValueError(wrong)

    def _make_room(self, row: Any) -> None:
        if len(self._state.memory) + len(empty_memory(row)) > MAX_MEMORY:
            raise ValueError("too many degradations")

    def _say(self, time_s: float, what: str, row: Any) -> None:
        degradation = self._degradation(row)
        model = self._running.world.robots[int(row["robot"])].model
        text = f"{described(degradation, model)} ({degradation.id} {what})"
        self._log.say(time_s, "degradation", text, int(row["robot"]))


def _phase(row: Any, at_s: float) -> int:
    """Return the phase of a degradation at a time up to which all changes were logged."""
    end_s = float(row["onset_s"] + row["duration_s"])
    over_s = end_s + float(row["recovery_s"])
    if at_s <= row["onset_s"]:
        return WAITS
    if at_s <= end_s:
        return ACTS
    return FADES if at_s <= over_s else OVER
