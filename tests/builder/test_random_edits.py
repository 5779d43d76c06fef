"""Random sequences of operations: every file on the way loads, and undoing gives the first bytes.

EDIT_SEQUENCES=500 in the environment asks for more of them than the suite runs.
"""

from __future__ import annotations

import os
import random
from pathlib import Path

import pytest

from crs_cc.builder.table import OPERATIONS, Value
from crs_cc.builder.world_builder import WorldBuilder

WORLDS = Path(__file__).parents[2] / "worlds"
SEQUENCES = int(os.environ.get("EDIT_SEQUENCES", "12"))
LENGTH, TRIES = 12, 40

MIXED = b"""<?xml version='1.0' encoding="UTF-8"?>
<!-- A hall, typed by several people. -->
<world version="1"
       name='hall &amp; co' >
  <area length = "30m"   width='90ft' origin="centre"/><!-- large -->
  <surface><ramp x="1m" y="1m" length="2m" width="1m" to="10cm"/></surface>
\t<material name="felt" colour="#223344" sonar='.5'/>
  <define name="pair"><box id='a' x="0" y="0" length="20cm" width="1ft"/>
     <cylinder x="50cm" y="0" radius="4in"/>
  </define>

  <wall x1="-100in" y1="0" x2="100in" y2="0.5m" material="felt" /> <wall x1='1'
     y1='5' x2='2' y2='6'/>
  <!-- Furniture. --><box x="3m" y="-3m" length="1m" width="2m" heading=".5rad"/>
  <polygon id="heap" points="1m,2m 3m,2m 2m,300cm"
           colour="red"/>
  <polygon id="pile" x="-3m" y="2m" heading="30deg" points="0,0 1m,0 50cm,70cm"/>
  <object ref="pair" id="p1" x="-5m" y="-5m"/>
  <object ref="pair" id="p2" x="-5m" y="5m" heading="90deg"></object>
  <light id="lamp" x="1m" y="1m"/>
  <robot x="13m" y="12m"><argument>-v &lt;1&gt;</argument></robot>
  <goal id="dock"><reach x="12m" y="0" radius="30cm"/></goal>
  <goal id="stay"><approach object="box0" distance="1m"/></goal>
</world>
"""


SETTINGS: tuple[dict[str, Value], ...] = (
    {"colour": "blue"},
    {"heat": 2},
    {"id": None},
    {"height": "1ft", "heat": None},
    {"id": "renamed"},
    {"material": "felt"},
)


def starts() -> list[tuple[str, bytes]]:
    """Return worlds to begin with: as people write them, and in ways that nobody does."""
    names = ("complex-3r", "office", "corridor", "canteen", "warehouse", "slope", "delivery")
    own = [(str(WORLDS / f"{name}.xml"), (WORLDS / f"{name}.xml").read_bytes()) for name in names]
    crlf = MIXED.replace(b"\n", b"\r\n")
    return [*own, ("", MIXED), ("", crlf), ("", b"\xef\xbb\xbf" + MIXED.replace(b"\n", b""))]


class Editor:
    """Makes random operations."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)

    def length(self, most: float = 3.0) -> Value:
        value = round(self.random.uniform(-most, most), self.random.choice((0, 1, 3)))
        return self.random.choice(
            (value, f"{value}m", f"{value * 100:.0f}cm", f"{value * 39:.1f}in")
        )

    def angle(self) -> Value:
        return self.random.choice(("90deg", "-30", "1rad", 0.5, "180deg"))

    def attributes(self, kind: str) -> dict[str, Value]:
        place: dict[str, Value] = {"x": self.length(), "y": self.length()}
        found: dict[str, dict[str, Value]] = {
            "wall": {"x1": 0.5, "y1": self.length(), "x2": "1.5m", "y2": self.length()},
            "box": {**place, "length": "40cm", "width": 0.25},
            "cylinder": {**place, "radius": "3in"},
            "polygon": {"points": "0,0 1m,0 1m,1m"},
            "light": place,
            "ramp": {**place, "length": "1m", "width": "1m", "to": "8cm"},
        }
        return found[kind]

    def step(self, builder: WorldBuilder) -> list[str]:
        """Make one operation."""
        names = builder.names()
        for surface in builder.names("surface"):
            names += [f"{surface}/{each}" for each in ("ramp", "ramp[0]", "plateau")]
        chosen = self.random.sample(names, min(len(names), self.random.choice((1, 1, 2, 3, 5))))
        operation = self.random.choice((*OPERATIONS, "move", "move", "move", "turn", "array"))
        if operation == "add":
            kind = self.random.choice(("wall", "box", "cylinder", "polygon", "light", "ramp"))
            return builder.apply("add", (), {"kind": kind}, self.attributes(kind))
        if operation == "paste":
            clip = builder.copy(chosen)
            return builder.apply("paste", (), {"clip": clip, "x": self.length(), "y": "1m"})
        if operation in ("ungroup", "text", "place"):
            chosen = chosen[:1]
        attributes = self.random.choice(SETTINGS) if operation == "set" else {}
        return builder.apply(operation, chosen, self.values(operation), attributes)

    def values(self, operation: str) -> dict[str, Value]:
        """Return values for the fields of an operation."""
        place: dict[str, Value] = {"x": self.length(), "y": self.length()}
        found: dict[str, dict[str, Value]] = {
            "text": {"text": "a < b & c"},
            "move": place,
            "place": place,
            "turn": {"angle": self.angle()},
            "mirror": {"axis": self.random.choice("xy")},
            "scale": {"factor": self.random.choice((0.5, "2", 1.25))},
            "array": {"columns": 2, "rows": self.random.choice((1, 2)), **place},
            "ring": {"count": 3, **place},
            "align": {"side": self.random.choice(("left", "top", "centre-x"))},
            "distribute": {"axis": self.random.choice("xy")},
            "raise": {"path": f"{self.length()},1m 1m,50cm", "radius": "30cm", "rise": "-2cm"},
            "group": {"name": f"group-{self.random.randrange(9)}"},
        }
        return found.get(operation, {})


@pytest.mark.parametrize("seed", range(SEQUENCES))
def test_every_intermediate_file_loads_and_undo_restores_the_bytes(
    seed: int,
) -> None:
    editor = Editor(seed)
    path, text = starts()[seed % len(starts())]
    builder = WorldBuilder(path) if path else WorldBuilder(text=text)
    assert not builder.problems()
    kept = [text]
    for _ in range(TRIES):
        if len(kept) > LENGTH:
            break
        before = builder.document.text
        try:
            names = editor.step(builder)
        except ValueError:
            assert builder.document.text == before
            continue
        if builder.document.text == before:
            continue
        for name in names:
            builder.element(name)
        if builder.problems():  # something is in a wall now, say
            builder.undo()
            assert builder.document.text == before
        else:
            kept.append(builder.document.text)
    assert len(kept) > 1
    for text in reversed(kept[:-1]):
        assert builder.undo()
        assert builder.document.text == text
    assert not builder.undo()
    for text in kept[1:]:
        assert builder.redo()
        assert builder.document.text == text
