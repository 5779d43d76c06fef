"""What a client can look at, evaluate and change."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.debug.dap.client import Client
from tests.debug.dap.programs import LOOP, open_run
from tests.debug.debuggers import source_file


@pytest.fixture
def client() -> Iterator[Client]:
    """A client whose program stands in line 16, with i == 0."""
    path = source_file(LOOP, "loop.c")
    with Client(open_run) as made:
        made.launch(path)
        made.break_at(path, 16)
        made.begin()
        yield made


def names(rows: list[dict[str, object]]) -> dict[str, object]:
    return {str(row["name"]): row["value"] for row in rows}


def test_scopes_have_locals_and_globals(client: Client) -> None:
    assert names(client.scope("Locals")) == {"i": "0", "row": "{1, 2, 3, 4, 5}"}
    assert names(client.scope("Globals")) == {"here": "{x = 0, y = 0}", "total": "0"}


def test_parts_of_values_are_sent_on_demand(client: Client) -> None:
    row = next(each for each in client.scope("Locals") if each["name"] == "row")
    assert row["indexedVariables"] == 5
    number = row["variablesReference"]
    assert names(client.parts(number, filter="indexed", start=3, count=1)) == {"[3]": "4"}
    assert client.parts(number, filter="named") == []
    assert client.parts(number)[4]["evaluateName"] == "row[4]"
    here = next(each for each in client.scope("Globals") if each["name"] == "here")
    assert here["namedVariables"] == 2
    assert client.parts(here["variablesReference"])[0]["evaluateName"] == "here.x"


def test_robot_and_world_are_scopes_too(client: Client) -> None:
    assert names(client.scope("Robot"))["pose"] == "0.000, 0.000 m, 0.0 deg"
    assert "time" in names(client.scope("World"))


def test_a_watch_is_evaluated_in_its_frame_and_changes_nothing(client: Client) -> None:
    frame = client.frames()[0]["id"]
    assert client.ask("evaluate", expression="row[i] + 7", frameId=frame)["result"] == "8"
    why = client.refused("evaluate", expression="i++", frameId=frame, context="hover")
    assert "would change" in why
    assert "undeclared" in client.refused("evaluate", expression="nothing", frameId=frame)
    assert client.ask("evaluate", expression="i", frameId=frame)["result"] == "0"


def test_assignments_persist_and_are_reported(client: Client) -> None:
    frame = client.frames()[0]["id"]
    scopes = client.ask("scopes", frameId=frame)["scopes"]
    mine = scopes[0]["variablesReference"]
    body = client.ask("setVariable", variablesReference=mine, name="i", value="row[0] + 1")
    assert body["value"] == "2"
    assert client.event("invalidated") == {"areas": ["all"]}
    row = next(each for each in client.parts(mine) if each["name"] == "row")
    client.ask("setVariable", variablesReference=row["variablesReference"], name="[2]", value="40")
    assert client.ask("setExpression", expression="row[2] ", value="41", frameId=frame)
    assert client.ask("evaluate", expression="row[i]", frameId=frame)["result"] == "41"
    assert "assignable" in client.refused("setExpression", expression="3", value="4", frameId=frame)


def test_the_console_accepts_expressions_and_commands(client: Client) -> None:
    def console(text: str) -> str:
        frame = client.frames()[0]["id"]
        body = client.ask("evaluate", expression=text, context="repl", frameId=frame)
        result: str = body["result"]
        return result

    assert console("row") == "{1, 2, 3, 4, 5}"
    assert console("i = 1") == "1"
    assert console("i") == "1"
    assert console("p i + 1").endswith("= 2")
    assert "Undefined command" in console("frobnicate")
    assert "Breakpoint 2" in console("b 17")
    made = client.event("breakpoint")
    assert made["reason"] == "new"
    assert made["breakpoint"]["line"] == 17
    console("delete 2")
    assert client.event("breakpoint")["reason"] == "removed"


def test_a_command_that_moves_is_followed_by_a_stop(client: Client) -> None:
    frame = client.frames()[0]["id"]
    client.ask("evaluate", expression="reverse-next", context="repl", frameId=frame)
    assert client.event("stopped")["reason"] == "step"
    assert client.line() == 15
    assert "moved on" in client.refused("scopes", frameId=frame)


def test_commands_of_a_breakpoint_are_not_taken_for_variables(
    client: Client,
) -> None:
    def console(text: str) -> str:
        frame = client.frames()[0]["id"]
        result: str = client.ask("evaluate", expression=text, context="repl", frameId=frame)[
            "result"
        ]
        return result

    console("b 17")
    console("commands 2")
    assert console("row") == ""  # is a variable
    assert console("i = 3") == ""
    assert console("end") == ""
    assert console("i = 1") == "1"


def test_completions_are_names_and_commands(client: Client) -> None:
    frame = client.frames()[0]["id"]

    def completed(text: str) -> list[dict[str, object]]:
        arguments = {"frameId": frame, "text": text, "column": len(text) + 1}
        found: list[dict[str, object]] = client.ask("completions", **arguments)["targets"]
        return found

    assert [each["label"] for each in completed("rev")][:2] == [
        "reverse-continue",
        "reverse-finish",
    ]
    assert completed("p to") == [{"label": "total", "start": 3, "length": 2}]


def test_memory_is_read_and_written(client: Client) -> None:
    frame = client.frames()[0]["id"]
    place = client.ask("evaluate", expression="row", frameId=frame)["memoryReference"]
    read = client.ask("readMemory", memoryReference=place, offset=4, count=4)
    assert base64.b64decode(read["data"]) == b"\2\0\0\0"
    data = base64.b64encode(b"\7\1").decode()
    wrote = client.ask("writeMemory", memoryReference=place, offset=8, data=data)
    assert wrote == {"bytesWritten": 2}
    assert client.event("memory")["count"] == 2
    assert client.ask("evaluate", expression="row[2]", frameId=frame)["result"] == "263"
    assert "null" in client.refused("writeMemory", memoryReference="0:0x0", data=data)


def test_disassembly_around_the_current_location(client: Client) -> None:
    frame = client.frames()[0]
    place = frame["instructionPointerReference"]
    found = client.ask(
        "disassemble", memoryReference=place, instructionOffset=-200, instructionCount=400
    )["instructions"]
    assert len(found) == 400
    assert len({each["address"] for each in found}) == 400
    assert found[0]["presentationHint"] == "invalid"
    here = next(each for each in found if each["address"] == place)
    assert here["line"] == frame["line"]
    assert here["symbol"] == "main"


def test_library_source_has_a_source_reference(client: Client) -> None:
    sources = client.ask("loadedSources")["sources"]
    assert [each["name"] for each in sources] == ["loop.c"]
    text = client.ask("source", source=sources[0], sourceReference=0)["content"]
    assert text == LOOP


def test_data_breakpoints_watch_the_object(client: Client) -> None:
    row = next(each for each in client.scope("Locals") if each["name"] == "row")
    info = client.ask(
        "dataBreakpointInfo", variablesReference=row["variablesReference"], name="[2]"
    )
    assert info["description"] == "row[2]"
    wanted = [{"dataId": info["dataId"], "accessType": "read"}]
    made = client.ask("setDataBreakpoints", breakpoints=wanted)["breakpoints"]
    assert made[0]["verified"], made
    path = client.frames()[0]["source"]["path"]
    client.break_at(Path(path))
    stop = client.move("continue")
    assert stop["reason"] == "data breakpoint"
    assert stop["hitBreakpointIds"] == [made[0]["id"]]
    assert client.line() == 17
    frame = client.frames()[0]["id"]
    assert client.ask("evaluate", expression="i", frameId=frame)["result"] == "2"
    assert client.ask("setDataBreakpoints", breakpoints=[]) == {"breakpoints": []}
    assert client.move("continue")["reason"] == "exited"


def test_only_objects_can_be_watched(client: Client) -> None:
    frame = client.frames()[0]["id"]
    for name in ("i + 1", "nothing", "3"):
        info = client.ask("dataBreakpointInfo", name=name, frameId=frame)
        assert info["dataId"] is None
        assert info["description"]
    wanted = [{"dataId": each} for each in ("x", "0 main", "7 main i", "0 main 3", "0 - nothing")]
    made = client.ask("setDataBreakpoints", breakpoints=wanted)["breakpoints"]
    assert not any(each["verified"] for each in made)
    assert all(each["message"] for each in made)


def test_a_pointer_to_a_struct_expands_to_its_members(client: Client, tmp_path: Path) -> None:
    frame = client.frames()[0]["id"]
    found = client.ask("evaluate", expression="&here", context="watch", frameId=frame)
    assert found["namedVariables"] == 2
    rows = client.parts(found["variablesReference"])
    assert [row["evaluateName"] for row in rows] == ["(*(&here)).x", "(*(&here)).y"]
    number = found["variablesReference"]
    assert client.ask("setVariable", variablesReference=number, name="y", value="9")["value"] == "9"
    assert client.ask("evaluate", expression="here.y", frameId=frame)["result"] == "9"
    found = client.ask("evaluate", expression="&row", context="watch", frameId=frame)
    [row] = client.parts(found["variablesReference"])
    assert client.parts(row["variablesReference"])[1]["evaluateName"] == "(*(&row))[1]"


HIDING = """\
int main(void)
{
    int n = 1;
    {
        int n = 2;
        n++;
    }
}
"""


def test_a_shadowed_variable_is_shown_separately(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "hide.c"
    path.write_text(HIDING)
    client.ask("restart", arguments={"program": str(path)})
    client.event("stopped")
    client.break_at(path, 6)
    client.ask("restart")
    assert client.event("stopped")["reason"] == "breakpoint"
    assert names(client.scope("Locals")) == {"n": "2", "n (hidden)": "1"}
    frame = client.frames()[0]["id"]
    mine = client.ask("scopes", frameId=frame)["scopes"][0]["variablesReference"]
    hidden = {"variablesReference": mine, "name": "n (hidden)"}
    assert "cannot be expressed in C" in client.refused("setVariable", **hidden, value="5")
    assert client.ask("dataBreakpointInfo", **hidden)["dataId"] is None
