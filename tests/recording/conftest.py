"""The recordings that these tests read."""

from tests.recorded import recorded
from tests.recorded_fields import fields_folder

__all__ = ["fields_folder", "recorded"]
