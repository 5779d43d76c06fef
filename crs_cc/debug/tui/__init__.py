"""The full screen of the debugger: source, stack, values, robots, a map, output and a time line.

`app` is the one place that talks to the debugger: in a thread of its own, one command at a time.
After each it takes a `look` at the stopped run, plain data, and the panes show that.
"""
