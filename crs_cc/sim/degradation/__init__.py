"""What goes wrong with devices: the law, its state, and who changes it."""
