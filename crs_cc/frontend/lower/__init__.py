"""From the checked tree to IR."""
