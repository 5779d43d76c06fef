"""What changes while a world runs, device by device; `state.EnvState` holds them all."""
