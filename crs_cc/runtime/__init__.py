"""From IR to running programs: code generation, the fleet of sandboxes, the C library."""
