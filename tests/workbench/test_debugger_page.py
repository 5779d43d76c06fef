"""The debugger in the page, in a real browser: values, stops, faults, and inside a recording."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from crs_cc.cli.view_recording import recording_screen
from crs_cc.recording.recording import Recording
from crs_cc.workbench.screen import Screen
from tests.workbench.in_browser import page_in, played, running, wait

PROGRAM = """\
#include <Nclient.h>

struct plan { int speed; int goal[2]; };
static struct plan plan = {100, {3, 4}};
static int readings[8];

static int worst(int count)
{
    int i, found = 0;
    for (i = 0; i < count; i++)
        if (readings[i] > found)
            found = readings[i];
    return found;
}

int main(void)
{
    int n;
    connect_robot(1);
    for (n = 0; n < 40; n++) {
        vm(plan.speed, 0, 0);
        readings[n % 8] = n;
        worst(plan.goal[1]);
    }
    return 0;
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="6m" width="4m"/>
  <robot id="ada" x="1m" y="1m"/>
  <robot id="bob" x="1m" y="2.500m"/>
</world>
"""


@pytest.fixture
def screen(tmp_path: Path) -> Iterator[Screen]:
    with running(tmp_path, PROGRAM, WORLD) as made:
        yield made


def value(page: Any, key: str) -> Any:
    return page.locator(f".value[data-key='{key}']")


def a_condition_is_checked_where_it_stands(page: Any) -> None:
    page.wait_for_selector(".line.current")
    page.click(".line[data-line='21'] .gutter", button="right")
    page.fill(".stop-editor [name=condition]", "n > speeed")
    page.click(".stop-editor button[type=submit]")
    page.wait_for_selector(".stop-editor .field-error:not(:empty)")
    assert "speeed" in page.locator(".stop-editor .field-error").inner_text()
    page.fill(".stop-editor [name=condition]", "n == 5")
    page.select_option(".stop-editor [name=robot]", label="bob")
    page.fill(".stop-editor [name=commands]", "print n * 2")
    page.click(".stop-editor button[type=submit]")
    page.wait_for_selector(".line.stop.asks")
    page.keyboard.press("F5")
    wait(page, "crs.model.state.halt.reason === 'breakpoint' && crs.model.position.robot === 1")
    page.wait_for_function("document.querySelector('#panel-console').textContent.includes('= 10')")


def values_unfold_are_marked_when_they_change_and_can_be_set(page: Any, screen: Screen) -> None:
    page.fill(".watch-form input", "plan.")
    page.keyboard.press("Enter")
    page.wait_for_selector(".watch-form .field-error:not(:empty)")
    page.fill(".watch-form input", "plan")
    page.keyboard.press("Enter")
    value(page, "watched/1").locator(".fold").click()
    value(page, "watched/1/goal").locator(".fold").click()
    row = value(page, "watched/1/goal/[1]")
    assert row.locator(".content").inner_text() == "4"
    row.locator(".content").dblclick()
    page.fill("input.new-value", "nonsense")
    page.keyboard.press("Enter")
    page.wait_for_selector(".value .field-error:not(:empty)")
    page.fill("input.new-value", "9")
    page.keyboard.press("Enter")
    wait(page, "!document.querySelector('input.new-value')")
    assert screen.run.debugger().view.evaluate_pure("plan.goal[1]", robot=1).text == "9"
    page.locator(".listing").focus()
    page.keyboard.press("F10")
    page.wait_for_selector(".line[data-line='22'].current")


def a_fault_is_shown_at_its_expression(page: Any) -> None:
    page.keyboard.press("F5")
    wait(page, "crs.model.state.halt.reason === 'error'")
    page.wait_for_selector(".fault >> text=index 8 is past the end of 'readings'")
    mark = page.locator(".fault-mark").bounding_box()
    row = page.locator(".line.current .gutter").bounding_box()
    assert abs(mark["y"] - row["y"]) < row["height"]
    assert page.locator(".frame[aria-pressed=true] b").inner_text() == "worst"
    page.click(".frame:nth-child(2)")
    page.wait_for_selector(".line[data-line='23'].current")
    value(page, "locals/main@1/n#1").wait_for()
    page.keyboard.press("Shift+F10")
    page.wait_for_selector(".line[data-line='11'].current:not(.outer)")
    assert page.locator(".fault").count() == 0


def the_run_stops_at_events_and_changes(page: Any) -> None:
    form = page.locator(".stop-form")
    form.locator("select").first.select_option("watch")
    form.locator("input").first.fill("readings[5]")
    form.locator("button").click()
    page.wait_for_selector(".stop-row >> text=readings[5]")
    form.locator("select").first.select_option("catch")
    form.locator("[aria-label=event]").select_option("collision")
    form.locator("button").click()
    page.wait_for_selector(".stop-row >> text=collision")
    page.locator(".listing").focus()
    page.keyboard.press("Shift+F5")
    wait(page, "crs.model.state.halt.reason === 'watchpoint'")
    page.locator(".stop-row", has_text="readings[5]").locator("button.small[title^=Remove]").click()
    wait(page, "crs.model.position.breakpoints.length === 2")


def test_programs_are_debugged_in_the_page(browser: Any, screen: Screen) -> None:
    """One test, since each step begins where the one before has led."""
    with page_in(browser, screen, 1280, 720, flat=True) as page:
        a_condition_is_checked_where_it_stands(page)
        values_unfold_are_marked_when_they_change_and_can_be_set(page, screen)
        a_fault_is_shown_at_its_expression(page)
        the_run_stops_at_events_and_changes(page)


def test_programs_follow_where_a_recording_is_scrubbed(browser: Any, recorded: Path) -> None:
    with ExitStack() as stack:
        recording = Recording(recorded)
        stack.callback(recording.close)
        screen = stack.enter_context(played(recording_screen(recording, 0, stack)))
        page = stack.enter_context(page_in(browser, screen, flat=True))
        page.wait_for_selector(".line.current")
        end = page.evaluate("crs.timeline.end")
        box = page.locator(".track").bounding_box()
        page.mouse.move(box["x"] + box["width"] * 1.0 / end, box["y"] + 30)
        page.mouse.down()
        page.mouse.move(box["x"] + box["width"] * 3.0 / end, box["y"] + 30, steps=4)
        page.mouse.up()
        wait(page, "crs.model.state.t > 2.5 && crs.model.position.t === crs.model.state.t")
        text = page.locator(".line.current").inner_text()
        assert "usleep" in text
        before = screen.run.time_s
        page.keyboard.press("Shift+F11")
        page.keyboard.press("Shift+F11")
        wait(page, "document.querySelector('.line.current').textContent.includes('printf')")
        assert screen.run.time_s < before
        assert page.evaluate("crs.model.state.end") == pytest.approx(recording.end_ns / 1e9)
