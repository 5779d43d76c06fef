"""Reads experiments from TOML files (`docs/experiments.md`).

>>> lines = "world = 'room.xml'", "duration = '5s'", "seeds = 3"
>>> found = parse(chr(10).join(lines), Path("trial.toml"))
>>> str(found.world), found.duration_s, found.seeds
('room.xml', 5.0, (1, 2, 3))
>>> parse('wrld = "room.xml"', Path("trial.toml"))
Traceback (most recent call last):
crs_cc.sweeps.experiment.ExperimentError: trial.toml: error: unknown key 'wrld'
    hint: did you mean 'world'?
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any, Final, TypeVar, cast

from crs_cc.core.quantity import TIME
from crs_cc.core.source import Location
from crs_cc.core.suggest import closest
from crs_cc.session.host import CLIENTS
from crs_cc.sweeps.experiment import Experiment, ExperimentError, Limits, Range, Search, Value
from crs_cc.sweeps.targets import check_target

MAX_BYTES: Final = 2**20
MAX_SEEDS: Final = 1_000_000

_T = TypeVar("_T")


class InvalidError(ValueError):
    """An experiment's file requests something impossible."""


def read_text(path: Path) -> str:
    """Return the text of a file.

    Raises:
        ExperimentError: it cannot be read.
    """
    place = Location(str(path))
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
        if len(content) > MAX_BYTES:
            raise ExperimentError.at(place, "larger than 1 MiB")
        return content.decode()
    except OSError as error:
        raise ExperimentError.at(place, f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise ExperimentError.at(place, "not UTF-8 text") from None


def parse(text: str, path: Path) -> Experiment:
    """Return the experiment that a text describes.

    Args:
        text: the text.
        path: its file, for messages.

    Raises:
        ExperimentError: it is invalid.
    """
    try:
        return _experiment(tomllib.loads(text), path)
    except (ValueError, RecursionError) as error:
        text, _, hint = str(error).partition("\n")
        raise ExperimentError.at(Location(str(path)), text, hint) from None


def _experiment(data: dict[str, Any], path: Path) -> Experiment:
    values: dict[str, Any] = {}
    readers: dict[str, Callable[[str, Any], Any]] = {
        "world": _file,
        "title": _text,
        "programs": lambda name, value: _each(name, value, _file),
        "arguments": lambda name, value: _each(name, value, _text),
        "defines": lambda name, value: _each(name, value, _text),
        "include_paths": lambda name, value: _each(name, value, _file),
        "seeds": _seeds,
        "duration": _duration,
        "until_decided": _flag,
        "setup": _text,
        "robot": _text,
        "link": lambda name, value: _choice(name, value, ("serial", "ideal")),
        "client": lambda name, value: _choice(name, value, CLIENTS),
        "files": lambda name, value: {
            key: _file(f"{name}.{key}", each) for key, each in _table(name, value).items()
        },
        "measures": _file,
        "limits": lambda name, value: _record(name, value, Limits),
        "parameters": _parameters,
        "cases": lambda name, value: _each(name, value, _case),
        "samples": lambda name, value: _whole(name, value, 1, MAX_SEEDS),
        "sample_seed": lambda name, value: _whole(name, value, 0, 2**63),
        "search": _search,
    }
    for name, value in data.items():
        if name not in readers:
            raise InvalidError(_unknown_key(name, tuple(readers)))
        values["duration_s" if name == "duration" else name] = readers[name](name, value)
    if "world" not in values:
        raise InvalidError("'world' is missing: name a world file")
    grid, ranges = values.pop("parameters", ({}, {}))
    found = Experiment(path=path, parameters=grid, ranges=ranges, **values)
    _check(found)
    return found


def _check(experiment: Experiment) -> None:
    """Check constraints between several keys.

    Raises:
        InvalidError: they contradict each other.
    """
    if experiment.ranges and not (experiment.samples or experiment.search):
        name = next(iter(experiment.ranges))
        raise InvalidError(f"parameters.{name} is a range: it requires 'samples' or [search]")
    if not experiment.ranges and (experiment.samples or experiment.search):
        key = "samples" if experiment.samples else "search"
        raise InvalidError(
            f"'{key}' needs a parameter with a range, such as {{ low = 1, high = 9 }}"
        )
    if experiment.samples and experiment.search:
        raise InvalidError("'samples' and [search] are mutually exclusive")
    if experiment.search and (experiment.cases or experiment.parameters):
        raise InvalidError("[search] requires ranges: lists of values and 'cases' are not allowed")
    names = set(experiment.cases[0]) if experiment.cases else set()
    for case in experiment.cases:
        if set(case) != names:
            raise InvalidError("all 'cases' must have the same parameters")
    for name in (*experiment.parameters, *experiment.ranges):
        if name in names:
            raise InvalidError(f"'{name}' is in 'cases' and in 'parameters'")


def _unknown_key(name: str, known: Sequence[str]) -> str:
    meant = closest(name, known)
    hint = f"did you mean '{meant}'?" if meant else f"known: {', '.join(known)}"
    return f"unknown key '{name}'\n{hint}"


# -- values ------------------------------------------------------------------------------------


def _text(name: str, value: object) -> str:
    if not isinstance(value, str) or "\0" in value:
        raise InvalidError(f"'{name}' must be a text, not {value!r}")
    return value


def _file(name: str, value: object) -> Path:
    return Path(_text(name, value))


def _flag(name: str, value: object) -> bool:
    if not isinstance(value, bool):
        raise InvalidError(f"'{name}' must be true or false, not {value!r}")
    return value


def _whole(name: str, value: object, low: int, high: int) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not low <= value <= high:
        raise InvalidError(f"'{name}' must be a whole number from {low} to {high}, not {value!r}")
    return value


def _number(name: str, value: object) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool) or not math.isfinite(value):
        raise InvalidError(f"'{name}' must be a number, not {value!r}")
    return value


