"""The simulated world: what it is, how it is read from files, and how a timestep changes it.

- What it is: `model` (a world), `robot_model` and the devices' models (a robot). Constant.
- From files: `world_xml`; `xml_document`, which alone knows lxml; `world_elements`, ...; robots
  that come with crs in `robots/`.
- What changes: `state.EnvState`, made of one part for each device, in `states/`.
- What happens: `environment.Environment` serves requests and ends cycles; `setting` has all that
  follows from the state, `presence` who comes and goes. `commands` has the handler of each request;
  those of the vendor's simulator window and world are in `server/`.
- Motion: `hardware` (profiles of axes), `actuators/` (what commands mean), `physics/` (contacts):
  `simulation` moves `bodies`, in a `space` made of `shapes`, by `drive_force` and `friction`.
- Seeing: `scene` (outlines of all things), `obstacles` (those within reach), `rays` and `echoes`
  (what beams hit), `surfaces` (what that looks and sounds like), `surroundings` (all of that in the
  current cycle), `sensors/`, and `timers` for those that measure by themselves.
- The ground, where it is not flat: `surface` (what it is), `terrain` and `heightmap` (how high and
  steep), `inclines` (what slopes do), `ledges` (what blocks), `outlook` (what beams meet).
- What is wrong with devices: `degradation`, with what it is in `degradation_model`, and who changes
  it in `degradation_control`.
- Taking hold of things: `handling` (grippers and arms of all robots), `fingers` (what is between
  them), `holds` (who holds what), `carrying` (how it moves with them), `room` (where it can stand).
- Light and sound: `beacon_model`, and `sources` (which of them are near and in sight).
- Talking: `messages/`, on the channels of `communication`; `waits` lets programs wait.
- What it tells: `state_vector` (the vendor's `State`), `step` (a cycle, for traces and viewers).
"""
