"""Jobs in processes of their own, several at a time: for `crs grade` and `crs sweep`."""
