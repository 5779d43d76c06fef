"""Judges the goals of a world at the end of each timestep.

A goal is judged by the poses at the end of a timestep, once the goal that it comes `after` has been
met; until then only its time limit applies. Goals refer only to earlier ones, so one pass in their
order is enough. What lasts without an end of its own (`NoCollision`, `Follow`) stays open, and
holds or does not hold at the end of the run.

In a world at rest only time changes a goal: `due_s` is when, and `skip` counts the timesteps that
were not executed.

>>> from crs_cc.sim.engine.environment import Environment
>>> from crs_cc.sim.files.world_xml import parse_world
>>> world = parse_world(b'''<world version="1"><area length="6m" width="5m"/>
...   <robot x="1m" y="1m"/>
...   <goal id="near"><reach x="1m" y="1m" radius="1cm" stay="0.1s"/></goal>
...   <goal id="clean"><no-collision/></goal>
... </world>''', "room")
>>> environment = Environment(world, seed=0)
>>> for _ in range(4):
...     step = environment.step()
>>> [(goal.id, goal.status, goal.at_s) for goal in environment.goals]
[('near', 'met', 0.15), ('clean', 'holds', None)]
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.core.time_grid import ROUNDING_S
from crs_cc.sim.engine.goal_floor import Floor
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.goals import (
    Approach,
    Bring,
    Cool,
    Cover,
    Follow,
    Goal,
    NoCollision,
    Place,
    Reach,
    Visit,
)
from crs_cc.sim.state.goals import ABSENT, FAILED, MET, OPEN, GoalState, mark_ranges

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.bodies import Contacts
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog

Status = Literal["open", "holds", "met", "failed"]

_DECIMALS: Final = 9  # of a time that is a number of timesteps


@dataclass(frozen=True, slots=True)
class GoalResult:
    """The status of a goal.

    Attributes:
        id: its name in the world.
        title: its title.
        points: what it is worth.
        status: `met` or `failed` for good; `holds` if it would be met if the run ended now, as a
            goal that lasts until the end of the run; else `open`.
        at_s: when it was met or failed [s].
        progress: how far it is met, such as `2 of 3 places`; may be empty.
    """

    id: str
    title: str
    points: float
    status: Status
    at_s: float | None
    progress: str

    @property
    def earned(self) -> float:
        """The points that it is worth if the run ends now."""
        return self.points if self.status in {"met", "holds"} else 0.0


class GoalJudge:
    """Judges the goals of a running world, whose set of objects is fixed."""

    def __init__(
        self, world: WorldModel, names: Sequence[str], constants: RobotConstants, floor: Floor
    ) -> None:
        """Set up the goals of a world.

        Args:
            world: the world.
            names: the names of all objects, as in `Scene.names`.
            constants: the constants of all robots and objects.
            floor: the cells of the floor, for `Cover`.
        """
        self._world = world
        self._constants = constants
        self._numbers = {name: number for number, name in enumerate(names)}
        self._floor = floor
        self._marks = mark_ranges(world)
        ids = [robot.id for robot in world.robots]
        self._chosen = [
            np.array([not goal.robots or each in goal.robots for each in ids], np.bool_)
            for goal in world.goals
        ]
        self._ids = [goal.id for goal in world.goals]
        self._radii_m = np.array([robot.model.radius_m for robot in world.robots])

    # -- a timestep ------------------------------------------------------------------------------

    def judge(self, state: EnvState, contacts: Contacts, end_s: float, log: EventLog) -> None:
        """Judge all open goals at the end of a timestep.

        Args:
            state: the state at its end.
            contacts: the contacts that began in it.
            end_s: its end.
            log: receives the goals that are met and those that fail.
        """
        goals = state.goals
        if goals is None or not (goals.status == OPEN).any():
            return
        for number, goal in enumerate(self._world.goals):
            if goals.status[number] != OPEN:
                continue
            status = self._status_now(number, state, contacts, end_s)
            if status != OPEN:
                goals.status[number], goals.at_s[number] = status, end_s
                word = "met" if status == MET else "failed"
                log.say(end_s, "goal", f"goal '{goal.title}' {word}")

    def _status_now(self, number: int, state: EnvState, contacts: Contacts, end_s: float) -> int:
        goal, goals = self._world.goals[number], state.goals
        assert goals is not None
        until, status = self._status_of(goals, goal.until), OPEN
        if FAILED in {until, self._status_of(goals, goal.after)}:
            return FAILED
        is_on = self._is_on(goal, goals)
        if is_on:
            status = self._condition(number, state, contacts)
        is_over = until == MET or end_s >= goal.within_s - ROUNDING_S
        if status != OPEN or not is_over:
            return status
        return MET if is_on and goal.is_lasting and self._holds(number, goals) else FAILED

    def _is_on(self, goal: Goal, goals: GoalState) -> bool:
        """Return whether a goal counts already."""
        return not goal.after or self._status_of(goals, goal.after) == MET

    def _status_of(self, goals: GoalState, name: str) -> int:
        return int(goals.status[self._ids.index(name)]) if name else OPEN

    # -- conditions ------------------------------------------------------------------------------

    def _condition(self, number: int, state: EnvState, contacts: Contacts) -> int:
        """Return the status of a goal by its condition alone."""
        condition = self._world.goals[number].condition
        match condition:
            case Reach() | Approach():
                is_met = self._stays(number, condition.stay_s, state)
            case Visit():
                is_met = self._visits(number, condition, state)
            case Cool():
                is_met = self._cools(condition, state)
            case Cover():
                is_met = self._covers(number, condition, state)
            case Bring():
                is_met = self._brings(number, condition, state)
            case Follow():
                self._count(number, state, 1)
                return OPEN
            case NoCollision():
                return FAILED if self._collides(number, condition, contacts) else OPEN
        return MET if is_met else OPEN

    def _stays(self, number: int, stay_s: float, state: EnvState) -> bool:
        """Return whether robots are where they should be for long enough."""
        goals, ended = state.goals, state.cycle + 1
        assert goals is not None
        there, since = self._there(number, state), goals.since[:, number]
        since[there & (since == ABSENT)] = ended
        since[~there] = ABSENT
        stayed_s = (ended - since) * self._world.timestep_s
        goals.done[:, number] |= there & (stayed_s >= stay_s - ROUNDING_S)
        return self._by_robots(number, goals.done[:, number])

    def _there(self, number: int, state: EnvState) -> BoolArray:
        """Return which robots are in the place of a goal, or near its object."""
        can = self._chosen[number] & state.presence.present
        return np.asarray(can & (self._outside_m(number, state) <= 0.0))

    def _outside_m(self, number: int, state: EnvState) -> FloatArray:
        """Return the distances of robots to the place of a goal, or to the range of its object [m].

        It is negative in it.
        """
        condition = self._world.goals[number].condition
        if isinstance(condition, Reach):
            return _outside_m(condition.place, state.x_m, state.y_m)
        assert isinstance(condition, Approach)
        obj = self._numbers.get(condition.object)
        if obj is None:  # a program has removed it
            return np.full(len(state.connected), np.inf)
        shapes, objects = self._constants.shapes, np.full(len(state.connected), obj)
        poses = shapes.poses(state.bodies)
        distance_m = shapes.distance_m(poses, objects, state.x_m, state.y_m)
        return np.asarray(distance_m - condition.distance_m)

    def _visits(self, number: int, condition: Visit, state: EnvState) -> bool:
        robots = np.flatnonzero(self._chosen[number] & state.presence.present)
        visited = self._marks_of(number, state)
        for row in np.flatnonzero(~visited).tolist():
            place = condition.places[row]
            visited[row] = (_outside_m(place, state.x_m[robots], state.y_m[robots]) <= 0.0).any()
        return bool(visited.all())

    def _cools(self, condition: Cool, state: EnvState) -> bool:
        numbers = [self._numbers.get(obj) for obj in condition.objects]
        return all(n is not None and state.heat.left[n] <= condition.heat for n in numbers)

    def _covers(self, number: int, condition: Cover, state: EnvState) -> bool:
        robots = np.flatnonzero(self._chosen[number] & state.presence.present)
        covered = self._marks_of(number, state)
        self._floor.cover(
            condition.cell_m, covered, state.x_m[robots], state.y_m[robots], self._radii_m[robots]
        )
        free = self._floor.free(condition.cell_m)
        return int((covered & free).sum()) >= condition.share * int(free.sum())

    def _brings(self, number: int, condition: Bring, state: EnvState) -> bool:
        goals, ended = state.goals, state.cycle + 1
        assert goals is not None
        if not self._all_present(condition, state):
            goals.brought[number] = ABSENT
            return False
        if goals.brought[number] == ABSENT:
            goals.brought[number] = ended
        stayed_s = (ended - goals.brought[number]) * self._world.timestep_s
        return bool(stayed_s >= condition.stay_s - ROUNDING_S)

    def _all_present(self, condition: Bring, state: EnvState) -> bool:
        numbers = [self._numbers.get(obj) for obj in condition.objects]
        if any(number is None for number in numbers):
            return False
        place_m = state.bodies.position_m[np.array(numbers, np.intp)]
        return bool((_outside_m(condition.place, place_m[:, 0], place_m[:, 1]) <= 0.0).all())

    def _collides(self, number: int, condition: NoCollision, contacts: Contacts) -> bool:
        if not len(contacts.robot):
            return False
        mine = self._chosen[number][contacts.robot]
        allowed = [self._numbers.get(name, ABSENT) for name in condition.excepted]
        return bool((mine & ~np.isin(contacts.other, allowed)).any())

    def _count(self, number: int, state: EnvState, timesteps: int) -> None:
        """Count timesteps in which a robot follows, or does not."""
        goals = state.goals
        assert goals is not None
        goals.counted[number] += timesteps
        if self._by_robots(number, self._follows(number, state)):
            goals.right[number] += timesteps

    def _follows(self, number: int, state: EnvState) -> BoolArray:
        """Return which robots are at the right distance from their target."""
        condition = self._world.goals[number].condition
        assert isinstance(condition, Follow)
        can = self._chosen[number] & state.presence.present
        target, present = self._numbers.get(condition.target), state.presence.present
        if target is None or (target < len(present) and not present[target]):
            return np.zeros_like(can)
        x_m, y_m = state.bodies.position_m[target].tolist()
        distance_m = exact.hypot(state.x_m - x_m, state.y_m - y_m)
        right = (distance_m >= condition.least_m) & (distance_m <= condition.most_m)
        right[target : target + 1] = False  # a robot cannot follow itself
        return np.asarray(can & right)

    def _by_robots(self, number: int, did: BoolArray) -> bool:
        """Return whether enough robots did something: all that are named, or any."""
        chosen = did[self._chosen[number]]
        return bool(chosen.all() if self._world.goals[number].robots else chosen.any())

    def _marks_of(self, number: int, state: EnvState) -> BoolArray:
        assert state.goals is not None
        return state.goals.marks[self._marks[number]]

    # -- time in which nothing is judged -----------------------------------------------------------

    def room_m(self, state: EnvState) -> float:
        """Return the total distance that robots may move before a goal must be evaluated [m].

        Nothing else is to move, touch or change meanwhile, and `due_s` still to come. 0.0 if a goal
        has to be judged at the end of this timestep.
        """
        goals = state.goals
        if goals is None:
            return math.inf
        numbers = np.flatnonzero(goals.status == OPEN).tolist()
        counting = [number for number in numbers if self._is_on(self._world.goals[number], goals)]
        return min((self._goal_room_m(each, state, goals) for each in counting), default=math.inf)

    def _goal_room_m(self, number: int, state: EnvState, goals: GoalState) -> float:
        condition = self._world.goals[number].condition
        can = self._chosen[number] & state.presence.present
        match condition:
            case Reach() | Approach():
                is_noted = goals.since[:, number] != ABSENT
                if (is_noted != self._there(number, state)).any():
                    return 0.0
                return float(np.abs(self._outside_m(number, state)[can]).min(initial=np.inf))
            case Visit(places):
                left = np.flatnonzero(~self._marks_of(number, state)).tolist()
                x_m, y_m = state.x_m[can], state.y_m[can]
                outside_m = np.array([_outside_m(places[row], x_m, y_m) for row in left])
                return max(0.0, float(outside_m.min(initial=np.inf)))
            case Cool():
                return 0.0 if self._cools(condition, state) else math.inf
            case Bring():
                is_noted = bool(goals.brought[number] != ABSENT)
                return math.inf if is_noted == self._all_present(condition, state) else 0.0
            case NoCollision():
                return math.inf
        return 0.0  # each timestep counts

    # -- time at rest ----------------------------------------------------------------------------

    def due_s(self, state: EnvState) -> float:
        """Return when time alone changes a goal next, infinite for never; in a world at rest."""
        goals = state.goals
        if goals is None:
            return math.inf
        found = [math.inf]
        for number in np.flatnonzero(goals.status == OPEN).tolist():
            goal = self._world.goals[number]
            found.append(goal.within_s)
            stay_s = getattr(goal.condition, "stay_s", 0.0)
            waiting = goals.since[~goals.done[:, number], number].tolist()
            waiting.append(int(goals.brought[number]))
            timestep_s = self._world.timestep_s
            found += [since * timestep_s + stay_s for since in waiting if since != ABSENT]
        return min(found)

    def skip(self, state: EnvState, timesteps: int) -> None:
        """Count timesteps at rest that have not been executed."""
        goals = state.goals
        if goals is None:
            return
        for number in np.flatnonzero(goals.status == OPEN).tolist():
            goal = self._world.goals[number]
            if self._is_on(goal, goals) and isinstance(goal.condition, Follow):
                self._count(number, state, timesteps)

    # -- results ---------------------------------------------------------------------------------

    def results(self, state: EnvState) -> tuple[GoalResult, ...]:
        """Return the current status of the goals."""
        if state.goals is None:
            return ()
        numbers = range(len(self._world.goals))
        return tuple(self._result(number, state, state.goals) for number in numbers)

    def _result(self, number: int, state: EnvState, goals: GoalState) -> GoalResult:
        goal = self._world.goals[number]
        at_s = float(goals.at_s[number])
        return GoalResult(
            goal.id,
            goal.title,
            goal.points,
            self._word(number, goals),
            round(at_s, _DECIMALS) if math.isfinite(at_s) else None,
            self._progress(number, state, goals),
        )

    def _word(self, number: int, goals: GoalState) -> Status:
        goal = self._world.goals[number]
        if goals.status[number] != OPEN:
            return "met" if goals.status[number] == MET else "failed"
        lasts_on = goal.is_lasting and not goal.until and math.isinf(goal.within_s)
        holds = lasts_on and self._is_on(goal, goals) and self._holds(number, goals)
        return "holds" if holds else "open"

    def _holds(self, number: int, goals: GoalState) -> bool:
        """Return whether a goal that lasts would be met if its time were over."""
        condition = self._world.goals[number].condition
        if not isinstance(condition, Follow):
            return True
        counted = int(goals.counted[number])
        return counted > 0 and bool(goals.right[number] >= condition.share * counted)

    def _progress(self, number: int, state: EnvState, goals: GoalState) -> str:
        goal = self._world.goals[number]
        match goal.condition:
            case Visit(places):
                return f"{int(self._marks_of(number, state).sum())} of {len(places)} places"
            case Cover(cell_m=cell_m):
                free = self._floor.free(cell_m)
                covered = int((self._marks_of(number, state) & free).sum())
                return f"{100 * covered // max(1, int(free.sum()))}% covered"
            case Follow():
                right, counted = int(goals.right[number]), int(goals.counted[number])
                return f"{100 * right // max(1, counted)}% of the time"
            case Cool(objects, heat):
                numbers = [self._numbers.get(obj) for obj in objects]
                cool = sum(n is not None and state.heat.left[n] <= heat for n in numbers)
                return f"{cool} of {len(objects)} cool" if len(objects) > 1 else ""
        if len(goal.robots) > 1 and isinstance(goal.condition, Reach | Approach):
            done = goals.done[self._chosen[number], number]
            return f"{int(done.sum())} of {len(done)} robots"
        return ""


def _outside_m(place: Place, x_m: FloatArray, y_m: FloatArray) -> FloatArray:
    """Return the distances of points to a place [m]; negative inside."""
    return np.asarray(exact.hypot(x_m - place.x_m, y_m - place.y_m) - place.radius_m)
