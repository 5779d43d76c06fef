"""Which branch of the double bridge robots chose."""

from crs_cc import Session

_MINUTE_S = 60


def north_by_minute(session: Session) -> str:
    """Return the share of choices of the northern branch, in each minute."""
    minutes = round(session.time_s) // _MINUTE_S
    north, all_ = [0] * minutes, [0] * minutes
    for robot in session.robots.values():
        for line in robot.stdout.splitlines():
            time_s, _, branch = line.partition(" ")
            if branch in ("north", "south"):
                north[int(time_s) // _MINUTE_S] += branch == "north"
                all_[int(time_s) // _MINUTE_S] += 1
    return " ".join(f"{one / of:.4f}" for one, of in zip(north, all_, strict=True))
