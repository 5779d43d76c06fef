"""What is done in a page before a picture of it is taken, see `pictures`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tests.workbench.in_browser import wait


def go_to(page: Any, time_s: float) -> None:
    """Go to a time and wait until the page shows it."""
    page.wait_for_selector(".robot b")
    page.evaluate(f"crs.timeline.seek({time_s})")
    wait(page, f"Math.abs(crs.model.state.t - {time_s}) < 0.06 && !crs.model.state.busy")
    wait(page, "Math.abs(crs.model.scene.time - crs.model.state.t) < 1e-6")


def change(page: Any, command: str) -> None:
    """Change the run by a command."""
    before = page.evaluate("crs.model.panel.changes.length")
    page.evaluate(f"crs.console('{command}')")
    wait(page, f"crs.model.panel.changes.length > {before}")


def line_of(page: Any, text: str) -> int:
    """Return the number of the line of the shown source that has a text."""
    line = page.locator(".line", has_text=text).first
    return int(line.locator(".gutter").inner_text())


def at_a_breakpoint(page: Any) -> None:
    """Stop robot0 where it changes its state for the first time after 20 s."""
    go_to(page, 20.0)
    line = line_of(page, "state = new_state;")
    page.evaluate(f"crs.model.request('break', {{ file: crs.model.position.file, line: {line} }})")
    page.keyboard.press("F5")
    wait(page, "crs.model.state.halt.reason === 'breakpoint'")


def two_runs(page: Any) -> None:
    """Degrade a sonar in the past, and compare the run with the one before."""
    go_to(page, 40.0)
    go_to(page, 9.0)
    change(page, "degrade robot0 sonar.0 bias -80cm noise 8cm")
    wait(page, "crs.model.panel.branches.length === 2")
    go_to(page, 30.0)
    page.evaluate("crs.compare('main')")
    wait(page, "crs.compared.exact?.is_done")
    page.click("button:has-text('Plot the distance')")
    page.click(".chip:has-text('speed') .close")
    wait(page, "crs.instruments.series.of('0 apart from main').times.length > 50")


def four_views(page: Any) -> None:
    """Look at robot0 in four ways, and at what has happened."""
    go_to(page, 24.0)
    page.keyboard.press("v")
    page.click("#tab-events")


def trails(page: Any) -> None:
    """Show what ants have left on their ways, beside a map of it."""
    go_to(page, 24.0)
    wait(page, "crs.look.fields[0]?.most > 0")
    page.evaluate("crs.views.setCount(2)")
    page.evaluate("crs.views.all[1].camera.setMode('top')")


def infrared(page: Any) -> None:
    """Look at heat as colour."""
    go_to(page, 6.0)
    page.keyboard.press("i")


def at_an_error(page: Any) -> None:
    """Run into an error, with a watched expression and a line that prints."""
    page.wait_for_selector(".line")
    page.fill("input[placeholder^='watch']", "readings[0..5]")
    page.click("button:has-text('Watch')")
    page.locator(".line", has_text="found = readings[i];").locator(".gutter").click(button="right")
    page.fill(".stop-editor [name=log]", "found {found} at {i}")
    page.click(".stop-editor button[type=submit]")
    page.keyboard.press("F5")
    wait(page, "crs.model.state.halt.reason === 'error'")


def why_and_histories(page: Any) -> None:
    """Ask why the robot turns away from a wall, go to the beam of which that came, and plot it."""
    go_to(page, 4.4)
    for expression in ("mode", "steer", "State[21]"):
        page.evaluate(f"crs.plot('{expression}')")
        page.wait_for_selector(f".chips .chip b:text-is('{expression}')")
    page.click(".chip:has-text('speed') .close")
    page.evaluate("crs.why('steer')")
    page.wait_for_selector(".why-row.measured")
    wait(page, "!crs.instruments.isFilling && !crs.model.state.busy")
    page.evaluate("crs.instruments.fill(['mode', 'steer', 'State[21]'], 0, crs.model.state.end)")
    wait(page, "!crs.instruments.isFilling && !crs.model.state.busy")
    page.locator(".why-row.measured").first.click()
    wait(page, "crs.look.beam && crs.model.state.t === crs.look.beam.t")


def table_of_robots(page: Any) -> None:
    """Look at all robots and at what can be done with one; a wheel of robot1 slips."""
    go_to(page, 4.0)
    change(page, "degrade robot1 drive.left gain 0.7")
    go_to(page, 9.0)
    page.click("#drawer-table")
    page.click("#tab-robot")


def faults_and_plot(page: Any) -> None:
    """Degrade a sonar of robot0, and plot what it reads."""
    go_to(page, 9.0)
    change(page, "degrade robot0 sonar.0 bias 30cm noise 8cm")
    go_to(page, 16.0)
    for expression in ("sonar.0", "clearance"):
        page.evaluate(f"crs.plot('{expression}')")
    page.click("#tab-faults")
    page.select_option("#panel-faults select >> nth=1", "0")
    page.locator(".in-force").first.scroll_into_view_if_needed()
    wait(page, "crs.instruments.series.of(crs.instruments.name('clearance')).times.length > 50")


def messages(page: Any) -> None:
    """Block the link to one robot of a platoon, and see what becomes of messages."""
    go_to(page, 6.2)
    change(page, "shut radio to fourth")
    go_to(page, 16.0)
    page.click("#drawer-messages")
    page.click("#tab-changes")


def builder_with(name: str) -> Callable[[Any], None]:
    """Return the step that selects an element in the builder."""

    def selects(page: Any) -> None:
        wait(page, "window.crs && crs.model.document")
        page.evaluate(f"crs.model.select(['{name}'])")
        page.wait_for_selector(".properties b")

    return selects


def recorded_page(page: Any) -> None:
    """Look at an instant of a recorded run, and at what was printed."""
    page.wait_for_selector(".robot b")
    page.evaluate("crs.timeline.seek(26)")
    wait(page, "Math.abs(crs.model.scene.time - 26) < 0.06")
    page.click("#tab-output")
