"""The library of objects."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from crs_cc.builder.library import library, put_object
from crs_cc.builder.world_builder import WorldBuilder

WORLDS = Path(__file__).parents[2] / "worlds"
STOOL = """<definitions version="1">
  <material name="pine" colour="#d2b48c"/>
  <define name="{name}"><cylinder id="seat" x="0" y="0" radius="20cm" material="pine"/></define>
</definitions>
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the folder of a world, with an object of its own and one of the user."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    mine = tmp_path / "data" / "crs_cc" / "lib"
    mine.mkdir(parents=True)
    (mine / "stool.xml").write_text(STOOL.format(name="stool"))
    (mine / "broken.xml").write_text("<definitions")
    home = tmp_path / "home"
    (home / "lib").mkdir(parents=True)
    (home / "lib" / "bar.xml").write_text(STOOL.format(name="bar"))
    shutil.copy(WORLDS / "room.xml", home)
    return home


def test_objects_have_pictures_and_come_from_three_places(folder: Path) -> None:
    found = {each.name: each for each in library(folder)}
    assert {"stool", "bar", "table", "chair", "rack"} <= set(found)
    assert found["stool"].shapes[0]["radius"] == 0.2
    assert found["stool"].shapes[0]["colour"] == "#d2b48c"
    assert len(found["place"].shapes) == 8


def test_an_object_beside_the_world_is_included_and_another_is_copied(folder: Path) -> None:
    builder = WorldBuilder(folder / "room.xml")
    found = {each.name: each for each in library(folder)}
    assert put_object(builder, found["bar"], 1.0, 4.0) == "bar"
    assert builder.get("include") == {"file": "lib/bar.xml"}
    put_object(builder, found["stool"], 2.0, 4.0)
    put_object(builder, found["stool"], 3.0, 4.0)
    assert builder.names("define") == ["define[stool]"]
    assert builder.names("object") == ["bar", "stool", "stool-2"]
    assert not builder.problems()
    builder.set("define[stool]/seat", radius="9cm")
    with pytest.raises(ValueError, match="the world has another definition 'stool'"):
        put_object(builder, found["stool"], 3.0, 4.0)
    assert [builder.undo() for _ in range(4)] == ["set", "add", "add", "add"]
    assert builder.document.text == (WORLDS / "room.xml").read_bytes()
