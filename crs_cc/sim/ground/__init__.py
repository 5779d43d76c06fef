"""The ground where it is not flat: how high it is, what slopes do, what blocks, what is seen."""
