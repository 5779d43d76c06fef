"""The runs of an experiment: every combination of parameters with every seed, in a fixed order.

>>> from pathlib import Path
>>> from crs_cc.sweeps.experiment import Range
>>> trial = Experiment(Path("t"), Path("w"), seeds=(1, 2), parameters={"robots": (1, 2)})
>>> [(run.number, run.parameters["robots"], run.seed) for run in runs_of(trial)]
[(0, 1, 1), (1, 1, 2), (2, 2, 1), (3, 2, 2)]
>>> random = Experiment(Path("t"), Path("w"), ranges={"define.N": Range(0, 9)}, samples=2)
>>> [run.parameters for run in runs_of(random)]
[{'define.N': 2.09039393}, {'define.N': 4.24659021}]
"""

from __future__ import annotations

import itertools
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.core.keyed_random import KeyedUniform
from crs_cc.sweeps.experiment import Experiment, Value

Parameters = Mapping[str, Value]
"""The value of each parameter, by its target."""

_STREAM: Final = 0x53574545
"""Distinguishes these random numbers from those of worlds with the same seed."""


@dataclass(frozen=True, slots=True)
class PlannedRun:
    """One run of an experiment.

    Attributes:
        number: its place among all runs, from 0.
        parameters: what is varied.
        seed: the random seed.
    """

    number: int
    parameters: Parameters
    seed: int


def names_of(experiment: Experiment) -> tuple[str, ...]:
    """Return the names of all parameters, in the order of the table's columns."""
    cases = tuple(experiment.cases[0]) if experiment.cases else ()
    return (*cases, *experiment.parameters, *experiment.ranges)


def combinations(experiment: Experiment) -> Iterator[Parameters]:
    """Yield all combinations of parameters, those of a search left out."""
    grid = experiment.parameters
    for case in experiment.cases or ({},):
        for values in itertools.product(*grid.values()):
            chosen = {**case, **dict(zip(grid, values, strict=True))}
            for number in range(experiment.samples or 1):
                yield {**chosen, **_sample(experiment, number)}


def combinations_to_check(experiment: Experiment) -> list[Parameters]:
    """Return the combinations to check before the first run: all, or both extremes of a search."""
    if experiment.search is None:
        return list(combinations(experiment))
    ranges = experiment.ranges.items()
    return [
        {name: each.written(each.low) for name, each in ranges},
        {name: each.written(each.high) for name, each in ranges},
    ]


def _sample(experiment: Experiment, number: int) -> Parameters:
    """Return a random sample: each depends on its number only, so more of them change none."""
    if not experiment.samples:
        return {}
    uniform = KeyedUniform(experiment.sample_seed, _STREAM)
    return {
        name: each.at(float(uniform.draw(np.array([number]), zlib.crc32(name.encode()))[0]))
        for name, each in experiment.ranges.items()
    }


def runs_of(experiment: Experiment) -> Iterator[PlannedRun]:
    """Yield all runs, seed by seed for each combination."""
    number = itertools.count()
    for parameters in combinations(experiment):
        for seed in experiment.seeds:
            yield PlannedRun(next(number), parameters, seed)


def shown(parameters: Parameters) -> str:
    """Return a combination of parameters for messages.

    >>> shown({"define.SPEED": 60, "setup": "noisy"})
    'define.SPEED=60, setup=noisy'
    """
    return ", ".join(f"{name}={value}" for name, value in parameters.items())
