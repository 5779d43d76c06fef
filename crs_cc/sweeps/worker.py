"""A process that checks variants of an experiment, runs and records them; see `jobs.worker`."""

from __future__ import annotations

import contextlib
import hashlib
import os
import time
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any, Final

from crs_cc.api.session import Session
from crs_cc.api.worlds import world_of
from crs_cc.core.errors import CrsError
from crs_cc.jobs.forked import run_forked
from crs_cc.jobs.memory_limit import limit_memory
from crs_cc.jobs.worker import serve
from crs_cc.recording.recording import Recording
from crs_cc.session.result import RunResult
from crs_cc.sweeps import single_run
from crs_cc.sweeps.experiment import Experiment
from crs_cc.sweeps.experiment_file import parse
from crs_cc.sweeps.measures import OURS, Measure, MeasureError, load_measures
from crs_cc.sweeps.rows import PART
from crs_cc.sweeps.variant import Variant, VariantLoader, unused_macros

_KEPT: Final = 16
"""Variants that a process keeps: the runs of one, with all seeds, follow each other."""

_SHOWN: Final = 3
"""Messages of one variant; a compiler can have many."""

_MIB: Final = 2**20


class _Loaded:
    """An experiment with its variants and measures, loaded on demand."""

    def __init__(self, job: dict[str, Any]) -> None:
        self.text = job["experiment"]
        self.experiment: Experiment = parse(self.text, Path(job["path"]))
        self._loader = VariantLoader(self.experiment, Path(job["robots"]))
        self._variants: OrderedDict[str, Variant] = OrderedDict()
        self._measures: tuple[Measure, ...] | None = None

    def variant(self, job: dict[str, Any]) -> Variant:
        """Return the variant of a combination of parameters; raise CrsError if it is invalid."""
        parameters = job["parameters"]
        seed = job["seed"] if self._loader.scatters else None
        key = repr((parameters, seed))
        if key not in self._variants:
            self._variants[key] = self._loader.load(parameters, seed)
            if len(self._variants) > _KEPT:
                self._variants.popitem(last=False)
        return self._variants[key]

    @property
    def measures(self) -> tuple[Measure, ...]:
        """The user's measures; raises CrsError if they are invalid."""
        if self._measures is None:
            path = self.experiment.measures
            self._measures = () if path is None else load_measures(path)
        return self._measures


_loaded: _Loaded | None = None


def _of(job: dict[str, Any]) -> _Loaded:
    global _loaded  # noqa: PLW0603 - a process has one experiment
    if _loaded is None or _loaded.text != job["experiment"]:
        os.chdir(Path(job["path"]).parent)
        _loaded = _Loaded(job)
    return _loaded


def _load(job: dict[str, Any]) -> None:
    """Load the data that later runs need as well; the job itself reports its errors."""
    with contextlib.suppress(CrsError, TypeError, ValueError):
        world_of(_of(job).variant(job).world)  # checks it, for all runs of the variant
        _of(job).measures  # noqa: B018 - loads them


def _batch_key(job: dict[str, Any]) -> str:
    """Return the variant that is run: a run depends on none before it in the same process."""
    return "" if job["do"] == "check" else repr(job["parameters"])


