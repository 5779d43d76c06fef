"""Recorded runs: snapshots, console, logged input, and replay."""
