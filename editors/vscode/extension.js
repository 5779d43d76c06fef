// The window with the map: the workbench of `crs view` beside the editor. While a debug session of
// crs stops, steps and goes back, the window follows its time. And the steps back that VS Code has no
// buttons for: into calls, and out of the function.
"use strict";

const { spawn } = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");
const vscode = require("vscode");

const ADDRESS = /open (http:\/\/127\.0\.0\.1:\d+\/#\S+)/;
const START_MS = 180_000;

/** The windows that are open: the panel, the process of `crs view`, and the address of its page. */
let shown = null;

/** What is shown: that of the debug session, or else the file in the editor and a world. */
async function wanted() {
  const session = vscode.debug.activeDebugSession;
  if (session?.type === "crs") return fromConfiguration(session.configuration);
  const file = vscode.window.activeTextEditor?.document;
  const folder = file && vscode.workspace.getWorkspaceFolder(file.uri);
  if (file?.languageId !== "c") {
    vscode.window.showErrorMessage("Open the C file of a robot program first, or start to debug one.");
    return null;
  }
  const worlds = await vscode.workspace.findFiles("**/*.xml", "**/node_modules/**", 200);
  const items = worlds.map((uri) => ({ label: vscode.workspace.asRelativePath(uri), file: uri.fsPath }));
  const chosen = items.length ? await vscode.window.showQuickPick(items, { placeHolder: "The world in which the program runs" }) : { file: "" };
  if (!chosen) return null;
  return { words: [file.uri.fsPath, chosen.file].filter(Boolean), cwd: folder?.uri.fsPath ?? path.dirname(file.uri.fsPath) };
}

/** The command line of a launch configuration. */
function fromConfiguration(configuration) {
  const listed = (each) => (each === undefined ? [] : [each].flat());
  const words = [...listed(configuration.program), ...listed(configuration.world)];
  for (const [name, option] of [["robot", "--robot"], ["setup", "--setup"], ["link", "--link"], ["client", "--client"], ["seed", "--seed"]]) {
    if (configuration[name] !== undefined) words.push(option, String(configuration[name]));
  }
  return { words, cwd: configuration.cwd };
}

/** The command `crs`, as the user has set it; an error that says what to do if there is none. */
function crs() {
  const command = vscode.workspace.getConfiguration("crs").get("command") || "crs";
  const folders = command.includes(path.sep) ? [""] : (process.env.PATH ?? "").split(path.delimiter);
  const ends = process.platform === "win32" ? ["", ...(process.env.PATHEXT ?? ".EXE;.BAT;.CMD").split(";")] : [""];
  const isThere = folders.some((folder) => ends.some((end) => fs.existsSync(path.join(folder, command + end))));
  if (!isThere) throw new Error(`'${command}' was not found. Set "crs.command" to its path (in a remote window, in the settings of the remote machine), or start VS Code where the command is found.`);
  return command;
}

/** Start `crs view`. @returns {Promise<{process: import("node:child_process").ChildProcess, address: string}>} */
function started({ words, cwd }) {
  const command = crs();
  return new Promise((resolve, reject) => {
    const run = spawn(command, ["view", "--no-open", ...words], { cwd, stdio: ["ignore", "ignore", "pipe"] });
    let said = "";
    const timer = setTimeout(() => fail("crs view gives no address"), START_MS);
    const fail = (text) => {
      clearTimeout(timer);
      run.kill();
      reject(new Error(said.trim() || text));
    };
    run.on("error", (error) => fail(`${command}: ${error.message}`));
    run.on("exit", () => fail("crs view has ended"));
    run.stderr.on("data", (data) => {
      said += data;
      const found = ADDRESS.exec(said);
      if (!found) return;
      clearTimeout(timer);
      resolve({ process: run, address: found[1] });
    });
  });
}

/** The page of the window: a frame with the workbench, and nothing else. */
function html(address) {
  const nonce = Math.random().toString(36).slice(2);
  const policy = `default-src 'none'; frame-src ${new URL(address).origin}; style-src 'nonce-${nonce}'; script-src 'nonce-${nonce}'`;
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<title>CRS workbench</title>
<style nonce="${nonce}">html, body, iframe { margin: 0; padding: 0; border: 0; width: 100%; height: 100vh; display: block; }</style>
</head>
<body>
<iframe src="${address}" title="CRS workbench" allow="clipboard-write"></iframe>
<script nonce="${nonce}">
const frame = document.querySelector("iframe");
addEventListener("message", ({ data }) => {
  if (typeof data.time === "number") frame.src = ${JSON.stringify(address)} + "&t=" + data.time;
});
</script>
</body>
</html>`;
}

async function showWorkbench() {
  if (shown) return shown.panel.reveal(undefined, true);
  const what = await wanted();
  if (!what) return;
  try {
    const { process, address } = await vscode.window.withProgress(
      { location: vscode.ProgressLocation.Notification, title: "CRS: compiling and starting the run" }, () => started(what));
    const panel = vscode.window.createWebviewPanel("crs.workbench", "CRS workbench", { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true }, { enableScripts: true, retainContextWhenHidden: true });
    panel.webview.html = html(address);
    shown = { panel, process };
    panel.onDidDispose(() => {
      process.kill("SIGINT");
      shown = null;
    });
    follow(vscode.debug.activeDebugSession);
  } catch (error) {
    vscode.window.showErrorMessage(`CRS: ${error.message}`);
  }
}

/** Let the window show the time at which a debug session stands. */
async function follow(session) {
  if (!shown || session?.type !== "crs") return;
  try {
    const { result } = await session.customRequest("evaluate", { expression: "when", context: "repl" });
    const found = /t = ([\d.]+) s/.exec(result);
    if (found) shown?.panel.webview.postMessage({ time: Number(found[1]) });
  } catch {
    // the session goes on or has ended
  }
}

/** The steps back that VS Code does not have, and the command of the debugger for each. */
const STEPS_BACK = { "crs.stepBackInto": "reverse-step", "crs.stepBackOut": "reverse-finish" };

/** Execute a command of the debugger; it tells the editor where the program stands then. */
async function execute(command) {
  const session = vscode.debug.activeDebugSession;
  if (session?.type !== "crs") return;
  const frameId = vscode.debug.activeStackItem?.frameId;
  try {
    await session.customRequest("evaluate", { expression: command, context: "repl", frameId });
  } catch (error) {
    vscode.window.showErrorMessage(`CRS: ${error.message}`);
  }
}

function activate(context) {
  const steps = Object.entries(STEPS_BACK);
  context.subscriptions.push(
    vscode.commands.registerCommand("crs.showWorkbench", showWorkbench),
    ...steps.map(([name, command]) => vscode.commands.registerCommand(name, () => execute(command))),
    vscode.debug.registerDebugAdapterDescriptorFactory("crs", {
      // that of the manifest has the arguments, and knows no setting
      createDebugAdapterDescriptor: (_, executable) => new vscode.DebugAdapterExecutable(crs(), executable.args, executable.options),
    }),
    vscode.debug.registerDebugAdapterTrackerFactory("crs", {
      createDebugAdapterTracker: (session) => ({
        onDidSendMessage: (message) => {
          if (message.type === "event" && message.event === "stopped") follow(session);
        },
      }),
    }),
    { dispose: () => shown?.panel.dispose() },
  );
}

module.exports = { activate, deactivate: () => shown?.panel.dispose() };
