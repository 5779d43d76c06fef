-- nvim-dap configuration for `crs debug --dap`; load it with: lua dofile(".../editors/nvim/crs.lua")

local dap = require("dap")

dap.adapters.crs = {
  type = "executable",
  command = "crs",
  args = { "debug", "--dap", "stdio" },
}

dap.configurations.c = dap.configurations.c or {}
table.insert(dap.configurations.c, {
  name = "This program in a room",
  type = "crs",
  request = "launch",
  program = "${file}",
  world = "${workspaceFolder}/worlds/room.xml",
  cwd = "${workspaceFolder}",
  args = {},
  stopOnEntry = true,
})

-- Function keys run forward, with Shift backward.
vim.keymap.set("n", "<F5>", dap.continue)
vim.keymap.set("n", "<S-F5>", dap.reverse_continue)
vim.keymap.set("n", "<F10>", dap.step_over)
vim.keymap.set("n", "<S-F10>", dap.step_back)
vim.keymap.set("n", "<F11>", dap.step_into)
vim.keymap.set("n", "<S-F11>", dap.step_out)
vim.keymap.set("n", "<F9>", dap.toggle_breakpoint)
