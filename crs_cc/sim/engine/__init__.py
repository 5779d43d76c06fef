"""One timestep: requests served, physics stepped, devices updated, waits ended."""
