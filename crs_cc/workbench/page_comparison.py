"""What a page of a recorded run holds of another one with which it is compared.

It is what a server answers to `compare`, with the frames of the other run and the distances of
robots, which a page without a server cannot ask for.
"""

from __future__ import annotations

from base64 import b64encode
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from crs_cc.workbench.comparison import common_robots, compare, distance_to_run
from crs_cc.workbench.feed import roster_fields
from crs_cc.workbench.other_runs import recorded_feed, title_of
from crs_cc.workbench.recorded_content import frame_blocks
from crs_cc.workbench.trajectories import robots_of

if TYPE_CHECKING:
    from crs_cc.recording.recording import Recording

MAX_ROBOTS: Final = 50
MAX_POINTS: Final = 500
"""Limits of the robots whose distances are included, and of the points of each."""


@dataclass(frozen=True, slots=True)
class OtherRecording:
    """A recorded run with which a page compares its own.

    Attributes:
        recording: the recording.
        exact: where variables first differ, as `ExactComparison.go_on` returns it; None if that
            is not known.
    """

    recording: Recording
    exact: dict[str, Any] | None = None


def compared_run(own: Recording, other: OtherRecording, most_bytes: int) -> dict[str, Any]:
    """Return the contents of a page about another run.

    Args:
        own: the run of the page.
        other: the other one.
        most_bytes: of the frames of the other one, before base 64.

    Raises:
        RecordingError: a recording is damaged, or the other one has no frames.
        DebugError: they have no robot in common.
    """
    mine, theirs = recorded_feed(own), recorded_feed(other.recording)
    blocks, stride = frame_blocks(other.recording, most_bytes)
    names = robots_of(mine)
    end_s = min(mine.end_s, theirs.end_s)
    distances = {}
    for name in common_robots(mine, theirs)[:MAX_ROBOTS]:
        times_s, values = distance_to_run(
            mine, theirs, names.index(name), begin_s=0.0, end_s=end_s, most=MAX_POINTS
        )
        rows = zip(times_s, values, strict=True)
        distances[name] = [
            [round(at_s, 3), None if value is None else round(value, 4)] for at_s, value in rows
        ]
    return {
        "name": other.recording.path.name,
        "title": title_of(other.recording),
        "rosters": [roster_fields(each) for each in theirs.rosters()],
        "frame_s": theirs.frame_s * stride,
        "thinned": stride,
        "blocks": [[*span, b64encode(block).decode("ascii")] for *span, block in blocks],
        "apart": distances,
        "exact": other.exact,
        **compare(mine, theirs),
    }
