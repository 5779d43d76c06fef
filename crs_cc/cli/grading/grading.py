"""Grading of submissions: copy them, run each in every case, and collect the results."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from crs_cc.cli.grading.grades import Case, Grade, identical_programs
from crs_cc.cli.grading.job import GradedRun, Job, Limits, Robots
from crs_cc.cli.grading.processes import run_all
from crs_cc.cli.grading.submissions import Copy, Submission, UnusableError, copy

_MAX_NAME: Final = 40


@dataclass(frozen=True, slots=True)
class Settings:
    """How to run submissions.

    Attributes:
        jobs: how many runs at a time.
        allowed: the functions of the vendor's simulator that may be called.
        limits: what a run may take.
        runs: the folder of pictures and recordings; None for none.
        robots: the robots.
        inputs: files of the assignment that programs can read, by the names that they use.
        data: patterns of the names of files of a submission that its program can read.
    """

    jobs: int
    allowed: tuple[str, ...]
    limits: Limits
    runs: Path | None
    robots: Robots = field(default_factory=Robots)
    inputs: Mapping[str, Path] = field(default_factory=dict)
    data: tuple[str, ...] = ()


def grade_all(
    submissions: Sequence[Submission],
    cases: Sequence[Case],
    settings: Settings,
    done: Callable[[], None],
) -> list[Grade]:
    """Return the grade of each submission.

    Args:
        submissions: the submissions.
        cases: what each of them is run in.
        settings: how to run them.
        done: is called with each run that has ended.

    Raises:
        OSError: a picture or a recording cannot be written.
    """
    if settings.runs is not None:
        for number, submission in enumerate(submissions):
            _remove_earlier(settings.runs, file_names(number, submission, cases))
    with tempfile.TemporaryDirectory(prefix="crs-grade-") as folder:
        unusable: dict[int, GradedRun] = {}
        jobs: list[Job] = []
        for number, submission in enumerate(submissions):
            own = Path(folder, str(number))
            own.mkdir()
            try:
                copied = copy(submission, own, settings.data)
            except UnusableError as error:
                unusable[number] = GradedRun("invalid", str(error))
                continue
            names = file_names(number, submission, cases)
            for case, record in zip(cases, names, strict=True):
                jobs.append(_job(submission.name, copied, case, record, settings))
        ran = iter(run_all(jobs, settings.jobs, done))
    runs = [
        [unusable[number] if number in unusable else next(ran) for _ in cases]
        for number in range(len(submissions))
    ]
    same = identical_programs(runs, [submission.name for submission in submissions])
    grades = [
        Grade(each, tuple(cases), tuple(runs[n]), same[n], tuple(file_names(n, each, cases)))
        for n, each in enumerate(submissions)
    ]
    if settings.runs is not None:
        _write_pictures(grades, settings.runs)
    return grades


def file_names(number: int, submission: Submission, cases: Sequence[Case]) -> list[str]:
    """Return the name of the recording of each run, which any file system can store.

    >>> file_names(0, Submission("a <b>/c", Path("x")), [Case("room seed 1", Path("r"), 1, ())])
    ['001-a_b_c-room_seed_1.mcap']
    """
    names = [_plain(case.name) for case in cases]
    if len({name.lower() for name in names}) < len(names):  # on Windows, case does not count
        names = [f"{place}-{name}" for place, name in enumerate(names, 1)]
    return [f"{number + 1:03d}-{_plain(submission.name)}-{name}.mcap" for name in names]


def _plain(name: str) -> str:
    return re.sub(r"[^A-Za-z0-9_]+", "_", name)[:_MAX_NAME].strip("_")


def _job(name: str, copied: Copy, case: Case, record: str, settings: Settings) -> Job:
    inputs = {each: copied.folder / each for each in copied.data} | dict(settings.inputs)
    return Job(
        name,
        str(copied.folder),
        copied.sources,
        str(case.world.resolve()),
        case.seed,
        settings.limits,
        settings.allowed,
        str((settings.runs / record).resolve()) if settings.runs is not None else "",
        {each: str(path.resolve()) for each, path in inputs.items()},
        settings.robots,
    )


def _remove_earlier(folder: Path, names: Sequence[str]) -> None:
    """Remove what an earlier grading has written of the same runs: they may fail now."""
    for name in names:
        for ending in (".mcap", ".svg"):
            (folder / name).with_suffix(ending).unlink(missing_ok=True)


def _write_pictures(grades: Sequence[Grade], folder: Path) -> None:
    for grade in grades:
        for run, name in zip(grade.runs, grade.files, strict=True):
            if run.picture:
                (folder / name).with_suffix(".svg").write_text(run.picture, "utf-8")
