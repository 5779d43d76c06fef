"""The data of a stopped program: C expressions, and values by type."""
