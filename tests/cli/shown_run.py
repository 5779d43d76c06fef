"""Where the page of a run is that another thread of this process shows."""

from __future__ import annotations

import io
import re
import time
from threading import Thread
from typing import Final

ADDRESS: Final = re.compile(r"127.0.0.1:(\d+)/#token=(\S+)")


def page_of(run: Thread, said: io.BytesIO) -> tuple[int, str]:
    """Return the port and the token of a run's page, as soon as it has printed them.

    What it prints must not be read by `capfd.readouterr`, which loses what is printed meanwhile.

    Args:
        run: the thread that shows it.
        said: what it has printed to the standard error stream so far.
    """
    while not (found := ADDRESS.search(text := said.getvalue().decode())):
        assert run.is_alive(), f"it has ended: {text}"
        time.sleep(0.01)
    return int(found[1]), found[2]
