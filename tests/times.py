"""How long tests take: measured in processor time, and kept in `times.txt` in rough classes.

The table has a line for each test function that takes long, with the class of one of its cases,
and further lines for those of its cases that take much longer or less. What it does not list is
cheap, or new. `pytest --update-times` renews the lines of all files that it runs.
"""

from __future__ import annotations

import os
import time
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path
from statistics import median
from typing import Final

import pytest

from tests import commands

TABLE: Final = Path(__file__).with_name("times.txt")

CLASSES_S: Final = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0)

LISTED_S: Final = 0.1
"""A function is listed when all its cases take at least so long together."""

OTHER: Final = 5.0
"""A case has a line of its own when its class is so many times that of its function, or less."""

KEPT: Final = 1.6
"""A time that is out of its class by less than this factor keeps it, so that lines stay."""

HEAD: Final = """\
# Processor time of a case of each test that is not cheap [s], in classes of a factor of 3.
# "pytest --update-times" writes this file; tests/quick.py chooses the quick tests by it.
"""


def function_of(test: str) -> str:
    """Return the test function of a case: its node id without the parameters."""
    return test.partition("[")[0]


def class_of(seconds: float, before_s: float | None = None) -> float:
    """Return the class of a time, the one that it had before where that still fits.

    >>> class_of(0.2), class_of(0.5), class_of(0.5, 0.1), class_of(0.05, 0.1)
    (0.3, 0.3, 0.3, 0.1)
    """
    if before_s is not None and before_s / KEPT < seconds * 3**0.5 < 3 * before_s * KEPT:
        return before_s
    return next((each for each in CLASSES_S if seconds < each * 3**0.5), CLASSES_S[-1])


def read(table: Path) -> dict[str, float]:
    """Return the time of each test function or single case that the table lists [s]."""
    lines = table.read_text().splitlines() if table.exists() else []
    rows = [line.split(maxsplit=1) for line in lines if line and not line.startswith("#")]
    return {test: float(seconds) for seconds, test in rows}


def renewed(old: Mapping[str, float], measured_s: Mapping[str, float]) -> dict[str, float]:
    """Return the table after a run.

    Args:
        old: the table before.
        measured_s: the processor time of each case that passed [s].
    """
    ran = {test.partition("::")[0] for test in measured_s}
    table = {test: s for test, s in old.items() if test.partition("::")[0] not in ran}
    cases: dict[str, list[str]] = defaultdict(list)
    for test in measured_s:
        cases[function_of(test)].append(test)
    for function, tests in cases.items():
        if sum(measured_s[test] for test in tests) < LISTED_S:
            continue
        usual = median(measured_s[test] for test in tests)
        table[function] = class_of(usual, old.get(function))
        for test in tests:
            own = class_of(measured_s[test], old.get(test, table[function]))
            if not 1 / OTHER < own / table[function] < OTHER:
                table[test] = own
    return table


def write(rows: Mapping[str, float], table: Path) -> None:
    """Write the table, sorted by test."""
    lines = (f"{seconds:<5g} {test}\n" for test, seconds in sorted(rows.items()))
    table.write_text(HEAD + "".join(lines))


def _now_s() -> float:
    """Return the processor time of this process and of those of its children that ended [s]."""
    import resource  # which Windows does not have

    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    own_s = time.process_time() + children.ru_utime + children.ru_stime
    return own_s + commands.processor_s()


def shared_fixtures(item: pytest.Item) -> str:
    """Return the fixtures that a test shares with others of its file, which the first one makes."""
    known = item._fixtureinfo.name2fixturedefs if isinstance(item, pytest.Function) else {}
    names = sorted(name for name, made in known.items() if made[-1].scope != "function")
    return f"{item.nodeid.partition('::')[0]}::{','.join(names)}" if names else item.nodeid


def is_sharing(item: pytest.Item) -> bool:
    """Return whether a test uses something that ends with the last test of its file."""
    known = item._fixtureinfo.name2fixturedefs if isinstance(item, pytest.Function) else {}
    return any(made[-1].scope not in {"function", "session"} for made in known.values())


class Recorder:
    """A pytest plugin that measures all tests and renews the table when the run is over.

    What tests share counts for each of them, its end as well: a quick run that takes one of them
    has to make it.
    """

    def __init__(self, table: Path = TABLE) -> None:
        self._table = table
        self._since_s = 0.0
        self._measured_s: dict[str, float] = defaultdict(float)
        self._shares: dict[str, str] = {}
        self._setup_s: dict[str, float] = defaultdict(float)
        self._end_s: dict[str, float] = defaultdict(float)  # by file
        self._sharing: set[str] = set()
        self._is_last = False
        self._left_out: set[str] = set()

    def pytest_runtest_logstart(self) -> None:
        self._since_s = _now_s()

    def pytest_runtest_teardown(self, item: pytest.Item, nextitem: pytest.Item | None) -> None:
        self._is_last = nextitem is None or nextitem.path != item.path

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self, item: pytest.Item) -> Iterable[object]:
        report = yield
        now_s = _now_s()
        report.processor_s = now_s - self._since_s  # type: ignore[attr-defined]
        report.shares = shared_fixtures(item)  # type: ignore[attr-defined]
        report.is_sharing = is_sharing(item)  # type: ignore[attr-defined]
        report.is_end = report.when == "teardown" and self._is_last  # type: ignore[attr-defined]
        self._since_s = now_s
        return report

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        processor_s = getattr(report, "processor_s", 0.0)
        if report.when == "setup":
            shares = self._shares[report.nodeid] = getattr(report, "shares", "")
            self._setup_s[shares] = max(self._setup_s[shares], processor_s)
            if getattr(report, "is_sharing", False):
                self._sharing.add(report.nodeid)
        elif getattr(report, "is_end", False):
            file = report.nodeid.partition("::")[0]
            self._end_s[file] = max(self._end_s[file], processor_s)
        else:
            self._measured_s[report.nodeid] += processor_s
        if not report.passed:
            self._left_out.add(report.nodeid)

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if "PYTEST_XDIST_WORKER" in os.environ:
            return
        old, bad = read(self._table), {function_of(test) for test in self._left_out}
        whole_s = {}
        for test, s in self._measured_s.items():
            end_s = self._end_s[test.partition("::")[0]] if test in self._sharing else 0.0
            whole_s[test] = s + self._setup_s[self._shares.get(test, "")] + end_s
        good = {test: s for test, s in whole_s.items() if function_of(test) not in bad}
        kept = {test: s for test, s in old.items() if function_of(test) in bad}
        root = session.config.rootpath
        rows = renewed(old, good) | kept
        there = {test: s for test, s in rows.items() if (root / test.partition("::")[0]).exists()}
        write(there, self._table)
