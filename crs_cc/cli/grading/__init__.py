"""`crs grade`: many submissions on worlds with goals, from folders to a table of grades.

`submissions` finds and copies the submissions, `job` describes one run, `processes` runs jobs
in processes of their own (`worker`), `graded_run` is one run there, `refused_calls` and
`fingerprint` look at its source, `grades` adds points up, `tables` and `page` write them.
"""
