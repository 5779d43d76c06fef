"""The page in a real browser: one run, watched, moved, stepped and left."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from crs_cc.workbench.screen import Screen
from tests.workbench.in_browser import new_page, page_in, running, wait

PROGRAM = """\
#include <Nclient.h>
#include <stdio.h>

int step;

void report(void)
{
    printf("step %d\\n", step);
}

int main(void)
{
    connect_robot(1);
    vm(100, 100, 0);
    for (step = 0; step < 1600; step++) {
        get_sn();
        if (step % 10 == 0)
            report();
    }
    return 0;
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="6m" width="4m"/>
  <box id="stove" x="4.500m" y="3m" length="0.5m" width="0.5m" heat="40" spread="2m"/>
  <robot id="ada" x="1m" y="1m"/>
  <robot id="bob" x="1m" y="2.500m"/>
</world>
"""
BLANK = """() => {
    const { canvas } = crs.views.active;
    const small = Object.assign(document.createElement("canvas"), { width: 60, height: 40 });
    const pen = small.getContext("2d");
    pen.drawImage(canvas, 0, 0, 60, 40);
    const data = pen.getImageData(0, 0, 60, 40).data;
    const colours = new Set();
    for (let at = 0; at < data.length; at += 4) colours.add(data.slice(at, at + 3).join());
    return [Boolean(canvas.getContext("webgl2")), colours.size];
}"""
POINT = """() => {
    crs.views.draw(0);  // places are those of the last picture, which may be of another camera
    const view = crs.views.active;
    const body = crs.model.scene.bodies[1];
    const box = view.element.getBoundingClientRect();
    const [x, y] = view.view.project(body.x, body.y, body.z + body.height / 2);
    return [box.left + x, box.top + y];
}"""
TRAIL_DRAWN = """() => {
    const { overlay } = crs.views.active;
    const draw = overlay.draw.bind(overlay);
    overlay.draw = (...all) => {
        window.trailDrawn = crs.look.trails.of(0);
        draw(...all);
    };
}"""
LOOKED_UP = """async (step) => {
    const { Trails } = await import("crs/trails.js");
    const trails = new Trails(() => undefined);
    const scene = { bodies: [], roster: () => ({ robots: [] }) };
    const frames = { span: async () => [] };
    trails.isStale = true;
    trails.update(scene, frames, 0);
    trails.update(scene, frames, step);
    trails.refine();
    return trails.isStale;
}"""
POSE = "() => crs.model.scene.bodies.map((body) => [body.x, body.y, body.heading])"


@pytest.fixture(scope="module")
def screen(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Screen]:
    with running(tmp_path_factory.mktemp("view"), PROGRAM, WORLD) as made:
        yield made


@pytest.fixture(scope="module")
def page(browser: Any, screen: Screen) -> Iterator[Any]:
    with page_in(browser, screen) as made:
        made.wait_for_function("() => document.body.dataset.time === '0.000'", polling=100)
        yield made


def poses(screen: Screen) -> list[list[float]]:
    state = screen.run.debugger().session.environment.state
    rows = zip(state.x_m.tolist(), state.y_m.tolist(), state.heading_rad.tolist(), strict=True)
    return [list(row) for row in rows]


def line(page: Any) -> int:
    return int(page.locator(".line.current .gutter").inner_text())


def it_shows_the_world_and_runs(page: Any, screen: Screen) -> None:
    assert page.title() == "go.c in room.xml · crs"
    has_webgl, colours = page.evaluate(BLANK)
    assert has_webgl
    assert colours > 20
    assert [row.inner_text() for row in page.locator(".robot b").all()] == ["ada", "bob"]
    page.click("button.start")
    wait(page, "crs.model.state.t > 1.2")
    page.click("#tab-code")  # and Space does not press it again
    page.keyboard.press(" ")
    wait(page, "!crs.model.state.playing && crs.model.clock.shown === crs.model.state.t")
    wait(page, "Math.abs(crs.model.scene.time - crs.model.state.t) < 1e-6")
    assert page.evaluate(POSE) == [pytest.approx(row, abs=2e-4) for row in poses(screen)]
    assert poses(screen)[0][0] > 1.1


def the_time_line_goes_back_to_any_instant(page: Any, screen: Screen) -> None:
    later = poses(screen)
    end = page.evaluate("crs.timeline.end")
    box = page.locator(".track").bounding_box()
    page.evaluate(TRAIL_DRAWN)
    page.mouse.click(box["x"] + box["width"] * 0.5 / end, box["y"] + 30)
    wait(page, "crs.model.clock.held === null && crs.model.state.t < 1.0")
    wait(page, "Math.abs(crs.model.scene.time - crs.model.state.t) < 1e-6")
    assert screen.run.time_s == pytest.approx(0.5, abs=0.051)
    assert page.evaluate(POSE) == [pytest.approx(row, abs=2e-4) for row in poses(screen)]
    assert poses(screen)[0][0] < later[0][0]
    # The trail that is drawn ends here, not where the robot has been later.
    wait(page, "window.trailDrawn?.at(-1)?.t <= crs.model.state.t + 1e-6")
    assert page.evaluate("window.trailDrawn[0].t") < 0.1


def trails_need_no_block_of_frames_while_the_run_is_watched(page: Any) -> None:
    assert page.evaluate(LOOKED_UP, 0.1) is False
    assert page.evaluate(LOOKED_UP, 1.0) is True


def a_button_goes_ten_seconds_back(page: Any) -> None:
    page.evaluate("crs.timeline.seek(10.5)")
    wait(page, "Math.abs(crs.model.state.t - 10.5) < 1e-6 && !crs.model.state.busy")
    page.click("[title^='Back ten seconds']")
    wait(page, "Math.abs(crs.model.state.t - 0.5) < 1e-6 && !crs.model.state.busy")


def what_was_printed_leads_to_its_instant(page: Any) -> None:
    page.evaluate("crs.timeline.seek(3.5)")
    wait(page, "Math.abs(crs.model.state.t - 3.5) < 1e-6 && !crs.model.state.busy")
    page.click("#tab-output")
    piece = page.locator("#output span", has_text="step 20").first
    time_s = float(piece.get_attribute("data-time"))
    assert time_s > 0.1
    piece.click()
    wait(page, f"Math.abs(crs.model.state.t - {time_s}) < 0.0501 && !crs.model.state.busy")
    page.click("#tab-code")
    page.evaluate("crs.timeline.seek(0.5)")
    wait(page, "Math.abs(crs.model.state.t - 0.5) < 1e-6 && !crs.model.state.busy")


def overlays_are_of_all_robots_or_of_the_selected_one(page: Any) -> None:
    named = "crs.views.active.overlay.chosen().map((body) => body.id).join()"
    assert page.evaluate(named) == "ada,bob"
    page.click("text=Only for the selected robot")
    assert page.evaluate(named) == "ada"
    page.click("text=Only for the selected robot")


def a_breakpoint_by_a_click_stops_there_and_steps_go_both_ways(page: Any) -> None:
    page.click(".line:nth-child(8) .gutter")
    page.wait_for_selector(".line:nth-child(8).stop")
    page.keyboard.press("F5")
    wait(page, "crs.model.state.halt.reason === 'breakpoint' && crs.model.position.line === 8")
    page.wait_for_selector(".line:nth-child(8).current")
    page.click("#tab-events")
    page.keyboard.press("Shift+F11")
    wait(page, "crs.model.position.line === 18")
    page.click("#tab-code")  # the line is in sight although the listing was hidden when it came
    listing, current = (page.locator(at).bounding_box() for at in (".listing", ".line.current"))
    assert 0 <= current["y"] - listing["y"] <= listing["height"] - current["height"]
    page.keyboard.press("F11")
    wait(page, "crs.model.position.line === 8")
    page.click(".line:nth-child(8) .gutter")
    page.wait_for_selector(".line:nth-child(8):not(.stop)")


def a_robot_is_selected_in_the_view_and_commands_change_the_run(page: Any) -> None:
    x, y = page.evaluate(POINT)
    page.mouse.click(x, y)
    wait(page, "crs.model.state.robot === 1")
    assert page.locator(".robot[aria-selected=true] b").inner_text() == "bob"
    page.click("#tab-console")
    page.fill(".prompt input", "move bob to 3 3 90")
    page.press(".prompt input", "Enter")
    page.wait_for_selector(".log >> text=bob is now at 3.000, 3.000 m")
    wait(page, "Math.abs(crs.model.scene.body(1).x - 3) < 1e-3")
    page.evaluate("""crs.console('note "moved here"')""")
    wait(
        page, "crs.model.happenings.some((each) => each[1] === 'note' && each[3] === 'moved here')"
    )
    page.fill(".prompt input", "source secret.dbg")
    page.press(".prompt input", "Enter")
    page.wait_for_selector(".log .error >> text='source' is not available in the browser")


def two_fingers_enlarge_the_view_and_one_selects(page: Any) -> None:
    camera = "[crs.views.active.camera.distance, crs.views.active.camera.azimuth]"
    box = page.locator(".viewport").first.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    line = page.context.new_cdp_session(page)

    def touch(kind: str, *places: tuple[float, float]) -> None:
        points = [{"x": x, "y": y, "id": each} for each, (x, y) in enumerate(places)]
        line.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": points})

    distance, azimuth = page.evaluate(camera)
    for apart in (40, 60, 80):
        touch("Start" if apart == 40 else "Move", (x - apart, y), (x + apart, y))
    touch("End")
    wait(page, f"Math.abs({camera}[0] - {distance / 2}) < 1e-6 && {camera}[1] === {azimuth}")
    for apart in (80, 40):
        touch("Start" if apart == 80 else "Move", (x - apart, y), (x + apart, y))
    touch("End")
    wait(page, f"Math.abs({camera}[0] - {distance}) < 1e-6")
    page.evaluate("crs.model.select(0)")
    wait(page, "crs.model.state.robot === 0")
    place = page.evaluate(POINT)
    touch("Start", place)
    touch("Move", (place[0] + 3, place[1] + 3))
    touch("End")
    wait(page, "crs.model.state.robot === 1")


def heat_is_a_colour_and_there_is_a_flat_map(page: Any) -> None:
    page.locator(".viewport").first.focus()
    page.keyboard.press("i")
    shapes = (
        "[...crs.views.active.view.meshes].map(([s, m]) => [s.id, m.material.color.getHexString()])"
    )
    wait(page, f"new Map({shapes}).get('stove') === 'fcfdbf'")
    assert dict(page.evaluate(shapes))["edge-south"] == "0b1026"
    page.evaluate("async () => { window.heat = await import('crs/heat.js'); }")
    at = "([x, y]) => heat.heatAt(heat.hotObjects(crs.model.scene), x, y)"
    # Half a metre from the stove's edge, whose heat of 40 spreads over 2 m: 40 * (1 - 0.5 / 2).
    assert page.evaluate(at, [4.5, 2.25]) == pytest.approx(30.0)
    assert page.evaluate(at, [4.5, 0.5]) == 0.0
    page.keyboard.press("i")
    page.keyboard.press("f")
    wait(page, "crs.views.active.isFlat")


def who_may_only_look_cannot_steer_and_hears_the_end(
    browser: Any, page: Any, screen: Screen
) -> None:
    looker = new_page(browser, 700, 500)
    looker.goto(screen.server.address("view") + "&flat=1")
    looker.wait_for_selector(".robot b")
    wait(looker, "document.querySelector('.transport .primary').disabled")
    said = looker.evaluate("crs.model.channel.request('play').catch((error) => error.message)")
    assert "view-only" in said
    screen.player.end()
    screen.server.close()
    for each in (page, looker):
        wait(each, "document.querySelector('.chip.state').textContent === 'not connected'")
        assert "restart it" in each.locator("#note").inner_text()
    looker.close()


def test_a_run_is_watched_moved_stepped_and_left(browser: Any, page: Any, screen: Screen) -> None:
    """One test, since each step begins where the one before has led."""
    it_shows_the_world_and_runs(page, screen)
    the_time_line_goes_back_to_any_instant(page, screen)
    trails_need_no_block_of_frames_while_the_run_is_watched(page)
    a_button_goes_ten_seconds_back(page)
    what_was_printed_leads_to_its_instant(page)
    overlays_are_of_all_robots_or_of_the_selected_one(page)
    a_breakpoint_by_a_click_stops_there_and_steps_go_both_ways(page)
    a_robot_is_selected_in_the_view_and_commands_change_the_run(page)
    two_fingers_enlarge_the_view_and_one_selects(page)
    heat_is_a_colour_and_there_is_a_flat_map(page)
    who_may_only_look_cannot_steer_and_hears_the_end(browser, page, screen)
