"""Many runs of one experiment: over parameters and seeds, to a table (`docs/experiments.md`).

`experiment` reads what is wanted, `plan` lists the runs, `variant` makes the world and the programs
of one, `single_run` runs it, `rows` stores the outcome of each, and `sweep` does it all.
"""
