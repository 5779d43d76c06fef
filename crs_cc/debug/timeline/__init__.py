"""A run at any instant of itself: snapshots, what was written and given, and going there again."""
