"""Debug in VS Code's own shell: `python -m tests.vscode_shell ADDRESS FOLDER [PICTURE]`.

ADDRESS is that of VS Code in a browser on this machine (code-server, `code serve-web`) with the
extension of `editors/vscode` installed and its setting `crs.command` made; FOLDER is an empty one
that it can open. Sets a breakpoint, runs to it, steps back in all ways, and has the window with the
workbench follow. Not among the tests: VS Code is heavy, and is installed by hand.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
from pathlib import Path
from typing import Any, Final

from playwright.sync_api import sync_playwright

from docs.generate.editors import launch
from tests.workbench.in_browser import FLAGS

ROOT: Final = Path(__file__).parents[1]
PROGRAM: Final = """\
#include <Nclient.h>

int turns;

static int twice(int what)
{
    int result = what;
    result += what;
    return result;
}

int main(void)
{
    connect_robot(1);
    for (int i = 0; i < 400; i++) {
        turns = twice(i);
        vm(100, 100, 0);
    }
    return 0;
}
"""
INSIDE: Final = PROGRAM.splitlines().index("    result += what;") + 1
CALL: Final = PROGRAM.splitlines().index("        turns = twice(i);") + 1
PATIENCE_MS: Final = 60_000
CURRENT: Final = """() => {
    const lines = [...document.querySelectorAll(".debug-call-stack .stack-frame")];
    return lines.length ? lines.map((each) => each.innerText.match(/(\\d+):\\d+/)?.[1]) : null;
}"""


def prepare(folder: Path) -> None:
    """Put a program, a world and a configuration into the folder."""
    (folder / "worlds").mkdir(exist_ok=True)
    (folder / ".vscode").mkdir(exist_ok=True)
    (folder / "twice.c").write_text(PROGRAM)
    shutil.copy(ROOT / "worlds" / "room.xml", folder / "worlds")
    (folder / ".vscode" / "launch.json").write_text(launch())


class Shell:
    """VS Code in a page."""

    def __init__(self, page: Any) -> None:
        self.page = page

    def open(self) -> None:
        """Open the program."""
        row = self.page.locator(".explorer-folders-view .monaco-list-row", has_text="twice.c")
        row.first.dblclick()
        self.page.wait_for_selector(".view-line")

    def set_breakpoint(self, line: int) -> None:
        """Click left of a line number, unless VS Code has kept one from the last time."""
        self.page.wait_for_timeout(2000)
        if self.page.locator(".glyph-margin-widgets .codicon-debug-breakpoint").count():
            return
        number = self.page.locator(".margin-view-overlays .line-numbers")
        box = number.filter(has_text=re.compile(rf"^{line}$")).first.bounding_box()
        self.page.mouse.click(box["x"] - 8, box["y"] + box["height"] / 2)
        self.page.wait_for_selector(".codicon-debug-breakpoint")

    def press(self, title: str) -> None:
        """Press a button of the debugger's tool bar."""
        self.page.locator(f".debug-toolbar [aria-label^='{title}']").first.click()

    def stands_at(self, *lines: int) -> None:
        """Wait until the call stack has these lines."""
        wanted = json.dumps([str(each) for each in lines])
        self.page.wait_for_function(f"JSON.stringify(({CURRENT})()) === '{wanted}'".replace(
            ', "', ',"'), timeout=PATIENCE_MS)  # fmt: skip
        print("stands at", *lines)

    def command(self, text: str) -> None:
        """Execute a command of the palette."""
        self.page.keyboard.press("F1")
        self.page.locator(".quick-input-widget input").first.wait_for()
        self.page.keyboard.type(text, delay=20)
        self.page.locator(".quick-input-list .monaco-list-row", has_text=text).first.click()

    def workbench(self) -> Any:
        """Return the frame with the workbench."""
        for _ in range(120):
            for frame in self.page.frames:
                if "#token=" in frame.url:
                    return frame
            self.page.wait_for_timeout(500)
        raise AssertionError("no window with the workbench")


def session(page: Any) -> None:
    """Go through a session."""
    shell = Shell(page)
    shell.open()
    shell.set_breakpoint(INSIDE)
    page.keyboard.press("F5")
    page.wait_for_selector(".debug-toolbar")
    shell.stands_at(CALL - 2)
    shell.press("Continue")
    shell.stands_at(INSIDE, CALL)
    shell.press("Step Over")
    shell.stands_at(INSIDE + 1, CALL)
    shell.press("Step Back")
    shell.stands_at(INSIDE, CALL)
    shell.press("Step back to the call of this function")
    shell.stands_at(CALL)
    shell.press("Step Over")
    shell.stands_at(INSIDE, CALL)
    shell.press("Step Out")
    shell.stands_at(CALL)
    shell.press("Step back, into calls")
    shell.stands_at(INSIDE + 1, CALL)
    shell.press("Reverse")
    shell.stands_at(INSIDE, CALL)
    shell.command("CRS: Show the run in the workbench")
    frame = shell.workbench()
    frame.wait_for_function("() => window.crs?.model.isConnected", timeout=PATIENCE_MS)
    for _ in range(8):
        page.wait_for_timeout(500)
        shell.press("Continue")
        shell.stands_at(INSIDE, CALL)
    frame.wait_for_function("() => crs.model.state.t >= 0.1", timeout=PATIENCE_MS)
    print("the workbench is at", frame.evaluate("crs.model.state.t"), "s")


def main() -> None:
    """Go through a session, and take a picture of its end."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("address")
    parser.add_argument("folder", type=Path)
    parser.add_argument("picture", type=Path, nargs="?")
    options = parser.parse_args()
    prepare(options.folder)
    with sync_playwright() as started:
        browser = started.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        page = browser.new_page(viewport={"width": 1500, "height": 950})
        page.set_default_timeout(PATIENCE_MS)
        page.goto(f"{options.address}/?folder={options.folder.resolve()}")
        session(page)
        if options.picture:
            page.wait_for_timeout(3000)
            page.screenshot(path=options.picture)
        browser.close()


if __name__ == "__main__":
    main()
