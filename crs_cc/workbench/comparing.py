"""The commands of pages that compare the run with another one: a branch, or a recording."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.errors import DebugError
from crs_cc.workbench import comparison
from crs_cc.workbench.command import Command
from crs_cc.workbench.exact_comparison import ExactComparison
from crs_cc.workbench.feed import roster_fields
from crs_cc.workbench.messages import message
from crs_cc.workbench.other_runs import MAX_PIECE

if TYPE_CHECKING:
    from crs_cc.workbench.context import Context
    from crs_cc.workbench.feed import Feed
    from crs_cc.workbench.trace import Samples


def other_feed(screen: Context, name: str) -> Feed:
    """Return the known data of another run.

    Raises:
        DebugError: there is none of this name.
    """
    other = screen.others.find(name)
    feed = screen.run.branches().feed(name) if other is None else other.feed
    screen.others.compared[name] = feed
    return feed


def distance_to_run(
    screen: Context, robot: int, name: str, *, begin_s: float, end_s: float, most: int
) -> Samples:
    """Return the distance between the positions of a robot in two runs, over time [m].

    Raises:
        DebugError: there is none of this name.
    """
    feed = other_feed(screen, name)
    return comparison.distance_to_run(
        screen.feed, feed, robot, begin_s=begin_s, end_s=end_s, most=most
    )  # fmt: skip


def _compare(screen: Context, name: str) -> dict[str, Any]:
    feed = other_feed(screen, name)
    return {
        "name": name,
        "rosters": [roster_fields(each) for each in feed.rosters()],
        "blocks": feed.frames.index(),
        "frame_s": feed.frame_s,
        **comparison.compare(screen.feed, feed),
    }


def _next_difference(screen: Context, name: str, *, anew: bool) -> dict[str, Any]:
    """Look on for the first difference of variables."""
    if screen.player.is_playing:
        raise DebugError("the run is not paused: pause it first")
    if anew or screen.exact is None or not screen.exact.is_of(name):
        if screen.exact is not None:
            screen.exact.close()
            screen.exact = None
        screen.exact = ExactComparison(screen.run, screen.feed, screen.others, name)
    return screen.exact.continue_search()


def _receive_piece(screen: Context, name: str, offset: int, data: str) -> None:
    screen.others.add_piece(name, offset, data)


def _open(screen: Context, name: str) -> dict[str, str]:
    opened = screen.others.open_sent(name)
    broadcast_runs(screen)
    return {"name": opened.name}


def _close(screen: Context, name: str) -> None:
    if screen.exact is not None and screen.exact.name == name:
        screen.exact.close()
        screen.exact = None
    screen.others.close(name)
    broadcast_runs(screen)


def broadcast_runs(screen: Context) -> None:
    """Send all pages the list of recordings to compare with."""
    text = message("others", runs=screen.others.listing())
    screen.server.broadcast_latest("others", text)


COMPARING: Final = (
    Command("compare", "Return how another run differs from this one, by the available data.",
            _compare, {"name": str}, controls=False, asks=True),
    Command("next_difference", "Search for the first variable that differs.",
            _next_difference, {"name": str, "anew": bool}, needs="debug", asks=True),
    Command("upload_piece", "Receive a piece of a recording to compare with, as base 64.",
            _receive_piece, {"name": str, "offset": int, "data": str}, longest=MAX_PIECE,
            at_once=True),
    Command("open", "Open the uploaded recording.", _open, {"name": str}, asks=True),
    Command("close", "Close a recording that this run was compared with.", _close, {"name": str},
            asks=True),
)  # fmt: skip
