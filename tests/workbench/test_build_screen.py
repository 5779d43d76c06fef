"""Commands of pages of the world builder, and the answers."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.cli.start_build import Trial
from crs_cc.workbench.build_screen import BuildScreen
from crs_cc.workbench.clients import Client, Role

WORLDS = Path(__file__).parents[2] / "worlds"


def no_run(_: WorldBuilder) -> str:
    raise ValueError("no run here")


@pytest.fixture(scope="module")
def screen(tmp_path_factory: pytest.TempPathFactory) -> Iterator[BuildScreen]:
    path = tmp_path_factory.mktemp("build") / "room.xml"
    path.write_bytes((WORLDS / "slope.xml").read_bytes().replace(b'"lib/climber.xml"', b'"scout"'))
    made = BuildScreen(WorldBuilder(path), no_run)
    yield made
    made.server.close()


def ask(screen: BuildScreen, do: str, role: Role = "control", **fields: Any) -> Any:
    """Return the answer to a command: its value, or its error as text after `!`."""
    client = Client(role)
    screen.receive(client, {"id": 1, "command": do, **fields})
    text = client.next_message()
    assert isinstance(text, str)
    found = json.loads(text)
    return f"!{found['error']}" if "error" in found else found["value"]


def document(screen: BuildScreen) -> Any:
    client = Client("view")
    screen.greet(client)
    hello, found = client.next_message(), client.next_message()
    assert json.loads(str(hello))["type"] == "hello"
    return json.loads(str(found))


def step(operation: str, *names: str, **values: Any) -> dict[str, Any]:
    return {"steps": [{"operation": operation, "names": list(names), "values": values}]}


def test_a_page_receives_the_document_and_edits_it_by_operations(screen: BuildScreen) -> None:
    before = document(screen)
    assert before["area"] == {"x": 0, "y": 0, "length": 12, "width": 7, "edge": 0.1}
    assert [each["name"] for each in before["items"]][1:5] == [
        "surface", "surface/ramp[0]", "surface/ramp[1]", "surface/plateau"
    ]  # fmt: skip
    assert before["shapes"]["surface/ramp[0]"][0]["points"][0] == [6, 3]
    assert ask(screen, "apply", **step("array", "sledge", columns=2, x=0.5)) == ["sledge-2"]
    assert document(screen)["undo"] == ["array"]
    assert ask(screen, "copy", names=["sledge"]).startswith("<clip>")
    assert ask(screen, "paste", values={"x": 1, "y": "50cm"}) == ["sledge-3"]
    form = ask(screen, "form", "view", into="", kind="channel")
    assert {"ramp", "channel", "reach", "robot"} < set(form["kinds"])
    assert [row["name"] for row in form["rows"]][:2] == ["name", "range"]
    rows = ask(screen, "properties", "view", name="sledge")["rows"]
    mass = next(row for row in rows if row["name"] == "mass")
    assert (mass["value"], mass["units"]) == ("4kg", ["kg", "g", "lb"])
    assert ask(screen, "undo") == "paste"
    assert ask(screen, "undo") == "array"
    assert ask(screen, "redo") == "array"
    assert ask(screen, "undo") == "array"
    assert ask(screen, "save").endswith("room.xml")


def test_problems_name_their_elements_and_prevent_saving(screen: BuildScreen) -> None:
    ask(screen, "apply", **step("place", "robot0", x=100))
    (problem,) = document(screen)["problems"]
    assert problem["name"] == "robot0"
    assert "not completely inside" in ask(screen, "save")
    assert "not completely inside" in ask(screen, "run")
    ask(screen, "apply", steps=[{"operation": "set", "names": ["sledge"], "attributes": {"a": 1}}])
    after = document(screen)
    assert after["problems"][0]["text"] == "unknown attribute 'a' in <box>"
    assert after["shapes"]["sledge"]  # as it was last
    ask(screen, "undo")
    ask(screen, "undo")
    assert ask(screen, "run") == "!no run here"


@pytest.mark.parametrize(
    ("do", "fields", "wrong"),
    [
        ("fly", {}, "!unknown command 'fly'"),
        ("apply", {}, "!'steps' must be a list"),
        ("apply", {"steps": [1]}, "!'steps' must be a list"),
        ("apply", {"steps": [{}]}, "!'operation' must be a string"),
        ("apply", step("fly"), "!unknown operation 'fly'"),
        ("apply", step("move", "sledge", x=True), "!values must be an object of numbers"),
        ("apply", step("move", "sledge", x=[1]), "!values must be an object of numbers"),
        ("apply", step("move", "sledge", x="x" * 10_000), "!x: 'xxx"),
        ("apply", step("array", "sledge", columns=10**9), "!columns: 1000000000 is not"),
        (
            "apply",
            step("array", "sledge", columns=9999, rows=9999),
            "!99980001 copies are too many",
        ),
        ("apply", {"steps": [{"operation": "move", "names": "sledge"}]}, "!'names' must be a list"),
        ("apply", {"steps": [{"operation": "move", "names": [1]}]}, "!'names' must be a list"),
        ("copy", {"names": ["nobody"]}, "!unknown element 'nobody'"),
        ("paste", {"clip": "<!DOCTYPE a><clip/>"}, "!a document type declaration"),
        ("properties", {"name": 1}, "!'name' must be a string"),
    ],
)
def test_invalid_operations_are_rejected_without_effect(
    screen: BuildScreen, do: str, fields: dict[str, Any], wrong: str
) -> None:
    before = screen.builder.document.text
    assert ask(screen, do, **fields).startswith(wrong)
    assert screen.builder.document.text == before


def test_programs_beside_the_world_and_warm_objects_are_listed(
    screen: BuildScreen,
) -> None:
    assert screen.builder.path is not None
    folder = screen.builder.path.parent
    for name in ("b.c", "a.c", "c.txt", "d\n.c"):
        (folder / name).touch()
    assert document(screen)["programs"] == ["a.c", "b.c"]
    ask(screen, "apply", **step_of_heat("sledge", heat="5", spread="1m"))
    (shape,) = document(screen)["shapes"]["sledge"]
    assert (shape["heat"], shape["spread"]) == (5.0, 1.0)
    rows = ask(screen, "properties", "view", name="sledge")["rows"]
    usual = {row["name"]: row["default"] for row in rows}
    assert (usual["mass"], usual["colour"], usual["heading"]) == (
        "the object is fixed",
        "grey",
        "0",
    )
    ask(screen, "undo")


def step_of_heat(name: str, **attributes: Any) -> dict[str, Any]:
    return {"steps": [{"operation": "set", "names": [name], "attributes": attributes}]}


def test_a_read_only_page_cannot_edit(screen: BuildScreen) -> None:
    for do in ("apply", "undo", "save", "copy", "run", "read"):
        assert ask(screen, do, "view") == "!this page is view-only"


def test_a_new_world_is_saved_below_a_plain_name_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    made = BuildScreen(WorldBuilder.new(4, 3), no_run)
    try:
        for name in ("../a.xml", "/tmp/a.xml", "a.txt"):
            assert ask(made, "save", file=name).startswith("!the name must be a file name")
        assert ask(made, "save", file="a.xml") == "!no robot in the world"
        ask(made, "apply", steps=[
            {"operation": "add", "values": {"kind": "robot"}, "attributes": {"x": 1, "y": 1}}
        ])  # fmt: skip
        assert ask(made, "save", file="a.xml") == "a.xml"
        assert (tmp_path / "a.xml").exists()
    finally:
        made.server.close()


@pytest.mark.usefixtures("forks")
def test_a_run_that_cannot_start_reports_the_reason_and_cleans_up(tmp_path: Path) -> None:
    path = tmp_path / "room.xml"
    path.write_bytes((WORLDS / "room.xml").read_bytes())
    with pytest.raises(ValueError, match="robot 'robot0' has no program"):
        Trial(None).start(WorldBuilder(path))
    (tmp_path / "bad.c").write_text("int main(void) { return x; }\n")
    with pytest.raises(ValueError, match=r"bad\.c:1:25: error: .*'x'"):
        Trial(tmp_path / "bad.c").start(WorldBuilder(path))
    assert sorted(each.name for each in tmp_path.iterdir()) == ["bad.c", "room.xml"]


@pytest.mark.usefixtures("forks")
def test_errors_of_a_trial_do_not_name_its_copy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They were reported for `.new.trial.xml`, which is not a file of the user's."""
    monkeypatch.chdir(tmp_path)
    builder = WorldBuilder.new(4, 3)
    builder.add("robot", x=1, y=1, program="no.c")
    with pytest.raises(ValueError, match=r"^new\.xml:4: error: program 'no\.c': no such file"):
        Trial(None).start(builder)
