"""How long the ways are that robots found: they print when, and the length in metres."""

import statistics

from crs_cc import Session

_WINDOW_S = 120


def lengths_m(session: Session) -> str:
    """Return the median length of the ways found in each two minutes [m]."""
    windows: list[list[float]] = [[] for _ in range(round(session.time_s) // _WINDOW_S)]
    for time_s, length_m in _ways(session):
        windows[time_s // _WINDOW_S].append(length_m)
    return " ".join(f"{statistics.median(each):.3f}" for each in windows)


def shortest_m(session: Session) -> float:
    """Return the length of the shortest way that was found [m]."""
    return min(length_m for _, length_m in _ways(session))


def _ways(session: Session) -> list[tuple[int, float]]:
    """Return all ways: when they were found [s], and their lengths [m]."""
    printed = "".join(robot.stdout for robot in session.robots.values())
    lines = [line.split() for line in printed.splitlines() if line[:1].isdigit()]
    return [(int(line[0]), float(line[1])) for line in lines]
