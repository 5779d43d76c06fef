"""Recordings of runs in files: written during a run, read, checked and exported."""
