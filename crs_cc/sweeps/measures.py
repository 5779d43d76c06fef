"""Measures of a run: ours, and the user's own functions of its session or its recording.

A module with measures has functions without a leading underscore whose one parameter is called
`session` or `recording`; what they return becomes a column with their name.
"""

from __future__ import annotations

import importlib.util
import inspect
import math
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, Final, Literal

from crs_cc.core.source import Location
from crs_cc.sweeps.experiment import ExperimentError, Value

if TYPE_CHECKING:
    from crs_cc.session.result import RunResult

OURS: Final[dict[str, tuple[str, Callable[[RunResult], Value]]]] = {
    "points": (
        "the points of the goals",
        lambda result: sum((g.earned for g in result.goals), 0.0),
    ),
    "items_taken": (
        "items that robots took from sources",
        lambda result: sum(source.taken for source in result.sources),
    ),
    "items_brought": (
        "items that robots brought to nests",
        lambda result: sum(nest.brought for nest in result.nests),
    ),
    "distance_m": (
        "the total distance driven by all robots [m]",
        lambda result: sum(robot.distance_m for robot in result.robots),
    ),
    "collisions": (
        "the number of collisions of all robots",
        lambda result: sum(robot.collisions for robot in result.robots),
    ),
    "collisions_per_robot_min": (
        "collisions per robot per minute",
        lambda result: (
            sum(robot.collisions for robot in result.robots)
            * 60.0
            / (len(result.robots) * max(result.simulated_s, 1e-9))
        ),
    ),
    "commands": (
        "commands sent to the robots",
        lambda result: sum(robot.commands for robot in result.robots),
    ),
    "fuel": (
        "instructions that the programs executed",
        lambda result: sum(robot.fuel for robot in result.robots),
    ),
}
"""What every run has: the meaning, and how it comes from the results."""

Of = Literal["session", "recording"]


@dataclass(frozen=True, slots=True)
class Measure:
    """A measure of the user's.

    Attributes:
        name: its name.
        of: what it looks at.
        function: computes it.
    """

    name: str
    of: Of
    function: Callable[[Any], object]

    def value(self, subject: object) -> Value | None:
        """Return its value.

        Raises:
            MeasureError: the function failed, or returned what is no value.
        """
        try:
            found = self.function(subject)
        except Exception as error:  # whatever a user's function does is a row's error
            raise MeasureError(f"{self.name}: {_place(error)}{error!r}") from None
        found = found.item() if hasattr(found, "item") and not hasattr(found, "__len__") else found
        if found is None or (isinstance(found, float) and not math.isfinite(found)):
            return None
        if not isinstance(found, str | int | float | bool):
            raise MeasureError(
                f"{self.name} returned {type(found).__name__}, which is not a number"
            )
        return found


class MeasureError(Exception):
    """A measure could not be computed."""


def load_measures(path: Path) -> tuple[Measure, ...]:
    """Return the measures of a module, in the order of their names.

    Raises:
        ExperimentError: it cannot be loaded, or has none.
    """
    place = Location(str(path))
    try:
        module = _imported(path)
    except Exception as error:
        text = f"cannot be loaded: {_place(error)}{error!r}"
        raise ExperimentError.at(place, text) from None
    found = []
    for name, function in inspect.getmembers(module, inspect.isfunction):
        if name.startswith("_") or function.__module__ != module.__name__:
            continue
        parameters = list(inspect.signature(function).parameters)
        if parameters not in (["session"], ["recording"]):
            text = f"{name}({', '.join(parameters)}): a measure has one parameter, session or "
            hint = "names that begin with _ are no measures"
            raise ExperimentError.at(place, f"{text}recording", hint)
        if name in OURS:
            raise ExperimentError.at(place, f"'{name}' is a predefined measure")
        found.append(Measure(name, "session" if parameters == ["session"] else "recording",
                             function))  # fmt: skip
    if not found:
        raise ExperimentError.at(place, "no function has a parameter 'session' or 'recording'")
    return tuple(found)


def _imported(path: Path) -> ModuleType:
    if not path.is_file():
        raise FileNotFoundError(2, "no such file")
    spec = importlib.util.spec_from_file_location("crs_measures", path)
    if spec is None or spec.loader is None:
        raise ImportError("not a Python file")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _place(error: BaseException) -> str:
    frames = traceback.extract_tb(error.__traceback__)
    return f"line {frames[-1].lineno}: " if frames else ""
