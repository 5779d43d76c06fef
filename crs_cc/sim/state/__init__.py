"""The state of a running world as arrays; `env_state.EnvState` contains all of it."""
