"""Fuel is paid early and seldom, and yet exact wherever it can be seen."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.ir.instruction import Branch, Jump, Switch
from crs_cc.ir.loops import loop_headers
from crs_cc.runtime.codegen.fuel_charges import early_charges
from crs_cc.session.build import build_executable
from tests.c.execution import Run, Stepping
from tests.runtime.codegen.test_flow_graph import walker

SUM = """
int main(int argc, char **argv)
{
    static int values[20];
    int i, sum = 0;

    for (i = 0; i < 20; i++)
        values[i] = i;
    for (i = 0; i < 20 + 30 * argc; i++)
        if (i % 3)
            sum += values[i];
        else
            sum -= 1000 / (i - 18);
    return sum;
}
"""


@pytest.mark.parametrize("seed", range(40))
def test_every_path_pays_for_its_blocks(seed: int) -> None:
    function = walker(seed, 2 + seed % 12).functions["__crs_start"]
    headers = loop_headers(function)
    fuel = early_charges(function, headers, {each: each.fuel for each in function.blocks})
    assert fuel.received[function.blocks[0]] == 0
    for block in function.blocks:
        assert fuel.charges[block] >= 0
        assert fuel.charges[block] == block.fuel + fuel.prepaid[block] - fuel.received[block]
        assert all(fuel.received[each] == fuel.prepaid[block] for each in block.successors())
        if not isinstance(block.terminator, Jump | Branch | Switch):
            assert fuel.prepaid[block] == 0


def test_a_loop_pays_once_for_a_turn(tmp_path: Path) -> None:
    source = tmp_path / "loop.c"
    source.write_text("int main(void) { int i, s = 0; for (i = 0; i < 9; i++) s += i; return s; }")
    function = build_executable([source], Diagnostics()).program.functions["main"]
    (header,) = loop_headers(function)
    fuel = early_charges(function, {header}, {each: each.fuel for each in function.blocks})
    body = next(each for each in header.successors() if header in each.successors())
    assert fuel.charges[header] == 0
    assert fuel.charges[body] == header.fuel + body.fuel


@pytest.mark.parametrize("trap", ["out of bounds", "division by zero"])
def test_a_failure_in_a_loop_has_paid_the_same_in_every_build(tmp_path: Path, trap: str) -> None:
    source = tmp_path / "fails.c"
    source.write_text(SUM if trap == "division by zero" else SUM.replace("i - 18", "i + 1"))
    burnt = set()
    for debug in (False, True):
        executable = build_executable([source], Diagnostics(), debug=debug)
        for fuel in (10**6, 1, 17):
            outcome = Run(executable, Stepping(fuel)).to_end()
            assert outcome.failure is not None
            assert outcome.failure.kind == trap
            burnt.add(outcome.fuel)
    assert len(burnt) == 1
