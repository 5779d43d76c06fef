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
def controller(program: DebugProgram) -> Controller:
    reads = ProgramStreams()
    controller = Controller(Debugger(empty_world(), [program], read=reads.read), reads)
    controller.execute(BackendRequest())
    return controller


def press(controller: Controller, line: str, *unfolded: tuple[str, ...]) -> BackendReply:
    return controller.execute(BackendRequest(line, unfolded=OPEN | set(unfolded)))


def group(done: BackendReply, name: str) -> ValueRow:
    return next(each for each in done.snapshot.variables if each.key == (name,))


def texts(row: ValueRow) -> dict[str, str]:
    return {each.name: each.text for each in row.parts}


def test_it_starts_before_the_first_statement(controller: Controller) -> None:
    done = controller.execute(BackendRequest(unfolded=OPEN))
    assert done.snapshot.source.file.endswith("point.c")
    assert done.snapshot.source.line == 11
    assert not done.moved
    assert [each.text for each in done.snapshot.frames] == ["main"]
    assert texts(group(done, "locals")) == {"sum": "uninitialised"}


def test_steps_show_stack_values_and_the_callers_line(controller: Controller) -> None:
    done = press(controller, "break square")
    assert done.answer.plain.startswith("Breakpoint 1: square")
    assert done.snapshot.source.breakpoints[7].number == 1
    done = press(controller, "continue")
    assert done.moved
    assert done.snapshot.state.startswith("breakpoint 1: square (")
    assert [each.place for each in done.snapshot.frames] == ["point.c:7  (n=3)", "point.c:12  ()"]
    assert texts(group(done, "locals")) == {"n": "3"}
    assert [each.text for each in done.snapshot.events] == ["breakpoint 1"]
    done = press(controller, "up")
    assert (done.snapshot.source.line, done.snapshot.source.innermost) == (12, False)
    done = press(controller, "reverse-next")
    assert (done.snapshot.source.line, done.snapshot.source.innermost) == (12, True)


def test_values_are_expanded_and_long_ones_in_pieces(controller: Controller) -> None:
    key = ("globals", "0", "many")
    done = press(controller, "next", ("globals",), key, (*key, "100..."), (*key, "200..."))
    many = next(each for each in group(done, "globals").parts if each.name == "many")
    assert many.parts[99].name == "[99]"
    assert many.parts[100].name == "150 more"
    assert many.parts[100].parts[0].name == "[100]"
    assert many.parts[100].parts[100].parts[-1].name == "[249]"
    done = press(controller, "next", ("globals",), ("globals", "0", "at"))
    at = next(each for each in group(done, "globals").parts if each.name == "at")
    assert texts(at) == {"x": "3", "y": "4"}


def test_displays_state_robot_and_world_are_shown(controller: Controller) -> None:
    press(controller, "display at.x * 2")
    done = press(controller, "next", ("state",), ("robot",), ("world",))
    assert texts(group(done, "watched")) == {"at.x * 2": "6"}
    assert "[34] STATE_CONF_X" in texts(group(done, "state"))
    assert "pose" in texts(group(done, "robot"))
    assert group(done, "world").parts


def test_input_is_prompted_for_and_output_cannot_move_the_cursor(
    controller: Controller,
) -> None:
    asked = threading.Event()
    controller.on_input_request(lambda robot: asked.set())
    results: list[BackendReply] = []
    worker = threading.Thread(target=lambda: results.append(press(controller, "advance 16")))
    worker.start()
    assert asked.wait(10.0)
    assert controller.complete("reverse-f") == ["reverse-finish"]  # while it waits
    controller.send_input("17")
    worker.join(10.0)
    (done,) = results
    assert done.snapshot.source.line == 16
    written = [(each.text, each.is_error) for each in done.snapshot.output]
    assert written == [("9\x1b[2J", False), ("hm", True)]
    assert [each.number for each in done.snapshot.output] == [1, 2]
    done = press(controller, "continue")
    assert "out of bounds" in done.snapshot.state
    assert done.snapshot.events[-1].kind == "error"
    assert done.snapshot.source.line == 16


def test_scripts_are_executed_first_and_breakpoints_have_commands(program: DebugProgram) -> None:
    script = ["break square", "commands", "print n", "end", "", "continue", "quit", "next"]
    controller = Controller(Debugger(empty_world(), [program]), ProgramStreams(), script[:2])
    assert controller.execute(BackendRequest()).prompt == ">"
    assert press(controller, "end").prompt == "(crs) "
    controller = Controller(Debugger(empty_world(), [program]), ProgramStreams(), script)
    done = controller.execute(BackendRequest())
    assert done.quits
    assert done.snapshot.source.line == 7
    assert "$1 = 3" in done.answer.plain


