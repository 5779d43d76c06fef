"""The full screen of the debugger: source, stack, values, robots, map, output and timeline.

Only `app` talks to the debugger: through a `Backend` in a worker thread, one request at a time.
Each reply has the data of the stopped run, which the panes show.
"""
