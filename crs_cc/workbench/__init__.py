"""The screen in the browser: watch, control and debug a run.

It is one more screen of the debug engine, beside prompt, full screen and editors: what a user does
is an engine command, and part of the run's history.

- `run` is what it shows: a `debugged_run`, a `debugged_recording` (a `playback`, whose programs run
  again as they are asked for), or another that has the same methods. `player` decides when it goes
  on, in the thread of the run.
- `feed` keeps what is known of the run (frames, events, output) and passes on what is new; a
  `watcher` tells it what happens in a session. `frame_store` holds frames in blocks, `world_data`
  describes the world, `robot_table` the robots, `devices_in_view` what is drawn of their devices,
  `sources` the current line of a program, `values` its variables, `stops` its breakpoints.
- `screen` connects them with the pages: it checks commands in the thread of the `server` and
  carries them out in that of the run. `messages` is the form of the channel, `clients` what waits
  for each page.
- `control` changes the run for the control panel, and writes changes out; `instruments` reads
  robots, `message_log` keeps what became of messages; `panel_commands` has their commands.
- `other_runs` are recordings beside the run; `comparing` has the commands that compare it with one
  of them or with a branch: `comparison` of the available data, along `trajectories`, and
  `exact_comparison` by variables.
- `page` writes a recorded run as one HTML file, with the same modules; `page_comparison`
  another run into it, with which it is compared.
- `static/` has these modules: plain ES modules, no build step. `app.js` starts, `model.js` is what
  the page knows, `views.js` draws, `panels/` are at the sides, `debug/` has the parts of the
  debugger.

- `build_screen` serves another page, that of the world builder (`crs build`): its modules are in
  `static/builder/`, and what they ask for are operations of `crs_cc.builder`.

How a panel is added: a module in `static/panels/` that exports its row (`id`, `title`, `side`,
`needs`, `make`; below the view also a `key` and a `summary`), and its name in
`static/panels/index.js`. `make(root, model, look, page)` fills its element; it listens by
`model.on("status", draw)` (`model.js` lists the kinds) and acts by `await model.request("name",
{field: value})`. What it asks for is a row of the table in `commands.py`: name, summary, function,
fields, and whether it needs the token for control. Other data that it needs is sent as a message,
`screen.server.broadcast_latest("kind", message("kind", ...))`, which the model handles in
a method `handle_kind`. A key is a row in `static/keys.js`, a picture over the world a row in
`static/overlay.js`. A command of the debugger needs no row: `page.console(line)`.
"""
