"""Runs: compile programs, and run them with the environment, one timestep after the other."""
