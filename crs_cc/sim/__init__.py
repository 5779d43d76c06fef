"""The simulated world: what it is, how it is read from files, and how a timestep changes it.

What it is, as constant data:

- `model`: a world. `robot_model`: a kind of robot, with `sensor_model`, `sonar_model` and
  `beacon_model`: what it senses with, what shines and sounds. `communication`: the channels.
- `files/`: world files and robot definitions, read into these; `robots/`: the definitions that come
  with crs. `quantity`: numbers with units, `colours`: by name, `naming`: ids of things, `unknown`:
  how a name that nothing has is told.
- `equipment`: what the robots are made of, as arrays; `drives`: the same of their drives.

What changes:

- `state`: all of it, an array or more for each device, of which each has a file in `states/`;
  `growth`: how a robot is added to it; `packing`: how it is kept as one block of bytes.
- `setting`: all that follows from it; `presence`: who comes and goes; `relocation`: who is carried.

What happens in a timestep:

- `environment`: serves requests and ends cycles; `running`: what others see of that.
- `commands`: the handler of each request; `asked`: what it is given; `rows`: the robots that it is
  about; `waits`: requests that are answered later; `link`: the time on the serial line; `server/`:
  requests to the vendor's simulator, and `drawings`: what programs draw there.
- `hardware`: commands become profiles of axes; `actuators/`: what they mean to each device.
- `physics/`: contacts. `ground/`: heights, slopes and ledges. `handling/`: what is gripped and
  carried.
- `geometry/`: outlines of all things, who is near, what beams meet.
- `devices`: all that measure by themselves; `sensors/`: how each does; `instruments`: those that
  each reply tells; `timers`: those with a timer; `mount`: where they look from; `sources`: lights
  and sounds that reach them; `blobs`: spots in a camera's row of pixels.
- `degradation/`: what is wrong with devices. `messages/`: from robot to robot.
- `noise`: random numbers in streams, `chances`: by name; `instants`: when something is due.

What it tells:

- `state_vector`: the vendor's `State`. `step`: what happened in a cycle. `events`: besides motion.
- `sights`: what sensors told last, for pictures; `robot_colours`: by which they tell robots apart.
"""
