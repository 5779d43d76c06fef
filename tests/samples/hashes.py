"""Write the state hash of the beginning of each sample run, one line for each.

Each timestep is run alone: in calm time kernels compute what numpy does otherwise, and they use the
same instructions on every processor.
"""

from crs_cc.runtime import executable
from tests.conftest import fast_settings
from tests.samples.test_samples import RUNS

MAX_TIME_S = 4.0

NOISY = ("wander", "follow_wall", "localise", "push")

if __name__ == "__main__":
    executable.settings = fast_settings  # those of the tests, which keep the programs in the cache
    for run in RUNS:
        print(run.name, run.drive(longest_s=MAX_TIME_S, calmly=False).state_hash)
        if run.sample in NOISY:
            print(run.name, "noisy", run.drive("noisy", MAX_TIME_S, calmly=False).state_hash)
