"""The page of the world builder in a real browser: a world drawn with mouse and keyboard only."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from crs_cc.cli.start_build import building
from crs_cc.workbench.build_screen import BuildScreen
from tests.workbench.in_browser import page_in, wait

PROGRAM = """#include <Nclient.h>
int main(void) { connect_robot(1); vm(50, 50, 0); ws(1, 1, 0, 20); return 0; }
"""
DRAWN = """<?xml version="1.0" encoding="UTF-8"?>
<world version="1">
  <area length="8m" width="6m"/>
  <surface>
    <ramp x="6m" y="1.2m" length="2m" width="0.8m" to="0.3m"/>
  </surface>
  <wall id="wall0" x1="0m" y1="3m" x2="3.2m" y2="3m"/>
  <wall id="wall1" x1="4.2m" y1="3m" x2="6.2m" y2="3m"/>
  <wall id="wall2" x1="6.2m" y1="3m" x2="8m" y2="3m"/>
  <define name="table">
    <box id="box0" x="0m" y="0m" length="1m" width="0.6m"/>
    <cylinder id="cylinder0" x="0.1m" y="0.1m" radius="0.2m"/>
  </define>
  <object id="table" ref="table" x="1.5m" y="4.3m"/>
  <object id="table-2" ref="table" x="6.3m" y="4.3m"/>
  <robot id="robot0" x="1m" y="1m" heading="15deg"/>
</world>
"""


ROVER = """<robot-definition version="1" name="rover">
  <body radius="25cm" mass="9kg"/>
  <drive wheel-base="30cm" speed-limit="1m/s" acceleration-limit="1m/s2" speed="1m/s"
         acceleration="1m/s2"/>
  <odometry/>
  <sonars order="3"/>
  <sensor>
    <id>3</id> <!-- in front -->
    <type>sonar</type>
    <position>
      <x-relative>0.2</x-relative>
      <y-relative>0</y-relative>
      <z-relative>1ft</z-relative>
      <range>2m</range>
      <radius>10cm</radius>
      <dir-relative>0deg</dir-relative>
    </position>
  </sensor>
</robot-definition>
"""
BEHIND = """  <sensor>
    <id>0</id>
    <type>sonar</type>
    <position>
      <x-relative>-10cm</x-relative>
      <y-relative>0cm</y-relative>
      <z-relative>1ft</z-relative>
      <range>2m</range>
      <radius>10cm</radius>
      <dir-relative>180deg</dir-relative>
    </position>
  </sensor>
"""
CLIP = "<clip><cylinder id='stool' x='50cm' y='4m' radius='10cm'/></clip>"
PASTE = """(text) => {
  const clipboardData = new DataTransfer();
  clipboardData.setData("text/plain", text);
  document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));
}"""
FRAMES = """() => new Promise((done) => {
  const { view, tools } = crs;
  const [move, paint] = [tools.move.bind(tools), view.paint.bind(view)];
  const { left, top } = view.canvas.getBoundingClientRect();
  let busy = 0;
  const timed = (act) => (...given) => {
    const start = performance.now();
    act(...given);
    busy += performance.now() - start;
  };
  [tools.move, view.paint] = [timed(move), timed(paint)];
  const frames = [];
  const next = (count) => {
    frames.push(busy);
    busy = 0;
    if (!count) return done(frames.sort((a, b) => a - b)[frames.length / 2 | 0]);
    const place = { clientX: left + 300 + 5 * count, clientY: top + 300 - count };
    view.canvas.dispatchEvent(new PointerEvent("pointermove", place));
    requestAnimationFrame(() => next(count - 1));
  };
  requestAnimationFrame(() => next(20));
})"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("build")
    (found / "go.c").write_text(PROGRAM)
    return found


@pytest.fixture(scope="module")
def screen(folder: Path) -> Iterator[BuildScreen]:
    with building(folder / "hall.xml", folder / "go.c", 0) as made:
        yield made


@pytest.fixture(scope="module")
def page(browser: Any, screen: BuildScreen) -> Iterator[Any]:
    with page_in(browser, screen, 1200, 750) as made:
        wait(made, "window.crs && crs.model.document")
        yield made


