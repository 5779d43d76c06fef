"""The world in the debugger: displays, events and changes."""
