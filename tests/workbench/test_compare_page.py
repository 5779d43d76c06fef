"""Two runs side by side in a real browser: ghosts, paths, the first difference, the distance."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from crs_cc.cli.main import main
from crs_cc.cli.recording_plot import world_of
from crs_cc.cli.start_view import open_others
from crs_cc.cli.view_recording import recording_screen
from crs_cc.recording.recording import Recording
from crs_cc.workbench.page import html_page
from crs_cc.workbench.page_comparison import OtherRecording
from crs_cc.workbench.screen import Screen
from tests.recording.test_compare import PROGRAM
from tests.workbench.in_browser import new_page, page_at, page_in, played, wait
from tests.workbench.test_page import run_in

WORLD = """<world version="1" timestep="50ms">
  <area length="9m" width="6m"/><robot id="ada" x="2m" y="2m"/><robot id="bob" x="2m" y="4m"/>
</world>
"""
FIRST = "First difference from far.mcap: 0.000 s ada limit is 40 here, 80 there (difference 40)."


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("compared")
    (folder / "drive.c").write_text(PROGRAM)
    (folder / "world.xml").write_text(WORLD)
    for name, limit in (("near", 40), ("far", 80)):
        words = [f"{folder / 'drive.c'}", f"{folder / 'world.xml'}", "-D", f"LIMIT={limit}"]
        target = str(folder / f"{name}.mcap")
        assert main(["run", "-q", *words, "--max-time", "4", "--record", target]) == 0
    return folder


@pytest.fixture
def screen(runs: Path) -> Iterator[Screen]:
    with ExitStack() as stack:
        recording = Recording(runs / "near.mcap")
        stack.callback(recording.close)
        made = recording_screen(recording, 0, stack)
        open_others(made, [runs / "far.mcap"])
        yield stack.enter_context(played(made))


def a_recording_is_chosen_and_the_first_difference_is_named(page: Any) -> None:
    page.click("#drawer-compare")
    page.select_option("#panel-compare select", "far.mcap")
    wait(page, "crs.compared.exact?.is_done")
    first = page.locator(".differences .first").inner_text()
    assert first == FIRST
    rows = [each.inner_text() for each in page.locator(".differences tbody td:nth-child(2)").all()]
    assert rows[:2] == ["ada limit", "bob limit"]
    assert {"ada pose.x", "bob pose.x"} <= set(rows)


def a_click_goes_to_the_instant_where_the_ghost_parts(page: Any) -> None:
    row = page.locator(".differences tr:has-text('ada pose.x')")
    at = float(row.locator(".when").inner_text().removesuffix(" s"))
    row.locator(".when").click()
    wait(page, f"Math.abs(crs.model.state.t - {at}) < 0.051")
    assert page.evaluate("crs.model.differs.length") == 1
    assert page.evaluate("crs.model.happenings.at(-1)[1]") == "differs"
    page.evaluate("crs.timeline.seek(3.5)")
    wait(page, "Math.abs(crs.look.other.scene.time - 3.5) < 1e-6")
    ways = page.evaluate(
        "crs.look.other.scene.bodies.map((each, at) => each.x - crs.model.scene.bodies[at].x)"
    )
    assert all(way > 0.08 for way in ways)


def the_distance_is_plotted_under_the_time_line(page: Any) -> None:
    page.click("button:has-text('Plot the distance')")
    page.wait_for_selector(".chip b:text-is('apart from far.mcap')")
    series = "crs.instruments.series.of('0 apart from far.mcap')"
    wait(page, f"{series}.times.at(-1) > 3.9")
    assert page.evaluate(f"{series}.values[0]") == 0
    assert page.evaluate(f"Math.max(...{series}.values)") > 0.08
    page.mouse.move(0, 0)
    wait(page, "/0.09\\d+ m/.test(document.querySelector('.chips .chip:last-child').innerText)")


def an_end_removes_it(page: Any) -> None:
    page.click("#panel-compare button:has-text('End')")
    wait(page, "!crs.look.other && !crs.model.differs.length")
    assert page.locator(".differences .hint").inner_text().startswith("Compare this run with")


def a_file_is_dropped_on_the_page(page: Any, content: bytes) -> None:
    page.evaluate(
        """(bytes) => {
            const files = new DataTransfer();
            files.items.add(new File([new Uint8Array(bytes)], "dropped.mcap"));
            dispatchEvent(new DragEvent("drop", { dataTransfer: files, cancelable: true }));
        }""",
        list(content),
    )
    wait(page, "crs.compared.run?.name === 'dropped.mcap' && crs.compared.exact?.is_done")
    assert page.input_value("#panel-compare select") == "dropped.mcap"
    page.click("#panel-compare button:has-text('Close the file')")
    wait(page, "!crs.compared.run && crs.model.others.length === 1")


def a_page_that_looks_only_compares_too(page: Any) -> None:
    page.click("#drawer-compare")
    page.select_option("#panel-compare select", "far.mcap")
    page.wait_for_selector(".differences tr:has-text('ada pose.x')")
    assert not page.locator("button:has-text('Open a recording')").count()
    assert not page.locator("button:has-text('Find the first variable')").is_visible()


def test_two_recordings_are_shown_side_by_side(browser: Any, screen: Screen, runs: Path) -> None:
    with page_in(browser, screen, 1200, 800) as page:
        wait(page, "crs.model.others.length === 1")
        a_recording_is_chosen_and_the_first_difference_is_named(page)
        a_click_goes_to_the_instant_where_the_ghost_parts(page)
        the_distance_is_plotted_under_the_time_line(page)
        an_end_removes_it(page)
        a_file_is_dropped_on_the_page(page, (runs / "far.mcap").read_bytes())
    address = screen.server.address("view")
    looks = new_page(browser)
    looks.goto(address + "&flat=1")
    a_page_that_looks_only_compares_too(looks)
    looks.close()


@pytest.fixture(scope="module")
def held(runs: Path) -> Path:
    """A page that holds two runs."""
    path = runs / "two.html"
    words = [str(runs / "near.mcap"), "--compare", str(runs / "far.mcap"), "--html", str(path)]
    assert main(["replay", *words]) == 125, "they differ"
    return path


def test_a_page_contains_the_data_of_both_runs(held: Path) -> None:
    other = run_in(held.read_text())["other"]
    assert (other["name"], other["end"], other["until"]) == ("far.mcap", 4.0, 4.0)
    assert [
        (each["robot"], each["what"], each["is_variable"]) for each in other["exact"]["found"]
    ] == [
        ("ada", "limit", True),
        ("bob", "limit", True),
    ]
    assert {each["what"] for each in other["differences"]} == {"pose.x"}
    assert set(other["paths"]) == set(other["own"]) == set(other["apart"]) == {"ada", "bob"}
    distances = other["apart"]["ada"]
    assert distances[0] == [0.0, 0.0]
    assert distances[-1][1] == pytest.approx(0.0994, abs=1e-4)


def test_two_runs_share_the_size_of_a_page(runs: Path) -> None:
    with ExitStack() as stack:
        near, far = (Recording(runs / f"{name}.mcap") for name in ("near", "far"))
        for each in (near, far):
            stack.callback(each.close)
        text = html_page(near, world_of(near), most_bytes=1500, other=OtherRecording(far))
    run = run_in(text)
    assert re.search(
        r"left out: all but 1 in \d+ frames, all but 1 in \d+ frames of far", run["note"]
    )
    size = sum(len(block) for each in (run, run["other"]) for *_, block in each["blocks"])
    assert size <= 1500
    assert run["other"]["frame_s"] > 0.05


def test_a_page_of_runs_without_a_common_robot_is_rejected(
    runs: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (runs / "eve.xml").write_text(WORLD.replace("ada", "eve").replace("bob", "joe"))
    words = [str(runs / "drive.c"), str(runs / "eve.xml"), "-D", "LIMIT=40", "--max-time", "1"]
    assert main(["run", "-q", *words, "--record", str(runs / "eve.mcap")]) == 0
    target = runs / "none.html"
    words = [str(runs / "near.mcap"), "--compare", str(runs / "eve.mcap"), "--html", str(target)]
    assert main(["replay", *words]) not in {0, 125}
    assert "no robot of the same name" in capfd.readouterr().err
    assert not target.exists()


def test_two_runs_are_shown_in_one_file(browser: Any, held: Path) -> None:
    with page_at(browser, held.as_uri(), 1200, 800) as page:
        wait(page, "crs.compared.run?.name === 'far.mcap'")
        first = page.locator(".differences .first").inner_text()
        assert first == FIRST
        a_click_goes_to_the_instant_where_the_ghost_parts(page)
        assert page.locator("canvas.apart").is_visible()
        box = page.locator("canvas.apart").bounding_box()
        page.mouse.click(box["x"] + box["width"] / 2, box["y"] + 20)
        wait(page, "Math.abs(crs.model.state.t - 2) < 0.2")
        for name in ("Open a recording", "Find the first variable", "Plot the distance"):
            assert not page.locator(f"#panel-compare button:has-text('{name}')").is_visible()
        page.click("#panel-compare button:has-text('End')")
        wait(page, "!crs.look.other")
        page.select_option("#panel-compare select", "far.mcap")
        wait(page, "crs.compared.run && crs.compared.firstVariable")
