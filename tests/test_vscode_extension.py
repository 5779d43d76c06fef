"""The extension for VS Code: what is packaged is there, and its window shows a run (in Node)."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

from crs_cc.workbench.static_files import POLICY

ROOT = Path(__file__).parents[1]
EXTENSION = ROOT / "editors" / "vscode"
MANIFEST = json.loads((EXTENSION / "package.json").read_text())

VIEW = """
import sys, time
open("words", "w").write(" ".join(sys.argv[1:]))
print("crs: open http://127.0.0.1:7777/#token=abc", file=sys.stderr, flush=True)
time.sleep(60)
"""

STARTED = """
const Module = require("node:module");
const [extension, command, cwd] = process.argv.slice(1);
const said = [], asked = [];
const commands = {};
let tracker, disposed, factory, setting = command;
const session = {
  type: "crs",
  configuration: { type: "crs", program: ["go.c"], cwd, seed: 3 },
  customRequest: async (_, { expression }) => {
    asked.push(expression);
    return { result: "t = 1.500 s, tick 30" };
  },
};
const panel = {
  webview: { html: "", postMessage: (message) => said.push(message) },
  onDidDispose: (listener) => (disposed = listener),
  dispose: () => disposed(),
};
const registerDebugAdapterTrackerFactory = (_, made) => {
  tracker = made.createDebugAdapterTracker(session);
};
const vscode = {
  commands: { registerCommand: (name, does) => (commands[name] = does) },
  debug: {
    activeDebugSession: session,
    registerDebugAdapterTrackerFactory,
    registerDebugAdapterDescriptorFactory: (_, made) => (factory = made),
  },
  DebugAdapterExecutable: class {
    constructor(command, args) { Object.assign(this, { command, args }); }
  },
  window: {
    withProgress: (_, does) => does(),
    createWebviewPanel: () => panel,
    showErrorMessage: (text) => { throw new Error(text); },
  },
  workspace: { getConfiguration: () => ({ get: () => setting }) },
  ProgressLocation: {}, ViewColumn: {},
};
const load = Module._load;
Module._load = (name, ...rest) => (name === "vscode" ? vscode : load(name, ...rest));
const { activate } = require(extension);
activate({ subscriptions: [] });
(async () => {
  await commands["crs.showWorkbench"]();
  said.length = 0;
  tracker.onDidSendMessage({ type: "event", event: "stopped" });
  await new Promise((resolve) => setTimeout(resolve, 50));
  asked.length = 0;
  await commands["crs.stepBackInto"]();
  await commands["crs.stepBackOut"]();
  const names = Object.keys(commands);
  const adapter = factory.createDebugAdapterDescriptor(session, { args: ["debug"] });
  setting = "/nowhere/crs";
  let wrong = "";
  try {
    factory.createDebugAdapterDescriptor(session, { args: ["debug"] });
  } catch (error) {
    wrong = error.message;
  }
  console.log(JSON.stringify({ html: panel.webview.html, said, asked, names, adapter, wrong }));
  process.stdin.once("data", () => { panel.dispose(); process.stdin.pause(); });
})();
"""


def test_what_is_packaged_is_there() -> None:
    for name in (MANIFEST["main"], MANIFEST["icon"], *MANIFEST["files"], "README.md"):
        assert (EXTENSION / name).is_file(), name
    assert (EXTENSION / "LICENSE").read_text() == (ROOT / "LICENSE").read_text()
    with Image.open(EXTENSION / MANIFEST["icon"]) as icon:
        assert icon.size == (128, 128)


def test_the_window_shows_the_run_of_the_debug_session_and_follows_it(tmp_path: Path) -> None:
    if shutil.which("node") is None:
        pytest.skip("node not found")
    crs = tmp_path / "crs"
    crs.write_text(f"#!{sys.executable}\n{VIEW}")
    crs.chmod(0o755)
    words = ["node", "-e", STARTED, str(EXTENSION / "extension.js"), str(crs), str(tmp_path)]
    run = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    out, _ = run.communicate("\n", timeout=60)  # the window is closed, which ends the run
    assert run.returncode == 0
    found = json.loads(out)
    assert found["said"] == [{"time": 1.5}]
    assert found["asked"] == ["reverse-step", "reverse-finish"]
    assert found["names"] == [each["command"] for each in MANIFEST["contributes"]["commands"]]
    assert '<iframe src="http://127.0.0.1:7777/#token=abc"' in found["html"]
    assert "default-src 'none'; frame-src http://127.0.0.1:7777;" in found["html"]
    assert (tmp_path / "words").read_text() == "view --no-open go.c --seed 3"
    assert found["adapter"] == {"command": str(crs), "args": ["debug"]}
    assert found["wrong"].startswith(
        "'/nowhere/crs' was not found. Set \"crs.command\" to its path"
    )


def test_only_windows_of_this_machine_may_frame_the_page() -> None:
    ancestors = POLICY.rpartition("frame-ancestors ")[2].split()
    local = ["http://127.0.0.1:*", "http://localhost:*"]
    assert ancestors == ["vscode-webview:", "vscode-file:", *local]
