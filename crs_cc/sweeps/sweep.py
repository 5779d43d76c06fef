"""Runs an experiment: checks it, runs what has no row yet, and writes the table.

What is wrong with an experiment is found before its first run: every combination of parameters is
loaded and compiled. After that nothing costs the rows that there are.
"""

from __future__ import annotations

import json
import os
import shutil
import time
from collections.abc import Callable, Collection, Generator, Iterable, Iterator, Sequence
from contextlib import closing, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Self

from crs_cc import __version__
from crs_cc.core.errors import CrsError
from crs_cc.core.source import Diagnostic, Location
from crs_cc.jobs.forked import CAN_FORK
from crs_cc.jobs.pool import Outcome, Pool, Task
from crs_cc.recording.description import versions
from crs_cc.recording.recording import Recording
from crs_cc.sweeps.batches import MAX_BATCH, Batches
from crs_cc.sweeps.experiment import Experiment, ExperimentError
from crs_cc.sweeps.experiment_file import parse, read_text
from crs_cc.sweeps.plan import (
    Parameters,
    PlannedRun,
    combinations_to_check,
    names_of,
    runs_of,
    shown,
)
from crs_cc.sweeps.rows import PART, ROWS, TABLE, Row, RowFile, read_rows, replace_text, table_text

if TYPE_CHECKING:
    from crs_cc.jobs.cluster import Cluster

_MODULE: Final = "crs_cc.sweeps.worker"
_PLAN: Final = "sweep.json"
FAILED: Final = "failed"
"""The folder of the recordings of runs that failed."""

ROBOTS: Final = "robots"
"""The folder of robot definitions that are varied."""

MAX_RECORDINGS: Final = 100
"""Runs that failed and are recorded, the first ones: a sweep can have many thousands."""

_SHOWN: Final = 10
_CHECK_S: Final = 300.0
_RETRIES: Final = 2
"""How often a run is tried again whose process was killed."""

_TOGETHER_S: Final = 20.0
"""Real time of a run in a batch, which should take less than a second: then it is run alone."""

RunTasks = Callable[[Iterable[Task], int], Generator[Outcome, None, None]]
"""Yields the outcomes of tasks, given the number of retries when a process crashes."""


@dataclass(slots=True)
class Progress:
    """How far a sweep is.

    Attributes:
        runs: how many runs there are.
        done: how many of them have a row.
        failed: how many of these did not just end.
        begun_with: how many had a row when this process began.
        started_s: when it did, on `time.monotonic`.
    """

    runs: int
    done: int
    failed: int
    begun_with: int
    started_s: float = field(default_factory=time.monotonic)

    @property
    def per_s(self) -> float:
        """Runs per second of real time."""
        return (self.done - self.begun_with) / max(time.monotonic() - self.started_s, 1e-9)

    @property
    def left_s(self) -> float:
        """The estimated remaining real time [s]."""
        return (self.runs - self.done) / self.per_s if self.per_s else 0.0


