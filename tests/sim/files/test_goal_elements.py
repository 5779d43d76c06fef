"""Goals in world files: what is wrong with one is reported with its line."""

from __future__ import annotations

import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.goals import Bring, Cool, Goal, NoCollision, Place

WORLD = """<world version="1"><area length="6m" width="5m"/>
<robot x="1m" y="1m"/>
<box id="crate" x="3m" y="1m" length="40cm" width="40cm" mass="2kg"/>
<cylinder id="stove" x="3m" y="4m" radius="30cm" heat="2"/>
<goal id="home"><reach x="5m" y="4m" radius="30cm"/></goal>
{goal}
</world>"""
BRING = '<bring objects="crate" x="5" y="4" radius="1"/>'
REACH = '<reach x="5m" y="4m" radius="30cm"/>'


def parse(goal: str) -> tuple[Goal, ...]:
    return parse_world(WORLD.format(goal=goal).encode(), "room.xml").goals


def test_values_and_defaults_of_goals() -> None:
    (_, bring), (_, clean) = (
        parse(f'<goal points="2.5" name=" A crate ">{BRING}</goal>'),
        parse('<goal robots="robot0" after="home"><no-collision except="crate"/></goal>'),
    )
    assert bring == Goal("goal1", Bring(("crate",), Place(5.0, 4.0, 1.0)), "A crate", 2.5)
    assert clean == Goal("goal1", NoCollision(("crate",)), "", 1.0, ("robot0",), after="home")
    assert parse("<goal><cool/></goal>")[1].condition == Cool(("stove",))


@pytest.mark.parametrize(
    ("goal", "text"),
    [
        (f'<goal robots="robot7">{REACH}</goal>',
         "goal, robots: unknown robot 'robot7' (known: robot0)"),
        (f'<goal robots="robot0">{BRING}</goal>', "goal, robots: does not apply to <bring>"),
        ('<goal robots="robot0"><cool/></goal>', "goal, robots: does not apply to <cool>"),
        (f'<goal robots=" ">{REACH}</goal>', "goal, robots: names no robot"),
        (f'<goal after="later">{REACH}</goal>',
         "goal, after: unknown earlier goal 'later' (known: home)"),
        ('<goal id="x"><no-collision until="x"/></goal>',
         "no-collision, until: unknown earlier goal 'x' (known: home)"),
        (f'<goal points="-1">{REACH}</goal>',
         "goal, points: '-1' is not a number from 0 to 1000000"),
        (f'<goal points="nan">{REACH}</goal>',
         "goal, points: 'nan' is not a number from 0 to 1000000"),
        (f'<goal name="{"x" * 81}">{REACH}</goal>',
         "goal, name: must be at most 80 printable letters"),
        ('<goal><cover share="0"/></goal>', "cover, share: must be greater than 0"),
        ('<goal><cover share="1.5"/></goal>', "cover, share: '1.5' must be from 0 to 1"),
        ('<goal><cover share="1" cell="1cm"/></goal>', "cover, cell: must be 5cm or more"),
        ('<goal><reach x="7m" y="4m" radius="1m"/></goal>',
         "reach, the place is outside of the area (x 0 to 6, y 0 to 5 m)"),
        ('<goal><reach x="5m" y="4m" radius="0"/></goal>',
         "reach, radius: '0' must be greater than 0"),
        ('<goal within="1s"><reach x="5m" y="4m" radius="1m" stay="2s"/></goal>',
         "reach, stay: is longer than the goal's time limit"),
        ('<goal><visit><place x="5m" y="9m" radius="1m"/></visit></goal>',
         "place, the place is outside of the area (x 0 to 6, y 0 to 5 m)"),
        ('<goal><bring objects="stove" x="5m" y="4m" radius="1m"/></goal>',
         "bring, objects: 'stove' is fixed: give it a mass"),
        ('<goal><approach object="robot0" distance="1m"/></goal>',
         ("approach, object: unknown object 'robot0' (known: edge-south, edge-east, edge-north,"
          " edge-west, crate, stove)")),
        ('<goal><follow target="robot0 crate" most="1m" share="1"/></goal>',
         "follow, target: names more than one robot or movable object"),
        ('<goal><follow target="crate" least="2m" most="1m" share="1"/></goal>',
         "follow, least: is greater than most"),
        ("<goal/>", ("missing element in <goal>; expected <reach> or <approach> or <visit> or"
                     " <no-collision> or <cool> or <cover> or <bring> or <follow>")),
        ('<goal id="crate"><cool/></goal>', "duplicate id 'crate' (first used in line 3)"),
    ],
)  # fmt: skip
def test_a_wrong_goal_gives_one_error_with_its_line(goal: str, text: str) -> None:
    with pytest.raises(WorldError) as failed:
        parse(goal)
    shown = [f"{m.location.file}:{m.location.line}: {m.text}" for m in failed.value.diagnostics]
    assert shown == [f"room.xml:6: {text}"]


def test_a_world_without_heat_has_nothing_to_cool() -> None:
    text = WORLD.replace(' heat="2"', "").format(goal="<goal><cool/></goal>")
    with pytest.raises(WorldError, match=r"room.xml:6: error: cool, no object in the world is hot"):
        parse_world(text.encode(), "room.xml")


def test_the_number_of_goals_and_of_cells_is_limited() -> None:
    with pytest.raises(WorldError, match="more than 100 goals"):
        parse("<goal><cool/></goal>" * 100)
    text = (
        '<world version="1"><area length="999m" width="999m"/><robot x="1m" y="1m"/>'
        '<goal><cover share="1"/></goal></world>'
    )
    with pytest.raises(WorldError, match="more than 40000 cells in the world's area"):
        parse_world(text.encode(), "room.xml")
