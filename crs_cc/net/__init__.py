"""Runs whose parts are in other programs: servers of an environment, and who connects to them."""
