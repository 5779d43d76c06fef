"""The basis of all packages: errors, source locations, units, quantities, keyed random numbers."""
