"""Makes these tests a package for pytest, which share a browser (`conftest.py`)."""
