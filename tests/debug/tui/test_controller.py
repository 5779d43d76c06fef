"""What the screen is told of a real run."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.tui.backend import BackendReply, BackendRequest
from crs_cc.debug.tui.controller import Controller
from crs_cc.debug.tui.program_streams import ProgramStreams
from crs_cc.debug.tui.screen_data import OPEN, ValueRow
from crs_cc.sim.files.world_xml import empty_world, load_world
from tests.debug.debuggers import ROOT, debug_program

SOURCE = """\
#include <stdio.h>
#include "Nclient.h"
struct point { int x, y; } at = { 3, 4 };
int many[250];
static int square(int n)
{
    return n * n;
}
int main(void)
{
    int sum = 0;
    sum = square(at.x);
    printf("%d\\033[2J\\n", sum);
    fprintf(stderr, "hm");
    scanf("%d", &many[0]);
    many[State[0] * 0 + sum + 241] = 1;
    return 0;
}
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> DebugProgram:
    path = tmp_path_factory.mktemp("desk") / "point.c"
    path.write_text(SOURCE)
    return debug_program(path)


@pytest.fixture
def desk(program: DebugProgram) -> Controller:
    reads = ProgramStreams()
    desk = Controller(Debugger(empty_world(), [program], read=reads.read), reads)
    desk.do(BackendRequest())
    return desk


def press(desk: Controller, line: str, *unfolded: tuple[str, ...]) -> BackendReply:
    return desk.do(BackendRequest(line, unfolded=OPEN | set(unfolded)))


def group(done: BackendReply, name: str) -> ValueRow:
    return next(each for each in done.look.variables if each.key == (name,))


def texts(row: ValueRow) -> dict[str, str]:
    return {each.name: each.text for each in row.parts}


def test_it_starts_before_the_first_statement(desk: Controller) -> None:
    done = desk.do(BackendRequest(unfolded=OPEN))
    assert done.look.source.file.endswith("point.c")
    assert done.look.source.line == 11
    assert not done.moved
    assert [each.text for each in done.look.frames] == ["main"]
    assert texts(group(done, "locals")) == {"sum": "uninitialised"}


def test_steps_show_stack_values_and_the_callers_line(desk: Controller) -> None:
    done = press(desk, "break square")
    assert done.answer.plain.startswith("Breakpoint 1: square")
    assert done.look.source.breakpoints[7].number == 1
    done = press(desk, "continue")
    assert done.moved
    assert done.look.state.startswith("breakpoint 1: square (")
    assert [each.place for each in done.look.frames] == ["point.c:7  (n=3)", "point.c:12  ()"]
    assert texts(group(done, "locals")) == {"n": "3"}
    assert [each.text for each in done.look.events] == ["breakpoint 1"]
    done = press(desk, "up")
    assert (done.look.source.line, done.look.source.innermost) == (12, False)
    done = press(desk, "reverse-next")
    assert (done.look.source.line, done.look.source.innermost) == (12, True)


def test_values_are_expanded_and_long_ones_in_pieces(desk: Controller) -> None:
    key = ("globals", "0", "many")
    done = press(desk, "next", ("globals",), key, (*key, "100..."), (*key, "200..."))
    many = next(each for each in group(done, "globals").parts if each.name == "many")
    assert many.parts[99].name == "[99]"
    assert many.parts[100].name == "150 more"
    assert many.parts[100].parts[0].name == "[100]"
    assert many.parts[100].parts[100].parts[-1].name == "[249]"
    done = press(desk, "next", ("globals",), ("globals", "0", "at"))
    at = next(each for each in group(done, "globals").parts if each.name == "at")
    assert texts(at) == {"x": "3", "y": "4"}


def test_displays_state_robot_and_world_are_shown(desk: Controller) -> None:
    press(desk, "display at.x * 2")
    done = press(desk, "next", ("state",), ("robot",), ("world",))
    assert texts(group(done, "watched")) == {"at.x * 2": "6"}
    assert "[34] STATE_CONF_X" in texts(group(done, "state"))
    assert "pose" in texts(group(done, "robot"))
    assert group(done, "world").parts


