"""What commands of pages may use: the part of the screen that they see."""

from __future__ import annotations

from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from crs_cc.workbench.exact_comparison import ExactComparison
    from crs_cc.workbench.feed import Feed
    from crs_cc.workbench.other_runs import OtherRuns
    from crs_cc.workbench.player import Player
    from crs_cc.workbench.pointing import Pointing
    from crs_cc.workbench.run import Run
    from crs_cc.workbench.server import Server


class Context(Protocol):
    """The screen, as commands see it.

    Attributes:
        run: the run.
        feed: what is known of it.
        player: controls when it continues.
        server: sends messages to pages.
        robot: the selected robot.
        pointing: poses for which programs have asked the user.
        others: recorded runs to compare with.
        exact: a comparison of variables that has been begun.
    """

    run: Run
    feed: Feed
    player: Player
    server: Server
    robot: int
    pointing: Pointing
    others: OtherRuns
    exact: ExactComparison | None

    def publish(self) -> None:
        """Send the current position of the run to all pages."""

    def stopped(self) -> None:
        """Select the robot that the run has stopped for."""

    def working(self) -> AbstractContextManager[None]:
        """Report the start of a command that may take long, and then its result."""
