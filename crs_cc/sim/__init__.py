"""The simulated world: what it is, how it is read from files, and how a timestep changes it."""
