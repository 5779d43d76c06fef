"""The debugger: forward and backward through programs and their world."""
