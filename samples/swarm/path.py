"""When robots have formed a path from the nest to the source, and what they brought on it."""

from crs_cc import Session


def path_s(session: Session) -> float:
    """Return when the nest heard of a path to the source, the end of the run if never [s]."""
    said = session.robots["nest"].stdout.split()
    return float(said[0]) if said else session.time_s


def has_path(session: Session) -> int:
    """Return 1 if it heard of one, else 0."""
    return int(bool(session.robots["nest"].stdout))
