/**
 * The panels beside the view, in their order. To add one, write a module like those here and name it
 * below: it has an `id`, a `title`, a `side`, what the run must be able to do (`needs`), and `make`,
 * which fills its element and listens to the model. One that `asks` the server is not in pages that
 * hold a run.
 *
 * @typedef {{id: string, title: string, side: "left" | "right" | "below" | "under",
 *   summary?: string, key?: string, needs?: string, asks?: boolean, recorded?: boolean, isHeld?: (run: any) => boolean,
 *   make: (root: HTMLElement, model: any, look: any, page: any) => void}} Panel
 */
import { changes } from "crs/panels/changes.js";
import { code } from "crs/panels/code.js";
import { compare } from "crs/panels/compare.js";
import { commandLine } from "crs/panels/console.js";
import { events } from "crs/panels/events.js";
import { faults } from "crs/panels/faults.js";
import { messages } from "crs/panels/messages.js";
import { output } from "crs/panels/output.js";
import { overlays } from "crs/panels/overlays.js";
import { plot } from "crs/panels/plot.js";
import { robot } from "crs/panels/robot.js";
import { robotTable } from "crs/panels/robot_table.js";
import { robots } from "crs/panels/robots.js";
import { why } from "crs/panels/why.js";

/** @type {Panel[]} */
export const PANELS = [robots, overlays, code, robot, faults, output, events, changes, commandLine, robotTable, messages, why, compare, plot];
