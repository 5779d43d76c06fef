// Sessions driven by the public test client of the Debug Adapter Protocol.
//
// The environment says where a server listens (PORT, TOKEN), or what to start on standard streams (PYTHON,
// ADAPTER), and where the programs are (PROGRAMS, WORLD).
"use strict";

const assert = require("node:assert");
const path = require("node:path");
const { afterEach, beforeEach, test } = require("node:test");
const { DebugClient } = require("@vscode/debugadapter-testsupport");

const { PYTHON, ADAPTER, PORT, TOKEN, PROGRAMS, WORLD } = process.env;
const LOOP = path.join(PROGRAMS, "loop.c");

let client;

beforeEach(async (context) => {
  client = new DebugClient(PYTHON, ADAPTER, "crs", { stdio: "pipe" }, true);
  client.defaultTimeout = 60000;
  const launch = client.launchRequest.bind(client);
  client.launchRequest = (attributes) => launch({ ...attributes, token: TOKEN });
  await client.start(context.name.includes("standard streams") ? undefined : Number(PORT));
});

afterEach(() => client.stop());

// Goes on by a request and gives the stop that follows.
async function move(request, threadId = 1) {
  const stopped = client.waitForEvent("stopped");
  await client[`${request}Request`]({ threadId });
  return (await stopped).body;
}

async function line(threadId = 1) {
  const response = await client.stackTraceRequest({ threadId });
  return response.body.stackFrames[0].line;
}

async function evaluate(expression, context = "watch", threadId = 1) {
  const stack = await client.stackTraceRequest({ threadId });
  const frameId = stack.body.stackFrames[0].id;
  const response = await client.evaluateRequest({ expression, context, frameId });
  return response.body.result;
}

test("on standard streams a breakpoint is hit, steps go on and back, the program ends", async () => {
  await client.hitBreakpoint({ program: LOOP }, { path: LOOP, line: 15 });
  assert.equal((await move("next")).reason, "step");
  assert.equal(await line(), 16);
  await move("next");
  assert.equal(await line(), 17);
  await move("stepBack");
  await move("stepBack");
  assert.equal(await line(), 15);
  await move("stepIn");
  assert.equal(await line(), 5);
  await move("stepOut");
  assert.equal(await evaluate("total"), "0");
  await client.setBreakpointsRequest({ source: { path: LOOP }, breakpoints: [] });
  assert.equal((await move("continue")).reason, "exited");
  const terminated = client.waitForEvent("terminated");
  await client.continueRequest({ threadId: 1 });
  await terminated;
});

test("it goes back to the breakpoint before, and to the entry", async () => {
  await client.hitBreakpoint({ program: LOOP }, { path: LOOP, line: 17 });
  await move("continue");
  assert.equal(await evaluate("total"), "2");
  await Promise.all([
    client.reverseContinueRequest({ threadId: 1 }),
    client.assertStoppedLocation("breakpoint", { path: LOOP, line: 17 }),
  ]);
  assert.equal(await evaluate("total"), "0");
  assert.equal((await move("reverseContinue")).reason, "entry");
});

test("a value is changed, and the run goes on with it", async () => {
  await client.hitBreakpoint({ program: LOOP }, { path: LOOP, line: 17 });
  assert.equal(await evaluate("total = 40", "repl"), "40");
  await Promise.all([
    client.setBreakpointsRequest({ source: { path: LOOP }, breakpoints: [] }),
    client.continueRequest({ threadId: 1 }),
    client.assertOutput("stdout", "40\n42\n46\n"),
  ]);
});

test("a change of an object stops the run, forward and backward", async () => {
  await client.hitBreakpoint({ program: LOOP }, { path: LOOP, line: 14 });
  await client.setBreakpointsRequest({ source: { path: LOOP }, breakpoints: [] });
  const stack = await client.stackTraceRequest({ threadId: 1 });
  const frameId = stack.body.stackFrames[0].id;
  const info = await client.dataBreakpointInfoRequest({ name: "total", frameId });
  assert.ok(info.body.dataId, info.body.description);
  const set = await client.setDataBreakpointsRequest({
    breakpoints: [{ dataId: info.body.dataId, accessType: "write" }],
  });
  assert.equal(set.body.breakpoints[0].verified, true, set.body.breakpoints[0].message);
  assert.equal((await move("continue")).reason, "data breakpoint");
  assert.equal(await evaluate("total"), "2");
  await move("continue");
  assert.equal(await evaluate("total"), "6");
  assert.equal((await move("reverseContinue")).reason, "data breakpoint");
});

test("robots are threads, each with a stack of its own", async () => {
  const place = { path: path.join(PROGRAMS, "two.c"), line: 6 };
  await client.hitBreakpoint({ program: place.path, world: WORLD }, place);
  const threads = (await client.threadsRequest()).body.threads;
  assert.equal(threads.length, 2);
  assert.deepEqual(threads.map((each) => each.id), [1, 2]);
  const stop = await move("continue");
  assert.equal(stop.threadId, 2);
  assert.equal(stop.allThreadsStopped, true);
  assert.equal(await line(2), 6);
  assert.equal(await evaluate("seen", "watch", 2), "0");
  assert.equal(await evaluate("seen", "watch", 1), "1");
});

test("breakpoints have conditions, and log instead of stopping", async () => {
  await Promise.all([
    client.waitForEvent("initialized").then(async () => {
      await client.setBreakpointsRequest({
        source: { path: LOOP },
        breakpoints: [
          { line: 16, logMessage: "i is {i}" },
          { line: 17, condition: "i == 2" },
        ],
      });
      await client.configurationDoneRequest();
    }),
    client.launch({ program: LOOP }),
    client.assertStoppedLocation("breakpoint", { path: LOOP, line: 17 }),
  ]);
  assert.equal(await evaluate("i"), "2");
});
