"""Measure the world builder: a large world is changed, and dragged in a page in a browser.

Of the server it is the time of a change of one object and of all, until the message for the pages
is there. Of the page, in a browser without a graphics card, it is the time of the main thread in
each frame while one object or all are dragged, or the view is: the median and the longest; and
the time from the end of a drag until the page shows the changed world.

    python bench/builder.py [--frames N] [OBJECTS ROBOTS]

`--no-browser` leaves the page out.
"""

from __future__ import annotations

import argparse
import shutil
import statistics
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from crs_cc.cli.start_build import building
from crs_cc.workbench.build_screen import BuildScreen

COLUMNS = 50

FRAMES = """([count, x, y]) => new Promise((done) => {
    const { view, tools } = crs;
    const [move, paint] = [tools.move.bind(tools), view.paint.bind(view)];
    let busy = 0;
    const timed = (act) => (...given) => {
        const start = performance.now();
        act(...given);
        busy += performance.now() - start;
    };
    [tools.move, view.paint] = [timed(move), timed(paint)];
    const frames = [];
    const next = (left_over) => {
        frames.push(busy);
        busy = 0;
        if (!left_over) {
            [tools.move, view.paint] = [move, paint];
            return done(frames.slice(1));
        }
        const place = { clientX: x + 20 + (left_over % 40), clientY: y + 20 };
        view.canvas.dispatchEvent(new PointerEvent("pointermove", place));
        requestAnimationFrame(() => next(left_over - 1));
    };
    requestAnimationFrame(() => next(count));
})"""


@contextmanager
def edited(objects: int, robots: int) -> Iterator[BuildScreen]:
    """Serve a world of boxes and robots in rows."""
    rows = -(-(objects + robots) // COLUMNS) + 1
    boxes = [
        f'  <box id="box{number}" x="{1 + number % COLUMNS}m" y="{1 + number // COLUMNS}m"'
        f' length="40cm" width="30cm"/>\n'
        for number in range(objects)
    ]
    starts = [
        f'  <robot id="robot{number - objects}" x="{1 + number % COLUMNS}m"'
        f' y="{1 + number // COLUMNS}m"/>\n'
        for number in range(objects, objects + robots)
    ]
    area = f'  <area length="{COLUMNS + 1}m" width="{rows + 1}m"/>\n'
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "large.xml"
        path.write_text(f'<world version="1">\n{area}{"".join(boxes + starts)}</world>\n')
        with building(path, None, 0) as screen:
            yield screen


def change_ms(screen: BuildScreen, names: list[str]) -> float:
    """Return the median time to move elements and to tell pages of it [ms]."""
    took = []
    for step in (0.01, -0.01, 0.01):
        before_s = time.perf_counter()
        screen.builder.move(names, x=step)
        screen._document()
        took.append(1000 * (time.perf_counter() - before_s))
        screen.builder.undo()
    return statistics.median(took)


def drag(page: Any, button: str, frames: int) -> str:
    """Return the median and the longest time of a frame of a drag, and the time of its end [ms]."""
    x, y = page.evaluate("""() => {
        const [name] = crs.model.selection;
        const [shape] = crs.model.shapes(name);
        const [px, py] = crs.view.toScreen(shape.points[0].map((at) => at - 0.1));
        const { left, top } = crs.view.canvas.getBoundingClientRect();
        return [px + left, py + top];
    }""")
    page.mouse.move(x, y)
    page.mouse.down(button=button)
    took = page.evaluate(FRAMES, [frames, x, y])
    steps = page.evaluate("crs.model.document.steps")
    before_s = time.perf_counter()
    page.mouse.up(button=button)
    if button == "left":
        page.wait_for_function(f"() => crs.model.document.steps > {steps}", polling=20)
        page.evaluate("() => new Promise(requestAnimationFrame)")
    end_ms = 1000 * (time.perf_counter() - before_s)
    return f"{statistics.median(took):>8.1f} {max(took):>8.1f} {end_ms:>8.0f}"


def measure_page(screen: BuildScreen, frames: int) -> None:
    """Print the figures of a page."""
    from playwright.sync_api import sync_playwright

    flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    with sync_playwright() as started:
        browser = started.chromium.launch(executable_path=shutil.which("chromium"), args=flags)
        page = browser.new_page(viewport={"width": 1280, "height": 720})
        page.goto(screen.server.address())
        page.wait_for_function("() => window.crs && crs.model.document")
        page.evaluate("() => new Promise((done) => setTimeout(done, 500))")
        print(f"\n{'page, ms':16} {'median':>8} {'longest':>8} {'end':>8}")
        page.evaluate("() => crs.model.select(['box0'])")
        print(f"{'drag of one':16} {drag(page, 'left', frames)}")
        page.evaluate("() => crs.view.canvas.focus()")
        page.keyboard.press("Control+a")
        print(f"{'drag of all':16} {drag(page, 'left', frames)}")
        print(f"{'drag of the view':16} {drag(page, 'right', frames)}")
        browser.close()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("objects", type=int, nargs="?", default=2000)
    parser.add_argument("robots", type=int, nargs="?", default=200)
    parser.add_argument("--no-browser", action="store_true")
    parser.add_argument("--frames", type=int, default=60)
    options = parser.parse_args()
    with edited(options.objects, options.robots) as screen:
        print(f"{options.objects} objects, {options.robots} robots")
        names = [name for name in screen.builder.names() if name != "area"]
        screen._document()
        print(f"server, one changed: {change_ms(screen, names[:1]):.0f} ms")
        print(f"server, all changed: {change_ms(screen, names):.0f} ms")
        if not options.no_browser and shutil.which("chromium") is not None:
            measure_page(screen, options.frames)


if __name__ == "__main__":
    main()
