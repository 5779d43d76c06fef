"""Tables of `docs/communication.md`: predefined channels, what happens to messages."""

from __future__ import annotations

from crs_cc.sim.comms.message_log import MEANINGS
from crs_cc.sim.model.communication import PREDEFINED
from docs.generate import Fillers, table


def channels() -> str:
    """Return the table of the predefined channels."""
    titles = ("number", "name", "range", "walls", "delay", "jitter", "bandwidth", "queue")
    rows = [
        (
            str(number),
            f"`{channel.name}`",
            f"{channel.range_m:g} m",
            f"{channel.walls:g}",
            f"{channel.delay_s * 1e3:g} ms",
            f"{channel.jitter_s * 1e3:g} ms",
            _rate(channel.bandwidth_bps),
            str(channel.queue),
        )
        for number, channel in enumerate(PREDEFINED)
    ]
    return table(titles, rows)


def _rate(bandwidth_bps: float) -> str:
    return "unlimited" if bandwidth_bps == float("inf") else f"{bandwidth_bps:.0f} B/s"


def fates() -> str:
    """Return the table of everything that can happen to a message."""
    rows = [(f"`{fate.name}`", meaning) for fate, meaning in MEANINGS.items()]
    return table(("event", "in the trace"), rows)


FILLERS: Fillers = {"channels": channels, "fates": fates}
