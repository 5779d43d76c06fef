"""What a world and its robots are: constant data, independent of any file format."""
