"""Recordings of runs in files: written while a run goes on, read, checked and exported."""
