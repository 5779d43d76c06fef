"""What the sessions of these tests run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.session.host import Output
from crs_cc.sim.files.world_xml import empty_world, load_world
from tests.debug.debuggers import debug_program

LOOP = """\
#include <stdio.h>
struct point { int x, y; } here;
static int twice(int what)
{
    int result = what;
    result += what;
    return result;
}
int total;
int main(void)
{
    int i;
    int row[5] = {1, 2, 3, 4, 5};
    for (i = 0; i < 3; i++) {
        total += twice(i);
        here.x = row[i];
        printf("%d\\n", total);
    }
    return total;
}
"""


def open_run(arguments: Sequence[str], output: Output, say: Callable[[str], None]) -> Debugger:
    """Make a debugger of files: those that end in .xml are worlds, the others programs."""
    if any(word.startswith("--") for word in arguments):
        raise DebugError("no options here")
    worlds = [word for word in arguments if word.endswith(".xml")]
    model = load_world(Path(worlds[0])) if worlds else empty_world()
    program = debug_program(*(Path(word) for word in arguments if word.endswith(".c")))
    debugger = Debugger(model, [program] * len(model.robots), output=output)
    say("made")
    return debugger
