-- A session of `crs debug --dap` inside Neovim, as nvim-dap begins one: with the adapter and the
-- configuration of editors/nvim/crs.lua, started by Neovim, over its pipes. Run by
--   nvim --headless --clean -l session.lua CRS.LUA PROGRAM WORLD LINE
-- It prints what it has seen as JSON.

local settings, program, world, line = arg[1], arg[2], arg[3], tonumber(arg[4])

-- Of nvim-dap, what the settings use: tables that they fill, and functions that keys call.
local dap = { adapters = {}, configurations = {} }
for _, name in ipairs({ "continue", "reverse_continue", "step_over", "step_back", "step_into", "step_out", "toggle_breakpoint" }) do
  dap[name] = function() end
end
package.preload.dap = function() return dap end
dofile(settings)

local adapter, configuration = dap.adapters.crs, vim.deepcopy(dap.configurations.c[1])
vim.cmd.edit(program)
local variables = { file = vim.fn.expand("%:p"), workspaceFolder = vim.fn.getcwd() }
for name, value in pairs(configuration) do
  if type(value) == "string" then configuration[name] = value:gsub("%${(%w+)}", variables) end
end
configuration.world = world

local buffer, waiting, events, sequence = "", {}, {}, 0
local function read(chunk)
  buffer = buffer .. (chunk or "")
  while true do
    local head, after = buffer:match("^(.-)\r\n\r\n()")
    local size = head and tonumber(head:match("Content%-Length: (%d+)"))
    if not size or #buffer < after + size - 1 then return end
    local message = vim.json.decode(buffer:sub(after, after + size - 1))
    buffer = buffer:sub(after + size)
    if message.type == "response" then waiting[message.request_seq] = message end
    if message.type == "event" then table.insert(events, message) end
  end
end
local process = vim.system({ adapter.command, unpack(adapter.args) }, {
  stdin = true,
  stdout = function(_, chunk) vim.schedule(function() read(chunk) end) end,
})

local function wait(found)
  assert(vim.wait(60000, found, 5), "the adapter does not answer")
end
local function send(command, arguments)
  sequence = sequence + 1
  local text = vim.json.encode({ seq = sequence, type = "request", command = command, arguments = arguments or vim.empty_dict() })
  process:write(("Content-Length: %d\r\n\r\n%s"):format(#text, text))
  return sequence
end
local function answer(number)
  wait(function() return waiting[number] end)
  local response = waiting[number]
  assert(response.success, response.message)
  return response.body or {}
end
local function ask(command, arguments) return answer(send(command, arguments)) end
local seen = 0
local function event(name)
  local found
  wait(function()
    while seen < #events and not found do
      seen = seen + 1
      if events[seen].event == name then found = events[seen] end
    end
    return found
  end)
  return found.body or {}
end

-- Where the program stands, and its variables; the cursor goes there. nvim-dap lets a thread go on that stops while it
-- believes that another one is stopped.
local believed
local function stopped()
  local stop = event("stopped")
  local thread = stop.threadId
  assert(not believed or believed == thread, "a second thread has stopped")
  assert(stop.allThreadsStopped, "the others run")
  believed = thread
  assert(#ask("threads").threads > 0, "there are no threads")
  local frame = ask("stackTrace", { threadId = thread, startFrame = 0 }).stackFrames[1]
  local values = {}
  for _, scope in ipairs(ask("scopes", { frameId = frame.id }).scopes) do
    if scope.name == "Locals" then
      for _, each in ipairs(ask("variables", { variablesReference = scope.variablesReference }).variables) do
        values[each.name] = each.value
      end
    end
  end
  vim.cmd.edit(frame.source.path)
  vim.api.nvim_win_set_cursor(0, { frame.line, 0 })
  return { line = frame.line, text = vim.trim(vim.api.nvim_get_current_line()), values = values }, thread
end

local capabilities = ask("initialize", { clientID = "neovim", clientName = "neovim", adapterID = "nvim-dap", pathFormat = "path",
  linesStartAt1 = true, columnsStartAt1 = true, supportsVariableType = true, supportsProgressReporting = true,
  supportsRunInTerminalRequest = true, supportsStartDebuggingRequest = true, locale = "en_US" })
local launched = send("launch", configuration)
event("initialized")
local breakpoints = ask("setBreakpoints", { source = { path = variables.file, name = vim.fs.basename(program) },
  breakpoints = { { line = line } }, lines = { line }, sourceModified = false }).breakpoints
local filters = {}
for _, each in ipairs(capabilities.exceptionBreakpointFilters) do
  if each.default then table.insert(filters, each.filter) end
end
ask("setExceptionBreakpoints", { filters = filters })
ask("configurationDone")
answer(launched)

local stops, thread = {}, nil
stops[1], thread = stopped()
for _, command in ipairs({ "continue", "next", "stepBack", "continue", "reverseContinue", "stepOut", "stepIn" }) do
  believed = nil
  ask(command, { threadId = thread, granularity = "statement" })
  table.insert(stops, (stopped()))
end
local said = ask("evaluate", { expression = "why total", context = "repl" }).result
-- At the end nvim-dap closes the pipe, and interrupts the adapter at once.
ask("terminate", { restart = false })
event("terminated")
process:write(nil)
process:kill("sigint")
local done = process:wait(20000)

print(vim.json.encode({ name = configuration.name, verified = breakpoints[1].verified, goesBack = capabilities.supportsStepBack,
  stops = stops, said = said, status = done.code }))
