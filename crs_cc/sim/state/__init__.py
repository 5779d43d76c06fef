"""Everything that changes while a world runs, as arrays; `env_state.EnvState` holds it all."""
