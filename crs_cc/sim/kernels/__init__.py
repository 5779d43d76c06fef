"""C kernels of the simulation, compiled by crs_cc itself: the same bits on every processor."""
