"""Which tests quick runs take: as many as the time allows, some of every file first.

Times come from the table in `times.txt`; what it does not list is cheap or new.
Every file is represented, if need be by its cheapest test, unless that takes very long. Then one
case of each function comes, and of one whose cases lie in folders (`valid/arrays/bounds`) one of
each folder, the cheap ones before, in turn of each file.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Final

from tests.times import function_of

BUDGET_S: Final = 14.0
"""Processor time of the tests that are taken. To be changed when quick runs take too long."""

UNLISTED_S: Final = 0.015
"""Processor time of a test that the table does not list, in the mean."""

TOO_LONG_S: Final = 0.3
"""A file whose cheapest test takes longer than this is not represented."""


def group_of(test: str) -> str:
    """Return the cases that a case can represent: those of its function, in the same folder.

    >>> group_of("tests/c/test_cases.py::test_valid[valid/arrays/bounds]")
    'tests/c/test_cases.py::test_valid[valid/arrays'
    >>> group_of("tests/test_a.py::test_b[1-2]")
    'tests/test_a.py::test_b'
    """
    return test.rpartition("/")[0] if "/" in test.partition("[")[2] else function_of(test)


def file_of(test: str) -> str:
    """Return the file that a test is in."""
    return test.partition("::")[0]


def chosen(
    tests: Sequence[str], times_s: Mapping[str, float], budget_s: float = BUDGET_S
) -> set[str]:
    """Return the tests that a quick run takes.

    Args:
        tests: the node ids of all tests, in their order.
        times_s: the table, see `times.read`.
        budget_s: the processor time for those that the table lists.
    """
    costs_s = {
        test: times_s.get(test, times_s.get(function_of(test), UNLISTED_S)) for test in tests
    }
    taken: set[str] = set()
    left_s = budget_s
    files: set[str] = set()
    for test in sorted(costs_s, key=costs_s.__getitem__):
        if file_of(test) not in files and costs_s[test] < TOO_LONG_S:
            files.add(file_of(test))
            taken.add(test)
            left_s -= costs_s[test]
    for test in _in_rounds(taken, costs_s):
        if costs_s[test] <= left_s:
            taken.add(test)
            left_s -= costs_s[test]
    return taken


def _in_rounds(taken: set[str], costs_s: Mapping[str, float]) -> Iterable[str]:
    """Return the other tests: first one of each group, of equal cost in turn of each file."""
    groups, files = Counter(map(group_of, taken)), Counter(map(file_of, taken))
    rounds = {}
    for test in sorted(costs_s, key=costs_s.__getitem__):
        if test not in taken:
            rounds[test] = groups[group_of(test)], files[file_of(test)]
            groups[group_of(test)] += 1
            files[file_of(test)] += 1
    return sorted(rounds, key=lambda test: (rounds[test][0], costs_s[test], rounds[test][1]))
