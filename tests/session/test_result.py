"""A failure is told at the innermost place in the user's own files."""

from __future__ import annotations

import gc
from pathlib import Path

from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.testing import counting_program
from crs_cc.sim.world_xml import empty_world
from crs_cc.source import Diagnostic
from tests.session.programs import build, run

SOURCE = """\
#include <stdlib.h>
#include <string.h>
static void copy(char *to)
{
    strcpy(to, "x");
}
int down(int n)
{
    return n ? down(n - 1) + 1 : abs(n / n);
}
int main(void)
{
    %s;
    return 0;
}
"""


def failure(folder: Path, statement: str) -> Diagnostic:
    program = build(folder, SOURCE % statement)
    error = run(empty_world(), [program], 100).session.result().robots[0].error
    assert error is not None
    return error


def test_a_failure_in_the_library_is_told_where_the_program_called_it(tmp_path: Path) -> None:
    error = failure(tmp_path, "copy(0)")
    assert error.text == "null pointer (address 0x00000000) in strcpy"
    assert (Path(error.location.file).name, error.location.line) == ("program.c", 5)
    assert error.hint.endswith("program.c:13:5 in main")


def test_abort_is_told_where_it_was_called(tmp_path: Path) -> None:
    error = failure(tmp_path, "abort()")
    assert error.text == "abort called"
    assert error.location.line == 13
    assert error.hint == ""


def test_a_long_chain_of_calls_is_cut(tmp_path: Path) -> None:
    error = failure(tmp_path, "down(50)")
    assert error.text == "division by zero"
    assert error.location.line == 9
    assert error.hint.count(" in down") == 3
    assert error.hint.endswith("48 more")


def test_arrays_into_a_fleet_keep_its_memory() -> None:
    fleet = Fleet([counting_program()])
    memory, slots = fleet.memory(0), fleet.slots
    del fleet
    gc.collect()
    assert memory[5000] == 0
    assert slots["run"][0] == 0
