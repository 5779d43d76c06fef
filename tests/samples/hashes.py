"""Write the state hash of the beginning of each sample run, one line for each.

Each timestep is run alone: in calm time kernels compute what numpy does otherwise, and they use the
same instructions on every processor.
"""

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

if __name__ == "__main__":
    executable.settings = fast_settings  # those of the tests, which keep the programs in the cache
    for run in RUNS:
        longest_s = LATER_S if run.sample in LATER else MAX_TIME_S
        print(run.name, run.drive(longest_s=longest_s, calmly=False).state_hash)
        if run.sample in NOISY:
            print(run.name, "noisy", run.drive("noisy", longest_s, calmly=False).state_hash)
