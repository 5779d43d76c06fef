"""What a stopped program's data are: expressions in the words of C, and values by their types."""
