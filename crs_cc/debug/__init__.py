"""The debugger: forward and reverse execution of programs and their world.

Read `engine` first: the operations of the debugger, without a user interface. It owns a `view`
(the selected robot and frame), `stop_points` (breakpoints of all kinds) and a `navigator`.
`errors` has the error that users see, `program` a program with its debug build.

- `timeline/`: a recorded run, which can be moved to any `Position`. A `RunEvent` is what the run
  has advanced to; a `Stop` reports it to the user.
- `navigator`: moves the run forward or back to the next reason to stop; `step_conditions`: where
  steps end; `searched_parts`: the parts of the past in which there may be a reason to stop.
- `locations`: where breakpoints are, as the user writes it; `breakpoints`: which of them are hit;
  `condition_tests`: conditions that programs test themselves; `saved_breakpoints`: those in a
  recording; `log_message`: what log points say; `stop`: why a run has stopped.
- `watch`: accesses to watched bytes, detected inside the sandbox; `watchpoints`: the expressions
  that users watch; `world_watch`: those that use the world or several programs; `run_values`:
  how expressions use these.
- `past`: questions about the recorded past; `last_write`: the last write of an object; `why`: a
  tree of where a value came from, whose nodes are in `cause`; through `message_cause` to other
  robots, `motion_cause` to what moves objects, `echo_cause` to what sensors met, and
  `battery_cause` to what drains batteries; `evaluation_point`: where operands are evaluated;
  `repeated_writes`: many writes as one cause; `statement_source`: the text of what a statement
  did; `returned_value`: what a call has returned; `skips`: functions that steps do not enter;
  `call_sites`: calls that a step can choose to enter.
- `branches`: alternative histories; `branch_comparison`: the differences between two of them, as
  texts of `difference_text`; `branch_facts`: their states at many timesteps; `first_difference`:
  the first of these in which two runs differ.
- `data/`: C expressions, and values by their types.
- `world/`: displays of the world, its events, and changes to it and to the run; `uploads`: programs
  that a user brings to a run, for robots that join; `interventions`: all that a user has done, and
  how it is taken back.

User interfaces use the engine, not vice versa: `commands/` has the table of commands, `repl/`
is a prompt, `tui/` the full screen, `dap/` serves editors.
"""
