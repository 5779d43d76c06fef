"""The control panel in a real browser: robots, faults, messages and changes of one run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.workbench.screen import Screen
from tests.workbench.in_browser import page_in, running, wait

PROGRAM = """\
#include <Nclient.h>
#include <crs.h>

int main(void)
{
    int i;

    connect_robot(1);
    for (i = 0; i < 3000; i++) {
        get_sn();
        if (i % 10 == 0)
            crs_broadcast(0, "tick", 5);
    }
    return 0;
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="6m" width="4m"/>
  <field name="trail" evaporation="60s"/>
  <robot id="ada" x="1m" y="1m"/>
  <robot id="bob" x="1m" y="2.500m"/>
</world>
"""


def click(page: Any, text: str, within: str) -> None:
    page.locator(f"{within} >> button:has-text('{text}')").first.click()


def changes(debugger: Debugger) -> list[str]:
    return [each.text for each in debugger.run.history.changes]


def the_table_has_a_row_for_each_robot(page: Any, debugger: Debugger) -> None:
    page.click("button.start")
    wait(page, "crs.model.state.t > 0.7")
    page.keyboard.press(" ")
    wait(page, "!crs.model.state.playing")
    page.keyboard.press("9")
    row = page.locator("#robot-row-1")
    page.wait_for_selector("#robot-row-1 .code:has-text('go.c')")
    assert row.locator("span").nth(0).inner_text() == "bob"
    assert row.locator("span").nth(4).inner_text() == "1.000, 2.500 m, 0°"
    row.click()
    wait(page, "crs.model.position.robot === 1")
    assert debugger.view.robot == 1
    page.keyboard.press("9")


def lines_of_plots_are_seen_on_light_and_dark(page: Any) -> None:
    """A contrast of 3 to 1 at least, WCAG 2.2, 1.4.11."""
    lines = page.evaluate("import('crs/plot.js').then(({ LINES }) => LINES)")
    for panel in ("#ffffff", "#1c2027"):
        for colour in lines:
            low, high = sorted((luminance(colour), luminance(panel)))
            assert (high + 0.05) / (low + 0.05) >= 3.0, (colour, panel)


def luminance(colour: str) -> float:
    """Return the relative luminance of a colour, WCAG 2.2."""
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    red, green, blue = (
        each / 12.92 if each <= 0.04045 else ((each + 0.055) / 1.055) ** 2.4 for each in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def sensors_have_their_past_though_the_run_stands(page: Any) -> None:
    page.evaluate("crs.instruments.now = null; crs.instruments.series.clear()")
    page.evaluate("crs.instruments.known.clear()")
    page.click("#tab-robot")
    wait(page, "crs.instruments.series.of('1 sonar.0').times.length > 10")


def a_robot_is_moved_and_what_is_wrong_is_said_at_its_field(page: Any, debugger: Debugger) -> None:
    page.wait_for_selector(".state-rows th:has-text('STATE_SONAR_0')")
    click(page, "Move", ".actions")
    x = page.locator(".action-form input").nth(0)
    heading = page.locator(".action-form input").nth(2)
    x.fill("5 lb")
    heading.fill("north")
    click(page, "Move", ".action-form")
    page.wait_for_selector(".action-form .field:first-child .wrong:has-text('is not a length')")
    page.wait_for_selector(".action-form .field:nth-child(3) .wrong:has-text('is not an angle')")
    x.fill("3")
    heading.fill("0")
    click(page, "Move", ".action-form")
    wait(page, "Math.abs((crs.model.scene.body(1)?.x ?? 0) - 3) < 1e-3")
    assert changes(debugger) == ["move bob to 3 2.50 0"]
    click(page, "Hold", ".actions")
    page.wait_for_selector(".actions button:has-text('Release')")


def a_sonar_is_degraded_and_reads_otherwise(page: Any, debugger: Debugger) -> None:
    page.click("#tab-faults")
    page.wait_for_selector("#panel-faults .laws")
    devices = page.locator("#panel-faults select").nth(0)
    devices.select_option("sonar")
    page.locator("#panel-faults select").nth(1).select_option("4")
    stuck = page.locator("#panel-faults .field:has(label:text-is('stuck')) input[type=text]")
    share = page.locator("#panel-faults .field:has(label:text-is('dropouts')) input")
    stuck.fill("5 lb")
    share.fill("7")
    click(page, "Degrade", "#panel-faults")
    page.wait_for_selector(".bad-field .wrong:has-text('is not a length')")
    page.wait_for_selector(".bad-field:has(label:text-is('dropouts')) .wrong:has-text('0 to 1')")
    stuck.fill("1.27m")
    share.fill("")
    click(page, "Degrade", "#panel-faults")
    page.wait_for_selector(".in-force:has-text('sonar 4, stuck at 1.27m')")
    page.evaluate("crs.model.request('step', { timesteps: 20 })")
    page.click("#tab-robot")
    # 1.27 m are 50 inches, as the vendor's State[] has them
    page.wait_for_selector(".state-rows tr:has-text('STATE_SONAR_4'):has-text('50 in')")
    page.click("#tab-faults")
    click(page, "Heal", ".in-force:has-text('sonar 4')")
    page.wait_for_selector(".in-force:has-text('sonar 4')", state="detached")
    assert changes(debugger)[2:] == ["degrade bob sonar.4 stuck 1.27m", "heal degradation0"]


def a_field_evaporates_otherwise(page: Any, debugger: Debugger) -> None:
    page.click("#tab-robot")
    click(page, "Evaporation", ".actions")
    field, time = (page.locator(".action-form input").nth(at) for at in (0, 1))
    assert (field.input_value(), time.input_value()) == ("trail", "60")
    field.fill("smoke")
    click(page, "Evaporation", ".action-form")
    page.wait_for_selector(".action-form .field:first-child .wrong:has-text('smoke')")
    field.fill("trail")
    time.fill("7.5")
    click(page, "Evaporation", ".action-form")
    wait(page, "crs.model.panel.changes.at(-1).text === 'evaporate trail 7.5s'")
    assert changes(debugger)[4:] == ["evaporate trail 7.5s"]
    assert debugger.session.environment.state.fields.evaporation_s.tolist() == [7.5]


def an_expression_is_plotted_back_to_the_start(page: Any) -> None:
    page.keyboard.press("g")
    # What the robot did is there at once, a sample for each timestep.
    times = "crs.instruments.series.of('1 speed').times"
    wait(page, f"{times}.length > 14 && {times}.at(-1) >= crs.model.state.end - 1e-6")
    page.fill("#panel-plot input", "j")
    page.press("#panel-plot input", "Enter")
    page.wait_for_selector("#panel-plot .wrong:has-text('undeclared'):has-text('clearance')")
    colour = "crs.el && document.querySelector('.chip:has(b) .dot').style.background"
    before = page.evaluate(colour)
    for name in ("clearance", "i"):
        page.fill("#panel-plot input", name)
        page.press("#panel-plot input", "Enter")
        page.wait_for_selector(f".chips .chip b:text-is('{name}')")
    page.wait_for_selector(".chips .chip:has-text('clearance'):has-text(' m')")
    wait(page, "crs.instruments.series.of('1 clearance').times.length > 14")
    wait(page, "crs.instruments.series.of('1 i').times.length > 10")
    assert page.evaluate(colour) == before
    page.click(".chip:has-text('speed') .close")
    page.wait_for_selector(".chip:has-text('speed')", state="detached")
    values = page.evaluate("crs.instruments.series.of('1 i').values")
    known = [each for each in values if each is not None]
    assert known == sorted(known)
    page.keyboard.press("g")  # what is plotted is read again while the run stands
    page.wait_for_selector("#panel-plot", state="hidden")


def a_click_on_an_approach_goes_there(page: Any, debugger: Debugger) -> None:
    """Bob started a metre from the edge, and is farther from all else since he was moved."""
    page.click("#tab-events")
    page.click(".only-robot:has-text('Only bob')")
    page.wait_for_selector(".events .event span:last-child:text-matches('^ada')", state="detached")
    gap_m = 1.0 - debugger.session.environment.world.robots[1].model.radius_m
    page.wait_for_selector(".event.closest:has-text('bob')")
    page.click(f".events .event:has-text('bob came to {gap_m:.2f} m of edge-west')")
    wait(page, "crs.model.state.t === 0 && crs.model.scene.time < 1e-6")
    page.evaluate("crs.timeline.seek(crs.model.state.end)")
    wait(page, "crs.model.state.t >= crs.model.state.end - 1e-6")
    page.click(".only-robot")
    page.wait_for_selector(".events .event span:last-child:text-matches('^ada')")


def messages_are_listed_shut_and_sent(page: Any, debugger: Debugger) -> None:
    page.click("#drawer-messages")
    page.wait_for_selector(".message:has-text('ada → bob'):has-text('tick'):has-text('arrived')")
    page.wait_for_selector(".graph .link[aria-label^='ada to bob']")
    when = page.locator(".message .when").last
    time_s = float(when.inner_text().split()[0])
    when.click()
    wait(page, f"Math.abs(crs.model.state.t - {time_s}) < 0.06")
    page.evaluate("crs.timeline.seek(crs.model.state.end)")
    wait(page, "crs.model.state.t >= crs.model.state.end - 1e-6")
    click(page, "Block links", ".side-box")
    shut = page.locator(".link-forms").first
    shut.locator("select").nth(1).select_option("bob")
    click(page, "Block", ".link-forms")
    page.wait_for_selector(".outages .in-force:has-text('from bob')")
    click(page, "Send", ".side-box .segmented")
    page.locator(".link-forms >> nth=1").locator("select").nth(0).select_option("bob")
    page.locator(".link-forms >> nth=1").locator("input").nth(1).fill("who hears?")
    click(page, "Send", ".link-forms >> nth=1")
    page.evaluate("crs.model.request('step', { timesteps: 4 })")
    page.wait_for_selector(".message:has-text('bob → ada'):has-text('hears?'):has-text('outage')")
    rows = page.evaluate("crs.model.channel.request('traffic', { since: 0 })")["rows"]
    events = debugger.run.event_history.world_events()
    told = [each for each in events if each.kind.startswith("message-")]
    assert len(rows) == len([each for each in told if each.kind != "message-way"])
    page.click("#drawer-messages")


def changes_are_listed_taken_back_and_written_out(page: Any, debugger: Debugger) -> None:
    page.click("#tab-events")  # changes are marked, and listed among what has happened
    page.wait_for_selector(".event:has-text('move bob to 3 2.50 0')")
    assert page.evaluate("crs.timeline.marks().filter(([, kind]) => kind === 'change').length") > 1
    page.click("#tab-changes")
    assert page.locator(".change").count() == len(changes(debugger)) == 7
    script = page.evaluate("crs.model.channel.request('export', { form: 'inputs' })")["text"]
    assert [line.split(": ", 1)[1] for line in script.splitlines()[1:]] == changes(debugger)
    xml = page.evaluate("crs.model.channel.request('export', { form: 'xml' })")["text"]
    assert 'id="hold-bob"' in xml
    assert 'from="bob"' in xml
    click(page, "Undo", ".change:has-text('move bob')")
    wait(page, "document.querySelectorAll('.change').length === 0")
    wait(page, "Math.abs(crs.model.scene.body(1).x - 1) < 1e-3")
    assert changes(debugger) == []


def the_run_before_is_kept_and_compared(page: Any, debugger: Debugger) -> None:
    """Bob was moved in the run that the take-back has left, and not in the one after."""
    assert [each.inner_text() for each in page.locator(".branch b").all()] == ["main", "run2"]
    assert page.locator(".branch[aria-current] b").inner_text() == "run2"
    page.evaluate("crs.model.request('step', { timesteps: 10 })")
    click(page, "Compare", ".branch:has-text('main')")
    row = page.locator(".differences tr:has-text('bob pose.x') td")
    row.first.wait_for()
    assert [row.nth(at).inner_text() for at in (2, 3)] == ["1", "3"]
    assert page.evaluate("crs.look.other.paths.bob.at(-1).slice(0, 2)") == [3.0, 2.5]
    click(page, "Show", ".branch:has-text('main')")
    wait(page, "Math.abs((crs.model.scene.body(1)?.x ?? 9) - 3) < 1e-3")
    wait(page, "document.querySelectorAll('.change').length === 7")
    assert changes(debugger)[0] == "move bob to 3 2.50 0"
    assert debugger.session.environment.state.x_m[1] == pytest.approx(3.0)
    click(page, "Show", ".branch:has-text('run2')")
    wait(page, "document.querySelectorAll('.change').length === 0")
    wait(page, "Math.abs((crs.model.scene.body(1)?.x ?? 9) - 1) < 1e-3")


def a_gamepad_drives_the_robot(page: Any, debugger: Debugger) -> None:
    page.click("#tab-robot")
    before_m = debugger.session.environment.state.x_m[1]
    page.evaluate(
        "navigator.getGamepads = () => [null, { connected: true, axes: [0, window.stick ?? -0.5] }]"
    )
    click(page, "Drive", ".actions")
    wait(page, f"(crs.model.scene.body(1)?.x ?? 0) > {before_m + 0.1}")
    page.evaluate("window.stick = 0.05")  # as good as in the middle: it stops
    wait(page, "crs.model.panel.changes.at(-1).text === 'drive bob 0 0'")
    page.keyboard.press("Escape")
    page.wait_for_selector(".driving", state="hidden")
    page.keyboard.press(" ")
    wait(page, "!crs.model.state.playing")
    assert changes(debugger)[0] == "drive bob 0.3 0"


def a_robot_joins_with_a_program_of_its_own(page: Any, folder: Path) -> None:
    dance = folder / "dance.c"
    dance.write_text("int main(void) { return x; }")
    page.click("#tab-robot")
    click(page, "Add a robot", ".actions")
    page.set_input_files(".action-form input[type=file]", dance)
    click(page, "Add", ".action-form")
    page.wait_for_selector(".action-form .wrong:has-text('dance.c:1')")
    dance.write_text("int main(void) { for (;;) ; }")
    page.set_input_files(".action-form input[type=file]", dance)
    click(page, "Add", ".action-form")
    wait(page, "crs.model.run.rosters.at(-1).robots.length === 3")
    page.wait_for_selector(".robot b:has-text('robot2')")
    wait(page, "Boolean(crs.model.scene.body(2))")


def test_a_run_is_viewed_changed_and_restored_by_the_panel(browser: Any, tmp_path: Path) -> None:
    """One test, since each step begins where the one before has led."""
    with running(tmp_path, PROGRAM, WORLD) as screen:
        debugger = debugger_of(screen)
        with page_in(browser, screen, 1280, 720) as page:
            wait(page, "document.body.dataset.time === '0.000'")
            the_table_has_a_row_for_each_robot(page, debugger)
            lines_of_plots_are_seen_on_light_and_dark(page)
            sensors_have_their_past_though_the_run_stands(page)
            a_robot_is_moved_and_what_is_wrong_is_said_at_its_field(page, debugger)
            a_sonar_is_degraded_and_reads_otherwise(page, debugger)
            a_field_evaporates_otherwise(page, debugger)
            an_expression_is_plotted_back_to_the_start(page)
            a_click_on_an_approach_goes_there(page, debugger)
            messages_are_listed_shut_and_sent(page, debugger)
            changes_are_listed_taken_back_and_written_out(page, debugger)
            the_run_before_is_kept_and_compared(page, debugger)
            a_gamepad_drives_the_robot(page, debugger)
            a_robot_joins_with_a_program_of_its_own(page, tmp_path)


def debugger_of(screen: Screen) -> Debugger:
    debugger = screen.run.debugger()
    assert isinstance(debugger, Debugger)
    return debugger