class Hand:
    """Works with mouse and keyboard, at points of the world [m]."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.at = (0.0, 0.0)

    def to(self, x: float, y: float) -> None:
        px, py = self.page.evaluate(
            """([x, y]) => {
                const [px, py] = crs.view.toScreen([x, y]);
                const box = crs.view.canvas.getBoundingClientRect();
                return [px + box.left, py + box.top];
            }""",
            [x, y],
        )
        self.at = (px, py)
        self.page.mouse.move(px, py)

    def click(self, x: float, y: float) -> None:
        self.to(x, y)
        self.page.mouse.down()
        self.page.mouse.up()

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        self.to(*start)
        self.page.mouse.down()
        self.to((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
        self.to(*end)
        self.page.mouse.up()

    def press(self, *keys: str) -> None:
        for key in keys:
            self.page.keyboard.press(key)

    def fill(self, values: dict[str, str], form: str = "form.operations") -> None:
        """Fill a form, and send it."""
        for name, text in values.items():
            self.page.fill(f"{form} [name={name}]", text)
        self.press("Enter")

    def has(self, *names: str) -> None:
        """Wait until there are these elements."""
        known = f"{list(names)}.every((name) => crs.model.item(name))"
        wait(self.page, known)


def walls_with_a_door_are_drawn_by_clicks_and_typed_lengths(hand: Hand) -> None:
    hand.press("w")
    hand.click(0.02, 3.03)
    hand.click(3.2, 3.05)
    hand.press("Escape")
    hand.click(4.2, 3.0)
    hand.to(5.0, 3.02)
    hand.press("2", "Enter")
    hand.click(8.0, 3.0)
    hand.press("Escape", "Escape")
    hand.has("wall0", "wall1", "wall2")


def a_ramp_and_two_tables_of_parts_are_drawn(hand: Hand) -> None:
    hand.press("m")
    hand.drag((5.0, 0.8), (7.0, 1.6))
    hand.press("b")
    hand.drag((1.0, 4.0), (2.0, 4.6))
    hand.press("c")
    hand.drag((1.6, 4.4), (1.8, 4.4))
    hand.has("surface/ramp", "box0", "cylinder0")
    hand.press("v")
    hand.drag((0.7, 3.7), (2.4, 4.9))
    wait(hand.page, "crs.model.selection.size === 2")
    hand.page.select_option("[aria-label=operation]", "group")
    hand.page.fill("[name=name]", "table")
    hand.press("Enter")
    hand.has("table")
    hand.page.locator("canvas").first.focus()
    hand.press("Control+d")
    hand.has("table-2")
    wait(hand.page, "crs.model.selection.has('table-2')")
    hand.drag((2.1, 4.3), (6.1, 4.3))
    wait(hand.page, "crs.model.shapes('table-2')[0].points[0][0] > 5")


def a_robot_is_placed_and_turned(hand: Hand) -> None:
    hand.press("r")
    hand.click(1.0, 1.0)
    hand.has("robot0")
    hand.press("v")
    wait(hand.page, "crs.model.selection.has('robot0')")
    hand.press("[")
    wait(hand.page, "crs.model.item('robot0').attributes.heading === '15deg'")


def problems_are_listed_and_undone(hand: Hand) -> None:
    hand.drag((1.0, 1.0), (1.0, 3.0))
    told = "robot 'robot0' overlaps wall 'wall0'"
    wait(hand.page, f'document.querySelector(".problem")?.innerText.endsWith("{told}")')
    hand.page.wait_for_selector("button:disabled:has-text('Save')")
    hand.page.locator(".item").first.click()
    hand.page.locator(".problem").click()
    wait(hand.page, "crs.model.selection.has('robot0')")
    hand.press("Control+z")
    wait(hand.page, "crs.model.document.problems.length === 0")
    hand.press("f")


def the_file_is_as_a_person_would_have_written_it(hand: Hand, folder: Path) -> None:
    hand.press("Control+s")
    wait(hand.page, "!crs.model.document.changed")
    assert (folder / "hall.xml").read_text() == DRAWN


def properties_are_typed_and_everything_is_undone_and_done_again(
    hand: Hand, screen: BuildScreen
) -> None:
    hand.page.locator(".item", has_text="wall0").click()
    hand.page.fill(".property [aria-label=thickness]", "20cm")
    hand.press("Enter")
    wait(hand.page, "crs.model.item('wall0').attributes.thickness === '20cm'")
    hand.page.locator("canvas").first.focus()
    hand.page.fill(".property [aria-label=thickness]", "wide")
    hand.press("Enter")
    wait(hand.page, "crs.model.document.problems.length === 1")
    while count := len(screen.builder.document.undoable):
        hand.page.get_by_role("button", name="Undo").click()
        wait(hand.page, f"crs.model.document.steps === {count - 1}")
    assert screen.builder.names() == ["area"]
    while screen.builder.document.redoable:
        screen.builder.redo()
    hand.press("Control+z", "Control+z")
    wait(hand.page, "crs.model.item('wall2') && !crs.model.document.changed")
    assert screen.builder.text == DRAWN


def the_world_is_tried_and_editing_goes_on_where_it_was(hand: Hand, folder: Path) -> None:
    hand.page.set_default_timeout(60_000)  # a process starts, and compiles
    hand.page.locator(".item", has_text="wall0").click()
    hand.page.locator("canvas").first.focus()
    hand.press("k")
    hand.page.evaluate("crs.view.zoom(5, [400, 300])")
    hand.page.get_by_role("button", name="Try").click()
    wait(hand.page, "window.crs && crs.model && crs.model.state && crs.model.state.t > 0.2")
    assert (folder / ".hall.trial.xml").exists()
    assert hand.page.locator("#title").inner_text() == "go.c in hall.xml"
    hand.page.locator("button:has(span:text-is('Edit'))").click()
    wait(hand.page, "window.crs && crs.model.document && crs.model.document.items.length === 15")
    wait(hand.page, "crs.model.locked.has('wall0') && crs.view.scale > 300")


def goals_sounds_steps_and_ranges_are_drawn(hand: Hand) -> None:
    hand.press("t")
    hand.drag((3.0, 0.4), (4.0, 1.4))
    hand.press("n")
    hand.click(2.4, 5.4)
    hand.press("g")
    hand.drag((7.4, 5.2), (7.6, 5.2))
    hand.has("surface/plateau", "sound0", "goal0")
    hand.press("v")
    hand.drag((7.6, 5.2), (7.8, 5.2))  # the handle of its radius
    wait(hand.page, "crs.model.shapes('goal0')[0].radius > 0.39")
    hand.page.fill("[aria-label=stay]", "2s")
    hand.press("Enter")
    hand.page.click("summary:text-is('Add')")
    hand.page.select_option("[aria-label='kind to add']", "channel")
    wait(hand.page, "document.querySelector('form.operations [name=range]')")
    hand.page.click("summary:text-is('more attributes')")
    hand.fill({"name": "radio", "range": "2m"})
    channel = "communication/channel[radio]"
    hand.has(channel)
    wait(hand.page, f"crs.model.selection.has('{channel}')")
    hand.drag((3.0, 1.0), (2.6, 1.0))
    wait(hand.page, f"crs.model.item('{channel}').attributes.range === '1.6m'")
    hand.page.click("summary:text-is('Add')")


def the_ground_is_raised_by_a_brush_and_read_from_a_picture(hand: Hand, folder: Path) -> None:
    hand.press("h")
    hand.page.fill("[aria-label='brush rise in metres']", "0.1")
    hand.drag((7.0, 2.0), (7.2, 2.0))
    hand.has("surface/heightmap")
    wait(hand.page, "Math.max(...crs.model.shapes('surface/heightmap')[0].rows.flat()) > 0.09")
    hand.press("Control+z")
    wait(hand.page, "!crs.model.item('surface/heightmap')")
    Image.linear_gradient("L").save(folder / "grey.png")
    hand.page.set_input_files("[aria-label='image of heights']", folder / "grey.png")
    hand.has("surface/heightmap")
    wait(hand.page, "crs.model.shapes('surface/heightmap')[0].rows.at(-1)[0] > 0.9")
    hand.press("Control+z", "Escape")
    wait(hand.page, "!crs.model.item('surface/heightmap')")


def a_definition_is_edited_and_all_copies_follow(hand: Hand, screen: BuildScreen) -> None:
    hand.to(6.2, 4.2)
    hand.page.mouse.dblclick(*hand.at)
    wait(hand.page, "crs.model.inside && crs.model.items.length === 2")
    hand.drag((-0.3, 0.0), (-0.3, 0.1))
    wait(hand.page, "crs.model.shapes('define[table]/box0')[0].points[0][1] > 0.35")
    hand.press("b")
    hand.drag((-0.4, -0.5), (-0.2, -0.3))
    hand.has("define[table]/box1")
    hand.press("Escape", "Escape")
    wait(hand.page, "!crs.model.inside && crs.model.shapes('table').length === 3")
    first, second = (f"crs.model.shapes('{name}')[0].points[0]" for name in ("table", "table-2"))
    wait(hand.page, f"Math.abs({second}[1] - {first}[1]) < 1e-9 && {second}[0] - {first}[0] > 4.7")
    hand.page.locator(".properties b", has_text="table-2").wait_for()
    hand.page.fill(".property [aria-label=mass]", "5kg")
    hand.press("Enter")
    wait(hand.page, "crs.model.shapes('table-2').every((shape) => shape.kind === 'movable')")
    assert not screen.builder.problems()


def an_object_is_dragged_from_the_library(hand: Hand) -> None:
    hand.page.click("summary:text-is('Library')")
    picture = hand.page.locator(".library button", has_text="chair")
    picture.scroll_into_view_if_needed()
    box = picture.bounding_box()
    hand.page.mouse.move(box["x"] + 20, box["y"] + 20)
    hand.page.mouse.down()
    hand.to(3.0, 5.0)
    hand.page.mouse.up()
    hand.has("chair")
    wait(hand.page, "crs.model.selection.has('chair') && crs.model.shapes('chair').length === 2")
    hand.page.locator("canvas").first.focus()
    hand.press("Control+c", "Control+v")
    hand.has("chair-2")
    wait(hand.page, "crs.model.selection.has('chair-2')")
    assert hand.page.locator("summary", has_text="Operation").is_visible()
    hand.press("Delete")
    hand.page.locator("summary", has_text="Operation").wait_for(state="hidden")
    hand.page.evaluate(PASTE, CLIP)
    hand.has("stool")
    hand.press("Control+z", "Control+z", "Control+z", "Control+z")
    wait(hand.page, "!crs.model.item('chair') && !crs.model.item('define[chair]')")
    hand.page.click("summary:text-is('Library')")


def goals_and_programs_are_checked_while_drawing(hand: Hand, folder: Path) -> None:
    problem = hand.page.locator(".problem")
    hand.press("Escape", "w")
    hand.click(7.0, 3.0)
    hand.click(7.0, 6.0)
    hand.press("Escape", "Escape")
    problem.get_by_text("goal 'goal0': no robot can get there").click()
    wait(hand.page, "crs.model.selection.has('goal0')")
    hand.page.locator("canvas").first.focus()
    hand.press("Control+z")
    problem.wait_for(state="detached")
    (folder / "bad.c").write_text("int main(void) { return x; }\n")
    hand.page.locator(".item", has_text="robot0").click()
    hand.page.locator(".properties b", has_text="robot0").wait_for()
    hand.page.fill(".property [aria-label=program]", "bad.c")
    hand.press("Enter")
    problem.filter(has_text=re.compile(r"^bad\.c, line 1.*'x'")).wait_for()
    assert hand.page.get_by_role("button", name="Save").is_enabled()
    hand.page.locator("canvas").first.focus()
    hand.press("Control+z", "f")
    problem.wait_for(state="detached")


def it_is_looked_at_in_three_dimensions(hand: Hand) -> None:
    hand.press("3")
    wait(hand.page, "crs.solid.picture && crs.solid.picture.lens")
    x, y = hand.page.evaluate("crs.solid.picture.project(1, 1, 0).slice(0, 2)")
    box = hand.page.locator(".solid").bounding_box()
    hand.page.mouse.click(box["x"] + x, box["y"] + y)
    wait(hand.page, "crs.model.selection.has('robot0') && crs.model.selection.size === 1")
    wait(hand.page, "crs.solid.picture.scene.bodies[0].colour === '#ffd400'")
    hand.page.mouse.move(box["x"] + x, box["y"] + y)
    hand.page.mouse.down()
    x, y = hand.page.evaluate("crs.solid.picture.project(2, 1, 0).slice(0, 2)")
    hand.page.mouse.move(box["x"] + x, box["y"] + y)
    hand.page.mouse.up()
    wait(hand.page, "crs.model.item('robot0').attributes.x === '2m'")
    hand.press("Control+z", "b")
    wait(hand.page, "!crs.solid.isOn && !document.querySelector('.solid canvas')")
    hand.press("Escape")
    wait(hand.page, "crs.model.item('robot0').attributes.x === '1m'")


def a_view_that_is_closed_while_it_is_made_or_dragged_stays_closed(page: Any) -> None:
    canvases = page.evaluate(
        """async () => {
            const { solid, model } = crs;
            await solid.toggle();
            const made = solid.make(await model.request("scene"));
            await solid.toggle();
            await made;
            return document.querySelectorAll(".solid canvas").length;
        }"""
    )
    assert canvases == 0
    page.evaluate(
        """async () => {
            const { solid } = crs;
            await solid.toggle();
            const at = { clientX: 500, clientY: 400, bubbles: true };
            const grasp = { place: [0, 0], height: 0, moved: [] };
            solid.drag = { x: 1, y: 1, way: 0, by: [0, 0], grasp };
            await solid.toggle();
            solid.element.dispatchEvent(new PointerEvent("pointermove", at));
        }"""
    )


def a_unit_is_chosen_for_what_is_drawn(hand: Hand) -> None:
    hand.page.select_option("[aria-label=unit]", "cm")
    hand.press("c")
    hand.drag((3.4, 5.4), (3.6, 5.4))
    hand.has("cylinder0")
    hand.drag((3.4, 4.6), (3.6, 4.8))  # not 28.28427124746190cm
    hand.has("cylinder1")
    assert hand.page.evaluate("crs.model.item('cylinder1').attributes.radius") == "28.3cm"
    hand.press("Control+z")
    wait(hand.page, "!crs.model.item('cylinder1')")
    hand.page.locator(".item", has_text="cylinder0").click()
    known = hand.page.evaluate("crs.model.item('cylinder0').attributes")
    assert known == {"id": "cylinder0", "x": "340cm", "y": "540cm", "radius": "20cm"}
    hand.page.once("dialog", lambda dialog: dialog.accept("post"))
    wait(hand.page, "crs.model.selection.has('cylinder0')")
    hand.press("Control+g")
    hand.has("post", "define[post]")
    hand.press("Control+z", "Control+z", "Escape")
    wait(hand.page, "!crs.model.item('cylinder0')")
    hand.page.select_option("[aria-label=unit]", "")


def the_line_below_and_the_list_of_keys_say_what_to_do(hand: Hand) -> None:
    said = hand.page.locator(".status .notice")
    hand.press("r")
    said.get_by_text("Robot: click its initial position").wait_for()
    hand.click(1.0, 1.0)  # it selects the one that is there
    wait(hand.page, "crs.model.selection.has('robot0') && !crs.model.item('robot1')")
    hand.to(2.0, 1.0)
    hand.page.get_by_text("2m, 1m").wait_for()
    wait(hand.page, "document.querySelector('[aria-label=program]')?.list.options.length > 0")
    offered = "[...document.querySelector('[aria-label=program]').list.options][0].value"
    assert hand.page.evaluate(offered) == "go.c"
    hand.page.hover("[aria-label=mass], [aria-label=heat]")
    said.get_by_text("Heat at the start of the run; 0 for none.").wait_for()
    assert hand.page.locator(".property:has([aria-label=heat])").inner_text() == "heat no unit"
    hand.page.locator("canvas").first.focus()
    hand.press("Escape", "Escape", "?")
    hand.page.locator("dialog[open]").get_by_text("group the selection into an object").wait_for()
    hand.press("Delete", "?")  # it does nothing while the list is open
    hand.page.locator("dialog[open]").wait_for(state="detached")
    wait(hand.page, "crs.model.item('robot0')")


def elements_are_locked_and_hidden(hand: Hand) -> None:
    hand.click(0.5, 3.0)
    wait(hand.page, "crs.model.selection.has('wall0')")
    hand.press("k", "Control+a")
    wait(hand.page, "crs.model.selection.size > 3 && !crs.model.selection.has('wall0')")
    hand.press("i")
    hand.click(1.0, 1.0)
    wait(hand.page, "!crs.model.selection.size && crs.model.hidden.has('robot0')")
    hand.press("u")
    hand.click(1.0, 1.0)
    wait(hand.page, "crs.model.selection.has('robot0')")
    hand.page.locator(".item", has_text="wall0").click()
    hand.page.locator("canvas").first.focus()
    hand.press("k")
    wait(hand.page, "!crs.model.locked.size")


@pytest.mark.usefixtures("forks")
def test_a_world_is_drawn_saved_and_tried(page: Any, screen: BuildScreen, folder: Path) -> None:
    hand = Hand(page)
    walls_with_a_door_are_drawn_by_clicks_and_typed_lengths(hand)
    a_ramp_and_two_tables_of_parts_are_drawn(hand)
    a_robot_is_placed_and_turned(hand)
    problems_are_listed_and_undone(hand)
    the_file_is_as_a_person_would_have_written_it(hand, folder)
    properties_are_typed_and_everything_is_undone_and_done_again(hand, screen)
    goals_sounds_steps_and_ranges_are_drawn(hand)
    the_ground_is_raised_by_a_brush_and_read_from_a_picture(hand, folder)
    a_definition_is_edited_and_all_copies_follow(hand, screen)
    a_unit_is_chosen_for_what_is_drawn(hand)
    the_line_below_and_the_list_of_keys_say_what_to_do(hand)
    elements_are_locked_and_hidden(hand)
    it_is_looked_at_in_three_dimensions(hand)
    a_view_that_is_closed_while_it_is_made_or_dragged_stays_closed(hand.page)
    an_object_is_dragged_from_the_library(hand)
    goals_and_programs_are_checked_while_drawing(hand, folder)
    the_world_is_tried_and_editing_goes_on_where_it_was(hand, folder)


def test_a_robot_is_changed_by_dragging_its_parts(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "rover.xml"
    path.write_text(ROVER)
    with building(path, None, 0) as screen, page_in(browser, screen, 1200, 750) as page:
        wait(page, "window.crs && crs.model.document")
        hand = Hand(page)
        hand.drag((0.2, 0.0), (0.1, 0.05))
        wait(page, "crs.model.shapes('sensor')[1].y > 0.04")
        hand.drag((0.1 + 56 / page.evaluate("crs.view.scale"), 0.05), (0.1, 0.25))
        wait(page, "Math.abs(crs.model.shapes('sensor')[1].heading - Math.PI / 2) < 0.01")
        hand.press("s")
        hand.click(-0.1, 0.0)
        hand.has("sensor[1]")
        hand.press("v")
        wait(page, "crs.model.selection.has('sensor[1]')")
        page.select_option("[aria-label=operation]", "ring")
        hand.fill({"count": "6"}, "")
        hand.has("sensor[6]")
        page.locator("canvas").first.focus()
        hand.press("Control+z")
        wait(page, "!crs.model.item('sensor[2]')")
        hand.page.locator(".item", has_text="drive").click()
        hand.drag((0.0, 0.15), (0.0, 0.1))
        wait(page, "crs.model.item('drive').attributes['wheel-base'] === '20cm'")
        hand.page.locator("canvas").first.focus()
        hand.press("Control+s")
        wait(page, "!crs.model.document.changed")
    moved = ROVER.replace("0.2</x", "0.1</x").replace("0</y", "5cm</y")
    moved = moved.replace("0deg", "90deg").replace("30cm", "20cm").replace('"3"', '"3 0"')
    assert path.read_text() == moved.replace("</sensor>\n", f"</sensor>\n{BEHIND}")


FIRST = """<?xml version="1.0" encoding="UTF-8"?>
<world version="1">
  <area length="8m" width="6m"/>
  <surface>
    <ramp x="5m" y="1.5m" length="2m" width="1m" to="0.3m"/>
  </surface>
  <wall id="wall0" x1="2m" y1="3m" x2="4m" y2="3m"/>
  <wall id="wall1" x1="4m" y1="3m" x2="4m" y2="5m"/>
  <box id="box0" x="1.5m" y="4.5m" length="1m" width="1m" heat="5" spread="1m"/>
  <robot id="robot0" x="1m" y="1m" program="go.c"/>
  <robot id="robot1" x="2m" y="1m" program="go.c"/>
  <robot id="robot2" x="3m" y="1m" program="go.c"/>
