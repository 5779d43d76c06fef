"""Write the state hash of the beginning of each sample run, one line for each.

The first line tells which instructions the processor seems to have.

Each timestep is run alone: in calm time kernels compute what numpy does otherwise, and they use the
same instructions on every processor.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator

import numpy as np

from crs_cc.runtime import executable
from tests.fast_settings import fast_settings
from tests.samples.test_samples import RUNS

MAX_TIME_S = 1.0

LATER_S = 4.0

LATER = ("push", "sonar_ages", "drivers/player_like", "hand", "climb", "platoon", "ants")
"""The samples that need what none needs in the first second: contacts, arms, ledges, old messages.

Together they execute by `LATER_S` each line of the simulation that any sample does by then.
"""

NOISY = ("wander", "follow_wall", "localise", "push")


def instructions() -> str:
    """Return a digest of what numpy and the C library compute by vector instructions and FMA."""
    x = np.linspace(0.1, 9, 9999)
    computed = np.arctan2(x, 0.7), (x + 2j) * (x - 1j), np.array([math.sin(each) for each in x])
    return hashlib.sha256(b"".join(each.tobytes() for each in computed)).hexdigest()


def hashes() -> Iterator[str]:
    """Yield the state hash of each run, after its name."""
    for run in RUNS:
        longest_s = LATER_S if run.sample in LATER else MAX_TIME_S
        yield f"{run.name} {run.drive(longest_s=longest_s, calmly=False).state_hash}"
        if run.sample in NOISY:
            yield f"{run.name} noisy {run.drive('noisy', longest_s, calmly=False).state_hash}"


if __name__ == "__main__":
    executable.settings = fast_settings  # those of the tests, which keep the programs in the cache
    print(instructions(), *hashes(), sep="\n")