def _choice(name: str, value: object, known: Sequence[str]) -> str:
    if value not in known:
        raise InvalidError(f"'{name}' must be one of {', '.join(known)}, not {value!r}")
    return str(value)


def _each(name: str, value: object, read: Callable[[str, Any], _T]) -> tuple[_T, ...]:
    if not isinstance(value, list):
        raise InvalidError(f"'{name}' must be a list, not {value!r}")
    return tuple(read(name, each) for each in value)


def _table(name: str, value: object) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise InvalidError(f"'{name}' must be a table, not {value!r}")
    return value


def _duration(name: str, value: object) -> float:
    time_s = TIME.parse(value) if isinstance(value, str) else _number(name, value)
    if time_s <= 0.0:
        raise InvalidError(f"'{name}' must be above 0, not {value!r}")
    return float(time_s)


def _seeds(name: str, value: object) -> tuple[int, ...]:
    """Return a list of seeds, or that many from 1 on."""
    if not isinstance(value, list):
        return tuple(range(1, _whole(name, value, 1, MAX_SEEDS) + 1))
    seeds = _each(name, value, lambda name, each: _whole(name, each, 0, 2**63))
    if not seeds or len(set(seeds)) < len(seeds):
        raise InvalidError(f"'{name}' must have at least one seed, without duplicates")
    return seeds


def _value(name: str, value: object) -> Value:
    if isinstance(value, float) and not math.isfinite(value):
        raise InvalidError(f"'{name}': invalid value {value!r}")
    if not isinstance(value, str | int | float | bool):
        raise InvalidError(f"'{name}': {value!r} is neither a number nor a text")
    return value


def _parameters(name: str, value: object) -> tuple[dict[str, tuple[Value, ...]], dict[str, Range]]:
    """Return the parameters with lists of values, and those with ranges."""
    grid: dict[str, tuple[Value, ...]] = {}
    ranges: dict[str, Range] = {}
    for target, each in _flat(_table(name, value)):
        check_target(target)
        key = f"{name}.{target}"
        if isinstance(each, dict):
            ranges[target] = _range(key, each)
            continue
        values = _each(key, each, _value)
        if not values or len({repr(each) for each in values}) < len(values):
            raise InvalidError(f"'{key}' must have at least one value, without duplicates")
        grid[target] = values
    return grid, ranges


def _flat(table: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the values of a table by their full names: `define.SPEED` is a table in TOML."""
    for key, value in table.items():
        if isinstance(value, dict) and "low" not in value:
            yield from _flat(value, f"{before}{key}.")
        else:
            yield f"{before}{key}", value


def _case(name: str, value: object) -> dict[str, Value]:
    found = {key: _value(f"{name}.{key}", each) for key, each in _flat(_table(name, value))}
    for target in found:
        check_target(target)
    if not found:
        raise InvalidError(f"'{name}' has an empty table")
    return found


def _range(name: str, data: dict[str, Any]) -> Range:
    found = _record(name, data, Range)
    if not found.low < found.high or (found.log and found.low <= 0):
        above = " of positive numbers" if found.log else ""
        raise InvalidError(f"'{name}' must have low < high{above}")
    return found


def _search(name: str, value: object) -> Search:
    found = _record(name, value, Search)
    _choice(f"{name}.method", found.method, ("tpe", "cma-es"))
    return found


def _record(name: str, value: object, kind: type[_T]) -> _T:
    """Return a table as a dataclass of numbers, texts and flags."""
    table = _table(name, value)
    known = {each.name: str(each.type) for each in fields(cast("Any", kind))}
    values: dict[str, Any] = {}
    for key, each in table.items():
        if key not in known:
            raise InvalidError(_unknown_key(key, tuple(known)))
        label = f"{name}.{key}"
        match known[key]:
            case "int":
                values[key] = _whole(label, each, 1, 2**62)
            case "float":
                values[key] = _number(label, each)
            case "bool":
                values[key] = _flag(label, each)
            case _:
                values[key] = _text(label, each)
    try:
        return kind(**values)
    except TypeError:
        missing = next(each for each in known if each not in values)
        raise InvalidError(f"'{name}.{missing}' is missing") from None