</world>
"""


def test_a_first_world_is_drawn_in_a_few_steps(browser: Any, tmp_path: Path) -> None:
    (tmp_path / "go.c").write_text(PROGRAM)
    path = tmp_path / "first.xml"
    with building(path, None, 0) as screen, page_in(browser, screen, 1280, 720) as page:
        wait(page, "window.crs && crs.model.document")
        hand = Hand(page)
        hand.press("w")
        hand.click(2.0, 3.0)
        hand.click(4.0, 3.0)
        hand.click(4.0, 5.0)
        hand.press("Escape", "b")
        hand.drag((1.0, 4.0), (2.0, 5.0))
        hand.has("wall0", "wall1", "box0")
        for name, text in (("heat", "5"), ("spread", "1m")):
            page.fill(f".property [aria-label={name}]", text)
            hand.press("Enter")
            wait(page, f"crs.model.item('box0').attributes.{name} === '{text}'")
        page.locator("canvas").first.focus()
        hand.press("m")
        hand.drag((4.0, 1.0), (6.0, 2.0))
        hand.has("surface/ramp")
        hand.click(1.5, 4.5)  # a click without a drag selects
        wait(page, "crs.model.selection.has('box0')")
        hand.press("r")
        for number in range(3):
            hand.click(1.0 + number, 1.0)
            hand.has(f"robot{number}")
        page.get_by_role("button", name="Try").click()
        page.locator(".notice.wrong", has_text="robot 'robot0' has no program").wait_for()
        hand.press("v")
        hand.drag((0.5, 0.5), (3.5, 1.5))
        wait(page, "crs.model.selection.size === 3")
        page.fill(".property [aria-label=program]", "no.c")
        hand.press("Enter")
        page.locator(".problem", has_text="robot0").get_by_text("'no.c': no such file").wait_for()
        page.fill(".property [aria-label=program]", "go.c")
        hand.press("Enter")
        wait(page, "crs.model.item('robot2').attributes.program === 'go.c'")
        hand.click(-0.05, 3.0)  # the edge
        page.locator(".notice", has_text="The area and the walls around it").wait_for()
        wait(page, "crs.model.selection.has('area')")
        page.locator("canvas").first.focus()
        hand.press("Control+s")
        wait(page, "!crs.model.document.changed")
        page.locator(".notice.news", has_text="saved").wait_for()
    assert path.read_text() == FIRST


def test_a_definitions_file_names_where_to_edit_them(browser: Any, tmp_path: Path) -> None:
    """The page was empty, and did not say why."""
    path = tmp_path / "lib.xml"
    path.write_text('<definitions version="1"><material name="wood" colour="red"/></definitions>')
    with building(path, None, 0) as screen, page_in(browser, screen, 1200, 750) as page:
        page.get_by_text("definitions but no floor").wait_for()
        page.locator(".item", has_text="material[wood]").click()
        page.fill(".property [aria-label=colour]", "blue")
        page.keyboard.press("Enter")
        page.keyboard.press("Control+s")
        wait(page, "!crs.model.document.changed && crs.model.document.steps === 1")
    assert 'name="wood" colour="blue"' in path.read_text()


def test_a_drag_in_a_large_world_leaves_most_of_a_frame(browser: Any, tmp_path: Path) -> None:
    """Everything was redrawn for each frame of a drag."""
    boxes = "".join(
        f'<box x="{1 + number % 50}m" y="{1 + number // 50}m" length="40cm" width="30cm"/>'
        for number in range(2000)
    )
    robots = "".join(
        f'<robot x="{1.5 + number % 50}m" y="{42 + number // 50}m"/>' for number in range(200)
    )
    path = tmp_path / "large.xml"
    path.write_text(f'<world version="1"><area length="60m" width="60m"/>{boxes}{robots}</world>')
    with building(path, None, 0) as screen, page_in(browser, screen, 1200, 750) as page:
        wait(page, "window.crs && crs.model.document")
        hand = Hand(page)
        hand.press("Control+a")
        wait(page, "crs.model.selection.size === 2200")
        for button in ("left", "right"):
            hand.to(1.0, 1.0)
            page.mouse.down(button=button)
            assert page.evaluate(FRAMES) < 16, button
            page.mouse.up(button=button)
