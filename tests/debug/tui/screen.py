"""The screen as text, and sizes to look at it."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Sequence

from textual.pilot import Pilot

from crs_cc.debug.tui.app import DebugApp
from crs_cc.debug.tui.backend import Backend
from crs_cc.debug.tui.command_line import CommandLine

SMALL, LARGE, TINY = (80, 24), (160, 50), (40, 10)

NO_BARS = dict.fromkeys(map(ord, "▁▂▃▄▅▆▇▉▊▋▌▍▎▏"), " ")
"""Leaves out where scroll bars stand, which is no matter of what is shown."""

Session = Callable[[Pilot[int], DebugApp], Awaitable[None]]


def drive(
    backend: Backend,
    session: Session,
    size: tuple[int, int] = SMALL,
    history: Sequence[str] = (),
) -> DebugApp:
    """Let somebody use a screen of this size; return the app when it has ended."""

    async def run() -> DebugApp:
        app = DebugApp(backend, history)
        async with app.run_test(size=size) as pilot:
            await settle(pilot)
            await session(pilot, app)
        return app

    return asyncio.run(run())


async def settle(pilot: Pilot[int]) -> None:
    """Wait until the debugger has nothing to do and the screen shows what there is."""
    app = pilot.app
    assert isinstance(app, DebugApp)
    await pilot.pause()
    while not app.is_idle:
        await app.workers.wait_for_complete()
        await pilot.pause()
    await pilot.pause()


async def until(pilot: Pilot[int], holds: Callable[[], bool]) -> None:
    """Wait for something that is to happen soon, however busy the computer is."""
    for _ in range(500):
        if holds():
            return
        await pilot.pause(0.02)
    raise AssertionError("it did not happen")


async def enter(pilot: Pilot[int], line: str) -> None:
    """Types a line, quicker than key by key."""
    pilot.app.query_one(CommandLine).value = line
    await pilot.press("enter")


def text_of(app: DebugApp) -> str:
    """Return the characters on the screen, without scroll bars and what is empty at the right."""
    strips = app.screen._compositor.render_strips()
    return "\n".join(strip.text.translate(NO_BARS).rstrip() for strip in strips) + "\n"
