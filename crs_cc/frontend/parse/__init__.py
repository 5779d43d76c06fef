"""From preprocessed text to pycparser's tree, with messages that a programmer can read."""
