"""Grades submissions: copies them, runs each in every case, and collects what has become of it."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from crs_cc.cli.grading.grades import Case, Grade, alike
from crs_cc.cli.grading.job import GradedRun, Job, Limits
from crs_cc.cli.grading.processes import run_all
from crs_cc.cli.grading.submissions import Submission, UnusableError, copy

_LONGEST_NAME: Final = 40


@dataclass(frozen=True, slots=True)
class Settings:
    """How to run submissions.

    Attributes:
        jobs: how many runs at a time.
        allowed: the functions of the vendor's simulator that may be called.
        limits: what a run may take.
        runs: the folder of pictures and recordings; None for none.
    """

    jobs: int
    allowed: tuple[str, ...]
    limits: Limits
    runs: Path | None


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
        done: is told of each run that has ended, in any thread.

    Raises:
        OSError: a picture or a recording cannot be written.
    """
    with tempfile.TemporaryDirectory(prefix="crs-grade-") as folder:
        unusable: dict[int, GradedRun] = {}
        jobs: list[Job] = []
        for number, submission in enumerate(submissions):
            own = Path(folder, str(number))
            own.mkdir()
            try:
                sources = copy(submission, own)
            except UnusableError as error:
                unusable[number] = GradedRun("invalid", str(error))
                continue
            names = file_names(number, submission, cases)
            jobs += [_job(own, sources, *each, settings) for each in zip(cases, names, strict=True)]
        ran = iter(list(run_all(jobs, settings.jobs, done)))
    runs = [
        [unusable[number] if number in unusable else next(ran) for _ in cases]
        for number in range(len(submissions))
    ]
    same = alike(runs, [submission.name for submission in submissions])
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
    parts = [f"{number + 1:03d}", _plain(submission.name)]
    return [f"{'-'.join([*parts, _plain(case.name)])}.mcap" for case in cases]


def _plain(name: str) -> str:
    return re.sub(r"[^A-Za-z0-9_]+", "_", name)[:_LONGEST_NAME].strip("_")


def _job(
    folder: Path, sources: tuple[str, ...], case: Case, record: str, settings: Settings
) -> Job:
    return Job(
        str(folder),
        sources,
        str(case.world.resolve()),
        case.seed,
        settings.limits,
        settings.allowed,
        str((settings.runs / record).resolve()) if settings.runs is not None else "",
    )


def _write_pictures(grades: Sequence[Grade], folder: Path) -> None:
    for grade in grades:
        for run, name in zip(grade.runs, grade.files, strict=True):
            if run.picture:
                (folder / name).with_suffix(".svg").write_text(run.picture, "utf-8")