def _work(job: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    if job["do"] == "run":
        return _batch(job, prepared)
    do = {"check": _check, "record": _record}[job["do"]]
    return _guarded(job, lambda: do(job, prepared))


def _batch(job: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    """Run some runs of a variant; return their rows, or none if each has to be run alone.

    Measures come last: copying a process costs it a page fault for each page that it writes
    afterwards, some thousands in the next run.
    """
    runs: list[_Run] = []
    rows: list[dict[str, Any]] = []
    for number, seed in job["runs"]:
        runs.append(_Run({**job, "number": number, "seed": seed}))
        rows.append(_guarded(job, partial(runs[-1].run, prepared)))
        if "is_last" in rows[-1] and len(job["runs"]) > 1:
            return {"rows": [], "is_last": True}
    for place, run in enumerate(runs):
        if run.session is not None:
            if place:
                prepared()  # each may take as long as a run
            rows[place] = _guarded(job, partial(run.measured, rows[place]))
    ends = [row.pop("is_last", False) for row in rows]
    return {"rows": rows, "is_last": any(ends)}


def _guarded(job: dict[str, Any], do: Callable[[], dict[str, Any]]) -> dict[str, Any]:
    """Return the result of a function, or its exception: one run must not end the sweep."""
    try:
        return do()
    except CrsError as error:
        found = {"status": "crashed", "error": _message(error, job)}
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        found = {"status": "crashed", "error": f"{place}{error.strerror or error}"}
    except MemoryError:
        most = _of(job).experiment.limits.memory_mib
        found = {"status": "limit", "error": f"needed more than {most} MiB of memory"}
    except Exception as error:
        found = {"status": "crashed", "error": f"{type(error).__name__}: {error}"}
    return {**found, "is_last": True}


def _message(error: CrsError, job: dict[str, Any]) -> str:
    """Return the first message of an error, with its location if it is about the experiment."""
    first = error.diagnostics[0]
    if first.location.file != job["path"]:
        return "\n".join(each.render() for each in error.diagnostics[:_SHOWN])
    return f"{first.text}\n    hint: {first.hint}" if first.hint else first.text


def _check(job: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    """Return the sources of a variant, or its error."""
    loaded = _of(job)
    variant = loaded.variant(job)
    prepared()
    single_run.end_s(loaded.experiment, variant)
    unused = list(unused_macros(job["parameters"], variant))
    files = dict(variant.files)
    files.pop(loaded.experiment.world)  # as it is on the disk counts
    read = [loaded.experiment.world, *loaded.experiment.files.values()]
    if loaded.experiment.measures is not None:
        read.append(loaded.experiment.measures)
    files |= {path: path.read_bytes() for path in read}
    return {
        "unused": unused,
        "measures": [each.name for each in loaded.measures],
        "goals": [goal.id for goal in variant.world.goals],
        "files": {
            os.path.relpath(path): hashlib.sha256(content).hexdigest()
            for path, content in files.items()
            if not Path(path).is_relative_to(Path(job["out"]))
        },
    }


class _Run:
    """One run of a batch.

    Attributes:
        session: its session, until the user's measures have been computed; None if there are none.
    """

    def __init__(self, job: dict[str, Any]) -> None:
        self._job = job
        self.session: Session | None = None

    def run(self, prepared: Callable[[], None]) -> dict[str, Any]:
        """Run it; return its row without the user's measures, and without what planned it."""
        loaded = _of(self._job)
        variant = loaded.variant(self._job)
        prepared()
        started_s = time.monotonic()
        session = single_run.create(loaded.experiment, variant, self._job["seed"])
        # Programs have their memory now, of which they use a small part: it is not limited.
        limit_memory(loaded.experiment.limits.memory_mib * _MIB)
        try:
            ending = single_run.run(loaded.experiment, session)
        finally:
            limit_memory(None)
        wall_s = round(time.monotonic() - started_s, 6)
        if loaded.measures:
            self.session = session
        row = {"status": ending.status, "error": ending.text}
        return {**row, **_results(session.result()), "wall_s": wall_s}

    def measured(self, row: dict[str, Any]) -> dict[str, Any]:
        """Return its row with the user's measures, and release the session.

        They are computed apart: what their code keeps or changes reaches no other run.
        """
        loaded, session, self.session = _of(self._job), self.session, None
        assert session is not None
        measures, experiment = loaded.measures, loaded.experiment
        started_s = time.monotonic()
        most = experiment.limits.memory_mib * _MIB
        path = None
        if any(measure.of == "recording" for measure in measures):
            path = Path(self._job["out"], f"run-{self._job['number']}{PART}")
        try:
            if path is not None:
                variant = loaded.variant(self._job)
                single_run.record(experiment, variant, self._job["seed"], path)
            found = run_forked(lambda: _values(measures, session, path, most))
        finally:
            if path is not None:
                path.unlink(missing_ok=True)
        wall_s = round(row["wall_s"] + time.monotonic() - started_s, 6)
        row = {**row, "measures": {**row["measures"], **found["values"]}, "wall_s": wall_s}
        if row["status"] == "ended" and found["error"]:
            row |= {"status": "measure error", "error": found["error"]}
        return row


def _values(
    measures: Sequence[Measure], session: Session, path: Path | None, most: int
) -> dict[str, Any]:
    """Return the values of measures up to the first that fails, and its error."""
    values: dict[str, Any] = {}
    limit_memory(most)
    try:
        for measure in sorted(measures, key=lambda each: each.of == "recording"):
            subject = session if path is None or measure.of == "session" else Recording(path)
            values[measure.name] = measure.value(subject)
    except MeasureError as error:
        return {"values": values, "error": str(error)}
    finally:
        limit_memory(None)
    return {"values": values, "error": ""}


def _results(result: RunResult) -> dict[str, Any]:
    return {
        "simulated_s": round(result.simulated_s, 9),
        "goals": {goal.id: {"status": goal.status, "at_s": goal.at_s} for goal in result.goals},
        "measures": {name: of(result) for name, (_, of) in OURS.items()},
        "state_hash": result.state_hash,
    }


def _record(job: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    loaded = _of(job)
    variant = loaded.variant(job)
    prepared()
    path = Path(job["record"])
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        return asdict(single_run.record(loaded.experiment, variant, job["seed"], path))
    except OSError:
        path.unlink(missing_ok=True)  # the start of it would be taken for all
        raise


if __name__ == "__main__":
    serve(_work, _load, _batch_key)
