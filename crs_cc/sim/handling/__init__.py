"""Taking hold of things: grippers and arms, what they hold, and how that moves."""
