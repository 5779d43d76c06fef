"""The stack of a program that stops again and again is read anew only where it has changed."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.runtime.diagnosis.inspect import call_stack
from tests.debug.stopped_program import Stopping

PROGRAM = """\
static int leaf(int n) { n++; return n; /* STOP */ }
static int twin(int n) { n--; return n; /* STOP */ }
static int (*const either[])(int) = {leaf, twin};

static int down(int n)
{
    int i, total = 0; /* STOP */

    if (n == 0)
        return either[total & 1](n);
    for (i = 0; i < 2; i++)
        total += either[(n + i) & 1](i) + down(n - 1); /* STOP */
    return total + leaf(1) + leaf(2) + twin(3);
}
int main(void)
{
    return down(4) + down(1) + leaf(0); /* STOP */
}
"""


@pytest.mark.parametrize("checked", [True, False])
def test_at_each_stop_it_is_what_a_walk_of_the_whole_stack_finds(
    checked: bool, tmp_path: Path
) -> None:
    program = Stopping(tmp_path, PROGRAM, checked=checked)
    for _ in range(100):
        stack = program.run().fleet.stopped(0).stack
        whole = call_stack(program.fleet.memory(0), program.executable.detail().compiled)
        assert tuple(stack) == whole
        assert (stack[0], stack[-1], stack[1:]) == (whole[0], whole[-1], whole[1:])


def test_a_stop_in_a_deep_recursion_reads_only_the_calls_that_have_changed(tmp_path: Path) -> None:
    source = "int f(int n)\n{\n    return n ? 1 + f(n - 1) : 0; /* STOP */\n}\n"
    program = Stopping(tmp_path, source + "int main(void) { return f(50); }\n")
    outer = list(program.run().fleet.stopped(0).stack)[1:]
    for _ in range(50):
        stack = program.run().fleet.stopped(0).stack
        kept = stack[2:]
        assert all(now is before for now, before in zip(kept, outer, strict=True))
        outer = list(stack)[1:]
    assert len(outer) > 50
