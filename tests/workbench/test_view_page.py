"""What the view shows of devices, its light, its cameras, and what it saves, in a real browser."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.main import main
from crs_cc.cli.start_view import screen_of
from crs_cc.cli.view_recording import recording_screen
from crs_cc.recording import topics
from crs_cc.recording.recording import Recording
from crs_cc.workbench.screen import Screen
from tests.workbench.in_browser import new_page, page_at, page_in, played, wait

SAMPLE = Path(__file__).parents[2] / "samples" / "scout_c" / "hand"
BRIGHTNESS = """() => {
    const { canvas } = crs.views.active;
    const small = Object.assign(document.createElement("canvas"), { width: 60, height: 40 });
    const pen = small.getContext("2d");
    pen.drawImage(canvas, 0, 0, 60, 40);
    const { data } = pen.getImageData(0, 0, 60, 40);
    return data.reduce((sum, each, at) => sum + (at % 4 < 3 ? each : 0), 0) / 7200;
}"""
SLOPE = """async () => {
    const { Ground } = await import("crs/ground.js");
    const ramp = { x: 2, y: 0, heading: Math.PI / 2, length: 4, width: 2, from: 0, to: 1 };
    const ground = new Ground({ patches: [ramp], map: null });
    return [ground.slope(2, 0), ground.slope(-3, 0)];
}"""


@pytest.fixture
def screen() -> Iterator[Screen]:
    files = Inputs((SAMPLE / "hand.c",), SAMPLE / "hand.xml")
    with played(screen_of(DebugOptions(inputs=files, quiet=True), 0)) as made:
        yield made


def an_arm_and_what_it_carries_are_where_they_are(page: Any) -> None:
    page.evaluate("crs.timeline.seek(6)")
    wait(page, "crs.model.status.t === 6 && Math.abs(crs.model.scene.time - 6) < 1e-6")
    obj, joints = page.evaluate(
        "[crs.model.status.devices.holds[0][0], crs.model.status.devices.joints[0]]"
    )
    view = "crs.views.active.view"
    limbs = f"{view}.limbs.all.values().next().value"
    wait(page, f"Math.abs({limbs}.fore.rotation.z - {joints[1]}) < 1e-6")
    assert page.evaluate(f"{limbs}.upper.rotation.z") == pytest.approx(joints[0])
    high = f"[...{view}.meshes].find(([shape]) => shape.id === '{obj}')[1].position.z"
    assert page.evaluate(high) > 0.2


def what_is_degraded_is_told_and_slopes_are_measured(page: Any) -> None:
    page.evaluate("crs.console('degrade robot0 bumper.2 dead')")
    wait(page, "crs.model.status.devices.degraded.length === 1")
    assert page.evaluate("crs.look.devices.degraded[0].slice(0, 3)") == [0, "bumper", 2]
    steep, flat = page.evaluate(SLOPE)
    assert steep == pytest.approx([0.0, 0.25])
    assert flat is None


def what_is_hot_is_marked_and_has_its_heat_of_now(page: Any) -> None:
    shape = "crs.model.scene.shapes.find((each) => each.movable)"
    mark = f"crs.views.active.view.meshes.get({shape}).children[0]"
    assert page.evaluate(f"{mark} === undefined")
    page.evaluate(f"crs.console(`heat ${{{shape}.id}} 7`)")
    wait(page, f"{mark}?.visible && crs.model.scene.heat({shape}) === 7")
    page.evaluate(f"crs.console(`heat ${{{shape}.id}} 0`)")
    wait(page, f"!{mark}.visible && crs.model.scene.heat({shape}) === 0")


def what_can_be_pushed_is_outlined(page: Any) -> None:
    drawn = """(() => {
        const { over } = crs.views.active;
        const { data } = over.getContext("2d").getImageData(0, 0, over.width, over.height);
        return data.filter((each, at) => at % 4 === 3 && each).length;
    })()"""
    before = page.evaluate(drawn)
    page.click("text=Movable objects")
    wait(page, f"{drawn} < {before}")
    page.click("text=Movable objects")


def what_sensors_have_measured_is_drawn(page: Any) -> None:
    """Of the camera's picture, the left half is red and the right one green."""
    page.evaluate("crs.look.toggle('heat')")
    page.evaluate(
        """() => {
            const { kind } = crs.model.scene.body(0);
            kind.camera = { x: 0, y: 0, z: 0.3, direction: 0, fov: 1, range: 5 };
            kind.infrared = { step: 0.0254, z: 0.2, farthest: 15 };
            const { devices } = crs.model.status;
            devices.camera = [["#ff0000", 1], ["#00ff00", null]];
            devices.infrared = [5, 15, null, 0];
            crs.look.version++;
        }"""
    )
    pixel = """(away) => {
        const { over } = crs.views.active;
        const [x, y] = [(over.clientWidth / 2 + away) * devicePixelRatio, 75 * devicePixelRatio];
        return [...over.getContext("2d").getImageData(x, y, 1, 1).data.slice(0, 3)].join();
    }"""
    page.wait_for_function(f"() => ({pixel})(-60) === '255,0,0'", polling=100)
    assert page.evaluate(pixel, 60) == "0,255,0"
    page.evaluate("crs.look.toggle('heat')")


