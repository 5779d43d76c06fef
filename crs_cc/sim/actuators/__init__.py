"""The actuators, one file each."""
