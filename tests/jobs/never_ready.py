"""A process that runs jobs, but takes very long to start."""

import time

if __name__ == "__main__":
    time.sleep(600.0)
