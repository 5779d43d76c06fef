"""Take pictures of the workbench for docs: `python -m tests.workbench.pictures [NAME...]`.

A picture is a row in `PICTURES`: what is done in the page before it is taken. Look at each picture
before it is committed.
"""

from __future__ import annotations

import argparse
import shutil
from pathlib import Path
from typing import Any, Final

from playwright.sync_api import sync_playwright

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.start_view import screen_of
from tests.workbench.in_browser import FLAGS, page_in, played, wait

ROOT: Final = Path(__file__).parents[2]
IMAGES: Final = ROOT / "docs" / "images"
PROGRAM: Final = ROOT / "samples" / "scout_c" / "wander.c"
WORLD: Final = ROOT / "worlds" / "complex-3r.xml"


def at_a_breakpoint(page: Any) -> None:
    """Stop robot0 where it changes its state for the first time after 20 s."""
    go_to(page, 20.0)
    line = PROGRAM.read_text().splitlines().index("    state = new_state;") + 1
    page.evaluate(f"crs.model.ask('break', {{ file: crs.model.where.file, line: {line} }})")
    page.keyboard.press("F5")
    wait(page, "crs.model.state.halt.reason === 'breakpoint'")


def compared(page: Any) -> None:
    """Degrade a sonar in the past, and compare the run with the one before."""
    go_to(page, 20.0)
    go_to(page, 9.0)
    page.click("#tab-console")
    page.fill(".prompt input", "degrade robot0 sonar.0 bias 30cm noise 8cm")
    page.press(".prompt input", "Enter")
    wait(page, "crs.model.panel.branches.length === 2")
    go_to(page, 16.0)
    page.click("#tab-changes")
    page.click("button:has-text('Compare')")
    page.wait_for_selector(".differences tr")


PICTURES: Final = {"workbench": at_a_breakpoint, "workbench-runs": compared}


def go_to(page: Any, time_s: float) -> None:
    """Go to a time and wait until the page shows it."""
    page.evaluate(f"crs.timeline.seek({time_s})")
    wait(page, f"Math.abs(crs.model.state.t - {time_s}) < 0.06 && !crs.model.state.busy")
    wait(page, "Math.abs(crs.model.scene.time - crs.model.state.t) < 1e-6")


def main() -> None:
    """Take the named pictures, or all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", default=list(PICTURES))
    parser.add_argument("--into", type=Path, default=IMAGES)
    options = parser.parse_args()
    with sync_playwright() as started:
        browser = started.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        for name in options.names:
            run = DebugOptions(inputs=Inputs((PROGRAM,), WORLD), quiet=True)
            with (
                played(screen_of(run, 0)) as screen,
                page_in(browser, screen, 1280, 760) as page,
            ):
                page.wait_for_selector(".robot b")
                PICTURES[name](page)
                page.wait_for_timeout(3000)  # smooth edges, and no note any more
                page.screenshot(path=options.into / f"{name}.png")
        browser.close()


if __name__ == "__main__":
    main()
