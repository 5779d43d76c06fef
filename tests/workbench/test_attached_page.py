"""The control panel of a live run, in a real browser."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from tests.cli.test_serve import WORLD, join, served
from tests.session.programs import ROAM
from tests.workbench.in_browser import is_fault, new_page, wait
from tests.workbench.test_panel_page import click


def opened(browser: Any, address: str, wrong: list[str]) -> Any:
    page = new_page(browser, 1200, 800)
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda line: wrong.extend([line.text] if is_fault(line) else []))
    page.set_default_timeout(60_000)  # the machine may be busy with other tests
    page.goto(address + "&flat=1")
    wait(page, "crs.model.state.t > 0.2")
    return page


def test_a_served_run_is_changed_in_the_page(browser: Any, tmp_path: Path) -> None:
    tmp_path.joinpath("world.xml").write_text(WORLD)
    tmp_path.joinpath("roam.c").write_text(ROAM)
    wrong: list[str] = []
    with served(tmp_path, "--speed", "1") as environment:
        host = join(tmp_path, "--all", environment.address, "roam.c")
        looks = environment.wait_for(r"view only: (\S+)\n")[1]
        steers = re.search(r"open (\S+)\n", environment.text)
        assert steers
        page = opened(browser, steers[1], wrong)
        tabs = page.locator("[role=tab]").all_inner_texts()
        assert tabs == ["Robot", "Faults", "Output", "Events", "Changes"]
        page.keyboard.press(" ")
        wait(page, "!crs.model.state.playing")
        click(page, "battery", "#panel-robot")
        page.wait_for_selector(".plot .chip:has-text('battery') >> text=%")
        click(page, "Move", ".actions")
        for at, value in enumerate(("3", "1", "0")):
            page.locator(".action-form input").nth(at).fill(value)
        click(page, "Move", ".action-form")
        wait(page, "Math.abs((crs.model.scene.body(0)?.x ?? 0) - 3) < 1e-3")
        assert not page.locator(".actions button:has-text('Add a robot')").count()
        page.click("#tab-faults")
        page.locator("#panel-faults .laws input").first.fill("0.5m")
        click(page, "Degrade", "#panel-faults")
        page.wait_for_selector("#panel-faults h3:has-text('In force (1)')")
        page.keyboard.press("y")
        click(page, "Block links", ".messages")
        page.locator(".link-forms button:text-is('Block')").click()
        page.wait_for_selector(".outages:has-text('all from')")
        page.click("#tab-changes")
        page.wait_for_selector(".change:nth-child(3)")
        done = page.locator(".change code").all_inner_texts()
        assert done == ["shut all", "degrade left sonar bias 0.5m", "move left to 3 1 0"]
        assert not page.locator("button:has-text('Undo')").count()
        looking = opened(browser, looks, wrong)
        looking.click("#tab-faults")
        looking.wait_for_selector("#panel-faults h3:has-text('In force (1)')")
        assert not looking.locator("#panel-faults form").is_visible()
        for each in (page, looking):
            each.close()
        environment.process.kill()
        host.kill()
        host.communicate()
    assert not wrong
