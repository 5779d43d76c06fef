"""Experiments: a world, programs, and what is varied; `experiment_file` reads them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from crs_cc.core.errors import CrsError
from crs_cc.session.host import Client

Value = str | int | float | bool
"""A value of a parameter, as in the file."""

Link = Literal["serial", "ideal"]


class ExperimentError(CrsError):
    """An invalid experiment, or one that does not fit to its folder."""

    exit_status = 122


@dataclass(frozen=True, slots=True)
class Range:
    """The values of a parameter that is sampled or searched.

    Attributes:
        low: the smallest value.
        high: the largest.
        log: whether its logarithm is uniform.
        integer: whether values are whole.
        unit: is put behind each value, such as `m`.
    """

    low: float
    high: float
    log: bool = False
    integer: bool = False
    unit: str = ""

    def at(self, share: float) -> Value:
        """Return the value at a share of the range, 0 to below 1.

        >>> Range(1, 6, integer=True).at(0.999), Range(1, 100, log=True).at(0.5)
        (6, 10.0)
        >>> Range(0, 2, unit="m").at(0.25)
        '0.5m'
        """
        high = self.high + 1 if self.integer else self.high
        if self.log:
            value = self.low * math.exp(share * math.log(high / self.low))
        else:
            value = self.low + share * (high - self.low)
        return self.written(min(math.floor(value), self.high) if self.integer else value)

    def written(self, value: float) -> Value:
        """Return a number as a value of the parameter."""
        number = int(value) if self.integer else float(f"{value:.9g}")
        return f"{number}{self.unit}" if self.unit else number


@dataclass(frozen=True, slots=True)
class Limits:
    """What one run may take.

    Attributes:
        fuel: instructions of each program.
        output: bytes that its programs print, together.
        memory_mib: memory of a run in addition to what all need, on Linux.
        wall_s: real time: the last resort.
    """

    fuel: int = 20_000_000_000
    output: int = 10_000_000
    memory_mib: int = 4096
    wall_s: float = 600.0


@dataclass(frozen=True, slots=True)
class Search:
    """What is searched for, instead of running everything.

    Attributes:
        measure: the column of the table whose median over the seeds counts.
        method: how to search.
        trials: how many combinations are tried.
        batch: how many are chosen before the results of the last ones are known: with more, more
            runs are executed at a time.
        maximize: whether larger is better.
        seed: the random seed of the search.
    """

    measure: str
    method: Literal["tpe", "cma-es"] = "tpe"
    trials: int = 50
    batch: int = 4
    maximize: bool = False
    seed: int = 1


@dataclass(frozen=True, slots=True)
class Experiment:
    """An experiment; paths in it begin at the folder of its file.

    Attributes:
        path: its file.
        world: the world file.
        title: what it is about; for reports.
        programs: the C files of the program, for robots for which the world names none.
        arguments: the program's.
        defines: macros, as `NAME=value`.
        include_paths: folders for `#include`.
        seeds: the random seeds; each combination runs with each.
        duration_s: how long a run is; None for the world's duration.
        until_decided: whether a run ends when all goals of the world are met or failed.
        setup: the setup of all robots; empty for the world's.
        robot: the kind of robots for which the world names none: a name or a definition file.
        link: `serial` or `ideal`.
        client: which of the vendor's client libraries to emulate.
        files: files that programs can read, by the names that they use.
        measures: the module with the user's own measures; None for none.
        limits: what a run may take.
        parameters: values by target: all combinations are run.
        cases: combinations of their own; each is run with all of `parameters`.
        ranges: parameters that are sampled, or searched.
        samples: how many random samples of `ranges`.
        sample_seed: their random seed.
        search: what is searched for; None to sample.
    """

    path: Path
    world: Path
    title: str = ""
    programs: tuple[Path, ...] = ()
    arguments: tuple[str, ...] = ()
    defines: tuple[str, ...] = ()
    include_paths: tuple[Path, ...] = ()
    seeds: tuple[int, ...] = (1,)
    duration_s: float | None = None
    until_decided: bool = False
    setup: str = ""
    robot: str = "scout"
    link: Link = "serial"
    client: Client = "nclient"
    files: Mapping[str, Path] = field(default_factory=dict)
    measures: Path | None = None
    limits: Limits = field(default_factory=Limits)
    parameters: Mapping[str, tuple[Value, ...]] = field(default_factory=dict)
    cases: tuple[Mapping[str, Value], ...] = ()
    ranges: Mapping[str, Range] = field(default_factory=dict)
    samples: int = 0
    sample_seed: int = 1
    search: Search | None = None
