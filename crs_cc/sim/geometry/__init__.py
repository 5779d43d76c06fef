"""Outlines and shapes of objects, ray casting, and the ground.

- `scene`: the outlines of all objects; `shape_table`: distances from points to them; `surfaces`:
  their reflectance for light and sound; `frames`: transforms of poses between frames.
- `cell_list`: near pairs of points; `obstacles`: outlines within reach of a robot;
  `contact_mask`: sensors that touch an object or are inside one; `line_of_sight`: objects between
  two points.
- `rays` and `echoes`: intersections of beams with objects; `outline_query`: outlines in reach.
- `placement`: initial overlaps; `overlap`: their depth; `clearance`: distances to obstacles.
- `terrain`, `heightmap`: the height of the ground; `ledges`: steps that block; `height_occlusion`:
  beams at a height.
- `split_and_merge`: line segments from points.
"""