def test_a_late_interrupt_has_no_effect(controller: Controller) -> None:
    press(controller, "print 1")
    controller.interrupt()
    done = press(controller, "next")
    assert done.moved
    assert done.snapshot.state.startswith("main ")


def test_an_error_is_a_line_and_the_run_does_not_move(controller: Controller) -> None:
    for line in ("foo", "print nothing", "break 4711", "frame 7", "goto -1", "robot x"):
        done = press(controller, line)
        assert len(done.errors) == 1, line
        assert "\n" not in done.errors[0]
        assert "internal" not in done.errors[0], done.errors
        assert not done.moved


def test_an_internal_error_is_a_line_too(
    controller: Controller, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail() -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(controller.shell.debugger.view, "frames", fail)
    done = controller.execute(BackendRequest())
    assert done.errors == ("internal error: ZeroDivisionError: oh; please report it",)
    assert done.snapshot.source.line == 11


def test_several_robots_have_their_own_output_and_places(program: DebugProgram) -> None:
    world = load_world(ROOT / "worlds" / "pair.xml")
    controller = Controller(Debugger(world, [program] * 2), ProgramStreams())
    done = controller.execute(BackendRequest(map_size=(40, 10)))
    names = [robot.id for robot in world.robots]
    assert [each.text.split()[0] for each in done.snapshot.robots] == names
    assert len(done.snapshot.world_map.plain.split("\n")) == 10
    done = press(controller, "continue")
    assert {each.writer for each in done.snapshot.output} == set(names)
    printed = [each for each in done.snapshot.output if "[2J" in each.text]
    press(controller, f"goto output {printed[1].number}")
    assert (
        controller.shell.debugger.names[controller.shell.debugger.view.robot] == printed[1].writer
    )
    press(controller, "continue")
    done = press(controller, "robot 1")
    assert [each.is_current for each in done.snapshot.robots] == [False, True]


def test_another_file_is_shown_until_the_run_moves(tmp_path: Path) -> None:
    main, other = tmp_path / "main.c", tmp_path / "other.c"
    main.write_text("int f(int);\nint main(void)\n{\n    f(1);\n    return f(2);\n}\n")
    other.write_text("int f(int x)\n{\n    return x - 2;\n}\n")
    controller = Controller(Debugger(empty_world(), [debug_program(main, other)]), ProgramStreams())
    controller.execute(BackendRequest())
    snapshot = controller.execute(BackendRequest(file=str(other))).snapshot
    assert (snapshot.source.file, snapshot.source.line) == (str(other), 0)
    assert snapshot.source.files == (str(main), str(other))
    snapshot = controller.execute(BackendRequest("break other.c:3", file=str(other))).snapshot
    assert (snapshot.source.file, list(snapshot.source.breakpoints)) == (str(other), [3])
    snapshot = controller.execute(BackendRequest("next", file=str(other))).snapshot
    assert (snapshot.source.file, snapshot.source.line) == (str(other), 3)
    snapshot = controller.execute(BackendRequest("finish", file=str(other))).snapshot
    assert (snapshot.source.file, snapshot.source.line) == (str(main), 4)


def test_edited_files_are_shown_as_compiled(tmp_path: Path) -> None:
    path = tmp_path / "edited.c"
    path.write_text("int main(void)\n{\n    int x = 5;\n    return x;\n}\n")
    controller = Controller(Debugger(empty_world(), [debug_program(path)]), ProgramStreams())
    path.write_text("int main( { what")
    controller.execute(BackendRequest())
    done = press(controller, "next")
    assert (done.errors, done.snapshot.source.line) == ((), 4)
    assert done.snapshot.source.lines[2] == "    int x = 5;"
    assert texts(group(done, "locals")) == {"x": "5"}
    assert "edited.c" in press(controller, "print x").errors[0]


def test_the_time_line_is_at_the_instant_of_the_run() -> None:
    folder = ROOT / "samples" / "scout_c" / "convoy"
    programs = [debug_program(folder / f"{name}.c") for name in ("leader", "follower")]
    debugger = Debugger(load_world(folder / "convoy.xml"), programs)
    controller = Controller(debugger, ProgramStreams())
    press(controller, "goto 3")
    clocks = set()
    for robot in ("leader", "follower"):
        shown = press(controller, f"robot {robot}").snapshot
        assert (shown.now_s, shown.end_s, shown.timestep_s) == (3.0, 3.0, 0.05)
        clocks.add(shown.time_s)
    assert len(clocks) == 2  # they are ahead of it
