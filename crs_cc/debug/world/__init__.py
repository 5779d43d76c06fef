"""What a user sees of the world, can wait for in it, and can change in it."""
