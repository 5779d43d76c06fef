"""Sensors and actuators, one package each; its docstring has the formula, units and source.

A sensor that measures a few numbers is one row (`sim.model.device`), found by the registry
(`sim.model.registry`); `sensor` makes it measure, adds noise and replies. To add one, add a
package with a `DEVICE` and nothing else: `altimeter` is the smallest example, docs/extending.md
explains it.

There are three ways in which sensors measure:

- by their own timer, whether a program asks or not: the sonars, which `DeviceBoard.advance` makes
  fire before every request and at the end of a cycle;
- when a reply has their readings, at most at their rate: infrared, compass, laser. `sensor_board`
  knows which replies those are (ADR 11);
- when the program asks for them: heat, and those of `crs.h`.

All others can have a timer instead (`timers`), set by a definition or a program: then they measure
as the sonars do, and a program that asks gets the last reading. Bumpers are pressed by the
contacts of a cycle; odometry is what the wheels turned.

What devices share: `robot_constants`, arrays of what the robots are made of; `request_context`,
what a request's handler is given; `ray_caster`, what beams hit; `mount`, where sensors point;
`emitters`, lights and sounds; `waits` and `serial_link`, when requests are answered;
`vendor_state`, the vendor's `State`; `degradation`, the filter that values pass through:
`degradations.alter(state, "gps", rows, values, at_s)` once for each measurement, before it is kept
or rounded, and what comes back may be NaN, for no value. An actuator does the same with its
command. A robot refuses requests about devices that it does not have.
"""
