"""The typed intermediate representation between C and WebAssembly."""
