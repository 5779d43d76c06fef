"""The debugger's plain screen: lines in, lines out."""
