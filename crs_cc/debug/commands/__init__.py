"""The debugger's commands, in one table, for every screen: terminal, full screen and editor."""
