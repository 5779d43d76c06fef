"""World and robot models: immutable data, independent of any file format."""
