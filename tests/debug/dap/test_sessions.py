"""Sessions as an editor has them; each message that comes is checked against the schema."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from crs_cc.debug.dap import session
from crs_cc.debug.dap.progress import Progress
from tests.debug.dap.client import Client
from tests.debug.dap.programs import LOOP, open_run
from tests.debug.debuggers import debug_program, source_file

TURN = """\
#include "Nclient.h"
static void turn(int speed)
{
    vm(speed, 0, 0);
}
int main(void)
{
    connect_robot(1);
    for (;;)
        turn(100);
}
"""

CALLS = """\
static int f(int x) { return x; }
static int g(int x) { return x; }
static int h(int x) { return 3 * x; }
static int (*pointer)(int) = g;
int done;
int main(void)
{
    int sum = f(1) + f(h(2)) + (done && g(3)) + pointer(4);

    done = sum;
    return 0;
}
"""

WORLDS = Path(__file__).parents[3] / "worlds"


@pytest.fixture
def client() -> Iterator[Client]:
    with Client(open_run) as made:
        yield made


@pytest.fixture
def loop() -> Path:
    return source_file(LOOP, "loop.c")


def test_a_run_stops_at_a_breakpoint_and_at_its_end(client: Client, loop: Path) -> None:
    client.launch(loop)
    assert client.break_at(loop, 6)[0]["verified"]
    stop = client.begin()
    assert stop["reason"] == "breakpoint"
    assert stop["allThreadsStopped"]
    assert [frame["line"] for frame in client.frames()] == [6, 15]
    assert [frame["name"] for frame in client.frames()] == ["twice", "main"]
    client.break_at(loop)
    stop = client.move("continue")
    assert stop["reason"] == "exited"
    assert client.printed() == "0\n2\n6\n"
    assert client.frames()[0]["name"] == "exited with 6"
    client.ask("continue", threadId=1)
    assert client.event("exited") == {"exitCode": 6}
    client.event("terminated")
    client.ask("disconnect")


def test_steps_go_forward_and_backward(client: Client, loop: Path) -> None:
    client.launch(loop, stopOnEntry=True)
    assert client.begin()["reason"] == "entry"
    assert client.line() == 13
    moves = {"next": 14, "stepIn": 15, "stepBack": 14}
    assert [client.move(move)["reason"] for move in moves] == ["step"] * 3
    assert client.line() == 14


def test_a_step_enters_the_call_of_a_line_that_was_chosen(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "calls.c"
    path.write_text(CALLS)
    assert client.launch(path)["supportsStepInTargetsRequest"]
    client.break_at(path, 8)
    client.begin()
    wanted = {"h(2)": ("h", 3), "f(1)": ("f", 1), "f(h(2))": ("f", 1), "g(3)": ("main", 10)}
    for label, (function, line) in wanted.items():
        frame = client.frames()[0]
        targets = client.ask("stepInTargets", frameId=frame["id"])["targets"]
        assert [each["label"] for each in targets] == ["f(1)", "f(h(2))", "h(2)", "g(3)"]
        number = next(each["id"] for each in targets if each["label"] == label)
        client.move("stepIn", targetId=number)
        top, *callers = client.frames()
        assert (top["name"], top["line"]) == (function, line), label
        if label == "f(h(2))":
            assert client.scope("Locals")[0]["value"] == "6"
        assert [each["line"] for each in callers] == [8] * len(callers)
        if callers:
            assert client.ask("stepInTargets", frameId=callers[0]["id"])["targets"] == []
        client.move("reverseContinue")
    assert "no longer valid" in client.refused("stepIn", threadId=1, targetId=number)
    assert "unknown" in client.refused("stepIn", threadId=1, targetId=client.frames()[0]["id"])


def test_reverse_continue_to_a_breakpoint_and_to_the_start(client: Client, loop: Path) -> None:
    client.launch(loop)
    client.break_at(loop, 15)
    client.begin()
    client.move("continue")
    client.move("continue")
    stop = client.move("reverseContinue")
    assert stop["reason"] == "breakpoint"
    assert client.line() == 15
    client.break_at(loop)
    assert client.move("reverseContinue")["reason"] == "entry"


def test_a_breakpoint_on_a_line_without_code_is_moved_with_a_message(
    client: Client, loop: Path
) -> None:
    client.launch(loop)
    [moved, lost] = client.break_at(loop, 11, 400)
    assert (moved["verified"], moved["line"]) == (True, 13)
    assert "moved to line 13" in moved["message"]
    assert not lost["verified"]
    assert "no code" in lost["message"]


def test_breakpoints_in_other_files_are_not_verified(client: Client, loop: Path) -> None:
    client.launch(loop)
    [made] = client.break_at(loop.with_name("other.c"), 3)
    assert not made["verified"]
    assert "no program" in made["message"]


def test_breakpoints_before_the_launch_are_set_at_launch(client: Client, loop: Path) -> None:
    [made] = client.break_at(loop, 6)
    assert not made["verified"]
    client.launch(loop)
    changed = client.event("breakpoint")
    assert changed["reason"] == "changed"
    assert changed["breakpoint"]["verified"]
    assert client.begin()["hitBreakpointIds"] == [made["id"]]


def test_conditions_hit_counts_and_logs(client: Client, loop: Path) -> None:
    client.launch(loop)
    wanted = [
        {"line": 15, "hitCondition": "3"},
        {"line": 16, "condition": "i == 1"},
        {"line": 17, "logMessage": "total {total}"},
        {"line": 5, "condition": "1 +"},
        {"line": 6, "hitCondition": "often"},
    ]
    assert [each["verified"] for each in client.break_at(loop, *wanted)] == [True] * 3 + [False] * 2
    client.begin()
    assert (client.line(), client.printed()) == (16, "0\n")
    client.move("continue")
    assert (client.line(), client.printed()) == (15, "2\n")
    assert client.printed("console") == "made\ntotal 0\ntotal 2\n"


def test_a_hit_condition_may_ask_for_every_second_hit(client: Client, loop: Path) -> None:
    client.launch(loop)
    [made] = client.break_at(loop, {"line": 15, "hitCondition": "% 2"})
    assert made["verified"]
    client.begin()
    assert (client.line(), client.printed()) == (15, "0\n")
    assert not client.break_at(loop, {"line": 16, "hitCondition": "% 0"})[0]["verified"]


def test_unchanged_breakpoints_keep_their_ids(client: Client, loop: Path) -> None:
    client.launch(loop)
    first = client.break_at(loop, 6, 17)
    second = client.break_at(loop, 5, 17)
    assert first[1]["id"] == second[1]["id"]
    assert first[0]["id"] not in [each["id"] for each in second]


def test_functions_of_the_program_and_of_the_robot_stop_a_run(
    client: Client, tmp_path: Path
) -> None:
    path = tmp_path / "turn.c"
    path.write_text(TURN)
    client.launch(path)
    body = client.ask("setFunctionBreakpoints", breakpoints=[{"name": "turn"}, {"name": "vm"}])
    assert [each["verified"] for each in body["breakpoints"]] == [True, True]
    assert client.begin()["reason"] == "function breakpoint"
    assert client.line() == 4
    stop = client.move("continue")
    assert "called 'vm'" in stop["text"]
    assert client.frames()[-2]["line"] == 4
    source = client.frames()[0]["source"]
    assert (source["origin"], source["presentationHint"]) == ("library", "deemphasize")
    text = client.ask("source", source=source, sourceReference=source["sourceReference"])["content"]
    assert "__crs_post" in text
    frame = client.frames()[0]["id"]
    assert [each["name"] for each in client.ask("scopes", frameId=frame)["scopes"]] == [
        "Locals", "Globals", "State", "Robot", "World",
    ]  # fmt: skip
    assert client.scope("State")[17]["name"] == "[17] STATE_SONAR_0"


def test_a_collision_stops_a_run_if_its_filter_is_set(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "ahead.c"
    path.write_text(TURN.replace("vm(speed, 0, 0)", "vm(speed, speed, 0), sleep(1)"))
    filters = client.launch(path, world=str(WORLDS / "wall.xml"))["exceptionBreakpointFilters"]
    assert {"collision", "message", "degradation", "bumper", "exit"} <= {
        each["filter"] for each in filters
    }
    client.ask("setExceptionBreakpoints", filters=["collision"])
    stop = client.begin()
    assert stop["reason"] == "exception"
    assert "touched" in stop["text"]
    assert client.ask("exceptionInfo", threadId=1)["exceptionId"] == "collision"


def test_a_runtime_error_stops_a_run_with_details(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "wild.c"
    path.write_text("int row[3];\nint main(void)\n{\n    int i = 3;\n    return row[i];\n}\n")
    client.launch(path)
    stop = client.begin()
    assert stop["reason"] == "exception"
    assert client.line() == 5
    info = client.ask("exceptionInfo", threadId=1)
    assert "'row' is int[3]" in info["description"]
    assert client.move("stepBack")["reason"] == "step"
    assert client.line() == 5
    client.move("continue")
    client.ask("continue", threadId=1)
    assert client.event("exited") == {"exitCode": 123}


def test_goto_runs_to_the_next_or_previous_visit_of_a_line(client: Client, loop: Path) -> None:
    client.launch(loop, stopOnEntry=True)
    client.begin()
    targets = client.ask("gotoTargets", source={"path": str(loop)}, line=17)["targets"]
    assert [each["line"] for each in targets] == [17, 17]
    assert client.move("goto", targetId=targets[0]["id"])["reason"] == "goto"
    assert (client.line(), client.printed()) == (17, "")
    targets = client.ask("gotoTargets", source={"path": str(loop)}, line=5)["targets"]
    assert client.move("goto", targetId=targets[1]["id"])["reason"] == "goto"
    assert client.line() == 5
    assert "no longer valid" in client.refused("goto", threadId=1, targetId=targets[1]["id"])


ENDLESS = """\
int main(void)
{
    volatile int n = 0;
    for (;;)
        n++;
}
"""


@pytest.fixture
def endless(tmp_path: Path) -> Path:
    path = tmp_path / "endless.c"
    path.write_text(ENDLESS)
    return path


def test_running_programs_can_be_paused(client: Client, endless: Path) -> None:
    client.launch(endless)
    client.ask("configurationDone")
    assert client.ask("threads")["threads"] == [{"id": 1, "name": "robot0"}]
    assert "pause" in client.refused("next", threadId=1)
    for _ in range(100):
        client.ask("pause", threadId=1)
        assert client.event("stopped")["reason"] == "pause"
        if client.line():
            break
        client.ask("continue", threadId=1)  # it has not reached main yet
    assert client.line() in {4, 5}


@pytest.mark.parametrize("command", ["continue", "next"])
def test_a_long_move_shows_its_progress_and_can_be_cancelled(
    client: Client, endless: Path, command: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(session, "Progress", partial(Progress, delay_s=0.1))
    endless.write_text("void stay(void)\n{\n    for (;;)\n        ;\n}\n" + CALLER)
    client.ask("initialize", adapterID="crs", supportsProgressReporting=True)
    client.ask("launch", program=[str(endless)], stopOnEntry=True)
    client.event("initialized")
    client.begin()
    client.ask(command, threadId=1)
    started = client.event("progressStart")
    assert started["cancellable"]
    assert client.event("progressUpdate")["message"].startswith("t = ")
    client.ask("cancel", progressId=started["progressId"])
    assert client.event("progressEnd")["progressId"] == started["progressId"]
    assert client.event("stopped")["reason"] == "pause"


def test_a_breakpoint_can_be_set_while_programs_run(client: Client, endless: Path) -> None:
    client.launch(endless)
    client.ask("configurationDone")
    assert client.break_at(endless, 5)[0]["verified"]
    assert client.event("stopped")["reason"] == "breakpoint"


def test_an_endless_step_can_be_paused(client: Client, endless: Path) -> None:
    endless.write_text("void stay(void)\n{\n    for (;;)\n        ;\n}\n" + CALLER)
    client.launch(endless, stopOnEntry=True)
    client.begin()
    client.ask("next", threadId=1)
    client.ask("pause", threadId=1)
    assert client.event("stopped")["reason"] == "pause"


def test_an_endless_command_can_be_paused(client: Client, endless: Path) -> None:
    client.launch(endless, stopOnEntry=True)
    client.begin()
    asked = client.post("evaluate", expression="continue", context="repl")
    client.ask("pause", threadId=1)
    assert client.answer(asked)["success"]
    assert client.event("stopped")["reason"] == "pause"


CALLER = "int main(void)\n{\n    stay();\n}\n"


def test_a_run_is_terminated_while_it_runs(client: Client, endless: Path) -> None:
    client.launch(endless)
    client.ask("configurationDone")
    client.ask("terminate")
    client.event("terminated")
    assert "no program is launched" in client.refused("continue", threadId=1)
    client.ask("disconnect")
    assert client.hear() is None


def test_a_client_that_disconnects_ends_the_run(client: Client, endless: Path) -> None:
    client.launch(endless)
    client.ask("configurationDone")
    client.hang_up()


def test_restart_compiles_again_and_keeps_the_breakpoints(client: Client, tmp_path: Path) -> None:
    loop = tmp_path / "loop.c"
    loop.write_text(LOOP)
    client.launch(loop)
    client.break_at(loop, 18)
    client.begin()
    loop.write_text(LOOP.replace("i < 3", "i < 1"))
    debug_program.cache_clear()
    client.ask("restart")
    assert client.event("breakpoint")["breakpoint"]["verified"]
    client.event("stopped")
    client.move("continue")
    assert client.printed().endswith("0\n")
    loop.write_text("int main(void) { return nothing; }\n")
    debug_program.cache_clear()
    assert "undeclared" in client.refused("restart")
    assert client.frames()[0]["name"] == "exited with 0"


def test_without_debugging_a_run_just_runs(client: Client, loop: Path) -> None:
    client.break_at(loop, 6)
    client.launch(loop, noDebug=True, stopOnEntry=True)
    client.ask("configurationDone")
    client.event("terminated")
    assert client.printed() == "0\n2\n6\n"


def test_an_unrequested_move_is_reported_as_continued(client: Client, loop: Path) -> None:
    client.launch(loop, world=str(WORLDS / "pair.xml"))
    client.break_at(loop, 15)
    client.begin()
    client.ask("evaluate", expression="continue", context="repl")
    assert client.event("continued")["allThreadsContinued"]
    assert client.event("stopped")["allThreadsStopped"]
    client.ask("restart")
    assert client.event("continued")["allThreadsContinued"]
    assert client.event("stopped")["threadId"] == 1


def test_a_rejected_breakpoint_names_its_line(client: Client, loop: Path) -> None:
    client.launch(loop)
    asked = [{"line": 15, "condition": "nothing > 0"}, {"line": 15}]
    source = {"path": str(loop)}
    made = client.ask("setBreakpoints", source=source, breakpoints=asked)["breakpoints"]
    assert [(each["verified"], each["line"]) for each in made] == [(False, 15), (True, 15)]


def test_a_log_point_is_checked_when_it_is_set(client: Client, loop: Path) -> None:
    client.launch(loop)
    asked = [{"line": 18, "logMessage": text} for text in ("{nothing}", "{i} and {i + 1}")]
    source = {"path": str(loop)}
    made = client.ask("setBreakpoints", source=source, breakpoints=asked)["breakpoints"]
    assert [each["verified"] for each in made] == [False, True]
    assert "nothing" in made[0]["message"]


def test_robots_are_threads(client: Client, loop: Path) -> None:
    client.launch(loop, world=str(WORLDS / "pair.xml"))
    client.break_at(loop, 15)
    assert client.begin()["threadId"] == 1
    threads = client.ask("threads")["threads"]
    assert threads == [{"id": 1, "name": "robot0"}, {"id": 2, "name": "robot1"}]
    assert client.frames(2)[0]["name"]
    client.break_at(loop, 18)
    assert client.move("continue")["threadId"] == 1
    assert client.move("continue")["threadId"] == 2
    client.break_at(loop)
    client.move("continue")
    assert client.printed().splitlines()[0] == "[robot0] 0"


def test_a_pending_request_can_be_cancelled(client: Client, endless: Path) -> None:
    endless.write_text("void stay(void)\n{\n    for (;;)\n        ;\n}\n" + CALLER)
    client.launch(endless, stopOnEntry=True)
    client.begin()
    client.ask("next", threadId=1)
    waiting = client.post("stackTrace", threadId=1)
    client.ask("cancel", requestId=waiting)
    assert client.answer(waiting)["message"] == "cancelled"
    client.ask("cancel", requestId=12345)


def test_paths_can_be_uris_and_lines_can_start_at_0(client: Client, loop: Path) -> None:
    client.ask("initialize", pathFormat="uri", linesStartAt1=False, columnsStartAt1=False)
    client.ask("launch", program=str(loop))
    client.event("initialized")
    body = client.ask("setBreakpoints", source={"path": loop.as_uri()}, breakpoints=[{"line": 5}])
    assert body["breakpoints"][0]["verified"]
    client.begin()
    frame = client.frames()[0]
    assert (frame["line"], frame["column"]) == (5, 4)
    assert frame["source"]["path"] == loop.as_uri()


def test_an_unknown_attribute_is_reported(client: Client, loop: Path) -> None:
    client.launch(loop, sed=3, type="crs", request="launch", name="x", __sessionId="y")
    told = client.printed("important")
    assert told == "unknown attribute 'sed' of launch: ignored\n"


@pytest.mark.parametrize(
    ("attributes", "reason"),
    [
        ({}, "neither a program nor a world"),
        ({"program": 3}, "must be a list"),
        ({"program": ["a.c", 3]}, "list of strings"),
        ({"program": "a.c", "seed": "3"}, "an integer"),
        ({"program": "a.c", "seed": -1}, "negative"),
        ({"program": "a.c", "link": "slow"}, "serial or ideal"),
        ({"program": "a.c", "stopOnEntry": "yes"}, "true or false"),
        ({"program": "a\0.c"}, "NUL"),
        ({"program": "a.c", "cwd": "/nowhere"}, "No such file"),
        ({"program": ""}, "is empty"),
    ],
)
def test_an_invalid_launch_is_refused(
    client: Client, attributes: dict[str, object], reason: str
) -> None:
    client.ask("initialize", adapterID="crs")
    assert reason in client.refused("launch", **attributes)
    assert client.ask("threads") == {"threads": []}
