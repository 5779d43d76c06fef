"""Runs real C control programs of the Nomadic Scout in a simulated, shared world."""

__version__ = "0.1.0"
