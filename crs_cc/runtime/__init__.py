"""From IR to running programs: WebAssembly, the fleet of robots, the C library."""
