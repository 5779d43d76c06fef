"""The builder of worlds: files that are changed in place, by page, shell and Python alike.

- `spans` locates each element and attribute in the bytes of a file, `document` replaces
  ranges of these bytes and takes that back.
- `addresses` names elements, `naming` lets references follow new names, `markup` writes attributes
  and elements as the rest of the file is written.
- `motion` moves coordinates in their own units, `mounting` and `robot_shapes` parts of robots;
  `changes`, `arrangement`, `composition` and `clips` work out what operations change, `mirroring`
  and `scaling` too; `extents` is the area that elements cover, `shapes` their outlines from above.
- `sensor_copies` numbers copies of sonars, `ground` is raised by a brush, `floor_grid` says where
  bodies can go.
- `table` lists the operations, `operations` works them out, `world_builder` does them, checks the
  result, and saves it by `world_file`.
- `library` finds objects for worlds, `reaching` goals that no robot can reach.
- `importing/` reads plans of other programs, `exporting` writes pictures and SDF.
"""
