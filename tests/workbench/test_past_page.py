"""Questions about the past in the page: why-trees, histories, instants that are found."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tests.workbench.in_browser import page_in, running, wait
from tests.workbench.test_questions import PROGRAM, WORLD

MODE = "crs.instruments.series.of('0 mode')"


def a_variable_is_explained_by_a_tree(page: Any) -> None:
    page.wait_for_selector(".line.current")
    page.evaluate("crs.timeline.seek(1)")
    wait(page, "crs.model.position?.t > 0.9 && !crs.model.state.busy")
    page.locator(".value[data-key='globals'] .fold").click()
    row = page.locator(".value[data-key='globals/speed#1']")
    row.hover()
    row.locator("button:has-text('why')").click()
    page.wait_for_selector(".why-row:has-text('limited returned')")
    first = page.locator(".why-row").first
    assert "speed = limited(State[17] / 2 + n)" in first.inner_text()
    page.locator(".why-row.measured:has-text('crate')").click()
    wait(page, "crs.look.beam?.met === 'crate' && crs.model.state.t === crs.look.beam.t")
    page.wait_for_selector(".why-row.measured[aria-current]")


def the_keyboard_walks_the_tree(page: Any) -> None:
    first = page.locator(".why-row").first
    page.locator(".why-row.measured").focus()
    page.keyboard.press("Home")
    count = page.locator(".why-row").count()
    page.keyboard.press("ArrowLeft")
    wait(page, "document.querySelectorAll('.why-row').length === 1")
    page.keyboard.press("ArrowRight")
    wait(page, f"document.querySelectorAll('.why-row').length === {count}")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    wait(page, "crs.model.position.line === 10")
    page.wait_for_selector(".line[data-line='10'].current")
    assert "limited returned" in page.locator(".why-row[aria-current]").first.inner_text()
    assert first.get_attribute("tabindex") == "-1"
    assert page.evaluate("document.activeElement.textContent").strip().startswith("▾")


def a_local_variable_is_plotted_at_its_line(page: Any) -> None:
    row = page.locator(".value[data-key='locals/limited@2/wanted#1']")
    row.locator(".content").focus()
    page.keyboard.press("g")
    page.wait_for_selector(".chip:has-text('wanted at ')")
    wait(
        page,
        "[...crs.instruments.series.byName].some(([n, s]) => / at /.test(n) && s.times.length > 9)",
    )


def words_are_plotted_and_a_click_goes_to_their_change(page: Any) -> None:
    page.fill("#panel-plot input", "mode")
    page.press("#panel-plot input", "Enter")
    page.wait_for_selector(".chip b:text-is('mode')")
    wait(page, f"{MODE}.places.filter(Boolean).length > 3")
    assert page.evaluate(f"{MODE}.isStep && {MODE}.texts.includes('DRIVING')")
    time_s, place = page.evaluate(f"[{MODE}.times[2], {MODE}.places[2]]")
    box = page.locator(".plot canvas").bounding_box()
    track = page.locator(".track").bounding_box()
    assert abs(track["x"] - box["x"] - 62) < 1  # one axis for both
    share = page.evaluate(f"{time_s} / crs.timeline.shownPart[1]")
    page.mouse.click(track["x"] + share * track["width"], box["y"] + box["height"] - 14)
    wait(page, f"crs.model.position.place === '{place}'")
    assert page.evaluate("crs.model.position.line") == 19
    page.evaluate("crs.timeline.zoom(0.5, 0.5)")
    page.wait_for_selector("button:has-text('Whole run'):visible")
    page.click("button:has-text('Whole run')")
    page.click(".chip:has-text('mode') .close")
    page.wait_for_selector(".chip:has-text('mode')", state="detached")


def instants_are_found_and_stepped_through(page: Any) -> None:
    page.click("#tab-events")
    page.fill(".finder input", "mode == DRVING")
    page.press(".finder input", "Enter")
    page.wait_for_selector(".finder .field-error:has-text('DRVING')")
    page.fill(".finder input", "mode == DRIVING")
    page.press(".finder input", "Enter")
    page.wait_for_selector(".event:has-text('mode == DRIVING')")
    page.locator(".event:has-text('mode == DRIVING')").last.click()
    rows = page.evaluate("crs.model.found.rows")
    wait(page, f"crs.model.position.place === '{rows[0][3]}'")
    page.locator(".finder input").blur()
    page.keyboard.press("n")
    wait(page, f"crs.model.position.place === '{rows[1][3]}'")
    page.keyboard.press("p")
    wait(page, f"crs.model.position.place === '{rows[0][3]}'")
    page.click(".finder button:has-text('Clear')")
    wait(page, "crs.model.found.rows.length === 0")
    page.click("#tab-code")


def what_a_line_would_have_printed_is_listed(page: Any) -> None:
    page.click("#tab-code")
    page.click(".line[data-line='21'] .gutter", button="right")
    page.fill(".stop-editor [name=log]", "speed is {speed}")
    page.click(".stop-editor button:has-text('Print the past')")
    page.wait_for_selector(".event:has-text('speed is ')")


def a_name_in_the_source_shows_its_value_and_is_plotted(page: Any) -> None:
    page.locator(".line[data-line='4'] code").dblclick(position={"x": 145, "y": 9})
    page.wait_for_selector(".name-menu code:text-matches('^mode = ')")
    page.click(".name-menu button:has-text('plot')")
    page.wait_for_selector(".chip b:text-is('mode')")
    page.wait_for_selector(".name-menu", state="detached")


def numbers_of_lists_in_the_console_are_links(page: Any) -> None:
    page.click("#tab-console")
    page.evaluate("crs.console('history mode 0..0.5')")
    page.evaluate(
        "crs.console('when mode == WAITING')"
    )  # another list: the first one's numbers stay
    link = page.locator(".log button:text-is('@2')").first
    link.click()
    wait(page, "crs.model.position.line === 19 && crs.model.position.t < 0.5")


def test_the_page_queries_the_past(browser: Any, tmp_path: Path) -> None:
    """One test, since each step begins where the one before has led."""
    with (
        running(tmp_path, PROGRAM, WORLD) as screen,
        page_in(browser, screen, 1280, 760, flat=True) as page,
    ):
        a_variable_is_explained_by_a_tree(page)
        the_keyboard_walks_the_tree(page)
        a_local_variable_is_plotted_at_its_line(page)
        words_are_plotted_and_a_click_goes_to_their_change(page)
        instants_are_found_and_stepped_through(page)
        a_name_in_the_source_shows_its_value_and_is_plotted(page)
        numbers_of_lists_in_the_console_are_links(page)
        what_a_line_would_have_printed_is_listed(page)
