"""Jobs in separate processes, several at a time: for `crs grade` and `crs sweep`."""
