"""Questions of pages about the past: what is answered, and that the run stays where it is."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from crs_cc.cli.view_recording import recording_screen
from crs_cc.recording.recording import Recording
from crs_cc.workbench.screen import Screen
from tests.workbench.in_browser import played, running
from tests.workbench.test_screen import Page, page_of

PROGRAM = """\
#include <Nclient.h>

enum mode { WAITING, DRIVING };
static enum mode mode;
static int speed;

static int limited(int wanted)
{
    int most = 90;
    return wanted > most ? most : wanted;
}

int main(void)
{
    int n;
    connect_robot(1);
    for (n = 0; n < 300; n++) {
        get_sn();
        mode = n % 8 < 4 ? WAITING : DRIVING;
        speed = limited(State[17] / 2 + n);
        vm(speed, speed, 0);
    }
    return 0;
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="6m" width="4m"/>
  <box id="crate" x="4m" y="1m" length="400mm" width="1m"/>
  <robot id="ada" x="1m" y="1m" heading="0deg"/>
</world>
"""


@pytest.fixture(scope="module")
def screen(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Screen]:
    with running(tmp_path_factory.mktemp("asked"), PROGRAM, WORLD) as made:
        yield made


@pytest.fixture
def page(screen: Screen) -> Iterator[Page]:
    with page_of(screen) as made:
        made.ask("seek", time_s=2.0)
        made.take_until(lambda: abs(made.told.get("position", {}).get("t", 0.0) - 2.0) < 0.06)
        yield made


def value(page: Page, name: str, **fields: Any) -> Any:
    answer = page.ask(name, **fields)
    assert "value" in answer, answer
    return answer["value"]


def test_a_why_tree_leads_to_the_beam_and_each_node_to_its_time(page: Page, screen: Screen) -> None:
    here = page.told["position"]["place"]
    tree = value(page, "why", expression="speed")
    assert tree["expression"] == "speed"
    assert tree["line"] == 20
    assert "speed = limited(" in tree["how"]
    returned = tree["causes"][0]
    assert returned["text"] == "limited returned"
    below, beams = [tree], []
    while below:
        node = below.pop()
        below += node["causes"]
        beams += [node] if node["beam"] else []
    assert beams[0]["beam"]["met"] == "crate"
    assert beams[0]["beam"]["sonar"] == 0
    assert 0.0 < beams[0]["t"] <= 2.0
    page.ask("go", place=returned["place"], robot=returned["robot"])
    page.take_until(lambda: page.told["position"]["place"] == returned["place"])
    assert page.told["position"]["line"] == 10
    page.ask("go", place=here, robot=0)
    page.take_until(lambda: page.told["position"]["place"] == here)


def test_a_history_has_each_change_with_its_text_and_position(page: Page) -> None:
    found = value(page, "changes", robot=0, expression="mode", begin_s=0.0, end_s=2.0)
    texts = [text for _, _, text, _, _ in found["rows"]]
    assert texts[:3] == ["WAITING", "DRIVING", "WAITING"]
    time_s, number, _, place, _ = found["rows"][1]
    assert number == 1
    page.ask("go", place=place, robot=0)
    page.take_until(lambda: page.told["position"]["place"] == place)
    assert page.told["position"]["line"] == 19
    assert page.told["state"]["t"] <= time_s


def test_a_local_variable_has_its_history_at_a_line(page: Page) -> None:
    asked = {"robot": 0, "begin_s": 0.0, "end_s": 2.0}
    found = value(page, "changes", expression="wanted at go.c:10", **asked)
    assert found["is_at"]
    assert len(found["rows"]) > 5
    assert all(number is not None for _, number, *_ in found["rows"])
    assert "undeclared" in page.error("changes", expression="wnted at go.c:10", **asked)


def test_times_are_found_up_to_the_latest_known_one(page: Page) -> None:
    page.ask("seek", time_s=0.5)
    driving = value(page, "when", condition="mode == DRIVING")
    assert len(driving) >= 2
    assert driving[-1][0] > 0.5
    assert driving[0][2] == "mode == DRIVING"
    said = value(
        page, "log_messages", file=page.told["position"]["file"], line=21, text="speed {speed}"
    )
    assert said[0][2].startswith("speed ")
    added = value(page, "break", file=page.told["position"]["file"], line=20)["added"]
    assert len(value(page, "hits", number=added)) in {len(said), len(said) + 1}
    page.ask("break", file=page.told["position"]["file"], line=20)


@pytest.mark.parametrize(
    ("place", "wrong"),
    [
        ("1.2.3", "is not a position"),
        ("999999.0.-1.0", "has not reached"),
        ("1.0.7.1", "has not reached"),
    ],
)
def test_a_position_that_the_run_has_not_reached_is_rejected(
    page: Page, place: str, wrong: str
) -> None:
    assert wrong in page.error("go", place=place, robot=0)


def test_a_read_only_page_cannot_query(screen: Screen) -> None:
    with page_of(screen, "view") as page:
        assert "view-only" in page.error("why", expression="speed")


def test_in_a_recording_the_past_is_the_whole_recording(recorded: Path) -> None:
    with ExitStack() as stack:
        recording = Recording(recorded)
        stack.callback(recording.close)
        made = stack.enter_context(played(recording_screen(recording, 0, stack)))
        page = stack.enter_context(page_of(made))
        page.ask("seek", time_s=1.0)
        found = value(page, "when", condition="State[17] > 0")
        assert found[0][0] > 0.0
        page.take_until(lambda: abs(page.told["state"]["t"] - 1.0) < 0.06)


def test_a_query_does_not_change_the_selected_robot(tmp_path: Path) -> None:
    two = WORLD.replace("</world>", '<robot id="bob" x="1m" y="3m" heading="0deg"/></world>')
    with running(tmp_path, PROGRAM, two) as screen, page_of(screen) as page:
        value(page, "console", line="break limited if speed > 40")
        value(page, "console", line="continue")
        page.take_until(lambda: page.told["state"]["halt"]["reason"] == "breakpoint")
        stopped = page.told["state"]["robot"]
        value(page, "select", robot=1 - stopped)
        value(page, "why", expression="speed")
        page.ask("traffic", since=0)
        page.take_until(lambda: page.told["state"]["busy"] is False)
        assert page.told["state"]["robot"] == screen.robot == 1 - stopped
        value(page, "console", line="next")
        page.take_until(lambda: page.told["state"]["halt"]["reason"] != "breakpoint")
        assert screen.robot == 1 - stopped
