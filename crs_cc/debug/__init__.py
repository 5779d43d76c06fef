"""The debugger: forward and backward through programs and their world.

Read `engine` first: what a user can do, without a screen. It builds on `view` (what the user looks
at) and `stop_points` (what the run stops at), and adds moving, changing, branches. `errors` has the
errors a user can make, `program` what the debugger needs of a program.

- `timeline/`: a run at any point of its history. A `Position` counts; an `Instant` is the state
  that the run has reached there; a `Stop` reports it to the user.
- `navigator`: moves the run forward or back to the next reason to stop; `step_conditions`: the
  reasons of stepping.
- `locations`: where breakpoints are, as the user writes it; `calls`: statements that call a library
  function; `breakpoints`: which of them are hit; `stop`: why a run has stopped.
- `watch`: accesses to watched bytes, detected inside the sandbox; `watchpoints`: the expressions
  that users watch.
- `branches`: alternative histories; `comparison`: what differs between two of them.
- `data/`: C expressions, and values by their types.
- `world/`: what is shown of the world, can be waited for in it, and changed.

Screens use the engine, which knows none of them: `commands/` is the one table of commands, `repl/`
a prompt, `tui/` the full screen, `dap/` serves editors.
"""
