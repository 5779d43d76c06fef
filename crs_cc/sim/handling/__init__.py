"""Taking hold of things: `handling` has the grippers and arms of all robots, `model` what they are.

`fingers` tells what lies between them, `choice` what of that is taken, `holds` who holds what,
`carrying` how that moves with them.
"""