class Sweep:
    """An experiment and the folder of its results.

    Attributes:
        experiment: the experiment.
        folder: the folder.
        rows: the rows that there are, by the numbers of their runs.
        unrecorded: why runs that failed have no recording, by their numbers.
    """

    def __init__(self, path: Path, folder: Path, text: str | None = None) -> None:
        """Read an experiment.

        Args:
            path: its file.
            folder: the folder of its results.
            text: its text; by default the content of the file.

        Raises:
            ExperimentError: it is invalid.
        """
        self._text = read_text(path) if text is None else text
        self.experiment: Experiment = parse(self._text, path)
        self.folder = folder
        self.rows: dict[int, Row] = {}
        self.unrecorded: dict[int, str] = {}
        self._versions = {"crs": __version__, **versions()}

    @classmethod
    def of(cls, folder: Path) -> Self:
        """Return the sweep whose results are in a folder.

        Raises:
            ExperimentError: there are none.
        """
        try:
            plan = json.loads((folder / _PLAN).read_text("utf-8"))
            found = cls(Path(os.path.normpath(folder / plan["path"])), folder, plan["experiment"])
            found.rows, _ = read_rows(folder / ROWS)
        except (OSError, ValueError, KeyError, TypeError):
            text, hint = "no results of a sweep", "crs sweep EXPERIMENT.toml --out DIR makes them"
            raise ExperimentError.at(Location(str(folder)), text, hint) from None
        if not found.rows:
            raise found._error("no run has ended yet", "continue with crs sweep --resume")
        return found

    def run(
        self,
        jobs: int,
        *,
        dask: str = "",
        resume: bool = False,
        report: Callable[[Progress], None] = lambda _: None,
        pool: RunTasks | None = None,
    ) -> None:
        """Run everything that has no row yet.

        Args:
            jobs: how many runs at a time on this machine.
            dask: the address of the scheduler of a Dask cluster to run on instead.
            resume: continue from the rows in the folder.
            report: is called with the progress after each run.
            pool: runs tasks; by default chosen by `jobs` and `dask`.

        Raises:
            CrsError: the experiment is invalid, or does not fit to the folder, or the cluster is
                lost; the rows so far are kept.
            OSError: a result cannot be written; the rows so far are kept.
        """
        if pool is None:
            with _pool(jobs, dask) as workers:
                self.run(jobs, resume=resume, report=report, pool=workers.run)
            return
        self._check_folder(resume=resume)
        is_new = not self.folder.exists()
        try:
            plan = self._checked_plan(pool)
        except BaseException:
            self._remove_definitions(is_new=is_new)
            raise
        self._check_plan(plan, resume=resume)
        self.folder.mkdir(parents=True, exist_ok=True)
        replace_text(self.folder / _PLAN, json.dumps(plan, indent=1))
        with RowFile(self.folder) as rows:
            self.rows = rows.rows
            self._remove_leftovers()
            try:
                self._run_planned(pool, rows, report)
                self._record_failed(pool)
            finally:
                self._remove_leftovers()
                self.write_table()

    def _remove_definitions(self, *, is_new: bool) -> None:
        """Remove the definitions that were written for checking, unless the sweep has a plan."""
        if (self.folder / _PLAN).exists():
            return
        shutil.rmtree(self.folder / ROBOTS, ignore_errors=True)
        if is_new:
            with suppress(OSError):
                self.folder.rmdir()

    def _remove_leftovers(self) -> None:
        """Remove the temporary files of measures whose processes were killed."""
        for path in self.folder.glob(f"run-*{PART}"):
            path.unlink(missing_ok=True)

    def write_table(self) -> None:
        """Write the table of the rows that there are."""
        constants = {name: self._versions[name] for name in ("crs", "sources")}
        text = table_text(list(self.rows.values()), constants)
        replace_text(self.folder / TABLE, text)

    # -- before the first run --------------------------------------------------------------------

    def _error(self, text: str, hint: str = "") -> ExperimentError:
        return ExperimentError.at(Location(str(self.folder)), text, hint)

    def _check_folder(self, *, resume: bool) -> None:
        has_rows = (self.folder / _PLAN).exists()
        if has_rows and not resume:
            hint = "continue it with --resume, or choose another folder with --out"
            raise self._error("already has the results of a sweep", hint)
        names = {path.name for path in self.folder.iterdir()} if self.folder.is_dir() else set()
        if not has_rows and names - {ROBOTS}:
            raise self._error("is not empty", "name another folder with --out")

    def _checked_plan(self, pool: RunTasks) -> dict[str, Any]:
        """Check every combination; return what identifies the sweep.

        Raises:
            ExperimentError: some of them are invalid.
        """
        wanted = combinations_to_check(self.experiment)
        tasks = (self._task("check", PlannedRun(0, each, 0)) for each in wanted)
        results: dict[int, Row] = {}
        wrong: dict[str, int] = {}
        with closing(pool(tasks, 0)) as outcomes:
            for each in outcomes:
                found = results[each.number] = each.result or {"error": each.text}
                if "error" in found:
                    first = wrong.get(found["error"], each.number)
                    wrong[found["error"]] = min(first, each.number)
        if wrong:
            raise ExperimentError(list(self._messages(wrong, wanted)))
        self._check_macros([results[number]["unused"] for number in range(len(wanted))])
        return {
            "path": os.path.relpath(self.experiment.path, self.folder),
            "experiment": self._text,
            "files": {
                name: digest
                for number in range(len(wanted))
                for name, digest in results[number]["files"].items()
            },
            "versions": self._versions,
        }

    def _messages(
        self, wrong: dict[str, int], wanted: Sequence[Parameters]
    ) -> Iterator[Diagnostic]:
        """Yield each distinct error once, with the first combination that causes it."""
        place = Location(str(self.experiment.path))
        for text, number in sorted(wrong.items(), key=lambda each: each[1])[:_SHOWN]:
            where = shown(wanted[number])
            yield Diagnostic("error", place, f"{where}: {text}" if where else text)
        if len(wrong) > _SHOWN:
            yield Diagnostic("error", place, f"{len(wrong) - _SHOWN} more errors")

    def _check_macros(self, unused: Sequence[Sequence[str]]) -> None:
        for name in names_of(self.experiment):
            macro = name.removeprefix("define.")
            if macro != name and all(macro in each for each in unused):
                place = Location(str(self.experiment.path))
                raise ExperimentError.at(place, f"{name}: no C file uses the macro '{macro}'")

    def _check_plan(self, plan: dict[str, Any], *, resume: bool) -> None:
        """Refuse to continue with results of a different experiment."""
        if not resume or not (self.folder / _PLAN).exists():
            return
        try:
            before = json.loads((self.folder / _PLAN).read_text("utf-8"))
        except ValueError:
            raise self._error(f"{_PLAN} is damaged", "name another folder with --out") from None
        changed = [name for name in ("experiment", "versions") if before[name] != plan[name]]
        changed += sorted(
            name
            for name in before["files"].keys() | plan["files"].keys()
            if before["files"].get(name) != plan["files"].get(name)
        )
        if changed:
            what = ", ".join(changed[:_SHOWN])
            hint = "its rows belong to what there was: name another folder with --out"
            raise self._error(f"the sweep has changed since it began: {what}", hint)

    # -- the runs --------------------------------------------------------------------------------

    def _task(self, do: str, run: PlannedRun, **more: object) -> Task:
        job = {
            "do": do,
            "experiment": self._text,
            "path": os.path.abspath(self.experiment.path),  # noqa: PTH100 - links stay
            "out": os.path.abspath(self.folder),  # noqa: PTH100
            "robots": os.path.abspath(self.folder / ROBOTS),  # noqa: PTH100
            "number": run.number,
            "parameters": run.parameters,
            "seed": run.seed,
            **more,
        }
        return Task(job, _CHECK_S, self.experiment.limits.wall_s, "loading")

    def _batch_task(self, batch: Sequence[PlannedRun]) -> Task:
        task = self._task("run", batch[0], runs=[(run.number, run.seed) for run in batch])
        is_alone = len(batch) == 1
        return task if is_alone else replace(task, run_s=min(task.run_s, _TOGETHER_S))

    def _run_planned(
        self, pool: RunTasks, rows: RowFile, report: Callable[[Progress], None]
    ) -> None:
        failed = sum(row["status"] != "ended" for row in rows.rows.values())
        progress = Progress(self._total, len(rows.rows), failed, len(rows.rows))
        report(progress)
        for batch in self._batches():
            for row in self._rows_of(pool, batch, set(rows.rows)):
                rows.add(row)
                progress.done += 1
                progress.failed += row["status"] != "ended"
                report(progress)

    @property
    def _total(self) -> int:
        if self.experiment.search is not None:
            return self.experiment.search.trials * len(self.experiment.seeds)
        return sum(1 for _ in runs_of(self.experiment))

    def _batches(self) -> Iterable[Iterable[PlannedRun]]:
        """Return the runs in batches, each of which is chosen when those before have ended."""
        if self.experiment.search is None:
            return [runs_of(self.experiment)]
        from crs_cc.sweeps.search import ParameterSearch

        return ParameterSearch(self.experiment, self.folder).batches(self.rows)

    def _rows_of(
        self, pool: RunTasks, runs: Iterable[PlannedRun], done: Collection[int]
    ) -> Iterator[Row]:
        """Yield the rows of runs that are not done yet, as they end.

        What may be the fault of another run of a batch is found out by running each of them alone.
        """
        alone: list[PlannedRun] = []
        batches = Batches((each for each in runs if each.number not in done), self._most_in_batch)
        yield from self._rows_of_batches(pool, batches, alone)
        if alone:
            alone.sort(key=lambda run: run.number)
            yield from self._rows_of_batches(pool, Batches(alone, 1), None)

    @property
    def _most_in_batch(self) -> int:
        """The user's measures of several runs would meet where they are not computed apart."""
        return MAX_BATCH if CAN_FORK or self.experiment.measures is None else 1

    def _rows_of_batches(
        self, pool: RunTasks, batches: Batches, alone: list[PlannedRun] | None
    ) -> Iterator[Row]:
        """Yield the rows of runs, as they end; those that have to run alone are put in a list.

        Without such a list they are alone, and tried again if their process crashes.
        """
        planned: dict[int, list[PlannedRun]] = {}

        def tasks() -> Iterator[Task]:
            for number, batch in enumerate(batches):
                planned[number] = batch
                yield self._batch_task(batch)

        with closing(pool(tasks(), 0 if alone is not None else _RETRIES)) as outcomes:
            for outcome in outcomes:
                batch = planned.pop(outcome.number)
                rows = rows_of(batch, outcome)
                if alone is not None and (len(rows) < len(batch) or outcome.kind == "crashed"):
                    alone += batch
                    continue
                for row in rows:
                    batches.add_duration(row.get("wall_s"))
                    yield row

    def _record_failed(self, pool: RunTasks) -> None:
        """Run the first runs that failed once more, and record them."""
        failed = sorted(number for number, row in self.rows.items() if row["status"] != "ended")
        names = {number: f"{FAILED}/{number:04d}.mcap" for number in failed[:MAX_RECORDINGS]}
        missing = [each for each in names.items() if not (self.folder / each[1]).exists()]
        wrong = self._record([(self._planned(number), name) for number, name in missing], pool)
        for number, name in names.items():
            if self._unreadable(name):
                text = wrong.get(number, "its process ended")
                self.unrecorded[number] = text
                (self.folder / name).unlink(missing_ok=True)
            else:
                self.rows[number] = {**self.rows[number], "recording": name}

    def _unreadable(self, name: str) -> str:
        """Return why a recording cannot be read, empty if it can."""
        try:
            Recording(self.folder / name)
        except (OSError, CrsError) as error:
            return str(error)
        return ""

    def _planned(self, number: int) -> PlannedRun:
        row = self.rows[number]
        return PlannedRun(number, row["parameters"], row["seed"])

    def record_again(self, runs: Sequence[tuple[int, str]]) -> str:
        """Record runs that have a row, in files of the folder by their names.

        Returns:
            what went wrong, empty for nothing.
        """
        with Pool(_MODULE, 1) as workers:
            planned = [(self._planned(number), name) for number, name in runs]
            wrong = self._record(planned, workers.run)
        for number, text in wrong.items():
            return f"run {number} cannot be recorded: {text}"
        for number, name in runs:
            wanted = self.rows[number]["state_hash"]
            try:
                found = Recording(self.folder / name).result or {}
            except (OSError, CrsError) as error:
                return str(error)
            if found.get("state_hash") != wanted:
                return f"run {number} has another result now: a file or crs has changed"
        return ""

    def _record(self, runs: Sequence[tuple[PlannedRun, str]], pool: RunTasks) -> dict[int, str]:
        """Run some runs again and record them in files of the folder, by their names.

        Returns:
            what went wrong, by the numbers of the runs.
        """
        tasks = [
            self._task("record", run, record=os.path.abspath(self.folder / name))  # noqa: PTH100
            for run, name in runs
        ]
        wrong: dict[int, str] = {}
        with closing(pool(tasks, 0)) as outcomes:
            for each in outcomes:
                text = each.text if each.result is None else each.result.get("error", "")
                if text:
                    wrong[runs[each.number][0].number] = text
        return wrong


def _pool(jobs: int, dask: str) -> Pool | Cluster:
    """Return the executor of tasks: processes of this machine, or a Dask cluster."""
    if not dask:
        return Pool(_MODULE, jobs)
    from crs_cc.jobs.cluster import Cluster

    return Cluster(_MODULE, dask)


def rows_of(batch: Sequence[PlannedRun], outcome: Outcome) -> list[Row]:
    """Return the rows of runs that have ended, or whose process has; fewer if that is not sure."""
    if outcome.result is not None:
        found = outcome.result["rows"]
    else:
        found = [{"status": outcome.kind, "error": outcome.text}] * (len(batch) == 1)
    return [
        {"run": run.number, "parameters": dict(run.parameters), "seed": run.seed, **each}
        for run, each in zip(batch, found, strict=False)
    ]
