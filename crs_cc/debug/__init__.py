"""The debugger: forward and backward through programs and their world.

Who begins here reads `engine` first. It is what a user can do, without a screen, and comes in three
steps: `view` (what he looks at), on it `points` (what the run stops at), on that `engine` (moving,
changing, branches). `errors` has what he can do wrong, `program` what is needed of a program.

- `timeline/`: a run at any instant of itself. A `Position` counts an instant of a run; an `Instant`
  is what the run has come to there, and what has just happened; a `Stop` tells the user.
- `travel`: goes on, or back, to where there is a reason to stop; `aims`: the reasons of stepping.
- `places`: breakpoints' places in the user's words; `calls`: statements that call a function of the
  library; `breakpoints`: which of them an instant meets; `stop`: why a run has stopped.
- `watch`: accesses to watched bytes, found out inside the sandbox; `watchpoints`: what the user
  calls these bytes.
- `branches`: courses of events beside each other; `comparison`: what differs between two.
- `data/`: C expressions, and values by their types.
- `world/`: what is seen of the world, can be waited for in it, and changed.

Screens use the engine, and it knows none of them: `commands/` is the one table of what can be
typed, `repl/` a prompt, `tui/` the full screen, `dap/` serves editors.
"""
