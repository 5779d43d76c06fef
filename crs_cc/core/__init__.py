"""What every part builds on: errors, source places, units, quantities, random streams, messages."""
