"""A process that checks variants of an experiment, runs and records them; see `jobs.worker`."""

from __future__ import annotations

import contextlib
import hashlib
import os
import time
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, Final

from crs_cc.api.session import Session
from crs_cc.api.worlds import world_of
from crs_cc.core.errors import CrsError
from crs_cc.jobs.apart import apart
from crs_cc.jobs.memory_limit import limit_memory
from crs_cc.jobs.worker import serve
from crs_cc.recording.recording import Recording
from crs_cc.session.result import RunResult
from crs_cc.sweeps import single_run
from crs_cc.sweeps.experiment import Experiment
from crs_cc.sweeps.experiment_file import parse
from crs_cc.sweeps.measures import OURS, Measure, MeasureError, load_measures
from crs_cc.sweeps.variant import Variant, VariantLoader, unused_macros

_KEPT: Final = 16
"""Variants that a process keeps: the runs of one, with all seeds, follow each other."""

_SHOWN: Final = 3
"""Messages of one variant; a compiler can have many."""

_MIB: Final = 2**20


class _Loaded:
    """An experiment with its variants and measures, as far as they have been needed."""

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
    """Load what later runs need as well; what is wrong with it is said by the job itself."""
    with contextlib.suppress(CrsError, TypeError, ValueError):
        world_of(_of(job).variant(job).world)  # checks it, for all runs of the variant
        _of(job).measures  # noqa: B018 - loads them


def _alike(job: dict[str, Any]) -> str:
    """Return the variant that is run: a run depends on none before it in the same process."""
    return repr(job["parameters"]) if job["do"] == "run" else ""


def _work(job: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    do = {"check": _check, "run": _run, "record": _record}[job["do"]]
    try:
        loaded = _of(job)
        variant = loaded.variant(job)
        prepared()
        return do(job, loaded, variant)
    except CrsError as error:
        return {"status": "crashed", "error": _message(error, job)}
    except OSError as error:
        return {"status": "crashed", "error": f"{error.filename}: {error.strerror}"}
    except MemoryError:
        most = loaded.experiment.limits.memory_mib
        return {"status": "limit", "error": f"needed more than {most} MiB of memory"}
    except Exception as error:  # one run must not end the sweep
        return {"status": "crashed", "error": f"{type(error).__name__}: {error}"}


def _message(error: CrsError, job: dict[str, Any]) -> str:
    """Return the first message of an error; that about the experiment is told with its place."""
    first = error.diagnostics[0]
    if first.location.file != job["path"]:
        return "\n".join(each.render() for each in error.diagnostics[:_SHOWN])
    return f"{first.text}\n    hint: {first.hint}" if first.hint else first.text


def _check(job: dict[str, Any], loaded: _Loaded, variant: Variant) -> dict[str, Any]:
    """Return what a variant was loaded from, or what is wrong with it."""
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


def _run(job: dict[str, Any], loaded: _Loaded, variant: Variant) -> dict[str, Any]:
    """Run a variant with a seed; return its row, without what planned it."""
    started_s = time.monotonic()
    session = single_run.create(loaded.experiment, variant, job["seed"])
    # Programs have their memory now, of which they use a small part: the rest of it is not limited.
    limit_memory(loaded.experiment.limits.memory_mib * _MIB)
    try:
        ending = single_run.run(loaded.experiment, session)
    finally:
        limit_memory(None)
    wall_s = time.monotonic() - started_s
    status, text = ending.status, ending.text
    measured = _measured(job, loaded, variant, session)
    if status == "ended" and measured["error"]:
        status, text = "measure error", measured["error"]
    return {
        "status": status,
        "error": text,
        **_results(session.result(), measured["values"]),
        "wall_s": round(wall_s, 6),
    }


def _measured(
    job: dict[str, Any], loaded: _Loaded, variant: Variant, session: Session
) -> dict[str, Any]:
    """Return the values of the user's measures, and what was wrong with one.

    They are computed apart: what their code keeps or changes reaches no other run.
    """
    measures = loaded.measures
    if not measures:
        return {"values": {}, "error": ""}
    if all(measure.of == "session" for measure in measures):
        return apart(lambda: _values(measures, session))
    path = Path(job["out"], f"run-{job['number']}.mcap.part")
    try:
        single_run.record(loaded.experiment, variant, job["seed"], path)
        return apart(lambda: _values(measures, session, path))
    finally:
        path.unlink(missing_ok=True)


def _values(
    measures: Sequence[Measure], session: Session, path: Path | None = None
) -> dict[str, Any]:
    """Return the values of measures up to the first that fails, and what was wrong with it."""
    values: dict[str, Any] = {}
    try:
        for measure in sorted(measures, key=lambda each: each.of == "recording"):
            subject = session if path is None or measure.of == "session" else Recording(path)
            values[measure.name] = measure.value(subject)
    except MeasureError as error:
        return {"values": values, "error": str(error)}
    return {"values": values, "error": ""}


def _results(result: RunResult, values: dict[str, Any]) -> dict[str, Any]:
    return {
        "simulated_s": round(result.simulated_s, 9),
        "goals": {goal.id: {"status": goal.status, "at_s": goal.at_s} for goal in result.goals},
        "measures": {**{name: of(result) for name, (_, of) in OURS.items()}, **values},
        "state_hash": result.state_hash,
    }


def _record(job: dict[str, Any], loaded: _Loaded, variant: Variant) -> dict[str, Any]:
    path = Path(job["record"])
    path.parent.mkdir(parents=True, exist_ok=True)
    return asdict(single_run.record(loaded.experiment, variant, job["seed"], path))


if __name__ == "__main__":
    serve(_work, _load, _alike)
