"""The basis of all packages: errors, source locations, units, quantities, random streams."""