def test_input_is_prompted_for_and_output_cannot_move_the_cursor(
    desk: Controller,
) -> None:
    asked = threading.Event()
    desk.listen(lambda robot: asked.set())
    results: list[BackendReply] = []
    worker = threading.Thread(target=lambda: results.append(press(desk, "advance 16")))
    worker.start()
    assert asked.wait(10.0)
    assert desk.complete("reverse-n") == ["reverse-next"]  # while it waits
    desk.give("17")
    worker.join(10.0)
    (done,) = results
    assert done.look.source.line == 16
    written = [(each.text, each.is_error) for each in done.look.output]
    assert written == [("9\x1b[2J", False), ("hm", True)]
    done = press(desk, "continue")
    assert "out of bounds" in done.look.state
    assert done.look.events[-1].kind == "error"
    assert done.look.source.line == 16


def test_scripts_are_executed_first_and_breakpoints_have_commands(program: DebugProgram) -> None:
    script = ["break square", "commands", "print n", "end", "", "continue", "quit", "next"]
    desk = Controller(Debugger(empty_world(), [program]), ProgramStreams(), script[:2])
    assert desk.do(BackendRequest()).prompt == ">"
    assert press(desk, "end").prompt == "(crs) "
    desk = Controller(Debugger(empty_world(), [program]), ProgramStreams(), script)
    done = desk.do(BackendRequest())
    assert done.leaves
    assert done.look.source.line == 7
    assert "$1 = 3" in done.answer.plain


def test_a_late_interrupt_stops_nothing(desk: Controller) -> None:
    press(desk, "print 1")
    desk.interrupt()
    done = press(desk, "next")
    assert done.moved
    assert done.look.state.startswith("main ")


def test_an_error_is_a_line_and_the_run_does_not_move(desk: Controller) -> None:
    for line in ("foo", "print nothing", "break 4711", "frame 7", "goto -1", "robot x"):
        done = press(desk, line)
        assert len(done.errors) == 1, line
        assert "\n" not in done.errors[0]
        assert "internal" not in done.errors[0], done.errors
        assert not done.moved


def test_an_internal_error_is_a_line_too(desk: Controller, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail() -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(desk.shell.debugger.view, "frames", fail)
    done = desk.do(BackendRequest())
    assert done.errors == ("internal error: ZeroDivisionError: oh; please report it",)
    assert done.look.source.line == 11


def test_several_robots_have_their_own_output_and_places(program: DebugProgram) -> None:
    world = load_world(ROOT / "worlds" / "pair.xml")
    desk = Controller(Debugger(world, [program] * 2), ProgramStreams())
    done = desk.do(BackendRequest(chart_size=(40, 10)))
    names = [robot.id for robot in world.robots]
    assert [each.text.split()[0] for each in done.look.robots] == names
    assert len(done.look.chart.plain.split("\n")) == 10
    done = press(desk, "continue")
    assert {each.who for each in done.look.output} == set(names)
    done = press(desk, "robot 1")
    assert [each.is_current for each in done.look.robots] == [False, True]


def test_another_file_is_shown_until_the_run_moves(tmp_path: Path) -> None:
    main, other = tmp_path / "main.c", tmp_path / "other.c"
    main.write_text("int f(int);\nint main(void)\n{\n    f(1);\n    return f(2);\n}\n")
    other.write_text("int f(int x)\n{\n    return x - 2;\n}\n")
    desk = Controller(Debugger(empty_world(), [debug_program(main, other)]), ProgramStreams())
    desk.do(BackendRequest())
    look = desk.do(BackendRequest(file=str(other))).look
    assert (look.source.file, look.source.line) == (str(other), 0)
    assert look.source.files == (str(main), str(other))
    look = desk.do(BackendRequest("break other.c:3", file=str(other))).look
    assert (look.source.file, list(look.source.breakpoints)) == (str(other), [3])
    look = desk.do(BackendRequest("next", file=str(other))).look
    assert (look.source.file, look.source.line) == (str(other), 3)
    look = desk.do(BackendRequest("finish", file=str(other))).look
    assert (look.source.file, look.source.line) == (str(main), 5)


def test_edited_files_are_shown_as_compiled(tmp_path: Path) -> None:
    path = tmp_path / "edited.c"
    path.write_text("int main(void)\n{\n    int x = 5;\n    return x;\n}\n")
    desk = Controller(Debugger(empty_world(), [debug_program(path)]), ProgramStreams())
    path.write_text("int main( { what")
    desk.do(BackendRequest())
    done = press(desk, "next")
    assert (done.errors, done.look.source.line) == ((), 4)
    assert done.look.source.lines[2] == "    int x = 5;"
    assert texts(group(done, "locals")) == {"x": "5"}
    assert "edited.c" in press(desk, "print x").errors[0]
