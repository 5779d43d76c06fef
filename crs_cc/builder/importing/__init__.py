"""Import of plans from other programs: `plan` chooses the reader by the file name.

- `drawn` collects walls, boxes and so on, and what was left out.
- `svg_plan` reads floor plans in SVG, with `svg_path` and `svg_transform`; `stage_plan` Stage's
  worlds, with `stage_tokens`; `sdf_plan` SDF; `png_plan` pictures.
"""
