"""The debugger's prompt."""
