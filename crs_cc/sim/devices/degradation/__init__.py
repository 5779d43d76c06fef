"""Degradation of devices: the filter that values pass through, and its control at run time."""