def who_wants_no_motion_is_shown_the_end_of_it(page: Any) -> None:
    jump = "[crs.model.clock.shown = 5.9, crs.model.clock.advance(0.001), crs.model.clock.target]"
    page.emulate_media(reduced_motion="reduce")
    _, shown, target = page.evaluate(jump)
    assert shown == target
    page.emulate_media(reduced_motion="no-preference")


def lamps_light_the_night(page: Any) -> None:
    day = page.evaluate(BRIGHTNESS)
    page.keyboard.press("m")
    page.locator(".slider input").first.fill("0")
    wait(page, f"({BRIGHTNESS})() < {day / 2}")
    night = page.evaluate(BRIGHTNESS)
    page.click("text=Add a lamp")
    box = page.locator(".viewport").bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] * 0.6)
    wait(page, f"crs.look.light.lamps.length === 1 && ({BRIGHTNESS})() > {night * 1.1}")


def views_are_kept_and_shown_again(page: Any) -> None:
    page.click(".menu >> text=2")
    assert page.locator(".viewport").count() == 2
    page.fill(".menu [aria-label='name of this view']", "behind")
    page.click(".menu >> text=Keep")
    kept = page.evaluate("crs.views.cameras()")
    page.click(".menu .segmented button:first-child")
    page.evaluate("crs.look.light.set({ day: 1 })")
    page.click(".menu .saved")
    assert page.evaluate("crs.views.cameras()") == kept
    assert page.evaluate("crs.look.light.day") == 0


def a_video_and_a_page_are_saved(browser: Any, page: Any, folder: Path) -> None:
    page.click(".menu >> text=Video")
    wait(page, "crs.views.video.isOn")
    page.keyboard.press("Escape")
    page.locator(".viewport").first.focus()
    page.keyboard.press("ArrowRight")
    wait(page, "crs.model.scene.time === crs.model.state.t")
    wait(page, "crs.views.video.size > 0")
    with page.expect_download() as saved:
        page.keyboard.press("r")
    saved.value.save_as(folder / "video.webm")
    assert (folder / "video.webm").read_bytes()[:4] == b"\x1a\x45\xdf\xa3"  # EBML, RFC 8794
    page.keyboard.press("m")
    with page.expect_download() as saved:
        page.click(".menu >> text=Web page")
    saved.value.save_as(folder / "run.html")
    alone = new_page(browser)
    alone.goto((folder / "run.html").as_uri() + "#flat=1&t=1")
    wait(alone, "crs.model.scene && Math.abs(crs.model.scene.time - 1) < 0.03")
    assert alone.locator(".robot b").inner_text() == "robot0"
    alone.close()


def a_recording_is_saved_that_runs_again(page: Any, folder: Path) -> None:
    page.evaluate("crs.model.channel.request('console', { line: 'note here it holds on' })")
    page.keyboard.press("m")
    with page.expect_download() as saved:
        page.click(".menu >> text=Recording")
    saved.value.save_as(folder / "crs-run.mcap")
    recording = Recording(folder / "crs-run.mcap")
    wait(page, "!crs.model.state.playing")
    shown_s = page.evaluate("crs.model.state.t")
    assert recording.end_ns == pytest.approx(shown_s * 1e9, abs=0.06e9)
    changes = [data for _, data in recording.data(topics.INPUT.topic)]
    assert any("here it holds on" in each.values() for each in changes)
    assert main(["replay", "--verify", str(folder / "crs-run.mcap")]) == 0


def a_picture_is_saved_and_a_link_leads_here(browser: Any, page: Any, folder: Path) -> None:
    page.keyboard.press("Escape")
    with page.expect_download() as saved:
        page.keyboard.press("s")
    saved.value.save_as(folder / "view.png")
    with Image.open(folder / "view.png") as picture:
        assert len(picture.convert("RGB").getcolors(1 << 24)) > 50
    page.keyboard.press("k")
    other = new_page(browser)
    other.goto(page.url)
    here = page.evaluate("[crs.model.scene.time, crs.views.cameras()]")
    wait(other, f"Math.abs(crs.model.scene?.time - {here[0]}) < 0.01")
    wait(other, f"crs.views.cameras() === '{here[1]}'")
    other.close()


