"""What the tests of reports share with those of C programs."""

from __future__ import annotations

from tests.c.conftest import users_settings

__all__ = ["users_settings"]
