"""Where objects are, what shape they have, and what beams hit.

- `scene`: the outlines of all objects; `shape_table`: distances from points to them; `surfaces`:
  how they reflect light and sound; `frames`: poses in other frames.
- `cell_list`: which points are near each other; `obstacles`: outlines within reach of a robot;
  `contact_mask`: sensors that touch or lie inside an object; `line_of_sight`: what lies between
  two places.
- `rays` and `echoes`: what beams hit; `outline_query`: which outlines they may hit.
- `placement`: initial overlaps; `overlap`: how deep; `clearance`: the free space around robots.
- `terrain`, `heightmap`: the height of the ground; `ledges`: where it blocks; `height_occlusion`:
  beams at a height.
- `split_and_merge`: straight lines through points.
"""
