"""The public Python interface: worlds, programs, sessions, and robots steered from Python.

Its names are those of `crs_cc`, which imports them from here on first use. docs/python.md describes
them. Values are in SI units and radians, in the world's frame unless noted otherwise.
"""
