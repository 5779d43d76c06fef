"""The results of a sweep, by combinations of parameters, for its report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.core.suggest import unknown
from crs_cc.sweeps.experiment import Value
from crs_cc.sweeps.plan import shown
from crs_cc.sweeps.rows import Row

_TIME: Final = ".at_s"


@dataclass(frozen=True, slots=True)
class Group:
    """The runs of one combination of parameters.

    Attributes:
        parameters: the combination, without what is the same in all runs.
        rows: its rows, by seed.
        values: the measure in each row.
        reached: of the time of a goal, whether it was met in each row: else the value is the end
            of the run, as long as which it took at least.
    """

    parameters: Mapping[str, Value]
    rows: tuple[Row, ...]
    values: tuple[float, ...]
    reached: tuple[bool, ...]


@dataclass(frozen=True, slots=True)
class Results:
    """The results of a sweep, as one measure.

    Attributes:
        measure: the measure.
        varied: the parameters that have several values.
        groups: the runs by combination.
        failed: how many runs have no such measure.
    """

    measure: str
    varied: tuple[str, ...]
    groups: tuple[Group, ...]
    failed: int

    @property
    def labels(self) -> list[str]:
        """The combinations as text, by the parameters that distinguish them."""
        combinations = [group.parameters for group in self.groups]
        names = _distinguishing_parameters(combinations, self.varied)
        return [shown({name: each[name] for name in names}) or "all runs" for each in combinations]

    @property
    def is_time(self) -> bool:
        """Whether the measure is the time of a goal, which some runs do not reach."""
        return is_time(self.measure)

    @property
    def label(self) -> str:
        """The measure in words, for the axes of figures."""
        return f"time to goal {_goal_of(self.measure)} [s]" if self.is_time else self.measure


def is_time(measure: str) -> bool:
    """Return whether a measure is the time of a goal."""
    return measure.startswith("goal.") and measure.endswith(_TIME)


def _goal_of(measure: str) -> str:
    """Return the goal whose time a measure is."""
    return measure.removeprefix("goal.").removesuffix(_TIME)


def measures_of(rows: Sequence[Row]) -> list[str]:
    """Return the measures that are numbers: first the times of goals that were ever met."""
    goals = dict.fromkeys(goal for row in rows for goal in row.get("goals", ()))
    times = [
        f"goal.{goal}{_TIME}"
        for goal in goals
        if any(row["goals"][goal]["status"] == "met" for row in rows if goal in row["goals"])
    ]
    found = dict.fromkeys(
        name
        for row in rows
        for name, value in row.get("measures", {}).items()
        if isinstance(value, int | float)
    )
    return [*times, *found]


def results(rows: Sequence[Row], measure: str = "") -> Results:
    """Return the results of rows.

    Args:
        rows: the rows.
        measure: the measure; by default the time of the first goal that was ever met, else the
            points.

    Raises:
        ValueError: there is no such measure.
    """
    known = measures_of(rows)
    if measure and measure not in known:
        raise ValueError(unknown("measure", measure, known))
    if not known:
        raise ValueError("no run has a measure")
    wanted = measure or known[0]
    names = dict.fromkeys(name for row in rows for name in row["parameters"])
    varied = tuple(
        name for name in names if len({repr(row["parameters"].get(name)) for row in rows}) > 1
    )
    members: dict[str, list[Row]] = {}
    for row in sorted(rows, key=lambda each: int(each["run"])):
        members.setdefault(shown(row["parameters"]), []).append(row)
    groups = [_group(each, varied, wanted) for each in members.values()]
    failed = len(rows) - sum(len(group.values) for group in groups)
    return Results(wanted, varied, tuple(group for group in groups if group.values), failed)


def _distinguishing_parameters(
    combinations: Sequence[Mapping[str, Value]], varied: Sequence[str]
) -> list[str]:
    """Return the first parameters that distinguish combinations; others vary with these.

    >>> rows = [{"setup": "", "fault": ""}, {"setup": "noisy", "fault": "dead=yes"}]
    >>> _distinguishing_parameters(rows, ["setup", "fault"])
    ['setup']
    """
    telling: list[str] = []
    classes = 1
    for name in varied:
        found = len({repr([each.get(n) for n in (*telling, name)]) for each in combinations})
        if found > classes:
            telling.append(name)
            classes = found
    return telling


def _group(rows: Sequence[Row], varied: Sequence[str], measure: str) -> Group:
    chosen, values, reached = [], [], []
    for row in rows:
        value, is_reached = value_of(row, measure)
        if value is not None:
            chosen.append(row)
            values.append(value)
            reached.append(is_reached)
    parameters = {name: rows[0]["parameters"][name] for name in varied}
    return Group(parameters, tuple(chosen), tuple(values), tuple(reached))


def value_of(row: Row, measure: str) -> tuple[float | None, bool]:
    """Return a measure of a row, None for none, and whether it is not only a lower bound."""
    if not is_time(measure):
        value = row.get("measures", {}).get(measure)
        return (float(value) if isinstance(value, int | float) else None), True
    goal = row.get("goals", {}).get(_goal_of(measure))
    if goal is None or row["status"] not in ("ended", "measure error"):
        return None, False
    is_met = goal["status"] == "met"
    return (float(goal["at_s"]) if is_met else float(row["simulated_s"])), is_met
