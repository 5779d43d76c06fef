"""The recording that these tests read."""

from tests.recorded import recorded

__all__ = ["recorded"]
