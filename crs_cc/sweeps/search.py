"""Searches for the best parameters by Optuna (extra `search`), instead of running all.

Trials are chosen in batches, and their values are reported when all runs of a batch have ended;
each batch has its own random seed. So the trials are a function of the experiment: they depend
neither on the number of processes nor on interruptions. The study is `study.db`, of Optuna.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Final

from crs_cc.core.source import Location
from crs_cc.sweeps.experiment import Experiment, ExperimentError, Range, Search, Value
from crs_cc.sweeps.plan import PlannedRun, shown
from crs_cc.sweeps.report.results import value_of
from crs_cc.sweeps.rows import Row

if TYPE_CHECKING:
    from optuna import Study, Trial
    from optuna.samplers import BaseSampler

DATABASE: Final = "study.db"
_NAME: Final = "sweep"


class ParameterSearch:
    """The search of an experiment, which proposes and evaluates batch by batch."""

    def __init__(self, experiment: Experiment, folder: Path) -> None:
        """Create the study, or open it if it has begun.

        Raises:
            ExperimentError: Optuna is not installed.
        """
        assert experiment.search is not None
        self._experiment, self._search = experiment, experiment.search
        try:
            import cmaes as _cmaes  # noqa: F401 - which Optuna needs for this method
            import optuna
        except ImportError:
            place = Location(str(experiment.path))
            hint = "pip install 'crs_cc[search]'"
            raise ExperimentError.at(place, "[search] needs Optuna", hint) from None
        optuna.logging.set_verbosity(optuna.logging.WARNING)
        self.study: Study = optuna.create_study(
            storage=f"sqlite:///{folder / DATABASE}",
            study_name=_NAME,
            direction="maximize" if self._search.maximize else "minimize",
            load_if_exists=True,
        )

    def batches(self, rows: Mapping[int, Row]) -> Iterator[list[PlannedRun]]:
        """Yield the runs of one batch after another; each needs the rows of those before.

        Args:
            rows: the rows that there are, which grow.
        """
        search = self._search
        for first in range(0, search.trials, search.batch):
            self.study.sampler = _sampler(search, first)
            numbers = range(first, min(first + search.batch, search.trials))
            runs = {number: self._runs(number) for number in numbers}
            yield [run for each in runs.values() for run in each]
            for number, planned in runs.items():
                self._tell(number, [rows[run.number] for run in planned])

    def _runs(self, number: int) -> list[PlannedRun]:
        """Return the runs of a trial, which is chosen now unless it has been."""
        trials = self.study.get_trials(deepcopy=False)
        if number < len(trials):
            values = trials[number].params
        else:
            trial = self.study.ask()
            values = {name: _suggested(trial, name, each) for name, each in self._ranges.items()}
        parameters = {name: each.written(values[name]) for name, each in self._ranges.items()}
        seeds = self._experiment.seeds
        return [
            PlannedRun(number * len(seeds) + place, parameters, seed)
            for place, seed in enumerate(seeds)
        ]

    @property
    def _ranges(self) -> Mapping[str, Range]:
        return self._experiment.ranges

    def _tell(self, number: int, rows: list[Row]) -> None:
        """Tell the study the median over the seeds; a trial without values has failed."""
        from optuna.trial import TrialState

        found = [value for value, _ in (value_of(row, self._search.measure) for row in rows)
                 if value is not None]  # fmt: skip
        if self.study.get_trials(deepcopy=False)[number].state != TrialState.RUNNING:
            return  # it was reported before an interruption
        if found:
            self.study.tell(number, median(found))
        else:
            self.study.tell(number, state=TrialState.FAIL)


def best(search: Search, rows: Iterable[Row]) -> tuple[Mapping[str, Value], float] | None:
    """Return the parameters with the best median of the measure, and the median; None for none.

    Of equal ones the first.
    """
    trials: dict[str, tuple[Mapping[str, Value], list[float]]] = {}
    for row in sorted(rows, key=lambda each: int(each["run"])):
        value, _ = value_of(row, search.measure)
        if value is not None:
            _, values = trials.setdefault(shown(row["parameters"]), (row["parameters"], []))
            values.append(value)
    sign = -1.0 if search.maximize else 1.0
    found = [(parameters, median(values)) for parameters, values in trials.values()]
    return min(found, key=lambda each: sign * each[1], default=None)


def _suggested(trial: Trial, name: str, wanted: Range) -> float:
    if wanted.integer:
        return trial.suggest_int(name, int(wanted.low), int(wanted.high), log=wanted.log)
    return trial.suggest_float(name, wanted.low, wanted.high, log=wanted.log)


def _sampler(search: Search, batch: int) -> BaseSampler:
    """Return the sampler of a batch's trials, as a function of earlier ones."""
    import warnings

    from optuna.exceptions import ExperimentalWarning
    from optuna.samplers import CmaEsSampler, TPESampler

    seed = search.seed + batch
    if search.method == "cma-es":
        return CmaEsSampler(seed=seed)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ExperimentalWarning)
        return TPESampler(seed=seed, constant_liar=True)  # of a batch, no two alike
