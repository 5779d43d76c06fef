"""From C files of our own to code that runs: the C library by units, and the compile cache."""
