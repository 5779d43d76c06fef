"""A local variable of a returned function is named only if it is unambiguous."""

from __future__ import annotations

from pathlib import Path

from tests.runtime.diagnosis.test_report import failure_of

FUNCTIONS = """\
#include <stdlib.h>
int *one(void) { int n[4] = { 1, 2, 3, 4 }, *p = n; return p + 1; }
int *again(void) { return one(); }
int *other(void) { int m[4] = { 1, 2, 3, 4 }, *p = m; return p; }
int compare(const void *a, const void *b) { return *(int *)a - *(int *)b; }
int main(void)
{
    int table[2] = { 2, 1 }, *p;

    qsort(table, 2, sizeof table[0], compare);
    p = %s();
    return *p;
}
"""


def test_a_variable_of_a_function_that_was_called_here_is_named(tmp_path: Path) -> None:
    failure = failure_of(tmp_path, FUNCTIONS % "one")
    assert failure.kind == "use after return"
    assert failure.object is not None
    assert (failure.object.name, failure.object.function) == ("n", "one")
    assert failure.value - failure.object.address == 4


def test_a_variable_of_a_function_further_down_is_named(tmp_path: Path) -> None:
    found = failure_of(tmp_path, FUNCTIONS % "again").object
    assert found is not None
    assert found.name == "n"


def test_an_ambiguous_variable_is_not_named(tmp_path: Path) -> None:
    failure = failure_of(tmp_path, FUNCTIONS % "other() ? one() : one")
    assert failure.kind == "use after return"
    assert failure.object is None
