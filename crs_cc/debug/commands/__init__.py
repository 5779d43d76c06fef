"""The debugger's commands, for all user interfaces."""
