"""The sensors. Each device's file opens with its formula, its units and its source.

There are three ways in which a sensor measures:

- by its own timer, whether anybody asks or not: the sonars (`sonar`, with `sonar_beams` and
  `sonar_errors`), which `Devices.advance` lets fire before every request and at the end of a cycle;
- when a reply tells its reading, at most at its rate: infrared, compass, laser. `Instruments` knows
  which replies those are (ADR 11);
- when the program asks for just that: heat, and those of `crs.h`. `Devices.answers` has who does.

All others can have a timer instead (`timers`), as a definition or a program sets it: then they
measure as the sonars do, and whoever asks is told the last reading. Another one that is to have a
timer gets a number in `states.timers`, gives `Devices` its `Timed`, and asks
`state.timers.on_request` before it measures for an answer. Beams that want to know which thing they
hit ask `Surroundings.seen`; what its surface does is in `Surroundings.surfaces`.

Bumpers are pressed by the contacts of a cycle (`Environment`); odometry is what the wheels turned.

A new sensor has its constants in `sensor_model`, read by `sensor_elements` from what `robot.xsd`
allows; its changing state in `states`, as a field of `state.EnvState`; its stream in `noise`; its
requests in `commands`, and in `crs_cc.requests.device` with functions in `runtime/lib/device` and
`crs_cc.robot_api.device`, where they are those of `crs.h`; or in `crs_cc.requests.robot`, with
their length on the line in the robot definitions, where they are the vendor's. Tests hold these
together: they name what is missing. What a robot does not have it refuses (`commands`).

Degradation is applied at one place: what a device has measured, in SI units and with the errors of
its definition, goes through `equipment.degradations.alter(state, "gps", rows, values, at_s)` once
for each measurement, before it is kept or rounded; what comes back may be NaN, for nothing. `gps`
is the example. An actuator does the same with what it is told to do. The device, its unit, its
elements and what it makes of nothing are a row of `degradation.model.DEVICES`; the law is in
`degradation.law`.
"""
