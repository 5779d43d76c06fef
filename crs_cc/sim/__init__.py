"""The simulated world, in layers: each package may import only itself and those named before it.

- `kernels/`: C that computes the same bits on every processor: functions, echoes, arcs.
- `model/`: what a world and a robot are, as constant data. `files/`: world files, robot definitions
  and pictures, read into it.
- `geometry/`: outlines, rays, echoes, lines of sight, the height of the ground.
- `state/`: all that changes, an array or more for each device, in `state.env_state`.
- `physics/`: contacts, by pymunk, which nothing else imports.
- `devices/`: sensors and actuators, a folder each; what they share (`devices.robot_constants`,
  `devices.ray_caster`, timers, degradation).
- `comms/`: messages from robot to robot.
- `engine/`: `engine.environment` serves requests and ends timesteps; requests to the vendor's
  simulator are in `engine.server`.
"""
