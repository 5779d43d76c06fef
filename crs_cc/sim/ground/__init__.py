"""The ground where it is not flat.

`model` says what it is, `terrain` and `heightmap` how high and steep, `inclines` what slopes do,
`ledges` what blocks, `falls` who fell, `outlook` what beams meet.
"""
