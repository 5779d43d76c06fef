"""Where things are, what shape they have, and what beams meet.

- `scene`: the outlines of all things; `polygon`: of things with many corners; `things`: how far a
  point is from them; `surfaces`: what they look and sound like; `frames`: poses in other frames.
- `neighbours`: what lies near what, without looking at all pairs; `obstacles`: outlines in reach of
  a robot; `covered`: sensors that lie in something; `sight`: what stands between two places.
- `rays` and `echoes`: what beams hit; `prospect`: what they can; `surroundings`: all of that in the
  current cycle.
- `placement`: who stands where nobody can; `overlap`: how deep things do; `room`: whether there is
  any to put something; `clearance`: how much robots have.
- `segments`: straight lines through points.
"""