def a_span_is_repeated(page: Any) -> None:
    box = page.locator(".track").bounding_box()
    scale = box["width"] / page.evaluate("crs.timeline.end")
    page.keyboard.down("Shift")
    page.mouse.move(box["x"] + 0.5 * scale, box["y"] + 30)
    page.mouse.down()
    page.mouse.move(box["x"] + 1.5 * scale, box["y"] + 30, steps=3)
    page.mouse.up()
    page.keyboard.up("Shift")
    wait(page, "crs.model.state.span && crs.model.state.t <= 0.51")
    assert page.evaluate("crs.model.state.span") == pytest.approx([0.5, 1.5], abs=0.05)


def test_the_view_shows_devices_and_saves_its_contents(
    browser: Any, screen: Screen, tmp_path: Path
) -> None:
    """One test, since each step begins where the one before has led."""
    with page_in(browser, screen) as page:
        page.wait_for_selector(".robot b")
        an_arm_and_what_it_carries_are_where_they_are(page)
        what_is_degraded_is_told_and_slopes_are_measured(page)
        what_is_hot_is_marked_and_has_its_heat_of_now(page)
        what_can_be_pushed_is_outlined(page)
        what_sensors_have_measured_is_drawn(page)
        who_wants_no_motion_is_shown_the_end_of_it(page)
        lamps_light_the_night(page)
        views_are_kept_and_shown_again(page)
        a_video_and_a_page_are_saved(browser, page, tmp_path)
        a_picture_is_saved_and_a_link_leads_here(browser, page, tmp_path)
        a_span_is_repeated(page)
        a_recording_is_saved_that_runs_again(page, tmp_path)


FIELD = "crs.look.fields.find(({ name }) => name === 'trail')"
SQUARES = f"{FIELD}?.shares.filter((each) => each).length"
CARPET = "crs.views.active.view.fields.all.get('trail').mesh"
SCALE = """(() => {
    const { canvas, pen } = crs.views.active.overlay;
    return [...pen.getImageData(57, canvas.height - 93, 1, 1).data];
})()"""


def shows(page: Any, time_s: float, most: float, squares: int) -> None:
    """Go to a time, and see what is recorded of the trail."""
    page.evaluate(f"crs.timeline.seek({time_s})")
    wait(page, f"crs.look.time === {time_s} && {SQUARES} === {squares}")
    assert page.evaluate(f"{FIELD}.most") == pytest.approx(most, rel=0.01)
    opaque = f"{CARPET}.material.map.image.data.filter((each, at) => at % 4 === 3 && each)"
    wait(page, f"{opaque}.length === {squares}")


def what_was_laid_is_shown_at_any_time(page: Any) -> None:
    """At 2 s there is 31.94, which evaporates in 2 s; at 6 s the robot has gone on."""
    page.wait_for_selector(".robot b")  # it has heard of the run
    shows(page, 6.0, 10.71, 2)
    shows(page, 3.5, 31.94 * math.exp(-1.5 / 2), 1)
    shows(page, 1.0, 0.0, 0)
    shows(page, 4.25, 31.94 * math.exp(-2.25 / 2), 1)


def a_switch_hides_fields_and_their_scale(page: Any) -> None:
    shown = page.locator("label:has-text('Pheromone fields') input")
    wait(page, f"{CARPET}.visible && {SCALE}[2] > 150 && {SCALE}[1] < 120")
    shown.uncheck()
    wait(page, f"!{CARPET}.visible && {SCALE}[3] === 0")
    shown.check()
    wait(page, f"{CARPET}.visible && {SCALE}[2] > 150")


def test_fields_of_recordings_are_shown_in_the_view_and_in_pages(
    browser: Any, fields_folder: Path, tmp_path: Path
) -> None:
    path, html = fields_folder / "run.mcap", tmp_path / "run.html"
    assert main(["replay", str(path), "--html", str(html)]) == 0
    with ExitStack() as stack:
        recording = Recording(path)
        stack.callback(recording.close)
        screen = recording_screen(recording, 0, stack)
        screen.feed.description["follows"] = False  # the programs, which would tell their own
        with played(screen), page_in(browser, screen) as page:
            what_was_laid_is_shown_at_any_time(page)
            a_switch_hides_fields_and_their_scale(page)
    with page_at(browser, html.as_uri(), 900, 600, "dark") as page:
        what_was_laid_is_shown_at_any_time(page)
        a_switch_hides_fields_and_their_scale(page)
